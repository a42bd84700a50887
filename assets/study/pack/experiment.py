"""One participant's trials with PsychoPy: both vibrations of a pair, then a slider.

    python experiment.py P01               one of the participants of study.json
    python experiment.py P01 --simulate    answers that nobody gave, marked synthetic; needs no PsychoPy

Writes answers/NAME.csv, line by line, so that nothing is lost; "tactspace study SET --unpack" reads it.
"""

import csv
import datetime
import json
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ["participant", "trial", "a", "b", "side", "rating", "response_s", "attention", "plays_left",
           "plays_right", "felt_first", "at", "device", "fingerprint", "synthetic"]


def trials_of(participant, study):
    if participant not in study["participants"]:
        sys.exit(f"{participant}: expected one of the participants {', '.join(study['participants'])}")
    names, files = study["patterns"], study["files"]
    return [{"participant": participant, "trial": number, "left": names[left], "right": names[right],
             "left_file": files[left], "right_file": files[right]}
            for number, (left, right) in enumerate(study["participants"][participant], 1)]


def answer_of(trial, study, given):
    """A line of the answers; `given`: rating, response_s, plays_left, plays_right, first ("left", ..)."""
    left, right = trial["left"], trial["right"]
    a, b = sorted((left, right), key=study["patterns"].index)
    first = {"left": left, "right": right}.get(given["first"])
    return {"participant": trial["participant"], "trial": trial["trial"], "a": a, "b": b,
            "side": "a" if left == a else "b", "rating": given["rating"],
            "response_s": round(given["response_s"], 3), "attention": int(left == right),
            "plays_left": given["plays_left"], "plays_right": given["plays_right"],
            "felt_first": "NA" if first is None else "a" if first == a else "b",
            "at": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
            "device": "sound output, PsychoPy", "fingerprint": study["fingerprint"],
            "synthetic": int(given.get("synthetic", False))}


def simulated(trial):
    same = trial["left"] == trial["right"]
    return {"rating": random.randint(90, 100) if same else random.randint(0, 100), "response_s": 4.0,
            "plays_left": 1, "plays_right": 1, "first": "left", "synthetic": True}


class Window:
    """The screen: two buttons, a slider that waits until both were felt to their end, and Next."""

    def __init__(self, study):
        from psychopy import core, event, sound, visual
        self.core, self.event, self.sound = core, event, sound
        self.study = study
        self.window = visual.Window(units="height", color="black")
        self.buttons = [visual.ButtonStim(self.window, text=side, pos=(x, 0.2), size=(0.3, 0.12))
                        for side, x in (("left", -0.25), ("right", 0.25))]
        self.question = visual.TextStim(self.window, "How alike do these two feel?", height=0.04, pos=(0, 0.05))
        self.slider = visual.Slider(self.window, ticks=(0, 100), labels=("totally different", "totally the same"),
                                    pos=(0, -0.1), size=(0.9, 0.05), granularity=1)
        self.next = visual.ButtonStim(self.window, text="Next", pos=(0, -0.35), size=(0.25, 0.1))

    def show(self, text):
        from psychopy import visual
        visual.TextStim(self.window, text + "\n\n[space]", height=0.035, wrapWidth=1.2).draw()
        self.window.flip()
        self.event.waitKeys(keyList=["space"])

    def ask(self, trial):
        sounds = [self.sound.Sound(str(HERE / "stimuli" / trial[side + "_file"])) for side in ("left", "right")]
        plays, first, clock = [0, 0], None, self.core.Clock()
        self.slider.reset()
        while True:
            if "escape" in self.event.getKeys():
                self.core.quit()
            for side, button in enumerate(self.buttons):
                button.draw()
                if button.isClicked and not button.wasClicked:
                    sounds[side].play()
                    self.core.wait(sounds[side].getDuration() + self.study["gap_s"])
                    plays[side] += 1
                    first = first or ("left", "right")[side]
                button.wasClicked = button.isClicked
            if all(plays):
                self.question.draw()
                self.slider.draw()
            if all(plays) and self.slider.getRating() is not None:
                self.next.draw()
                if self.next.isClicked:
                    return {"rating": self.slider.getRating(), "response_s": clock.getTime(), "plays_left": plays[0],
                            "plays_right": plays[1], "first": first}
            self.window.flip()


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    study = json.loads((HERE / "study.json").read_text(encoding="utf-8"))
    trials = trials_of(sys.argv[1], study)
    window = None if "--simulate" in sys.argv else Window(study)
    if window:
        window.show(study["consent"])
        window.show(study["instructions"])
    out = HERE / "answers" / f"{sys.argv[1]}.csv"
    out.parent.mkdir(exist_ok=True)
    # Never over answers that somebody gave.
    with open(out, "x", newline="", encoding="utf-8") as stream:
        lines = csv.DictWriter(stream, COLUMNS)
        lines.writeheader()
        for trial in trials:
            lines.writerow(answer_of(trial, study, window.ask(trial) if window else simulated(trial)))
            stream.flush()


if __name__ == "__main__":
    main()
