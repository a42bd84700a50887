"""Writes training.json: rho of PM with ratings at points of the grid of trained parameters.

Source   reference_model.py beside this file (spikes), predictions.json (OC), scipy.stats.spearmanr.
What     ratings with ties and pairs that nobody rated, of two sets; at points drawn from the grid
         Spearman's rho of each set, null where PM has no order. NC and PM are compared as whole
         numbers of squared tenths and of half ranks times tenths, so ties are exact.
Run      python3 tests/golden/make_training.py
"""

import json
import pathlib
import platform
import sys

sys.dont_write_bytecode = True

import numpy as np
import scipy
from scipy import stats

import make_golden
import reference_model as model

FOLDER = pathlib.Path(__file__).parent
SETS = {"am-8-5Hz": make_golden.am_patterns(5), "rhythm-6": make_golden.rhythm_patterns()}
LAYERS = [(3, 1), (0, 0), (4, 4), (1, 0), (2, 3), (0, 2)]
POINTS_PER_LAYERS = 12


def linear_congruential(seed):
    """The generator of reference_model.noise_g, as whole numbers."""
    while True:
        seed = (1664525 * seed + 1013904223) % 2**32
        yield seed >> 16


def ratings(pairs, seed):
    """Few levels, so with many ties; every ninth pair is not rated."""
    numbers = linear_congruential(seed)
    return [None if k % 9 == 4 else int(next(numbers) % 12) for k in range(pairs)]


def central_signals(patterns, layers):
    """Spikes of the four central neurons of every pattern, 0 or 1."""
    params = model.Params(L_E=layers[0], L_I=layers[1])
    waveforms_g = model.padded_to_longest([model.render_g(p) for p in patterns.values()])
    coded = [model.neural_coding(x, params) for x in waveforms_g]
    return [np.array([c.channels[name].signal for name in model.CHANNELS]).astype(np.int64)
            for c in coded]


def rho(signals, oc, rated, channels, nc_weight, oc_weight):
    """Spearman's rho with the known ratings; None where either side has no order."""
    brain = [np.array(channels) @ s for s in signals]
    squared = model.condensed(brain, lambda a, b: int(np.sum((a - b) ** 2)))
    twice_nc = 2 * stats.rankdata(squared)
    twice_oc = 2 * model.average_ranks(oc)
    pm = nc_weight * twice_nc + oc_weight * twice_oc
    known = [k for k, value in enumerate(rated) if value is not None]
    if len(set(pm[known])) < 2:
        return None
    return float(stats.spearmanr(pm[known], [rated[k] for k in known])[0])


def main():
    predictions = json.loads((FOLDER / "predictions.json").read_text())
    oc = {s["name"]: next(r["oc"] for r in s["results"] if not r["params"])
          for s in predictions["sets"]}
    people = {name: ratings(len(oc[name]), seed) for seed, name in enumerate(SETS, start=3)}
    numbers = linear_congruential(17)
    points = []
    for layers in LAYERS:
        signals = {name: central_signals(patterns, layers) for name, patterns in SETS.items()}
        for _ in range(POINTS_PER_LAYERS):
            channels = [int(next(numbers) % 11) for _ in range(4)]
            nc_weight, oc_weight = int(next(numbers) % 11), int(next(numbers) % 11)
            rhos = [rho(signals[name], oc[name], people[name], channels, nc_weight, oc_weight)
                    for name in SETS]
            points.append({"layers": layers, "channels": channels, "nc": nc_weight,
                           "oc": oc_weight, "rho": rhos})
    document = {
        "made_by": {"command": "python3 tests/golden/make_training.py",
                    "python": platform.python_version(), "numpy": np.__version__,
                    "scipy": scipy.__version__},
        "sets": [{"name": name, "patterns": list(patterns.values()), "ratings": people[name]}
                 for name, patterns in SETS.items()],
        "points": points}
    (FOLDER / "training.json").write_text(json.dumps(document, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    main()
