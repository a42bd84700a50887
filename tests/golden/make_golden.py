"""Writes the golden tables of the model from reference_model.py.

Source   reference_model.py beside this file, and the check values printed in the design pages.
What     stages.json, filters.json, tables.json, predictions.json, dtw.json, next to this script.
         Stops with a sentence when a published value is not met or when a count would hang on
         rounding noise, so that no doubtful table is written.
Run      python3 tests/golden/make_golden.py [--tables FOLDER]
         With --tables, the knots and pattern lists typed into the two scripts are first compared
         with firing_rate_slopes.csv, absolute_thresholds.csv, pm_2023_own_12.csv and
         park_choi_2011_am.csv in FOLDER.
"""

import argparse
import csv
import json
import pathlib
import platform
import sys

sys.dont_write_bytecode = True

import numpy as np
import scipy
from scipy import signal

import reference_model as model
from reference_model import CHANNELS, Params, require

FOLDER = pathlib.Path(__file__).parent
COMMAND = "python3 tests/golden/make_golden.py"
WAVE_STRIDE, PBW_STRIDE = 97, 53
CHECKSUM_MODULUS = 1_000_003
LISTED_RECEPTORS = 700
NEAR_TIE = 1e-9          # relative: a largest value closer than this to another has no index
COUNT_MARGIN = 2e-10     # fires * C + 1e-9 must stay this far from a whole number
REAL_MARGIN = 1e-9       # thresholds, radii and grid sizes must stay this far from equality


# ------------------------------------------------------------------ Patterns

def pattern(amplitude_g, carriers, modulation=("product", 0, 1), rhythm=("", 0.125), ramps_s=(0, 0),
            duration_s=1.0):
    """A pattern in the form of the set file; a carrier is (frequency_hz, weight[, phase_rad])."""
    full = [tuple(c) + (0.0,) * (3 - len(c)) for c in carriers]
    return {
        "amplitude_g": amplitude_g,
        "carriers": [{"frequency_hz": f, "weight": w, "phase_rad": p} for f, w, p in full],
        "modulation": {"kind": modulation[0], "frequency_hz": modulation[1], "depth": modulation[2]},
        "rhythm": {"text": rhythm[0], "unit_s": rhythm[1]},
        "attack_s": ramps_s[0], "release_s": ramps_s[1], "duration_s": duration_s}


def twelve_patterns():
    """The paper's section 6.1 set: id -> pattern."""
    mixes = {"f70": (1.0, 0.0), "mix": (0.5, 0.5), "f210": (0.0, 1.0)}
    out = {}
    for size, amplitude_g in (("half", 0.8), ("full", 1.6)):
        for modulation_hz in (0, 4):
            for name, (w_70, w_210) in mixes.items():
                carriers = [c for c in ((70.0, w_70), (210.0, w_210)) if c[1] > 0]
                out[f"{name}-{modulation_hz}-{size}"] = pattern(
                    amplitude_g, carriers, ("product", modulation_hz, 1.0))
    return out


def am_patterns(ambiguous_hz):
    """The eight AM patterns, the ambiguous one as the authors' files (5) or as the caption (4)."""
    rates_hz = (0, 1, 2, ambiguous_hz, 10, 20, 40, 80)
    return {f"AM{f}": pattern(1.0, [(150.0, 1.0)], ("product", f, 1.0)) for f in rates_hz}


def rhythm_patterns():
    """Six rhythms of our own, two of them shorter, one an amplitude twin, with ramps and mixes."""
    plain, mixed = [(150.0, 1.0)], [(70.0, 0.6, 0.3), (210.0, 0.4, -1.1)]
    return {
        "R1": pattern(1.0, plain, rhythm=("x=x---x-", 0.125), ramps_s=(0.01, 0.02)),
        "R2": pattern(0.5, plain, rhythm=("x=x---x-", 0.125), ramps_s=(0.01, 0.02)),
        "R3": pattern(1.0, plain, rhythm=("x-", 0.0625)),
        "R4": pattern(1.2, mixed, rhythm=("x==-xx--", 0.1), ramps_s=(0.005, 0.0), duration_s=0.9),
        "R5": pattern(2.0, [(60.0, 1.0)], rhythm=("x", 0.05), ramps_s=(0.0, 0.03), duration_s=0.7),
        "R6": pattern(1.0, mixed, ("am", 20.0, 0.5), rhythm=("xxx---x===", 0.1)),
    }


def odd_patterns():
    """One pattern for every corner the two published sets leave out."""
    return {
        "rhythm": pattern(1.0, [(150.0, 1.0)], rhythm=("x=x---x-", 0.125), ramps_s=(0.01, 0.02)),
        "am-kind": pattern(1.0, [(80.0, 0.7, 0.4), (200.0, 0.3, -1.3)], ("am", 5.0, 0.6)),
        "silent": pattern(0.0, [(150.0, 1.0)]),
        "short-0.3s": pattern(2.0, [(60.0, 1.0)], duration_s=0.3),
        "long-2.5s": pattern(1.0, [(150.0, 0.6), (40.0, 0.4)], ("product", 2.0, 1.0), duration_s=2.5),
        "awkward-0.1237s": pattern(1.0, [(150.0, 1.0)], duration_s=0.1237),
        "leaking-150.5Hz": pattern(1.0, [(150.5, 1.0)]),
        "odd-rhythm": pattern(1.5, [(95.0, 0.8, 0.2), (33.0, 0.2, 2.0)], ("am", 11.0, 0.9),
                              ("x=-x==--x", 0.0371), (0.05, 0.013), 0.83),
        "silent-SA1": pattern(1.0, [(450.0, 1.0)], ramps_s=(0.5, 0.5)),
        "burst": pattern(6.0, [(150.0, 1.0)], rhythm=("x" + "-" * 49, 0.02)),
    }


def stage_cases():
    """(name, source, changed parameters) of every case in stages.json."""
    twelve, am, odd = twelve_patterns(), am_patterns(5), odd_patterns()
    am["AM4"] = am_patterns(4)["AM4"]
    noise = {"seed": 2023, "samples": 10_000, "amplitude_g": 1.0}
    loud = {"seed": 7, "samples": 10_000, "amplitude_g": 12.0}
    plain = [(n, {"pattern": p}, {}) for n, p in (twelve | am | odd).items()]
    plain += [("noise", {"noise": noise}, {}), ("loud-noise", {"noise": loud}, {})]
    return plain + changed_cases(twelve, am, odd, noise, loud)


def changed_cases(twelve, am, odd, noise, loud):
    """Cases with a parameter that is not the default."""
    sources = {
        "mix-4-full": {"pattern": twelve["mix-4-full"]}, "AM0": {"pattern": am["AM0"]},
        "AM20": {"pattern": am["AM20"]}, "rhythm": {"pattern": odd["rhythm"]},
        "burst": {"pattern": odd["burst"]}, "leaking-150.5Hz": {"pattern": odd["leaking-150.5Hz"]},
        "odd-rhythm": {"pattern": odd["odd-rhythm"]}, "awkward-0.1237s": {"pattern": odd["awkward-0.1237s"]},
        "noise": {"noise": noise}, "loud-noise": {"noise": loud}}
    changes = [
        ("share-own", {"share": "own"}, ("mix-4-full", "AM0", "rhythm", "loud-noise")),
        ("peaks", {"components": "peaks"}, ("mix-4-full", "leaking-150.5Hz", "odd-rhythm", "noise",
                                            "loud-noise", "awkward-0.1237s")),
        ("raw", {"envelope": "raw"}, ("AM20", "rhythm")),
        ("layers-0-0", {"L_E": 0, "L_I": 0}, ("mix-4-full", "rhythm", "burst")),
        ("layers-2-2", {"L_E": 2, "L_I": 2}, ("mix-4-full", "rhythm", "loud-noise")),
        ("layers-4-0", {"L_E": 4, "L_I": 0}, ("AM0", "rhythm")),
        ("layers-0-3", {"L_E": 0, "L_I": 3}, ("AM20", "burst")),
        ("weights", {"weights": {"FA1": 0.5, "FA2": 0.1, "SA1": 0.4, "SA2": 1.0}}, ("mix-4-full",)),
    ]
    return [(f"{name}/{label}", sources[name], params)
            for label, params, names in changes for name in names]


def source_g(source):
    """Waveform of a case or set member."""
    if "noise" in source:
        n = source["noise"]
        return model.noise_g(n["seed"], n["samples"], n["amplitude_g"])
    return model.render_g(source["pattern"])


# -------------------------------------------------------------- stages.json

def unique_argmax(values):
    """Index of the largest value, None when another value is within rounding noise of it."""
    order = np.sort(values)
    if len(values) > 1 and order[-1] - order[-2] <= NEAR_TIE * abs(order[-1]):
        return None
    return int(np.argmax(values))


def sampled(values, stride):
    """Every stride-th value as floats."""
    return [float(v) for v in values[::stride]]


def integers(values):
    """Counts as plain integers."""
    return [int(v) for v in values]


def spikes_checksum(steps):
    """Sum of (receptor + 1) * (step + 1) * count, modulo 1,000,003."""
    k = np.arange(1, steps.shape[0] + 1, dtype=object)
    j = np.arange(1, steps.shape[1] + 1, dtype=np.int64)
    return int(np.sum(k * (steps @ j).astype(object)) % CHECKSUM_MODULUS)


def floor_margin(result):
    """How far fires * C + 1e-9 stays from the whole numbers where a count could flip."""
    value = np.outer(result.fires, result.fraction) + model.FLOOR_GUARD
    value = value[value > 0.5]
    return float(np.min(np.abs(value - np.round(value)))) if value.size else 0.5


def layer_table(layers, params):
    """Sum, cells at the cap and centre value of every layer."""
    return [{"kind": "E" if i < params.L_E else "I", "size": int(images.shape[1]),
             "sum": int(images.sum()), "at_cap": int((images == model.SPIKE_CAP).sum()),
             "centre": integers(model.centre(images))} for i, images in enumerate(layers)]


def perceived_table(perceived):
    """Perceived waveform, thinned."""
    magnitude = np.abs(perceived.waveform)
    return {"silent": perceived.silent, "filtered_energy": perceived.filtered_energy,
            "perceived_energy": float(np.sum(perceived.waveform**2)),
            "perceived_max_abs": float(magnitude.max()),
            "perceived_max_index": None if perceived.silent else unique_argmax(magnitude),
            "perceived_every_97th": sampled(perceived.waveform, WAVE_STRIDE)}


def spikes_table(result):
    """Counts of the receptors."""
    middle = int(np.flatnonzero(result.grid.r_mm == 0)[0])
    table = {"centre_receptor": middle, "centre_fires": float(result.fires[middle]),
             "centre_receptor_counts": integers(result.steps[middle]),
             "spikes_total": int(result.steps.sum()), "spikes_checksum": spikes_checksum(result.steps),
             "floor_margin": floor_margin(result)}
    if len(result.grid.row) <= LISTED_RECEPTORS:
        table["receptor_totals"] = integers(result.steps.sum(axis=1))
    return table


def channel_table(result, params):
    """Every stage of one channel."""
    rate = result.rate
    return {"f0_imp_per_s": rate.f0_imp_per_s, "slope_sum": rate.slope_sum, "r_max_mm": rate.r_max_mm,
            "components_above_threshold": rate.components, "n0": result.grid.n0,
            "receptors": len(result.grid.row), **perceived_table(result.perceived),
            **spikes_table(result), "layers": layer_table(result.layers, params),
            "final_counts": integers(result.final_counts)}


def input_table(x_g):
    """The rendered waveform, thinned."""
    return {"samples": len(x_g), "sum_g": float(np.sum(x_g)), "sum_squares_g2": float(np.sum(x_g**2)),
            "every_97th_g": sampled(x_g, WAVE_STRIDE)}


def spectrum_table(components):
    """Number of components kept and the five largest accelerations."""
    largest = np.argsort(-components.amplitude_g, kind="stable")[:5]
    return {"components": len(components.bin),
            "largest": [{"f_hz": float(components.frequency_hz[i]), "A_g": float(components.amplitude_g[i]),
                         "displacement_um": float(components.displacement_um[i])} for i in largest]}


def pbw_table(pbw):
    """Predicted brain waveform, thinned."""
    return {"samples": len(pbw), "sum": float(np.sum(pbw)), "sum_squares": float(np.sum(pbw**2)),
            "every_53rd": sampled(pbw, PBW_STRIDE)}


def envelope_table(y):
    """Envelope feature waveform, thinned; no argmax among near ties."""
    return {"sum": float(np.sum(y)), "argmax": unique_argmax(y), "max": float(np.max(y)),
            "every_97th": sampled(y, WAVE_STRIDE)}


def check_margins(name, components, channels):
    """Refuse a case in which rounding noise could change a count or a grid."""
    for channel, result in channels.items():
        label = f"{name} {channel}"
        require(floor_margin(result) >= COUNT_MARGIN, f"{label}: a spike count hangs on rounding noise")
        require(threshold_margin(channel, components) >= REAL_MARGIN, f"{label}: a component sits on its threshold")
        require(radius_margin(channel, result) >= REAL_MARGIN, f"{label}: a receptor sits on the radius")


def threshold_margin(channel, components):
    """Smallest distance of a component from its threshold, in log10 um."""
    if not len(components.bin):
        return 1.0
    beta = model.threshold_log10_um(channel, components.frequency_hz)
    return float(np.min(np.abs(np.log10(components.displacement_um) - beta)))


def radius_margin(channel, result):
    """Smallest distance of a grid point, or of the grid's size, from r_max, relative."""
    if result.rate.r_max_mm == 0:
        return 1.0
    half = np.arange(result.grid.n0 // 2 + 2) / np.sqrt(model.DENSITY_PER_MM2[channel])
    r_mm = np.hypot(half[:, None], half[None, :]) / result.rate.r_max_mm
    return float(np.min(np.abs(r_mm - 1)))


def stage_table(name, source, changed):
    """One case of stages.json."""
    params, x_g = Params(**changed), source_g(source)
    coding = model.neural_coding(x_g, params)
    check_margins(name, coding.components, coding.channels)
    return {"name": name, **source, "params": changed, "input": input_table(x_g),
            "spectrum": spectrum_table(coding.components),
            "channels": {c: channel_table(coding.channels[c], params) for c in CHANNELS},
            "pbw": pbw_table(coding.pbw), "envelope": envelope_table(model.envelope(x_g, params.envelope))}


# ------------------------------------------------- filters.json, tables.json

GAIN_FREQUENCIES_HZ = (0.5, 1, 2, 3, 5, 10, 15, 30, 60, 100, 150, 250, 400, 500, 1000, 3000)
TABLE_FREQUENCIES_HZ = (1, 1.5, 2, 3, 4.4, 5, 8, 10, 15, 22, 40, 50, 63, 80, 100, 120, 150, 173.2, 200,
                        250, 275, 300, 333, 400, 450, 499, 500)


def filter_table(channel):
    """Impulse response and gains of one channel's filter."""
    sos = model.channel_filter(channel)
    impulse = np.zeros(model.RATE_HZ)
    impulse[0] = 1.0
    response = signal.sosfilt(sos, impulse)
    _, gain = signal.sosfreqz(sos, worN=np.array(GAIN_FREQUENCIES_HZ), fs=model.RATE_HZ)
    return {"edges_hz": list(model.FILTER_EDGES_HZ[channel]), "impulse_first_200": sampled(response[:200], 1),
            "impulse_every_500th": sampled(response, 500), "impulse_max_abs": float(np.max(np.abs(response))),
            "gains": [{"f_hz": f, "gain": float(abs(g))} for f, g in zip(GAIN_FREQUENCIES_HZ, gain)]}


def receptor_table(channel):
    """alpha and beta at and between the knots."""
    return [{"f_hz": f, "slope": float(model.slope(channel, f)),
             "threshold_log10_um": float(model.threshold_log10_um(channel, f))} for f in TABLE_FREQUENCIES_HZ]


# ----------------------------------------------------------- predictions.json

COMMON_CHANGES = ({}, {"share": "own"}, {"components": "peaks"}, {"envelope": "raw"},
                  {"L_E": 1, "L_I": 2, "w_NC": 0.3, "w_OC": 0.7,
                   "weights": {"FA1": 0.5, "FA2": 0.1, "SA1": 0.4, "SA2": 1.0}})

AM_NC = (0.345, 0.342, 0.321, 0.279, 0.148, 0.124, 0.205)
AM_OC = (2184.276, 2383.931, 2484.775, 2447.264, 2158.941, 824.318, 784.763)
AM_OC_RAW = (1391.287, 1520.520, 1602.123, 1631.863, 1693.235, 1894.298, 2093.795)
AM_PM = (19, 22, 22, 18, 10, 2, 3.5, 8.5, 19, 20.5, 19, 17, 19.5, 14, 15.5, 18, 21.5, 23.5, 7, 10.5,
         19.5, 24, 5.5, 11.5, 20.5, 5, 7.5, 2.5)


def check_quantised(label, distances):
    """Refuse a set in which ties fall apart by a few quanta, or nearly fall apart."""
    gaps = np.diff(np.sort(model.quantised(distances)))
    small = gaps[(gaps > 0) & (gaps < 100)]
    require(small.size == 0, f"{label}: values within 1e-7 of the largest are not tied: {small}")


def checked_nc(label, waveforms_g, params):
    """NC distances, refused when a count of any pattern hangs on rounding noise."""
    codings = [model.neural_coding(x, params) for x in model.padded_to_longest(waveforms_g)]
    for i, coding in enumerate(codings):
        check_margins(f"{label}[{i}]", coding.components, coding.channels)
    return model.condensed([c.pbw for c in codings], model.nc_dissimilarity)


def set_result(label, waveforms_g, changed, oc_of_envelope):
    """NC, OC and PM of one set under one choice of parameters."""
    params = Params(**changed)
    if params.envelope not in oc_of_envelope:
        oc_of_envelope[params.envelope] = model.predict_oc(waveforms_g, params)
    nc, oc = checked_nc(label, waveforms_g, params), oc_of_envelope[params.envelope]
    check_quantised(f"{label} {changed} NC", nc)
    check_quantised(f"{label} {changed} OC", oc)
    pm = model.perceptual_dissimilarity(nc, oc, params)
    return {"params": changed, "nc": nc.tolist(), "oc": oc.tolist(), "pm": pm.tolist(),
            "pm_unit": (pm / ((params.w_NC + params.w_OC) * len(pm))).tolist()}


def set_table(label, patterns):
    """One set of predictions.json."""
    waveforms_g, oc_of_envelope = [model.render_g(p) for p in patterns.values()], {}
    return {"name": label, "duration_s": max(p["duration_s"] for p in patterns.values()),
            "patterns": [{"name": n, **p} for n, p in patterns.items()],
            "results": [set_result(label, waveforms_g, c, oc_of_envelope) for c in COMMON_CHANGES]}


def result_of(table, changed):
    """The result of a set under the given changes."""
    return next(r for r in table["results"] if r["params"] == changed)


def check_rounded(label, found, printed):
    """Numbers printed to three places."""
    for i, (f, p) in enumerate(zip(found, printed)):
        require(abs(f - p) <= 0.5001e-3, f"{label}[{i}] is {f}, printed {p}")


def check_am(table):
    """Section 7: the eight AM patterns, 5 Hz."""
    default, raw = result_of(table, {}), result_of(table, {"envelope": "raw"})
    check_rounded("AM NC", default["nc"][:7], AM_NC)
    check_rounded("AM OC", default["oc"][:7], AM_OC)
    check_rounded("AM OC raw", raw["oc"][:7], AM_OC_RAW)
    require(tuple(default["pm"]) == AM_PM, f"AM PM is {default['pm']}")


def check_twelve(table):
    """Section 7: mean rank of PM within and between (modulation, amplitude) clusters.

    The printed means are of the ranks 1..66 of the PM values, not of the PM values themselves.
    """
    cluster = [p["name"].split("-", 1)[1] for p in table["patterns"]]
    same = model.condensed(cluster, lambda a, b: a == b).astype(bool)
    rank = model.average_ranks(result_of(table, {})["pm"])
    table["pm_ranks_default"] = rank.tolist()
    table["mean_pm_rank_within"], table["mean_pm_rank_between"] = float(rank[same].mean()), float(rank[~same].mean())
    check_printed("within", table["mean_pm_rank_within"], 18.21)
    check_printed("between", table["mean_pm_rank_between"], 36.90)


def check_printed(label, found, printed):
    """A mean printed to two places."""
    require(abs(found - printed) <= 0.5001e-2, f"mean PM rank {label} is {found}, printed {printed}")


def rank_tables():
    """Average ranks after quantisation: near ties, an all-tied vector, silence."""
    vectors = [[0.3, 0.1, 0.3 + 1e-13, 0.7, 0.1 - 2e-14, 0.30000001, 0.0, 0.7],
               [5.0, 5.0 + 1e-12, 5.0 - 1e-12], [0.0, 1e-17, 0.0], [3e-16, 1e-7, 5e-7, 2e-7],
               [10, 20, 20, 40, 50, 50, 50], [2.0]]
    return [{"values": v, "quantised": integers(model.quantised(v)),
             "ranks": model.average_ranks(v).tolist()} for v in vectors]


def prediction_tables():
    """All sets, checked against section 7."""
    am5, twelve = set_table("am-8-5Hz", am_patterns(5)), set_table("twelve", twelve_patterns())
    check_am(am5)
    check_twelve(twelve)
    return {"sets": [am5, set_table("am-8-4Hz", am_patterns(4)), twelve,
                     set_table("rhythm-6", rhythm_patterns())], "ranks": rank_tables()}


# ------------------------------------------------------------------ dtw.json

def dtw_plain(a, b):
    """The textbook double loop."""
    table = [[np.inf] * (len(b) + 1) for _ in range(len(a) + 1)]
    table[0][0] = 0.0
    for i, x in enumerate(a, 1):
        for j, y in enumerate(b, 1):
            table[i][j] = abs(x - y) + min(table[i - 1][j - 1], table[i - 1][j], table[i][j - 1])
    return float(table[-1][-1])


def dtw_cases():
    """(name, x, y, printed value or None)."""
    n = np.arange(50)
    sine_2, sine_3 = (np.sin(2 * np.pi * f * n / 50).tolist() for f in (2, 3))
    cases = [("shifted ramp", [0, 1, 2, 1, 0], [0, 0, 1, 2, 2, 1, 0], 0.0),
             ("textbook", [1, 3, 4, 9], [1, 3, 7, 8, 9], 4.0), ("constants", [2] * 3, [5] * 4, 12.0),
             ("one sample", [2], [1, 4, 2], 3.0), ("swapped halves", [0, 0, 1, 1], [1, 1, 0, 0], 4.0),
             ("sines 2 and 3 Hz", sine_2, sine_3, 13.0649457957637), ("both of length one", [1.5], [-2.25], 3.75)]
    rng = np.random.default_rng(20230423)
    lengths = [(1, 40), (40, 1)] + [tuple(rng.integers(1, 41, 2)) for _ in range(30)]
    for i, (a, b) in enumerate(lengths):
        x, y = (np.round(rng.normal(size=int(k)), 6).tolist() for k in (a, b))
        cases.append((f"random {i}", x, y, None))
    return cases


def dtw_table(name, x, y, printed):
    """One case, computed twice."""
    value = dtw_plain(x, y)
    require(abs(model.dtw(x, y) - value) <= 1e-12 * max(1.0, value), f"dtw {name}: two methods differ")
    require(printed is None or abs(value - printed) <= 1e-12, f"dtw {name} is {value}, printed {printed}")
    return {"name": name, "x": x, "y": y, "distance": value}


# --------------------------------------------------- Comparison with the tables

def csv_rows(path):
    """Rows of a table without its comment lines."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def check_knots(path, knots, value_column):
    """Typed knots equal the published table."""
    rows = csv_rows(path)
    for channel in CHANNELS:
        found = [(float(r["frequency_hz"]), float(r[value_column])) for r in rows if r["receptor"] == channel]
        require(found == [(float(f), float(v)) for f, v in knots[channel]], f"{path.name}: {channel} differs")


def check_pattern_lists(folder):
    """Typed pattern sets equal the published lists."""
    twelve = twelve_patterns()
    for row in csv_rows(folder / "pm_2023_own_12.csv"):
        weights = {c["frequency_hz"]: c["weight"] for c in twelve[row["id"]]["carriers"]}
        found = (twelve[row["id"]]["amplitude_g"], twelve[row["id"]]["modulation"]["frequency_hz"],
                 weights.get(70.0, 0.0), weights.get(210.0, 0.0), twelve[row["id"]]["duration_s"])
        require(found == tuple(float(row[c]) for c in ("amp_g", "fe_hz", "w_70", "w_210", "duration_s")),
                f"pattern {row['id']} differs")
    require(list(twelve) == [r["id"] for r in csv_rows(folder / "pm_2023_own_12.csv")], "order of the twelve differs")
    for column, reading in (("fm_hz_author_file", 5), ("fm_hz_paper_caption", 4)):
        found = [float(r[column]) for r in csv_rows(folder / "park_choi_2011_am.csv")]
        require(found == [p["modulation"]["frequency_hz"] for p in am_patterns(reading).values()], f"{column} differs")


def check_tables(folder):
    """Everything typed in against the published tables."""
    check_knots(folder / "firing_rate_slopes.csv", model.SLOPE_KNOTS, "slope_imp_per_s_per_log10um")
    check_knots(folder / "absolute_thresholds.csv", model.THRESHOLD_KNOTS, "threshold_log10_um_peak")
    check_pattern_lists(folder)
    print("typed knots and pattern lists equal the tables")


# ------------------------------------------------------------------- Writing

def write(name, what, content):
    """One golden file: provenance first, compact."""
    made_by = {"command": COMMAND, "python": platform.python_version(), "numpy": np.__version__,
               "scipy": scipy.__version__}
    text = json.dumps({"made_by": made_by, "what": what, **content}, separators=(",", ":"), allow_nan=False)
    (FOLDER / name).write_text(text + "\n", encoding="utf-8")
    print(f"{name}: {len(text) // 1024} KiB")


def main():
    """Check, compute, write."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--tables", type=pathlib.Path, help="folder with the published tables")
    tables = arguments.parse_args().tables
    if tables:
        check_tables(tables)
    model.check_published_values()
    write("dtw.json", "dynamic time warping, |x - y| summed along the best path",
          {"cases": [dtw_table(*case) for case in dtw_cases()]})
    write("filters.json", "the four Butterworth filters at 10 kHz, before differentiation",
          {"filters": {c: filter_table(c) for c in CHANNELS}})
    write("tables.json", "slopes (impulses/s per log10 um) and thresholds (log10 um peak) at and between knots",
          {"receptors": {c: receptor_table(c) for c in CHANNELS}})
    write("stages.json", "every stage of the model for single patterns and noise",
          {"cases": [stage_table(*case) for case in stage_cases()]})
    write("predictions.json", "NC, OC and PM of whole sets in condensed order, and ranks with near ties",
          prediction_tables())


if __name__ == "__main__":
    main()
