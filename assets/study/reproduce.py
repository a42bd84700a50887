"""The numbers of this report again, from its CSV files alone, by another program than made it.

    python3 reproduce.py [FOLDER]

Needs NumPy; with SciPy the intervals of the ICC and p of differences as well. A line each: what it is, the report's number,
the one found here, and whether they agree. Exact ones agree to 1e-6; what is drawn at random is drawn
anew here, so those agree within the tolerance that the line tells. Ends with 1 if any differs.

Not tried: the spread and the intervals of K, which take maps that the report does not hold.
"""

import csv
import itertools
import math
import pathlib
import sys

import numpy as np

EXACT = 1e-6
folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
random = np.random.default_rng(1)
differing = 0


def rows(file):
    with open(folder / file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def number(text):
    return math.nan if text in ("", "NA") else float(text)


def check(what, of_report, here, tolerance=EXACT):
    global differing
    both_unknown = math.isnan(of_report) and math.isnan(here)
    agrees = both_unknown or abs(of_report - here) <= tolerance * max(1.0, abs(of_report))
    differing += not agrees
    drawn = "" if tolerance == EXACT else f" (drawn anew, within {tolerance:g})"
    print(f"{'ok     ' if agrees else 'DIFFERS'} {what:44} {of_report:12.6g} {here:12.6g}{drawn}")


def ranks(values):
    """Of values that differ by more than a billionth of the largest; ties share the mean rank."""
    values = np.asarray(values, float)
    rounded = np.rint(values / max(np.abs(values).max(), 1e-6) * 1e9)
    _, place, count = np.unique(rounded, return_inverse=True, return_counts=True)
    last = np.cumsum(count)
    return (last - (count - 1) / 2)[place]


def pearson(a, b):
    a, b = a - a.mean(), b - b.mean()
    size = math.sqrt((a * a).sum() * (b * b).sum())
    return (a * b).sum() / size if size > 0 else math.nan


def spearman(a, b):
    known = np.isfinite(a) & np.isfinite(b)
    if known.sum() < 2:
        return math.nan
    return pearson(ranks(np.asarray(a)[known]), ranks(np.asarray(b)[known]))


def mean_known(values, axis=None):
    values = np.asarray(values, float)
    known = np.isfinite(values)
    count = known.sum(axis=axis)
    total = np.where(known, values, 0.0).sum(axis=axis)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


# --- who counts, and what each said -------------------------------------------------------------

people = rows("participants.csv")
answers = [row for row in rows("answers.csv") if row["excluded"] == "0"]
pairs = rows("pairs.csv")
labels = [pairs[0]["a"]] + [row["b"] for row in pairs if row["a"] == pairs[0]["a"]]
n = len(labels)
place = {name: k for k, name in enumerate(labels)}
index = {(i, j): p for p, (i, j) in enumerate(itertools.combinations(range(n), 2))}
counted = [row["participant"] for row in people if row["counted"] == "1"]
is_sorting = "group" in answers[0] if answers else False


def passes_of(who, column):
    """Dissimilarities, a row a pass through the pairs."""
    passes, times = [], {}
    for row in answers:
        if row["participant"] != who or row["attention"] == "1":
            continue
        pair = index[tuple(sorted((place[row["a"]], place[row["b"]])))]
        k = times[pair] = times.get(pair, -1) + 1
        if k == len(passes):
            passes.append(np.full(len(index), math.nan))
        passes[k][pair] = 100 - number(row[column])
    return passes


def sorted_by(who):
    """Two patterns in one group of a round are the more alike the more groups it had."""
    rounds = {}
    for row in answers:
        if row["participant"] == who:
            rounds.setdefault(row["round"], {})[place[row["pattern"]]] = row["group"]
    together, all_groups = np.zeros(len(index)), np.zeros(len(index))
    for group in rounds.values():
        groups = len(set(group.values()))
        for (i, j), p in index.items():
            if i in group and j in group:
                all_groups[p] += groups
                together[p] += groups * (group[i] == group[j])
    with np.errstate(invalid="ignore", divide="ignore"):
        return [100 * (1 - together / all_groups)]


column = "scaled" if answers and "scaled" in answers[0] else "rating"
passes = {who: sorted_by(who) if is_sorting else passes_of(who, column) for who in counted}
own = {who: mean_known(passes[who], axis=0) for who in counted if passes[who]}
voices = list(own.values())
mean = mean_known(voices, axis=0)
for p, row in enumerate(pairs):
    check(f"mean of {row['a']} and {row['b']}", number(row["people"]), mean[p])


def with_others(k, all_voices):
    return spearman(all_voices[k], mean_known(all_voices[:k] + all_voices[k + 1 :], axis=0))


def repeat_rho(rated):
    return float(mean_known([spearman(a, b) for a, b in itertools.combinations(rated, 2)] or [math.nan]))


for row in people:
    who = row["participant"]
    if who not in own:
        continue
    check(f"{who}: rho of own repetitions", number(row["repeat_rho"]), repeat_rho(passes[who]))
    if len(voices) > 1:
        check(f"{who}: rho with the others", number(row["rho_with_others"]),
              with_others(list(own).index(who), voices))

# --- how alike people rate ----------------------------------------------------------------------

said = {row["statistic"]: row for row in rows("reliability.csv")}


def check_said(statistic, here, tolerance=EXACT, field="value"):
    if statistic in said:
        what = statistic if field == "value" else f"{statistic}, {field}"
        check(what, number(said[statistic][field]), here, tolerance)


of_one = len(counted) == 1 and len(passes[counted[0]]) > 1
if of_one:
    voices = passes[counted[0]]
if len(voices) > 1:
    half = len(voices) // 2
    if len(voices) <= 12:
        halves = [set(part) for part in itertools.combinations(range(len(voices)), half)]
        if len(voices) % 2 == 0:
            halves = [part for part in halves if 0 in part]
        tolerance = EXACT
    else:
        halves = [set(random.permutation(len(voices))[:half]) for _ in range(1000)]
        tolerance = 0.01
    of_halves = float(mean_known([
        spearman(mean_known([v for k, v in enumerate(voices) if k in part], axis=0),
                 mean_known([v for k, v in enumerate(voices) if k not in part], axis=0))
        for part in halves]))
    stepped_up = 2 * of_halves / (1 + of_halves)
    check_said("split_half", of_halves, tolerance)
    check_said("reliability", stepped_up, tolerance)
    check_said("ceiling_of_mean", math.sqrt(stepped_up) if stepped_up >= 0 else math.nan, tolerance)
    check_said("one_with_others", float(mean_known([with_others(k, voices) for k in range(len(voices))])))

table = np.array(list(own.values())).T if own else np.empty((0, 0))
if table.size and table.shape[1] > 1:
    complete = table[np.isfinite(table).all(axis=1)]
    size, k = complete.shape
    rest = complete - complete.mean(1, keepdims=True) - complete.mean(0) + complete.mean()
    msr = k * ((complete.mean(1) - complete.mean()) ** 2).sum() / (size - 1)
    msc = size * ((complete.mean(0) - complete.mean()) ** 2).sum() / (k - 1)
    mse = (rest**2).sum() / ((size - 1) * (k - 1))
    single = (msr - mse) / (msr + (k - 1) * mse + k * (msc - mse) / size)
    check_said("icc_single", single)
    check_said("icc_mean", 1 - mse / msr)
    try:
        from scipy.stats import f as fisher
    except ImportError:
        print("        intervals of the ICC: not tried, as SciPy is not here")
    else:
        a = k * single / (size * (1 - single))
        b = 1 + a * (size - 1)
        v = (a * msc + b * mse) ** 2 / ((a * msc) ** 2 / (k - 1) + (b * mse) ** 2 / ((size - 1) * (k - 1)))
        low, high = fisher.ppf(0.975, size - 1, v), fisher.ppf(0.975, v, size - 1)
        others = k * msc + (k * size - k - size) * mse
        check_said("icc_single", size * (msr - low * mse) / (low * others + size * msr), EXACT, "low")
        check_said("icc_single", size * (high * msr - mse) / (others + size * high * msr), EXACT, "high")
        df = (size - 1) * (k - 1)
        check_said("icc_mean", 1 - mse / msr * fisher.ppf(0.975, size - 1, df), EXACT, "low")
        check_said("icc_mean", 1 - mse / msr / fisher.ppf(0.975, df, size - 1), EXACT, "high")
    units = [unit[np.isfinite(unit)] for unit in table]
    units = [unit for unit in units if len(unit) > 1]
    values = np.concatenate(units)
    within = sum(((unit[:, None] - unit) ** 2).sum() / (len(unit) - 1) for unit in units) / len(values)
    overall = 2 * (len(values) * (values**2).sum() - values.sum() ** 2) / (len(values) * (len(values) - 1))
    check_said("alpha", 1 - within / overall)


def p_of_signs(drawn, observed):
    """NaN where signs cannot change the number: then there is no test."""
    drawn = np.asarray(drawn)
    if np.all(np.abs(drawn - observed) <= 1e-12 * abs(observed)):
        return math.nan
    return ((drawn >= observed * (1 - 1e-12)).sum() + 1) / (len(drawn) + 1)


def check_shift(statistic, is_first):
    """Within each person and pair: ratings one way round less those the other."""
    found = []
    for who in counted:
        ways = {}
        for row in answers:
            if row["participant"] != who or row["attention"] == "1" or is_first(row) is None:
                continue
            pair = index[place[row["a"]], place[row["b"]]]
            ways.setdefault(pair, ([], []))[0 if is_first(row) else 1].append(number(row["rating"]))
        found += [(p, np.mean(a) - np.mean(b)) for p, (a, b) in ways.items() if a and b]
    if not found:
        return
    of, points = np.array([p for p, _ in found]), np.array([d for _, d in found])
    count = np.maximum(np.bincount(of), 1)

    def spread(signs):
        return (np.bincount(of, signs * points) ** 2 / count).sum()

    drawn = [spread(random.choice([-1, 1], len(of))) for _ in range(2000)]
    check_said(statistic, points.mean())
    check_said(statistic, p_of_signs(drawn, spread(1)), 0.05, "p")


if not is_sorting:
    check_shift("side", lambda row: row["side"] == "a")
    check_shift("felt_first", lambda row: None if row["felt_first"] == "NA" else row["felt_first"] == "a")
    raw = {who: passes_of(who, "rating") for who in counted}
    change = np.array([float(mean_known(one[0] - one[-1])) for one in raw.values() if len(one) > 1])
    if len(change):
        check_said("practice", change.mean())
        signs = random.choice([-1, 1], (2000, len(change)))
        check_said("practice", p_of_signs(np.abs((signs * change).mean(1)), abs(change.mean())), 0.05, "p")

# --- how well metrics agree ---------------------------------------------------------------------

maps = {}
for row in rows("maps.csv"):
    maps.setdefault(row["map"], {})[row["pattern"]] = [number(row[axis]) for axis in ("x", "y", "z")]
maps = {of: np.nan_to_num(np.array([points[name] for name in labels])) for of, points in maps.items()}
upper = np.triu_indices(n, 1)


def square(condensed):
    full = np.full((n, n), math.nan)
    full[upper] = condensed
    return np.where(np.isnan(full), full.T, full)


def distances(points):
    return np.sqrt(((points[:, None] - points) ** 2).sum(-1))[upper]


def alienation(d, e):
    c = (d * e).sum() / math.sqrt((d * d).sum() * (e * e).sum())
    return math.sqrt(max(0.0, 1 - c * c))


def procrustes(x, y):
    x, y = x - x.mean(0), y - y.mean(0)
    r = np.linalg.svd(x.T @ y, compute_uv=False).sum() / (np.linalg.norm(x) * np.linalg.norm(y))
    return math.sqrt(max(0.0, 1 - r * r))


def stress1(delta, d):
    """Kruskal's, with the monotone regression of d on delta; equal delta may be untied."""
    known = np.isfinite(delta)
    delta, d = ranks(delta[known]), d[known]
    blocks = []
    for value in d[np.lexsort((d, delta))]:
        blocks.append([value, 1])
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            value, count = blocks.pop()
            blocks[-1] = [(blocks[-1][0] * blocks[-1][1] + value * count) / (blocks[-1][1] + count),
                          blocks[-1][1] + count]
    fitted = np.concatenate([np.full(count, value) for value, count in blocks])
    d = d[np.lexsort((d, delta))]
    return math.sqrt(((d - fitted) ** 2).sum() / (d * d).sum())


def tau_b(a, b):
    a, b = ranks(a), ranks(b)
    sign_a, sign_b = np.sign(a[:, None] - a), np.sign(b[:, None] - b)
    return (sign_a * sign_b).sum() / math.sqrt((sign_a**2).sum() * (sign_b**2).sum())


def error_of_draws(values):
    """The standard deviation of draws, and how far it may be from that of 2,000 others."""
    values = np.array([one for one in values if not math.isnan(one)])
    if len(values) < 500 or values.std() < 1e-12:
        return math.nan, EXACT
    off = (values - values.mean()) / values.std()
    spread = math.sqrt(((off**4).mean() - 1) / 4 * (1 / len(values) + 1 / 2000))
    return values.std(), 4 * spread * values.std() + 1e-6


def jackknife(values):
    """The standard error over people, each of whom was left out once."""
    values = np.asarray(values)
    return math.sqrt((len(values) - 1) * values.var())


def two_way(both, one, other):
    """Of standard errors: both at once, corrected by either alone (Schuett et al. 2023, eLife 12)."""
    variance = max(2 * (one**2 + other**2) - both**2, one**2, other**2)
    return math.sqrt(min(variance, both**2))


ratings = np.array([number(row["people"]) for row in pairs])
rated = np.isfinite(ratings)
DRAWS = 1000
draws = [random.integers(0, n, n) for _ in range(DRAWS)]
crowds = [random.integers(0, len(voices), len(voices)) for _ in range(DRAWS)]
said = [mean_known([voices[k] for k in crowd], axis=0) for crowd in crowds] if len(voices) > 1 else []
without = [mean_known(voices[:k] + voices[k + 1 :], axis=0) for k in range(len(voices))] if len(voices) > 1 else []
resampled = {}
for row in rows("table.csv"):
    key = row["metric"]
    metric = np.array([number(pair[key]) for pair in pairs])
    rho = spearman(metric, ratings)
    check(f"{key}: rho", number(row["rho"]), rho)
    if rated.sum() <= 3000:
        check(f"{key}: tau-b", number(row["tau_b"]), tau_b(metric[rated], ratings[rated]))
    full, said_full = square(metric), square(ratings)
    if not math.isnan(rho):
        orders = [random.permutation(n) for _ in range(1000)]
        as_good = sum(spearman(full[np.ix_(o, o)][upper], ratings) >= rho - 1e-12 for o in orders)
        check(f"{key}: p of rho", number(row["p"]), (as_good + 1) / 1001, 0.06)
        by = {"patterns": [], "drawn": [], "both": []}
        for k, o in enumerate(draws):
            apart = (o[:, None] != o)[upper]
            of_metric = full[np.ix_(o, o)][upper][apart]
            by["patterns"].append(spearman(of_metric, said_full[np.ix_(o, o)][upper][apart]))
            if said:
                by["drawn"].append(spearman(metric, said[k]))
                by["both"].append(spearman(of_metric, square(said[k])[np.ix_(o, o)][upper][apart]))
        by["people"] = [spearman(metric, one) for one in without]
        resampled[key] = by
        found, tolerance = error_of_draws(by["patterns"])
        if not math.isnan(number(row["rho_patterns_se"])):
            check(f"{key}: error over patterns", number(row["rho_patterns_se"]), found, tolerance)
            reach = 1.959964 * number(row["rho_patterns_se"])
            check(f"{key}: rho_low", number(row["rho_low"]), max(rho - reach, -1))
            check(f"{key}: rho_high", number(row["rho_high"]), min(rho + reach, 1))
        if said and not math.isnan(number(row["rho_people_se"])):
            check(f"{key}: error over people", number(row["rho_people_se"]), jackknife(by["people"]))
        if said and not math.isnan(number(row["rho_both_se"])):
            of_both, tolerance = error_of_draws(by["both"])
            here = two_way(of_both, found, error_of_draws(by["drawn"])[0])
            check(f"{key}: error over both", number(row["rho_both_se"]), here, 3 * tolerance)
    if key in maps and "people" in maps and not math.isnan(number(row["K"])):
        d, e = distances(maps[key]), distances(maps["people"])
        check(f"{key}: K", number(row["K"]), alienation(d, e))
        check(f"{key}: K of Procrustes", number(row["K_procrustes"]), procrustes(maps[key], maps["people"]))
        check(f"{key}: stress-1", number(row["stress1"]), stress1(metric, d))
        whole = square(d)
        orders = [random.permutation(n) for _ in range(1000)]
        as_good = sum(alienation(whole[np.ix_(o, o)][upper], e) <= alienation(d, e) + 1e-12 for o in orders)
        check(f"{key}: p of K", number(row["K_p"]), (as_good + 1) / 1001, 0.06)

# --- how much better PM is ----------------------------------------------------------------------

for row in rows("differences.csv"):
    error, kind = number(row["se"]), row["resampled"]
    if math.isnan(error) or kind == "both":
        continue
    what = f"pm - {row['against']} over {kind}"
    apart = np.subtract(resampled["pm"][kind], resampled[row["against"]][kind])
    if kind == "people":
        check(f"{what}: error", error, jackknife(apart))
    else:
        check(f"{what}: error", error, *error_of_draws(apart))
    try:
        from scipy.stats import norm, t
        tail = t(len(voices) - 1) if kind == "people" else norm()
        check(f"{what}: p", number(row["p"]), 2 * tail.sf(abs(number(row["rho_difference"])) / error))
    except ImportError:
        pass

# --- what each goes by --------------------------------------------------------------------------

common, weighed = rows("dimensions.csv"), rows("weights.csv")
if weighed:
    axes = [name for name in weighed[0] if name.startswith("dimension_")]
    x = np.array([[number(row[axis]) for axis in axes] for row in common])
    size = len(x)
    inside = [place[row["pattern"]] for row in common]
    middle = np.eye(size) - 1 / size
    check("common map: a column's sum of squares", 1.0, float((x**2).sum(0).max()))
    for row in weighed:
        d = np.nan_to_num(square(own[row["participant"]]))[np.ix_(inside, inside)]
        b = -0.5 * middle @ (d * d) @ middle
        b /= np.linalg.norm(b)
        w = np.array([number(row[axis]) for axis in axes])
        rest = b - x @ np.diag(w) @ x.T
        check(f"{row['participant']}: share explained", number(row["explained"]), 1 - (rest**2).sum())
        # No weight could be moved for the better: where it is 0, not upwards.
        slope = -2 * np.einsum("ij,ir,jr->r", rest, x, x)
        worst = max(abs(s) if one > 0 else max(0.0, -s) for s, one in zip(slope, w))
        check(f"{row['participant']}: slope at these weights", 0.0, float(worst))

print(f"{differing} differ" if differing else "all agree")
sys.exit(1 if differing else 0)
