"""Writes evaluation.json, beside this script: agreement of matrices, maps and people.

Source   scipy.stats (spearmanr, kendalltau), scipy.spatial (procrustes, pdist), and plain
         enumeration of orders and halves; nothing is shared with the C++ program.
What     correlations: two lists, NaN where a pair is unknown, their rho and tau-b.
         mantel: two condensed matrices; of all orders of the objects, those with rho as high.
         bootstrap: the same matrices, rho and 1.96 standard errors of 20,000 draws of objects.
         maps: two configurations, K of distances, K of Procrustes, and of all orders of the
         points those with K as low.
         reliability: matrices of six and of five people; Spearman between the means of all halves,
         stepped up by Spearman-Brown, and of each person with the mean of the others.
Run      python3 tests/golden/make_evaluation.py
"""
import itertools
import json
import math
import pathlib
import sys

import numpy as np
import scipy
from scipy.spatial import procrustes
from scipy.spatial.distance import pdist, squareform
from scipy.stats import kendalltau, rankdata, spearmanr

state = 0


def seed(value):
    global state
    state = value


def uniform(count):
    """In [0, 1): a linear congruential generator that any language makes to the bit."""
    global state
    values = []
    for _ in range(count):
        state = (1664525 * state + 1013904223) % 4294967296
        values.append(state / 4294967296)
    return np.array(values)


def known(a, b):
    keep = ~(np.isnan(a) | np.isnan(b))
    return a[keep], b[keep]


def rho(a, b):
    a, b = known(np.asarray(a, float), np.asarray(b, float))
    return spearmanr(a, b).correlation


def listed(values):
    return [None if math.isnan(v) else float(v) for v in values]


def correlation(name, a, b):
    a, b = np.asarray(a, float), np.asarray(b, float)
    x, y = known(a, b)
    return {"name": name, "a": listed(a), "b": listed(b), "rho": rho(a, b),
            "tau_b": kendalltau(x, y).correlation}


def correlations():
    nan = math.nan
    seed(1)
    a = uniform(91)
    b = a + 0.7 * uniform(91)
    tied_a, tied_b = np.floor(4 * a), np.floor(5 * b)
    gaps = a.copy()
    gaps[::7] = nan
    return [correlation("printed example", [10, 20, 20, 40, 50, 50, 50], [1, 3, 2, 2, 8, 9, 7]),
            correlation("91 pairs", a, b), correlation("few levels", tied_a, tied_b),
            correlation("unknown pairs", gaps, b), correlation("opposed", a, -b),
            correlation("one pair in two", [1, 1, 1, 2], [3, 1, 2, 2])]


def reordered(condensed, order):
    square = squareform(condensed, checks=False)
    order = list(order)
    return squareform(square[np.ix_(order, order)], checks=False)


def mantel(name, size, a, b):
    observed = rho(a, b)
    orders = list(itertools.permutations(range(size)))
    as_good = sum(bool(rho(a, reordered(b, order)) >= observed - 1e-12) for order in orders)
    return {"name": name, "size": size, "a": listed(a), "b": listed(b), "rho": observed,
            "as_good": as_good, "orders": len(orders)}


def mantels():
    seed(5)
    five, noise = uniform(10), uniform(10)
    six, six_noise = uniform(15), uniform(15)
    gaps = six.copy()
    gaps[[3, 11]] = math.nan
    return [mantel("five alike", 5, five, five + 0.4 * noise),
            mantel("five tied", 5, np.floor(3 * five), np.floor(3 * (five + 0.6 * noise))),
            mantel("five opposed", 5, five, -five),
            mantel("six unrelated", 6, six, six_noise),
            mantel("six with unknown pairs", 6, gaps, six + 0.5 * six_noise)]


def bootstrap():
    size, draws = 10, 20000
    seed(9)
    a = uniform(45)
    b = a + 0.8 * uniform(45)
    first, second = squareform(a), squareform(b)
    generator = np.random.default_rng(1)
    upper = np.triu_indices(size, 1)
    values = []
    for _ in range(draws):
        drawn = generator.integers(0, size, size)
        i, j = drawn[upper[0]], drawn[upper[1]]
        i, j = i[i != j], j[i != j]
        values.append(np.corrcoef(rankdata(first[i, j]), rankdata(second[i, j]))[0, 1])
    reach = 1.959963984540054 * float(np.nanstd(values))
    whole = float(np.corrcoef(rankdata(a), rankdata(b))[0, 1])
    return {"size": size, "a": listed(a), "b": listed(b), "draws": draws, "low": whole - reach,
            "high": min(whole + reach, 1.0)}


def alienation(x, y):
    a, b = pdist(x), pdist(y)
    c = np.dot(a, b) / math.sqrt(np.dot(a, a) * np.dot(b, b))
    return math.sqrt(max(0.0, 1 - c * c))


def pair_of_maps(name, x, y):
    observed = alienation(x, y)
    orders = list(itertools.permutations(range(len(x))))
    as_good = sum(bool(alienation(x, y[list(order)]) <= observed + 1e-12) for order in orders)
    return {"name": name, "a": x.tolist(), "b": y.tolist(), "k": observed,
            "k_procrustes": math.sqrt(procrustes(x, y)[2]), "as_good": as_good,
            "orders": len(orders)}


def maps():
    seed(11)
    cube = uniform(18).reshape(6, 3)
    near = cube + 0.3 * uniform(18).reshape(6, 3)
    far = uniform(18).reshape(6, 3)
    plane = uniform(10).reshape(5, 2)
    return [pair_of_maps("near", cube, near), pair_of_maps("far", cube, far),
            pair_of_maps("plane", plane, plane ** 2)]


def halves_of(people):
    """Every way to part them once: of even numbers the first person's half is named first."""
    first = people // 2
    for half in itertools.combinations(range(people), first):
        if people % 2 == 1 or 0 in half:
            yield half, [p for p in range(people) if p not in half]


def reliability(name, size, matrices):
    matrices = np.array(matrices)
    split = [rho(np.nanmean(matrices[list(one)], 0), np.nanmean(matrices[other], 0))
             for one, other in halves_of(len(matrices))]
    half = float(np.mean(split))
    others = [rho(own, np.nanmean(np.delete(matrices, k, 0), 0)) for k, own in enumerate(matrices)]
    return {"name": name, "size": size, "matrices": [listed(m) for m in matrices],
            "halves": len(split), "half_rho": half, "spearman_brown": 2 * half / (1 + half),
            "one_with_others": float(np.mean(others))}


def reliabilities():
    seed(21)
    truth = uniform(21)
    even = [truth + 0.8 * uniform(21) for _ in range(6)]
    odd = [np.floor(10 * (truth + 0.8 * uniform(21))) for _ in range(5)]
    odd[2][4] = math.nan
    return [reliability("six people", 7, even), reliability("five people, a gap", 7, odd)]


def main():
    table = {"made_by": "python3 tests/golden/make_evaluation.py (Python %s, NumPy %s, SciPy %s)"
             % (sys.version.split()[0], np.__version__, scipy.__version__),
             "correlations": correlations(), "mantel": mantels(), "bootstrap": bootstrap(),
             "maps": maps(), "reliability": reliabilities()}
    file = pathlib.Path(__file__).with_name("evaluation.json")
    # One entry a line, to be read beside the source.
    lines = []
    for key, value in table.items():
        text = json.dumps(value)
        if isinstance(value, list):
            text = "[\n   " + ",\n   ".join(json.dumps(entry) for entry in value) + "\n  ]"
        lines.append('  "%s": %s' % (key, text))
    file.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main()
