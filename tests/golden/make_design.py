"""Writes design.json, beside this script: Sobol's sequence, necklaces, evenness of rhythms.

Source   scipy.stats.qmc.Sobol(scramble=False), whose direction numbers are those of Joe & Kuo
         2008; plain enumeration of all rhythms and their rotations; numpy.fft.
What     sobol: points of 32 dimensions, by their position in the sequence.
         necklaces: for every length and number of notes, the rotations that begin with a note, of
         every rhythm up to rotation the one with the longest gaps first ("-" before "x").
         counts: how many there are, of lengths too long for a list.
         evenness: |first coefficient of the DFT of the onsets' places on a circle| / notes.
Run      python3 tests/golden/make_design.py
"""
import itertools
import json
import math
import pathlib
import sys

import numpy as np
import scipy
from scipy.stats import qmc


def sobol():
    points = qmc.Sobol(32, scramble=False).random_base2(13)
    places = list(range(20)) + [100, 1023, 1024, 4095, 8191]
    return {str(k): [float(v) for v in points[k]] for k in places}


def necklaces(steps, notes):
    found = set()
    for onsets in itertools.combinations(range(steps), notes):
        text = "".join("x" if k in onsets else "-" for k in range(steps))
        rotations = [text[k:] + text[:k] for k in range(steps)]
        found.add(min(r for r in rotations if r[0] == "x"))
    return sorted(found)


def count(steps, notes):
    """Rhythms as bits, each counted where it is the least of its rotations."""
    total = 0
    mask = (1 << steps) - 1
    for onsets in itertools.combinations(range(steps), notes):
        bits = sum(1 << k for k in onsets)
        total += all(bits <= (((bits << k) | (bits >> (steps - k))) & mask)
                     for k in range(1, steps))
    return total


def evenness(text):
    onsets = np.array([k for k, mark in enumerate(text) if mark == "x"])
    points = np.exp(2j * np.pi * onsets / len(text))
    return float(abs(np.fft.fft(points)[1 % len(onsets)]) / len(onsets))


rhythms = ["x", "x---", "x-x-", "xx--", "x--x--x-", "xxx-----", "x=-x=-x-", "x--x-", "-x-xx--",
           "x-xx-x-xx-x-", "xxxxx"]
golden = {
    "made_by": f"Python {sys.version.split()[0]}, NumPy {np.__version__}, SciPy {scipy.__version__}",
    "sobol": sobol(),
    "necklaces": {f"{n},{k}": necklaces(n, k) for n in range(1, 10) for k in range(1, n + 1)},
    "counts": {f"{n},{k}": count(n, k) for n, k in [(12, 5), (16, 4), (16, 5), (16, 8), (18, 6)]},
    "evenness": {text: evenness(text) for text in rhythms},
}
assert all(math.isfinite(v) for v in golden["evenness"].values())
path = pathlib.Path(__file__).with_name("design.json")
path.write_text(json.dumps(golden, separators=(",", ":")) + "\n")
print(f"wrote {path} with {path.stat().st_size} bytes")
