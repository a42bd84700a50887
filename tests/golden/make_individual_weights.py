"""Writes individual_weights.json, beside this script: a common map and what each person weighs in it.

Source   INDSCAL's least squares on scalar products (Carroll & Chang 1970), here by SciPy's L-BFGS-B on
         all coordinates and weights at once, weights bounded by 0, from many starts; the program
         alternates least squares instead. Nothing is shared with it.
What     cases: noisy ratings of people with a common map, condensed a row a person; the share of the
         sum of squares explained, each one's weights and share, and the common map: columns of length
         1, by how much all weigh them, the farthest pattern of each on the positive side.
Run      /usr/bin/python3 tests/golden/make_individual_weights.py
"""
import json
import pathlib
import sys

import numpy as np
import scipy
from scipy.optimize import minimize


def products_of(condensed, n):
    d = np.zeros((n, n))
    d[np.triu_indices(n, 1)] = condensed
    d += d.T
    j = np.eye(n) - 1 / n
    b = -0.5 * j @ (d * d) @ j
    return b / np.linalg.norm(b)


def loss(values, b, k):
    people, n = b.shape[:2]
    x, w = values[: n * k].reshape(n, k), values[n * k :].reshape(people, k)
    rest = b - np.einsum("ir,sr,jr->sij", x, w, x)
    slope_x = -4 * np.einsum("sij,jr,sr->ir", rest, x, w)
    slope_w = -2 * np.einsum("sij,ir,jr->sr", rest, x, x)
    return (rest**2).sum(), np.concatenate([slope_x.ravel(), slope_w.ravel()])


def fitted(ratings, n, k, random):
    b = np.array([products_of(row, n) for row in ratings])
    people = len(b)
    best = None
    for _ in range(60):
        start = np.concatenate([random.standard_normal(n * k) / np.sqrt(n), random.random(people * k)])
        bounds = [(None, None)] * (n * k) + [(0, None)] * (people * k)
        found = minimize(loss, start, args=(b, k), method="L-BFGS-B", jac=True, bounds=bounds,
                         options={"maxiter": 20000, "maxfun": 40000, "ftol": 1e-15, "gtol": 1e-11})
        if best is None or found.fun < best.fun:
            best = found
    x, w = best.x[: n * k].reshape(n, k), best.x[n * k :].reshape(people, k)
    lengths = np.linalg.norm(x, axis=0)
    x, w = x / lengths, w * lengths**2
    order = np.argsort(-(w**2).sum(0))
    x, w = x[:, order], w[:, order]
    x = x * np.sign(x[np.abs(x).argmax(0), range(k)])
    rest = b - np.einsum("ir,sr,jr->sij", x, w, x)
    each = 1 - (rest**2).sum((1, 2))
    return {"explained": float(each.mean()), "each": each.tolist(), "weights": w.tolist(), "group": x.tolist()}


def case(name, n, people, k, noise, seed):
    random = np.random.default_rng(seed)
    x = random.standard_normal((n, k))
    w = random.uniform(0.1, 1.0, (people, k))
    if k > 1:
        w[0, 0] = 0.0  # somebody who does not go by a dimension at all
    pairs = np.triu_indices(n, 1)
    ratings = []
    for row in w:
        d = np.sqrt(((x[pairs[0]] - x[pairs[1]]) ** 2 * row).sum(1))
        d = np.abs(d * (1 + noise * random.standard_normal(len(d))))
        ratings.append(np.round(100 * d / d.max(), 1))
    ratings = np.array(ratings)
    return {"name": name, "patterns": n, "dimensions": k, "ratings": ratings.tolist(),
            **fitted(ratings, n, k, random)}


golden = {
    "tool": f"numpy {np.__version__}, scipy {scipy.__version__}",
    "cases": [case("two of eight", 8, 6, 2, 0.1, 1), case("three of twelve", 12, 10, 3, 0.15, 2),
              case("two, very noisy", 10, 5, 2, 0.4, 3), case("one", 6, 4, 1, 0.2, 4)],
}
path = pathlib.Path(__file__).parent / "individual_weights.json"
path.write_text(json.dumps(golden, indent=1).replace("\n    ", " ") + "\n")
print(f"{path.name}: {[round(one['explained'], 4) for one in golden['cases']]}", file=sys.stderr)
