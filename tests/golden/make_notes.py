"""Writes notes.json: rhythms whose notes have strengths and pitches of their own, as samples.

Source   the equation at the head of model/pattern/pattern.h, with r(t) of a note times its velocity, and
         F(t) the integral of 150 Hz times the pitch of the last note that began;
         written for reading in NumPy, without a look at the C++ code.
What     rhythm, step, ramps, duration, kinds of notes (velocity, pitch), and of the rendered pattern (1 g, 150 Hz and 220 Hz at half the
         weight, 10 kHz) every 61st sample, the sum of squares and the number of samples.
Run      python3 tests/golden/make_notes.py
Needs    Python 3.11, NumPy 1.24.
"""

import json
import pathlib
import platform

import numpy as np

RATE_HZ = 10_000
CASES = [("9=5-", 0.125, 0.0, 0.0, 1.0, {}), ("x1=3--7=", 0.05, 0.01, 0.02, 0.93, {}),
         ("2468", 0.25, 0.3, 0.0, 1.0, {}), ("-5==", 0.1, 0.0, 0.05, 0.37, {}),
         ("A=B-", 0.125, 0.0, 0.0, 1.0, {"A": [0.37, 1.0], "B": [1.0, 0.5]}),
         ("-xA=-Z5B", 0.06, 0.01, 0.02, 0.83, {"A": [0.8, 1.5], "B": [0.25, 1 / 3], "Z": [1.0, 1.25]})]


def notes(text, unit_s, duration_s, kinds):
    """Onset, end, velocity and pitch of each note; the text repeats, the last note is cut."""
    found = []
    for step in range(int(np.ceil(duration_s / unit_s - 1e-9))):
        mark = text[step % len(text)]
        end_s = min((step + 1) * unit_s, duration_s)
        if mark == "=":
            found[-1][1] = end_s
        elif mark != "-":
            digit = [int(mark) / 9, 1.0] if mark.isdigit() else [1.0, 1.0]
            found.append([step * unit_s, end_s, *kinds.get(mark, digit)])
    return found


def turns(t_s, found):
    """Turns of a carrier of 1 Hz since 0 s; before the first note its pitch counts."""
    total = t_s * found[0][3]
    for (_, _, _, before), (onset_s, _, _, pitch) in zip(found, found[1:]):
        total = total + np.maximum(t_s - onset_s, 0.0) * (pitch - before)
    return total


def samples(text, unit_s, attack_s, release_s, duration_s, kinds):
    count = round(duration_s * RATE_HZ)
    n = np.arange(count)
    t_s = n / RATE_HZ
    found = notes(text, unit_s, duration_s, kinds)
    one_hz = turns(t_s, found)
    tone = np.sin(2 * np.pi * 150 * one_hz) + 0.5 * np.sin(2 * np.pi * 220 * one_hz)
    gate = np.zeros(count)
    for onset_s, end_s, velocity, _ in found:
        begin, end = round(onset_s * RATE_HZ), min(round(end_s * RATE_HZ), count)
        inside = (n >= begin) & (n < end)
        gain = np.ones(count)
        if attack_s > 0:
            gain = np.minimum(gain, (n - begin) / RATE_HZ / attack_s)
        if release_s > 0:
            gain = np.minimum(gain, (end - n) / RATE_HZ / release_s)
        gate[inside] = velocity * gain[inside]
    return gate * tone


rows = []
for case in CASES:
    text, unit_s, attack_s, release_s, duration_s, kinds = case
    wave = samples(*case)
    rows.append({"rhythm": text, "unit_s": unit_s, "attack_s": attack_s, "release_s": release_s,
                 "duration_s": duration_s, "kinds": kinds, "samples": len(wave), "squares": float(np.sum(wave**2)),
                 "every_61st": wave[::61].tolist()})
path = pathlib.Path(__file__).with_name("notes.json")
made_by = {"python": platform.python_version(), "numpy": np.__version__}
path.write_text(json.dumps({"made_by": made_by, "notes": rows}, indent=1) + "\n")
