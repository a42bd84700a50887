// One participant's trials with jsPsych 7 or 8: both vibrations of a pair, then a slider. At the end
// the answers are saved as NAME.csv, which "tactspace study SET --unpack" reads.
//
//     experiment.html?participant=P01            one of those in study.js; otherwise it asks
//     experiment.html?participant=P01&simulate   answers that nobody gave, marked synthetic
"use strict";

const query = new URLSearchParams(window.location.search);
const simulates = query.has("simulate");
const names = Object.keys(study.participants);
let participant = query.get("participant");
while (!(participant in study.participants)) {
    participant = window.prompt("Participant, one of " + names[0] + " to " + names.at(-1));
    if (participant === null) throw new Error("no participant");
}

const jsPsych = initJsPsych({
    show_progress_bar: true,
    on_finish: () => jsPsych.data.get().filter({ of_study: true }).ignore(unused).localSave("csv", participant + ".csv"),
});
// Columns of jsPsych that say nothing of an answer.
const unused = ["stimulus", "trial_type", "trial_index", "plugin_version", "time_elapsed", "internal_node_id",
    "slider_start", "response", "rt", "of_study"];

// The vibrations of a trial by their sides; the answer waits until both were felt to their end.
function feel(sides, plays) {
    const slider = document.querySelector("#jspsych-html-slider-response-response");
    const next = document.querySelector("#jspsych-html-slider-response-next");
    const buttons = [...document.querySelectorAll(".plays button")];
    slider.disabled = true;
    sides.forEach((place, side) => {
        const sound = new Audio("stimuli/" + study.files[place]);
        buttons[side].addEventListener("click", () => {
            buttons.forEach((button) => { button.disabled = true; });
            sound.currentTime = 0;
            sound.play();
        });
        sound.addEventListener("ended", () => {
            plays[side] += 1;
            if (plays.first === undefined) plays.first = side;
            buttons[side].classList.add("felt");
            slider.disabled = plays[0] === 0 || plays[1] === 0;
            // The pause of the design lies between any two.
            setTimeout(() => buttons.forEach((button) => { button.disabled = false; }), 1000 * study.gap_s);
        });
    });
    return next;
}

function trial([left, right], index) {
    const plays = [0, 0];
    const a = Math.min(left, right);
    return {
        type: jsPsychHtmlSliderResponse,
        stimulus: '<p class="plays"><button type="button">left</button><button type="button">right</button></p>' +
            "<p>How alike do these two feel?</p>",
        labels: ["totally different", "totally the same"],
        min: 0, max: 100, step: 1, slider_start: 50, slider_width: 500,
        require_movement: true,
        button_label: "Next",
        data: { of_study: true },
        on_load: () => { if (!simulates) feel([left, right], plays); },
        on_finish: (data) => Object.assign(data, {
            participant,
            trial: index + 1,
            a: study.patterns[a],
            b: study.patterns[Math.max(left, right)],
            side: left === a ? "a" : "b",
            rating: data.response,
            response_s: data.rt / 1000,
            attention: left === right ? 1 : 0,
            plays_left: simulates ? 1 : plays[0],
            plays_right: simulates ? 1 : plays[1],
            felt_first: plays.first === undefined ? "NA" : (plays.first === 0) === (left === a) ? "a" : "b",
            at: new Date().toISOString().slice(0, 19) + "Z",
            device: "sound output of a browser, jsPsych",
            fingerprint: study.fingerprint,
            synthetic: simulates ? 1 : 0,
        }),
    };
}

const page = (text) => ({
    type: jsPsychHtmlButtonResponse,
    stimulus: text.split("\n").map((line) => { const p = document.createElement("p"); p.textContent = line; return p.outerHTML; }).join(""),
    choices: ["Continue"],
});

const timeline = [page(study.consent), page(study.instructions), ...study.participants[participant].map(trial)];
if (simulates) jsPsych.simulate(timeline, "data-only");
else jsPsych.run(timeline);
