"""Writes agreement.json, beside this script: how alike people rate, and whether sides shift ratings.

Source   SciPy's F distribution; mean squares by least squares on indicator columns, Krippendorff's
         alpha by its definition over all two values of a unit, the randomisation test by all ways to
         draw the signs; nothing is shared with the C++ program.
What     f: quantiles and shares below of F, of whole and of broken degrees of freedom.
         icc: tables (a row a pair, a column a person), ICC(2,1) and ICC(3,k) with 95 % intervals.
         The first is that of Shrout & Fleiss 1979, table 2, whose .29 and .91 it must give.
         alpha: ratings of people, None where one is missing, and alpha of interval data. The first
         is Krippendorff's own example (2011, section C), whose .849 it must give.
         signs: differences within persons and pairs, the statistic and its exact p.
Run      /usr/bin/python3 tests/golden/make_agreement.py
"""
import itertools
import json
import pathlib
import sys

import numpy as np
import scipy
from scipy.stats import f as fisher

state = 4711


def uniform(count):
    """In [0, 1): a linear congruential generator that any language makes to the bit."""
    global state
    values = []
    for _ in range(count):
        state = (1664525 * state + 1013904223) % 4294967296
        values.append(state / 4294967296)
    return values


def residual_square(y, columns):
    x = np.column_stack(columns)
    fitted = x @ np.linalg.lstsq(x, y, rcond=None)[0]
    return float(((y - fitted) ** 2).sum())


def icc(table):
    table = np.array(table, float)
    n, k = table.shape
    y = table.ravel()
    ones = [np.ones(n * k)]
    rows = [np.repeat(np.eye(n)[i], k) for i in range(n)]
    columns = [np.tile(np.eye(k)[j], n) for j in range(k)]
    rest = residual_square(y, ones + rows + columns)
    msr = (residual_square(y, ones + columns) - rest) / (n - 1)
    msc = (residual_square(y, ones + rows) - rest) / (k - 1)
    mse = rest / ((n - 1) * (k - 1))
    single = (msr - mse) / (msr + (k - 1) * mse + k * (msc - mse) / n)
    a = k * single / (n * (1 - single))
    b = 1 + k * single * (n - 1) / (n * (1 - single))
    v = (a * msc + b * mse) ** 2 / ((a * msc) ** 2 / (k - 1) + (b * mse) ** 2 / ((n - 1) * (k - 1)))
    low, high = fisher.ppf(0.975, n - 1, v), fisher.ppf(0.975, v, n - 1)
    f0 = msr / mse
    other = k * msc + (k * n - k - n) * mse
    return {
        "table": table.tolist(),
        "single": single,
        "single_low": n * (msr - low * mse) / (low * other + n * msr),
        "single_high": n * (high * msr - mse) / (other + n * high * msr),
        "mean": 1 - 1 / f0,
        "mean_low": 1 - fisher.ppf(0.975, n - 1, (n - 1) * (k - 1)) / f0,
        "mean_high": 1 - 1 / (f0 * fisher.ppf(0.975, (n - 1) * (k - 1), n - 1)),
    }


def alpha(people):
    units = [[v for v in unit if v is not None] for unit in zip(*people)]
    units = [unit for unit in units if len(unit) > 1]
    values = [v for unit in units for v in unit]
    observed = sum(
        sum((a - b) ** 2 for a, b in itertools.permutations(unit, 2)) / (len(unit) - 1)
        for unit in units) / len(values)
    expected = sum((a - b) ** 2 for a, b in itertools.permutations(values, 2)) / (
        len(values) * (len(values) - 1))
    return 1 - observed / expected


def sign_test(differences, pairs):
    """differences[person][pair]"""
    flat = [(p, d) for person in differences for p, d in zip(range(pairs), person)]

    def spread(signs):
        total = 0.0
        for pair in range(pairs):
            own = [s * d for s, (p, d) in zip(signs, flat) if p == pair]
            total += sum(own) ** 2 / len(own)
        return total

    observed = spread([1] * len(flat))
    ways = list(itertools.product([1, -1], repeat=len(flat)))
    return observed, sum(spread(signs) >= observed * (1 - 1e-12) for signs in ways) / len(ways)


shrout_fleiss = [[9, 2, 5, 8], [6, 1, 3, 2], [8, 4, 6, 8], [7, 1, 2, 6], [10, 5, 6, 9], [6, 2, 4, 7]]
made_up = np.array(uniform(60)).reshape(15, 4) * 40 + np.array(uniform(15))[:, None] * 60
tables = [icc(shrout_fleiss), icc(np.round(made_up, 1))]
assert abs(tables[0]["single"] - 0.29) < 0.005 and abs(tables[0]["mean"] - 0.91) < 0.005

_ = None
krippendorff = [
    [1, 2, 3, 3, 2, 1, 4, 1, 2, _, _, _],
    [1, 2, 3, 3, 2, 2, 4, 1, 2, 5, _, 3],
    [_, 3, 3, 3, 2, 3, 4, 2, 2, 5, 1, _],
    [1, 2, 3, 3, 2, 4, 4, 1, 2, 5, 1, _]]
assert abs(alpha(krippendorff) - 0.849) < 0.0005
gaps = [[None if u < 0.2 else round(100 * v, 1) for u, v in zip(uniform(10), uniform(10))]
        for _ in range(5)]

differences = [[round(20 * u - 7, 1) for u in uniform(3)] for _ in range(4)]
observed, p = sign_test(differences, 3)

result = {
    "made_by": f"make_agreement.py, Python {sys.version.split()[0]}, NumPy {np.__version__}, "
               f"SciPy {scipy.__version__}",
    "f": [{"share": share, "df1": a, "df2": b, "quantile": fisher.ppf(share, a, b),
           "value": 1.7, "below": fisher.cdf(1.7, a, b)}
          for share in (0.025, 0.5, 0.975)
          for a, b in ((1, 1), (5, 15), (65, 1235), (3.7, 65), (65, 21.3), (0.5, 4))],
    "icc": tables,
    "alpha": [{"people": people, "alpha": alpha(people)} for people in (krippendorff, gaps)],
    "signs": {"differences": differences, "spread": observed, "p": p},
}
path = pathlib.Path(__file__).parent / "agreement.json"
path.write_text(json.dumps(result, indent=1) + "\n")
