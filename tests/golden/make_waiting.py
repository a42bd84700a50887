"""Writes waiting.json: DTW with a cost on steps at which one signal waits.

Source   the recurrence printed in model/dtw/dtw.h, here as the shortest way through a graph: a node
         a cell, an edge a step, its length what the cell costs and, unless both signals advance, w.
What     waiting.json: 36 pairs of signals of 1 to 40 samples at costs of 0 to 2.
Run      python3 tests/golden/make_waiting.py
Needs    Python 3.11, NumPy 1.24, SciPy 1.10 (Debian 12: python3-numpy, python3-scipy).
"""

import json
import pathlib

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

# Edges of no length do not exist for csgraph: each gets this, and the way's own count of it is taken off.
LIFT = 1.0


def shortest_way(x, y, waiting_cost):
    n, m = len(x), len(y)
    begin, end, length = [n * m], [0], [LIFT + abs(x[0] - y[0])]
    for i in range(n):
        for j in range(m):
            for di, dj, cost in ((1, 1, 0.0), (1, 0, waiting_cost), (0, 1, waiting_cost)):
                if i + di < n and j + dj < m:
                    begin.append(i * m + j)
                    end.append((i + di) * m + j + dj)
                    # A diagonal step is two of the lattice: so every way is lifted alike.
                    lift = LIFT * (di + dj)
                    length.append(lift + cost + abs(x[i + di] - y[j + dj]))
    graph = coo_matrix((length, (begin, end)), shape=(n * m + 1, n * m + 1)).tocsr()
    return dijkstra(graph, indices=n * m)[n * m - 1] - LIFT * (1 + (n - 1) + (m - 1))


def main():
    random = np.random.default_rng(1978)
    cases = []
    for k in range(36):
        n, m = (int(v) for v in random.integers(1, 41, 2))
        x = [round(v, 3) for v in random.uniform(0.0, 1.0, n)]
        y = [round(v, 3) for v in random.uniform(0.0, 1.0, m)]
        cost = (0.0, 0.01, 0.1, 0.3, 0.9, 2.0)[k % 6]
        cases.append({"x": x, "y": y, "waiting_cost": cost, "distance": shortest_way(x, y, cost)})
    target = pathlib.Path(__file__).parent / "waiting.json"
    target.write_text(json.dumps({"cases": cases}, indent=1) + "\n")


if __name__ == "__main__":
    main()
