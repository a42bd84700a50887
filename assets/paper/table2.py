"""Table 2 of this folder again, from its CSV files alone, by another program than made it.

    python3 table2.py [FOLDER]

Needs NumPy. A line each: what it is, the table's number, the one found here. rho is Spearman's over the rated
pairs; K the alienation of two maps by the publication's procedure (maps.csv). Ends with 1 if any differs.
"""

import csv
import math
import pathlib
import sys

import numpy as np

folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
differing = 0


def rows(file):
    with open(folder / file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def number(text):
    return math.nan if text in ("", "NA") else float(text)


def check(what, of_table, here):
    global differing
    agrees = (math.isnan(of_table) and math.isnan(here)) or abs(of_table - here) <= 1e-6
    differing += not agrees
    print(f"{'ok     ' if agrees else 'DIFFERS'} {what:50} {of_table:12.6g} {here:12.6g}")


def ranks(values):
    """Of values that differ by more than a billionth of the largest; ties share the mean rank."""
    rounded = np.rint(values / max(np.abs(values).max(), 1e-300) * 1e9)
    _, place, count = np.unique(rounded, return_inverse=True, return_counts=True)
    return (np.cumsum(count) - (count - 1) / 2)[place]


def spearman(a, b):
    known = np.isfinite(a) & np.isfinite(b)
    a, b = ranks(a[known]), ranks(b[known])
    a, b = a - a.mean(), b - b.mean()
    size = math.sqrt((a * a).sum() * (b * b).sum())
    return (a * b).sum() / size if size > 0 else math.nan


def alienation(x, y):
    upper = np.triu_indices(len(x), 1)
    d, e = (np.sqrt(((p[:, None] - p) ** 2).sum(-1))[upper] for p in (x, y))
    c = (d * e).sum() / math.sqrt((d * d).sum() * (e * e).sum())
    return math.sqrt(max(0.0, 1 - c * c))


pairs, maps = {}, {}
for row in rows("pairs.csv"):
    pairs.setdefault(row["set"], []).append(row)
for row in rows("maps.csv"):
    place = [number(row[axis]) for axis in ("x", "y", "z") if row[axis] != "NA"]
    maps.setdefault((row["set"], row["map"]), []).append(place)

means = {}
table = rows("table2.csv")
for row in table:
    if row["set"] == "average":
        continue
    said = np.array([number(pair["people"]) for pair in pairs[row["set"]]])
    metric = np.array([number(pair[row["metric"]]) for pair in pairs[row["set"]]])
    rho = spearman(metric, said)
    own, people = maps.get((row["set"], row["metric"])), maps.get((row["set"], "people"))
    k = alienation(np.array(own), np.array(people)) if own and people else math.nan
    check(f"{row['set']}: {row['metric']}: rho", number(row["rho"]), rho)
    check(f"{row['set']}: {row['metric']}: K", number(row["K"]), k)
    means.setdefault(row["metric"], []).append((rho, k))
for row in table:
    if row["set"] != "average":
        continue
    rho, k = np.array(means[row["metric"]]).T
    # As the publication has it: an undefined rho is 0, its sign is dropped; a failed map is K = 1.
    check(f"average: {row['metric']}: |rho|", number(row["rho"]), np.abs(np.nan_to_num(rho)).mean())
    check(f"average: {row['metric']}: K", number(row["K"]), np.where(np.isnan(k), 1.0, k).mean())

print(f"{differing} differ" if differing else "all agree")
sys.exit(1 if differing else 0)
