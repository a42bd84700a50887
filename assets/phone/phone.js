// The phone's page of tactspace: it joins the computer whose address this is, plays what that sends
// by navigator.vibrate, and shows the cards that it sends.
//
// Protocol: POST join, next (a long poll) and tell, as JSON, all below this page's own address.
// Left out: browsers without navigator.vibrate show and answer, but play nothing.
// Parts: helpers, what is kept, player, computer, answers, pieces of cards, cards, what is shown,
// start.
"use strict";

// ---- helpers

const kMostEntries = 98;    // browsers take 99 a call: an even number ends in a silence
const kMostEntry_ms = 10000;  // and this much an entry
const kOwnPiece_ms = 1000;  // a piece of its own follows a silence this long: it keeps time better
const kTooLate_ms = 100;    // a play with a piece later than this was not felt as it is
const kLevel_ms = 120;      // the bar shows this much of the past: it must not flash
const kPoll_ms = 30000;     // the computer answers a poll within 20 s
const kAsk_ms = 8000;
const kAsleep_ms = 3000;    // a gap in the polls after which a play is an old one
const kTroubleText = "No answer from the computer; trying again";  // until the texts are there
const vibrates = typeof navigator.vibrate === "function";

const byId = (id) => document.getElementById(id);
const sum = (numbers) => numbers.reduce((total, number) => total + number, 0);

// Longer after each failure, and by chance, so that a room full of phones does not come at once.
function retryAfter_ms(failures) {
    return Math.min(8000, 500 * 2 ** failures) * (0.75 + 0.5 * Math.random());
}

// An element. Children that are strings become text nodes: no name or text is read as markup.
function make(tag, attributes = {}, ...children) {
    return filled(document.createElement(tag), attributes, children);
}

function makeSvg(tag, attributes = {}, ...children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    return filled(element, attributes, children);
}

function filled(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
        else element.setAttribute(name, value);
    }
    element.append(...children);
    return element;
}

// Screen readers tell of every change, so only changes are made.
function setText(element, text) {
    if (element.textContent !== text) element.textContent = text;
}

// Buttons keep the focus while they are locked, which "disabled" would take from them.
function setLocked(button, locked) {
    button.setAttribute("aria-disabled", String(Boolean(locked)));
}

// A pause that `wakeAll` ends early.
const sleepers = new Set();
function pause(ms) {
    return new Promise((resolve) => {
        const wake = () => {
            clearTimeout(timer);
            sleepers.delete(wake);
            resolve();
        };
        const timer = setTimeout(wake, ms);
        sleepers.add(wake);
    });
}
function wakeAll() {
    sleepers.forEach((wake) => wake());
}

// ---- what is kept

// Storage may be forbidden: then a reload is a new phone.
function recall(storage, name) {
    try {
        return window[storage].getItem(name);
    } catch {
        return null;
    }
}

function keep(storage, name, value) {
    try {
        if (value === null) window[storage].removeItem(name);
        else window[storage].setItem(name, value);
    } catch {
        // Only the reload suffers.
    }
}

// Of this visit to this address.
const nameHere = (name) => `tactspace ${location.pathname} ${name}`;
const recallHere = (name) => JSON.parse(recall("sessionStorage", nameHere(name)));
const keepHere = (name, value) => keep("sessionStorage", nameHere(name), JSON.stringify(value));
const forgetHere = (name) => keep("sessionStorage", nameHere(name), null);

const phone = {
    key: recallHere("key"),
    play: recallHere("play") || 0,
    card: 0,
    is_here: false,  // joined, and not closed
};
let texts = {};
let language = "en";

function say(name, values = {}) {
    return texts[name].replace(/\{(\w+)\}/g, (whole, value) => values[value]);
}

// ---- player

// One play at a time, made by startPlay. Its tag says whose it is: "window", or that of a button.
const player = {run: null, timer: 0, frame: 0};

// "On" stretches {at, on}; two without a silence between them are one.
function pulsesOf(ms) {
    const pulses = [];
    let at = 0;
    ms.forEach((time, k) => {
        const last = pulses[pulses.length - 1];
        if (k % 2 === 0 && time > 0) {
            if (last && last.at + last.on === at) last.on += time;
            else pulses.push({at, on: time});
        }
        at += time;
    });
    return pulses;
}

// No pulse longer than an entry may be.
function takenWhole(pulses) {
    return pulses.flatMap(({at, on}) => {
        const parts = [];
        for (let done = 0; done < on; done += kMostEntry_ms) {
            parts.push({at: at + done, on: Math.min(kMostEntry_ms, on - done)});
        }
        return parts;
    });
}

// Pieces {at, ms}, each for one call of navigator.vibrate at its own time. Silences before a piece
// are the timer's, since a leading 0 is played as a tick.
function piecesOf(pulses, total_ms) {
    const pieces = [];
    let silence_ms = Infinity;
    takenWhole(pulses).forEach((pulse, k, all) => {
        const end = k + 1 < all.length ? all[k + 1].at : total_ms;
        const isFull = pieces.length > 0 && pieces[pieces.length - 1].ms.length >= kMostEntries;
        if (isFull || silence_ms >= kOwnPiece_ms) pieces.push({at: pulse.at, ms: []});
        silence_ms = end - pulse.at - pulse.on;
        pieces[pieces.length - 1].ms.push(pulse.on, Math.min(silence_ms, kMostEntry_ms));
    });
    const last = pieces[pieces.length - 1];
    if (last && last.ms[last.ms.length - 1] === 0) last.ms.pop();
    return pieces;
}

function vibrate(ms) {
    return vibrates && navigator.vibrate(ms);
}

// `is_hidden`: no picture of the play is shown, since the eye must not tell patterns apart.
function startPlay(tag, ms, {loop = false, is_hidden = false, ended = () => {}} = {}) {
    stopPlay();
    const pulses = pulsesOf(ms);
    const total_ms = sum(ms);
    const run = {
        tag, ms, pulses, total_ms, is_hidden, ended,
        steps: [...piecesOf(pulses, total_ms), {at: total_ms}],
        loop: loop && total_ms > 0,
        begin_ms: performance.now(), round: 0, next: 0, is_felt: vibrates,
    };
    player.run = run;
    step(run);
    if (player.run) player.frame = requestAnimationFrame(drawLevel);
    refresh();
}

// Each piece is due at a time counted from the beginning, so that late timers do not add up.
function step(run) {
    while (player.run === run) {
        const due_ms = run.begin_ms + run.round * run.total_ms + run.steps[run.next].at;
        const wait_ms = due_ms - performance.now();
        if (wait_ms > 0) {
            player.timer = setTimeout(step, wait_ms, run);
            return;
        }
        takeStep(run, -wait_ms);
    }
}

function takeStep(run, late_ms) {
    const piece = run.steps[run.next++];
    if (piece.ms) {
        const isOver = piece.at + late_ms >= run.steps[run.next].at;
        const isFelt = !isOver && vibrate(piece.ms) && late_ms < kTooLate_ms;
        run.is_felt = run.is_felt && isFelt;
    } else if (run.loop) {
        run.next = 0;
        run.round += 1 + Math.floor(late_ms / run.total_ms);
    } else {
        endPlay(true);
    }
}

function endPlay(isWhole) {
    const run = player.run;
    if (!run) return;
    clearTimeout(player.timer);
    cancelAnimationFrame(player.frame);
    player.run = null;
    byId("level").style.transform = "scaleX(0)";
    if (shown.view.tick) shown.view.tick(run, 0);
    run.ended(isWhole && run.is_felt, isWhole);
    refresh();
}

function stopPlay() {
    if (player.run) vibrate(0);
    endPlay(false);
}

function isPlaying(tag) {
    return player.run !== null && player.run.tag === tag;
}

function togglePlay(tag, ms, options) {
    if (isPlaying(tag)) stopPlay();
    else startPlay(tag, ms, options);
}

function shareOn(pulses, from, to) {
    const on = pulses.map(({at, on}) => Math.max(0, Math.min(to, at + on) - Math.max(from, at)));
    return sum(on) / (to - from);
}

function drawLevel() {
    const run = player.run;
    if (!run) return;
    const time_ms = (performance.now() - run.begin_ms) % (run.loop ? run.total_ms : Infinity);
    const isCalm = run.is_hidden || matchMedia("(prefers-reduced-motion: reduce)").matches;
    const level = isCalm ? 1 : shareOn(run.pulses, time_ms - kLevel_ms, time_ms);
    byId("level").style.transform = `scaleX(${level.toFixed(3)})`;
    if (shown.view.tick) shown.view.tick(run, time_ms);
    player.frame = requestAnimationFrame(drawLevel);
}

// ---- computer

let poll = null;        // the AbortController of the long poll under way
let is_woken = false;   // that poll was ended by comeBack: there is no trouble
let is_in_trouble = false;
let notice = "";        // what the status line says for a while
let notice_timer = 0;

// {status, body}; throws if there is no answer in time.
async function ask(route, body, most_ms, abort = new AbortController()) {
    const timer = setTimeout(() => abort.abort(), most_ms);
    try {
        const response = await fetch(route, {
            method: "POST",
            headers: {"Content-Type": "application/json"},
            body: JSON.stringify(body),
            cache: "no-store",
            signal: abort.signal,
        });
        const {status} = response;
        return {status, body: status === 200 ? await response.json() : null};
    } finally {
        clearTimeout(timer);
    }
}

// As `ask`; status 0 says that there was no answer.
async function tryAsk(...request) {
    try {
        return await ask(...request);
    } catch {
        return {status: 0, body: null};
    }
}

function setTrouble(isTrouble) {
    is_in_trouble = isTrouble;
    showStatus();
}

function tellPerson(name, for_ms = 4000) {
    clearTimeout(notice_timer);
    notice = name;
    notice_timer = setTimeout(() => tellPerson(""), for_ms);
    showStatus();
}

function showStatus() {
    const name = is_in_trouble ? "trouble" : notice;
    setText(byId("status"), name ? say(name) : "");
    byId("status").classList.toggle("trouble", is_in_trouble);
}

// Polls until the phone is closed. `answered` is when it last knew all; Date.now() counts through
// sleep, which performance.now() may not.
async function follow(answered) {
    let failures = 0;
    while (phone.is_here) {
        const asked = Date.now();
        poll = new AbortController();
        const request = {phone: phone.key, card: phone.card, play: phone.play};
        const {status, body} = await tryAsk("next", request, kPoll_ms, poll);
        if (!phone.is_here || leaveOn(status)) return;
        if (status === 200) {
            const isOld = asked - answered > kAsleep_ms || Date.now() - asked > kPoll_ms;
            failures = 0;
            answered = Date.now();
            setTrouble(false);
            takeNews(body, isOld);
        } else if (!is_woken) {
            if (!document.hidden) setTrouble(true);
            if (failures > 0 && player.run?.loop) stopPlay();  // nobody could stop it
            await pause(retryAfter_ms(failures++));
        }
        is_woken = false;
    }
}

function takeNews({card, play}, isOld) {
    if (play.serial !== phone.play) takePlay(play, isOld);
    if (card.serial !== phone.card && card.kind) {
        if (card.id !== taken.card) taken = {};  // an id may come again in another round
        phone.card = card.serial;
        showCard(card);
    }
}

// A play that came while the phone slept is over by now, unless it loops.
function takePlay(play, isOld) {
    phone.play = play.serial;
    keepHere("play", play.loop ? 0 : play.serial);  // a reload repeats loops alone
    stopPlay();
    const isStop = play.stop || sum(play.ms) === 0;
    if (isStop) vibrate(0);
    if (isStop || (isOld && !play.loop)) return;
    startPlay("window", play.ms, {loop: play.loop});
    if (vibrates) tryAsk("tell", {phone: phone.key, played: play.serial}, kAsk_ms);
}

// Joins, or comes back as the same phone; false if the computer refuses.
async function join(nickname) {
    const request = {nickname, vibrates, language};
    if (phone.key) request.phone = phone.key;
    for (let failures = 0;; ++failures) {
        const {status, body} = await tryAsk("join", request, kAsk_ms);
        setTrouble(status === 0 || (status >= 500 && status !== 503));
        if (status === 200) return takeJoined(body);
        if (leaveOn(status)) return false;
        if (!is_in_trouble) {
            tellPerson(status === 503 ? "full" : "not_joined", 8000);
            return false;
        }
        await pause(retryAfter_ms(failures));
    }
}

function takeJoined(joined) {
    if (joined.phone !== phone.key) phone.play = 0;
    phone.key = joined.phone;
    phone.is_here = true;
    keepHere("key", phone.key);
    setText(byId("who"), `${joined.nickname} · ${joined.number}`);
    return true;
}

// 410: the computer has closed this phone; 404: the address is no longer valid.
function leaveOn(status) {
    if (status !== 410 && status !== 404) return false;
    leave(status === 410 ? "closed_title" : "gone_title");
    return true;
}

function leave(title) {
    stopPlay();
    phone.is_here = false;
    phone.key = null;
    ["key", "play", "answers", "taken"].forEach(forgetHere);
    const lost = answers.length > 0;
    answers.length = 0;
    setTrouble(false);
    tellPerson("");
    showView("left", leftView(title, lost));
    wakeAll();
    if (poll) poll.abort();
}

// ---- answers

// Those that the computer has not taken yet, [{card, answer}], and the last one that it took, which
// its cards may not tell of yet. Both outlive a reload.
const answers = recallHere("answers") || [];
let taken = recallHere("taken") || {};
let is_delivering = false;

const isSending = (id) => answers.some(({card}) => card === id);

// The last answer to a card, whether it has arrived or not.
function lastAnswer(id) {
    const found = [taken, ...answers].filter(({card}) => card === id).pop();
    return found && found.answer;
}

function submit(card, answer) {
    answers.push({card, answer});
    keepHere("answers", answers);
    refresh();
    deliver();
}

// One after the other, each until the computer has taken or refused it.
async function deliver() {
    if (is_delivering) return;
    is_delivering = true;
    const slow = setTimeout(() => tellPerson("sending", kAsk_ms), 400);
    for (let failures = 0; answers.length > 0 && phone.is_here;) {
        const {status} = await tryAsk("tell", {phone: phone.key, ...answers[0]}, kAsk_ms);
        if (!phone.is_here || leaveOn(status)) break;
        if (status >= 200 && status < 500 && status !== 429) {
            settle(status);
            failures = 0;
        } else {
            if (status !== 429) setTrouble(true);
            await pause(retryAfter_ms(failures++));
        }
    }
    clearTimeout(slow);
    is_delivering = false;
}

function settle(status) {
    const {card, answer} = answers.shift();
    if (status === 204) taken = {card, answer};
    keepHere("answers", answers);
    keepHere("taken", taken);
    setTrouble(false);
    if (status === 204) tellPerson("sent", 2000);
    else tellPerson(status === 409 ? "too_late" : "refused", 8000);
    if (shown.view.settled && shown.view.id === card) shown.view.settled(answer, status === 204);
    refresh();
}

// ---- pieces of cards

const kIcons = {
    play: "M8 5v14l11-7z",
    stop: "M7 7h10v10H7z",
    check: "M9.5 16.2 5.3 12l-1.4 1.4 5.6 5.6 11-11-1.4-1.4z",
};

function icon(name) {
    return makeSvg("svg", {class: `icon ${name}`, viewBox: "0 0 24 24", "aria-hidden": "true"},
        makeSvg("path", {d: kIcons[name]}));
}

// Each card has one, which takes the focus when the card comes.
function heading(text) {
    return make("h1", {tabindex: "-1"}, text);
}

function paragraph(text, kind = "") {
    return make("p", {class: kind}, text);
}

function button(attributes, pressed, ...children) {
    const made = make("button", {type: "button", ...attributes}, ...children);
    made.addEventListener("click", () => {
        if (made.getAttribute("aria-disabled") !== "true") pressed();
    });
    return made;
}

// On and off over time; `span_ms` is the width. `drawing.show(time_ms)` puts the mark of now.
function drawingOf(ms, span_ms = sum(ms)) {
    const on = pulsesOf(ms).map(({at, on}) => `M${at} 0h${on}v10h${-on}z`).join("");
    const now = makeSvg("path", {class: "now", d: "M0 0v10", visibility: "hidden"});
    const size = {viewBox: `0 0 ${Math.max(1, span_ms)} 10`, preserveAspectRatio: "none"};
    const drawing = makeSvg("svg", {class: "drawing", "aria-hidden": "true", ...size},
        makeSvg("path", {class: "ground", d: `M0 10H${sum(ms)}`}),
        makeSvg("path", {class: "on", d: on}), now);
    drawing.show = (time_ms) => {
        now.setAttribute("visibility", time_ms > 0 ? "visible" : "hidden");
        now.setAttribute("transform", `translate(${time_ms} 0)`);
    };
    return drawing;
}

const columnsOf = (parts) => make("div", {class: "columns"}, ...parts.map(({element}) => element));

// A button to feel a pattern by, without a picture of it. `feel.plays` counts the whole ones.
function feelButton(tag, text, ms) {
    const label = say("feel_one", {n: text});
    const feel = {ms, plays: 0, element: button({class: "feel"}, play, make("span", {}, text),
        make("span", {class: "mark"}, icon("play"), icon("stop"), icon("check")))};
    function play() {
        const ended = (isFelt, isWhole) => countPlay(feel, isFelt, isWhole);
        togglePlay(tag, feel.ms, {is_hidden: true, ended});
    }
    feel.refresh = (isLocked) => {
        const isFelt = feel.plays > 0;
        feel.element.classList.toggle("playing", isPlaying(tag));
        feel.element.classList.toggle("felt", isFelt);
        feel.element.setAttribute("aria-pressed", String(isPlaying(tag)));
        feel.element.setAttribute("aria-label", isFelt ? `${label}, ${say("felt")}` : label);
        setLocked(feel.element, isLocked);
    };
    return feel;
}

// What was felt whole counts; what was not is said.
function countPlay(feel, isFelt, isWhole) {
    if (isFelt) feel.plays += 1;
    else if (feel.plays === 0) tellPerson(isWhole ? "not_felt" : "cut_short");
}

function progressOf(at, of) {
    const words = make("p", {class: "words", "aria-live": "polite"});
    const done = make("div", {class: "done"});
    const line = make("div", {class: "line"}, done);
    function show(at_now) {
        setText(words, say("progress", {at: at_now, of}));
        done.style.width = `${100 * at_now / Math.max(1, of)}%`;
    }
    show(at);
    return {element: make("div", {class: "progress"}, words, line), show};
}

// ---- cards

// A view is {about, controls} and, as it needs them: id; refresh() after any change; tick(run,
// time_ms) while a play runs; take(card) for the same card with other news; settled(answer,
// isTaken) for an answer to it.
const cards = new Map(Object.entries({
    wait: waitView,
    feel: feelView,
    choice: choiceView,
    trial: (card) => vibrates ? trialView(card) : cannotFeelView(),
    rating: (card) => vibrates ? ratingView(card) : cannotFeelView(),
    thanks: (card) => messageView(bigCheck(), say("thanks_title"), card.text || ""),
}));

function viewOf(card) {
    try {
        return (cards.get(card.kind) || waitView)(card);
    } catch {
        return waitView();  // a card that is not understood
    }
}

// A card of words alone, in the middle.
function messageView(picture, title, ...paragraphs) {
    const words = paragraphs.map((text) => paragraph(text));
    return {about: [picture, heading(title), ...words], controls: []};
}

function cannotFeelView() {
    return messageView(idlePicture(), say("cannot_feel_title"), say("cannot_feel"));
}

function leftView(title, isLost) {
    return messageView(idlePicture(), say(title), say("closed"), ...(isLost ? [say("lost")] : []));
}

function waitView() {
    const stage = make("div", {class: "stage"});
    const stop = button({class: "wide"}, stopPlay, icon("stop"), say("stop"));
    let drawn = null;
    const words = vibrates ? ["wait_text", "wait_hint"] : ["wait_picture"];
    return {
        about: [heading(say("wait_title")), ...words.map((name) => paragraph(say(name), name))],
        controls: [stage, stop],
        refresh() {
            const run = player.run;
            setLocked(stop, !run);
            if (drawn === run && stage.firstChild) return;
            drawn = run;
            stage.replaceChildren(run ? drawingOf(run.ms) : idlePicture());
        },
        tick(run, time_ms) {
            if (drawn === run && stage.firstChild.show) stage.firstChild.show(time_ms);
        },
    };
}

function idlePicture() {
    return makeSvg("svg", {class: "idle", viewBox: "0 0 96 48", "aria-hidden": "true"},
        makeSvg("rect", {x: 37, y: 5, width: 22, height: 38, rx: 4}),
        makeSvg("path", {d: "M45 38h6"}),
        makeSvg("path", {class: "wave", d: "M29 16q-4 8 0 16M67 16q4 8 0 16"}),
        makeSvg("path", {class: "wave far", d: "M21 12q-6 12 0 24M75 12q6 12 0 24"}));
}

function bigCheck() {
    return make("div", {class: "felt big"}, icon("check"));
}

function feelView(card) {
    const span_ms = Math.max(...card.patterns.map(({ms}) => sum(ms)));  // one scale of time for all
    const rows = card.patterns.map((pattern, k) => feelRow(pattern, `feel ${k}`, span_ms));
    const text = say(vibrates ? "feel_text" : "feel_picture");
    return {
        about: [heading(say("feel_title")), paragraph(text)],
        controls: [make("ul", {}, ...rows.map(({element}) => make("li", {}, element)))],
        refresh: () => rows.forEach((row) => row.refresh()),
        tick: (run, time_ms) => rows.forEach((row) => row.tick(run, time_ms)),
    };
}

function feelRow({name, ms, loss}, tag, span_ms) {
    const drawing = drawingOf(ms, span_ms);
    const element = button({class: "row"}, () => togglePlay(tag, ms),
        make("span", {class: "mark"}, icon("play"), icon("stop")),
        make("span", {class: "what"}, make("span", {class: "name"}, name), drawing,
            ...(loss ? [make("span", {class: "loss"}, loss)] : [])));
    return {
        element,
        refresh() {
            element.classList.toggle("playing", isPlaying(tag));
            element.setAttribute("aria-pressed", String(isPlaying(tag)));
        },
        tick: (run, time_ms) => drawing.show(run.tag === tag ? time_ms : 0),
    };
}

function choiceView(card) {
    const sent = lastAnswer(card.id);
    let mine = sent ? sent.option : card.mine;
    const options = card.options.map((text, k) => optionButton(text, () => choose(k)));
    const hint = paragraph("", "small");
    const result = make("p", {"aria-live": "polite"});
    const pattern = {name: say("feel_it"), ms: card.ms};
    const feels = card.ms ? [feelRow(pattern, "choice", sum(card.ms))] : [];
    function choose(option) {
        if (option === mine) return;
        mine = option;
        submit(card.id, {option});
    }
    return {
        id: card.id,
        about: [heading(card.ask), hint, result],
        controls: [...feels, ...options].map(({element}) => element),
        refresh() {
            const {revealed} = card;
            setText(hint, revealed ? say("votes", {n: sum(revealed.votes)}) : say("choice_hint"));
            setText(result, (revealed && revealed.text) || "");
            options.forEach((option, k) => option.show(k, mine, revealed));
            options.forEach(({element}) => setLocked(element, revealed || isSending(card.id)));
            feels.forEach((feel) => feel.refresh());
        },
        tick: (run, time_ms) => feels.forEach((feel) => feel.tick(run, time_ms)),
        take(next) {
            card = next;
            if (Number.isInteger(next.mine) && !isSending(next.id)) mine = next.mine;
        },
        settled(answer, isTaken) {
            if (!isTaken) mine = card.mine;
        },
    };
}

// Its mark, chips and tally have their room from the beginning: nothing moves when they come.
function optionButton(text, pressed) {
    const bar = make("span", {class: "bar", "aria-hidden": "true"});
    const chips = make("span", {class: "chips"});
    const votes = make("span", {class: "votes"});
    const element = button({class: "option"}, pressed, bar,
        make("span", {class: "mark"}, icon("check")),
        make("span", {class: "text"}, text, chips), votes);
    function show(k, mine, revealed) {
        const isMine = k === mine;
        const isRight = Boolean(revealed) && revealed.right.includes(k);
        const said = [isRight && say("right_answer"), isMine && say("your_answer")];
        element.setAttribute("aria-pressed", String(isMine));
        element.classList.toggle("mine", isMine);
        element.classList.toggle("right", isRight);
        element.classList.toggle("revealed", Boolean(revealed));
        setText(chips, said.filter(Boolean).join(" · "));
        setText(votes, revealed ? String(revealed.votes[k]) : "");
        const share = revealed ? revealed.votes[k] / Math.max(1, sum(revealed.votes)) : 0;
        bar.style.width = `${100 * share}%`;
    }
    return {element, show};
}

function trialView(card) {
    const begin_ms = performance.now();
    let is_answered = Boolean(lastAnswer(card.id));
    const feels = card.ms.map((ms, k) => feelButton(`trial ${k}`, String(k + 1), ms));
    const choices = card.ms.map((ms, k) => pickButton(String(k + 1), () => choose(k)));
    function choose(option) {
        is_answered = true;
        choices[option].element.classList.add("mine");
        stopPlay();
        const response_ms = Math.round(performance.now() - begin_ms);
        submit(card.id, {option, response_ms, plays: feels.map(({plays}) => plays)});
    }
    return {
        id: card.id,
        about: [progressOf(card.at, card.of).element, heading(say("trial_title"))],
        controls: [
            make("h2", {}, say("trial_feel")), columnsOf(feels),
            make("h2", {}, say("trial_answer")), columnsOf(choices),
        ],
        refresh() {
            const isOpen = !is_answered && feels.every(({plays}) => plays > 0);
            feels.forEach((feel) => feel.refresh(is_answered));
            choices.forEach(({element}) => setLocked(element, !isOpen));
        },
        settled(answer, isTaken) {
            if (isTaken) return;
            is_answered = false;
            choices[answer.option].element.classList.remove("mine");
        },
    };
}

function pickButton(text, pressed) {
    const attributes = {class: "pick", "aria-label": say("trial_answer_one", {n: text})};
    return {element: button(attributes, pressed, text)};
}

function ratingView(card) {
    const {id, patterns, trials} = card;
    const last = lastAnswer(id);
    let k = Math.max(card.done, !last ? 0 : isSending(id) ? last.k : last.k + 1);
    if (k >= trials.length) return ratedView(id);
    let first = null;
    let begin_ms = 0;
    const feels = ["left", "right"].map((side) => {
        const feel = feelButton(side, say(side), []);
        feel.element.addEventListener("click", () => first = first || side);
        return feel;
    });
    const scale = similarityScale();
    const next = button({class: "wide primary"}, send, say("next"));
    const progress = progressOf(k + 1, trials.length);
    const hint = paragraph(say("rating_text"), "small");
    function send() {
        const response_ms = Math.round(performance.now() - begin_ms);
        const plays = feels.map((feel) => feel.plays);
        stopPlay();
        submit(id, {k, similarity: scale.value(), plays, first, response_ms});
    }
    function begin(next_k) {
        if (next_k >= trials.length) return showView(shown.key, ratedView(id));
        k = next_k;
        first = null;
        begin_ms = performance.now();
        feels.forEach((feel, side) => {
            feel.plays = 0;
            feel.ms = patterns[trials[k][side]].ms;
        });
        scale.clear();
        progress.show(k + 1);
    }
    begin(k);
    return {
        id,
        about: [progress.element, heading(say("rating_title")), hint],
        controls: [columnsOf(feels), scale.element, next],
        refresh() {
            const isOpen = feels.every(({plays}) => plays > 0) && !isSending(id);
            feels.forEach((feel) => feel.refresh(isSending(id)));
            scale.setOpen(isOpen);
            setLocked(next, !isOpen || scale.value() === null);
        },
        take(news) {
            if (news.done > k && !isSending(id)) begin(news.done);
        },
        settled(answer, isTaken) {
            if (isTaken && answer.k === k) begin(k + 1);
        },
    };
}

function ratedView(id) {
    return {id, ...messageView(bigCheck(), say("rating_done_title"), say("rating_done"))};
}

// A line from totally different, 0, to the same, 100, without a value until it is touched, as a
// beginning would be an anchor. Keys 0 to 9, Home and End put it; arrows only move what was put.
function similarityScale() {
    let value = null;
    const line = make("input", {type: "range", min: 0, max: 100, "aria-label": say("similarity")});
    const number = make("output", {class: "value", "aria-hidden": "true"});
    function put(similarity) {
        value = similarity;
        const text = value === null ? "–" : String(value);
        line.value = value === null ? 50 : value;
        line.classList.toggle("untouched", value === null);
        line.style.setProperty("--value", `${value || 0}%`);
        line.setAttribute("aria-valuetext", value === null ? say("similarity_none") : text);
        setText(number, text);
    }
    function touched(similarity) {
        put(similarity);
        refresh();
    }
    line.addEventListener("input", () => touched(Number(line.value)));
    line.addEventListener("pointerup", () => {  // a touch in the middle is no input
        if (!line.disabled) touched(Number(line.value));
    });
    line.addEventListener("keydown", (event) => takeScaleKey(event, value, touched));
    const ends = ["different", "same"].map((name) => make("span", {}, say(name)));
    return {
        element: make("div", {class: "scale"}, number, line,
            make("div", {class: "ends", "aria-hidden": "true"}, ...ends)),
        value: () => value,
        clear: () => put(null),
        setOpen: (isOpen) => line.disabled = !isOpen,
    };
}

function takeScaleKey(event, value, put) {
    const ends = {Home: 0, End: 100};
    if (/^[0-9]$/.test(event.key)) put(10 * Number(event.key));
    else if (event.key in ends) put(ends[event.key]);
    else if (value !== null || event.key === "Tab") return;
    if (event.key !== "Tab") event.preventDefault();
}

// ---- what is shown

const shown = {key: "", view: {}};

// The same card with other news (a tally, a count) changes what is on the screen; another one takes
// its place.
function showCard(card) {
    const {serial, mine, revealed, done, ...rest} = card;
    const key = JSON.stringify(rest);
    if (key !== shown.key) showView(key, viewOf(card));
    else if (shown.view.take) shown.view.take(card);
    refresh();
}

function showView(key, view) {
    if (player.run && player.run.tag !== "window") {
        player.run.ended = () => {};  // its card is gone
        stopPlay();
    }
    shown.key = key;
    shown.view = view;
    byId("about").replaceChildren(...view.about);
    byId("controls").replaceChildren(...view.controls);
    document.body.classList.toggle("alone", view.controls.length === 0);
    window.scrollTo(0, 0);
    byId("about").querySelector("h1").focus({preventScroll: true});
    refresh();
}

function refresh() {
    if (shown.view.refresh) shown.view.refresh();
}

// ---- start

function startView() {
    const field = make("input", {
        id: "nickname", type: "text", maxlength: 24, autocomplete: "nickname", spellcheck: "false",
        enterkeyhint: "go", value: recall("localStorage", "tactspace nickname") || "",
    });
    const words = say(phone.key ? "continue" : "start");
    const start = make("button", {type: "submit", class: "wide primary"}, words);
    const form = make("form", {}, make("label", {for: "nickname"}, say("nickname")), field, start);
    form.addEventListener("submit", (event) => {
        event.preventDefault();
        if (start.getAttribute("aria-disabled") !== "true") begin(field, start);
    });
    const below = vibrates ? idlePicture() : cannotVibrate();
    const kept = paragraph(say("kept"), "small");
    return {about: [heading(say("start_title")), below], controls: [form, kept]};
}

function cannotVibrate() {
    const names = ["no_vibration", "no_vibration_android", "no_vibration_iphone"];
    return make("div", {class: "notice"}, ...names.map((name) => paragraph(say(name))));
}

// Called by the tap on Start: browsers let a page vibrate only after one. Its pulse shows that it
// works.
async function begin(field, start) {
    const nickname = field.value.trim();
    if (!nickname) {
        tellPerson("nickname_missing");
        field.focus();
        return;
    }
    vibrate(30);
    keep("localStorage", "tactspace nickname", nickname);
    setLocked(start, true);
    tellPerson("joining", kAsk_ms);
    const known = phone.key;
    const isJoined = await join(nickname);
    setLocked(start, false);
    if (!isJoined || !phone.is_here) return;
    tellPerson("");
    stayAwake();
    showCard({kind: "wait"});
    deliver();
    follow(phone.key === known ? 0 : Date.now());
}

// Only a secure page may: most phones will sleep, and come back.
function stayAwake() {
    if (!phone.is_here || !navigator.wakeLock) return;
    navigator.wakeLock.request("screen").catch(() => {});
}

function comeBack() {
    wakeAll();
    if (!poll) return;
    is_woken = true;
    poll.abort();  // its connection may be dead without telling
}

let hidden_since = 0;
function followVisibility() {
    if (document.hidden) {
        hidden_since = Date.now();
        if (player.run) player.run.is_felt = false;  // browsers stop it
        return;
    }
    stayAwake();
    if (Date.now() - hidden_since > kAsleep_ms) comeBack();
}

async function loadTexts() {
    for (let failures = 0;; ++failures) {
        try {
            const response = await fetch("texts.json", {cache: "no-store"});
            if (response.ok) return await response.json();
        } catch {
            // Tried again below.
        }
        setText(byId("status"), kTroubleText);
        await pause(retryAfter_ms(failures));
    }
}

function languageOf(known) {
    const wanted = navigator.languages.map((tag) => tag.slice(0, 2).toLowerCase());
    return wanted.find((tag) => known.includes(tag)) || "en";
}

async function main() {
    document.addEventListener("visibilitychange", followVisibility);
    window.addEventListener("online", comeBack);
    window.addEventListener("pagehide", stopPlay);
    const all = await loadTexts();
    language = languageOf(Object.keys(all));
    texts = all[language];
    document.documentElement.lang = language;
    showStatus();
    showView("start", startView());
}

main();
