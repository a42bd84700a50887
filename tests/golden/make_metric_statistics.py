"""Writes metric_statistics.json, beside this script: how sure agreement with people is.

Source   scipy.stats (t, spearmanr), scipy.spatial (procrustes), numpy.quantile, and plain loops;
         nothing is shared with the C++ program.
What     student: two-sided p and quantiles of Student's t.
         holm: corrected p.
         protest: two maps of six points; of all orders of the points, those that fit as well.
         people: matrices of six people of eight patterns, and three metrics. Rho of each person with
         the mean of the others and of all, and with the metrics, with quartiles; jackknife over
         people of rho and of differences from the first metric; standard errors by 6,000 draws of
         patterns, of people, and of both at once, corrected (two_way); partial rho given a fourth matrix as the correlation
         of what regression leaves of ranks, with its bootstrap interval.
Run      /usr/bin/python3 tests/golden/make_metric_statistics.py
"""
import itertools
import json
import pathlib
import sys

import numpy as np
import scipy
from scipy.spatial import procrustes
from scipy.spatial.distance import pdist, squareform
from scipy.stats import rankdata, spearmanr, t

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


def rho(a, b):
    return float(spearmanr(a, b).correlation)


def student():
    return [{"freedom": f, "t": x, "p": float(2 * t.sf(x, f)), "coverage": c,
             "quantile": float(t.ppf(0.5 + c / 2, f))}
            for f, x, c in [(1, 1.0, 0.95), (2, 0.3, 0.9), (3, 2.5, 0.95), (4, 12.0, 0.99),
                            (5, 0.0, 0.5), (19, 2.093, 0.95), (20, 1.1, 0.8), (199, 3.3, 0.95)]]


def holm():
    cases = [[0.01, 0.04, 0.03, 0.005], [0.5, 0.5], [0.2], [0.001, 0.9, 0.9, 0.0001, 0.02]]
    made = []
    for p in cases:
        corrected = []
        for one in p:
            # The largest of all that are no larger, each times the number that is left.
            steps = [(sum(q > other or (q == other and k >= j) for k, q in enumerate(p)) * other)
                     for j, other in enumerate(p) if other <= one]
            corrected.append(min(1.0, max(steps)))
        made.append({"p": p, "corrected": corrected})
    return made


def protest(name, x, y):
    def fit(b):
        return procrustes(x, b)[2]
    observed = fit(y)
    orders = list(itertools.permutations(range(len(x))))
    as_good = sum(bool(fit(y[list(order)]) <= observed + 1e-12) for order in orders)
    return {"name": name, "a": x.tolist(), "b": y.tolist(), "m2": observed, "as_good": as_good,
            "orders": len(orders)}


def protests():
    seed(31)
    cube = uniform(18).reshape(6, 3)
    return [protest("near", cube, cube + 0.4 * uniform(18).reshape(6, 3)),
            protest("far", cube, uniform(18).reshape(6, 3))]


def partial(a, b, given):
    """By regression: what is left of ranks a and b when those of the third are taken away."""
    ranks = [rankdata(v) for v in (a, b, given)]
    design = np.column_stack([np.ones(len(a)), ranks[2]])
    left = [r - design @ np.linalg.lstsq(design, r, rcond=None)[0] for r in ranks[:2]]
    return float(np.corrcoef(*left)[0, 1])


def spread(values):
    q = np.quantile(values, [0.25, 0.5, 0.75])
    return {"mean": float(np.mean(values)), "low": q[0], "median": q[1], "high": q[2]}


def jackknife(values):
    values = np.asarray(values)
    n = len(values)
    return float(np.sqrt((n - 1) / n * np.sum((values - values.mean()) ** 2)))


def people():
    size, count = 8, 6
    seed(41)
    pairs = size * (size - 1) // 2
    truth = uniform(pairs)
    said = [truth + 0.9 * uniform(pairs) for _ in range(count)]
    metrics = [truth + w * uniform(pairs) for w in (0.3, 0.8, 2.5)]
    given = 0.5 * truth + uniform(pairs)
    mean = np.mean(said, 0)
    others = [rho(s, np.mean(np.delete(said, k, 0), 0)) for k, s in enumerate(said)]
    everyone = [rho(s, mean) for s in said]
    without = np.array([[rho(m, np.mean(np.delete(said, k, 0), 0)) for m in metrics]
                        for k in range(count)])
    upper = np.triu_indices(size, 1)
    squares = [squareform(m) for m in metrics]
    voices = np.array([squareform(s) for s in said])
    generator = np.random.default_rng(5)
    patterns, drawn_people, both, partials = [], [], [], []
    of_given = squareform(given)
    for _ in range(6000):
        drawn = generator.integers(0, size, size)
        i, j = drawn[upper[0]], drawn[upper[1]]
        i, j = i[i != j], j[i != j]
        one = voices.mean(0)[i, j]
        then = voices[generator.integers(0, count, count)].mean(0)
        other = then[i, j]
        ranks = [rankdata(m[i, j]) for m in squares]
        said_then = rankdata(then[upper])
        drawn_people.append([np.corrcoef(rankdata(m), said_then)[0, 1] for m in metrics])
        patterns.append([np.corrcoef(r, rankdata(one))[0, 1] for r in ranks])
        both.append([np.corrcoef(r, rankdata(other))[0, 1] for r in ranks])
        if len(partials) < 1500:
            partials.append(partial(squares[1][i, j], one, of_given[i, j]))
    of_second = partial(metrics[1], mean, given)
    reach = 1.959963984540054 * float(np.nanstd(partials))
    patterns, drawn_people, both = np.array(patterns), np.array(drawn_people), np.array(both)

    def errors(values):
        return {"rho": np.nanstd(values, 0).tolist(),
                "difference": np.nanstd(values[:, :1] - values[:, 1:], 0).tolist()}

    def two_way(plain, one, other):
        """Of three standard errors: Schütt et al. 2023, as rsatoolbox's _dual_bootstrap has it."""
        plain, one, other = [np.square(v) for v in (plain, one, other)]
        corrected = np.maximum(np.maximum(2 * (one + other) - plain, one), other)
        return np.sqrt(np.minimum(corrected, plain)).tolist()

    three = errors(both), errors(drawn_people), errors(patterns)
    return {"size": size, "said": [s.tolist() for s in said],
            "metrics": [m.tolist() for m in metrics], "given": given.tolist(),
            "with_others": spread(others), "with_all": spread(everyone),
            "rho_of_second": spread([rho(s, metrics[1]) for s in said]),
            "jackknife": {"rho": [jackknife(without[:, k]) for k in range(3)],
                          "difference": [jackknife(without[:, 0] - without[:, k])
                                         for k in (1, 2)]},
            "t": float(t.ppf(0.975, count - 1)), "patterns": errors(patterns),
            "plain_both": three[0], "drawn_people": three[1],
            "both": {key: two_way(*[one[key] for one in three]) for key in three[0]},
            "partial_of_second": of_second,
            "partial_interval": [of_second - reach, min(of_second + reach, 1.0)]}


def main():
    table = {"made_by": "/usr/bin/python3 tests/golden/make_metric_statistics.py "
             "(Python %s, NumPy %s, SciPy %s)"
             % (sys.version.split()[0], np.__version__, scipy.__version__),
             "student": student(), "holm": holm(), "protest": protests(), "people": people()}
    file = pathlib.Path(__file__).with_name("metric_statistics.json")
    lines = ['  "%s": %s' % (key, json.dumps(value)) for key, value in table.items()]
    file.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main()
