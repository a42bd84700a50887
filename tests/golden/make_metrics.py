"""Writes metrics.json: the rival and reference metrics, from an independent implementation.

Source   the definitions of the design page of the metrics, sections 1-6 and 13; pattern synthesis
         and neural coding from reference_model.py beside this file.
What     metrics.json: every metric on four sets in condensed order, and changed options on two of
         them. Stops with a sentence when a worked example printed in the design page is not met.
         Written for reading and without a look at the C++ code: spectra by numpy.fft, cosine
         transforms by scipy.fft, the normal distribution and ranks by scipy.stats.
Run      python3 tests/golden/make_metrics.py     (predictions.json beside it gives the OC part)
Needs    Python 3.11, NumPy 1.24, SciPy 1.10 (Debian 12: python3-numpy, python3-scipy).
"""

import json
import pathlib
import platform
import sys

sys.dont_write_bytecode = True

import numpy as np
import scipy
from scipy import fft, signal, special, stats

import make_golden
import reference_model as model
from reference_model import CHANNELS, RATE_HZ, Params, require

FOLDER = pathlib.Path(__file__).parent
SETS = FOLDER.parent.parent / "assets" / "sets"
COMMAND = "python3 tests/golden/make_metrics.py"
EPS = 2.22e-16


# ------------------------------------------------------------- Spectral metrics

def amplitudes(x):
    """One-sided peak amplitudes."""
    a = 2 * np.abs(np.fft.rfft(x)) / len(x)
    a[0] /= 2
    if len(x) % 2 == 0:
        a[-1] /= 2
    return a


def in_band(samples, bins, low_hz, high_hz, rate_hz):
    f_hz = np.arange(bins) * rate_hz / samples
    return (f_hz >= low_hz) & (f_hz <= high_hz)


def rms(v):
    return float(np.sqrt(np.mean(np.square(v))))


def spectral_rmse(x, y, kind="rmse", low_hz=0.0, high_hz=np.inf, decibel=False, smoothing=1,
                  rate_hz=RATE_HZ):
    a, b = amplitudes(x), amplitudes(y)
    if decibel:
        a, b = (20 * np.log10(np.maximum(v, 1e-6)) for v in (a, b))
    if smoothing > 1:
        a, b = (moving_mean(v, smoothing) for v in (a, b))
    band = in_band(len(x), len(a), low_hz, high_hz, rate_hz)
    a, b = a[band], b[band]
    if kind == "normalised":
        return rms(a - b) / rms(a)
    if kind == "gfc":
        return 1 - abs(np.sum(a * b)) / np.sqrt(np.sum(a * a) * np.sum(b * b))
    return rms(a - b)


def moving_mean(v, bins):
    """Centred mean of an odd number of bins, of fewer at the ends."""
    ones = np.ones(bins)
    return np.convolve(v, ones, "same") / np.convolve(np.ones_like(v), ones, "same")


def smoothed(a, fraction, mean_of, bins):
    """Mean over a window proportional to the frequency, of the first bins."""
    out = np.empty(bins)
    for k in range(bins):
        half = int(np.floor(fraction / 2 * k + 1e-9))
        window = a[max(0, k - half):k + half + 1]
        out[k] = rms(window) if mean_of == "squares" else float(np.mean(window))
    return out


def spectral_matching(x, y, fraction=0.10, low_hz=1.0, high_hz=1000.0, mean_of="squares",
                      normalised=False, rate_hz=RATE_HZ):
    a, b = amplitudes(x), amplitudes(y)
    band = in_band(len(x), len(a), low_hz, high_hz, rate_hz)
    top = int(np.flatnonzero(band)[-1])
    a, b = (smoothed(v, fraction, mean_of, top + 1)[band[:top + 1]] for v in (a, b))
    scale = np.sqrt((rms(a) ** 2 + rms(b) ** 2) / 2) if normalised else 1.0
    return rms(a - b) / scale


def temporal_matching(x, y, remove_mean=True, magnitude=False, any_lag=False):
    if remove_mean:
        x, y = x - np.mean(x), y - np.mean(y)
    lags = signal.correlate(x, y, "full", "direct") if any_lag else np.array([np.sum(x * y)])
    r = lags / np.sqrt(np.sum(x * x) * np.sum(y * y))
    return float(1 - np.max(np.abs(r) if magnitude else r))


# ----------------------------------------------------------- ST-SIM and SPQI

def threshold_db(block, rate_hz):
    """Held from the first value above zero on."""
    f_hz = np.arange(block) * rate_hz / (2 * block - 1)
    corner = np.log10(6 / 11)
    t = np.abs(62 / corner**2 * np.log10(f_hz / 550 + 6 / 11) ** 2) - 77
    if (t > 0).any():
        first = int(np.argmax(t > 0))
        t[first:] = t[first]
    return t


def blocks_of(x, block):
    """Whole blocks, the remainder cut off; at least one."""
    x = np.pad(x, (0, max(0, block - len(x))))
    count = len(x) // block
    return x[:count * block].reshape(count, block)


def levels_db(blocks, rate_hz):
    with np.errstate(divide="ignore"):
        level = 20 * np.log10(np.abs(fft.dct(blocks, type=2, norm="ortho", axis=1)))
    return level - threshold_db(blocks.shape[1], rate_hz)


def z_normalised(blocks):
    centred = blocks - blocks.mean(axis=1, keepdims=True)
    return centred / (blocks.std(axis=1, keepdims=True) + EPS)


def st_sim(ref, dist, block=512, rate_hz=RATE_HZ, gain=1.0, clamped=False, skip_silent=False):
    """(S-SIM, T-SIM, ST-SIM); a negative T-SIM keeps its sign through the power."""
    r, d = gain * blocks_of(ref, block), gain * blocks_of(dist, block)
    if np.array_equal(r, d):
        return 1.0, 1.0, 1.0
    if skip_silent:
        sounding = (r != 0).any(axis=1) | (d != 0).any(axis=1)
        r, d = r[sounding], d[sounding]
    s_r, s_d = (stats.norm.cdf(levels_db(v, rate_hz) / 12) for v in (r, d))
    u_r, u_d = z_normalised(r), z_normalised(d)
    s = np.mean(np.sum(s_r * s_d, axis=1) / (np.sum(s_r**2, axis=1) + EPS))
    t = np.mean(np.sum(u_r * u_d, axis=1) / (np.sum(u_r**2, axis=1) + EPS))
    if clamped:
        t = max(t, 0.0)
    return float(s), float(t), float(np.sign(t) * np.abs(t) ** (2 / 3) * s ** (1 / 3))


def block_errors_db(ref, dist, block=512, rate_hz=RATE_HZ):
    q_r, q_d = (10 ** (levels_db(blocks_of(v, block), rate_hz) / 10) for v in (ref, dist))
    with np.errstate(divide="ignore"):
        return 10 * np.log10(np.sum(np.abs(q_r - q_d), axis=1) / (np.sum(q_r, axis=1) + EPS))


def block_scores(errors_db):
    """(1 - tanh(0.3 E + 2)) / 2, which is the logistic function of -2 (0.3 E + 2)."""
    return special.expit(-2 * (0.3 * errors_db + 2))


def spqi(ref, dist, block=512, rate_hz=RATE_HZ):
    return float(np.mean(block_scores(block_errors_db(ref, dist, block, rate_hz))))


def error_distance_db(ref, dist):
    """Mean block error within +-60 dB, from 0 for equal signals."""
    return 60 + float(np.mean(np.clip(block_errors_db(ref, dist), -60, 60)))


def both_ways(similarity):
    return lambda x, y: 1 - (similarity(x, y) + similarity(y, x)) / 2


# --------------------------------------------------------- Reference metrics

def level_difference_db(x, y):
    levels = [20 * np.log10(max(rms(v - np.mean(v)), 1e-6)) for v in (x, y)]
    return float(abs(levels[0] - levels[1]))


def band_levels_db(x):
    """Nine bands of 5-1000 Hz: power over the threshold of the keenest receptor, in dB, from 0."""
    a = amplitudes(x - np.mean(x))
    f_hz = np.arange(len(a)) * RATE_HZ / len(x)
    edges_hz = 5 * 200 ** (np.arange(10) / 9)
    out = np.zeros(9)
    for b in range(9):
        last = f_hz <= 1000 * (1 + 1e-12) if b == 8 else f_hz < edges_hz[b + 1]
        k = np.flatnonzero((f_hz >= edges_hz[b]) & last)
        displacement_um = a[k] * model.GRAVITY_UM_PER_S2 / (2 * np.pi * f_hz[k]) ** 2
        threshold = np.min([model.threshold_log10_um(c, f_hz[k]) for c in CHANNELS], axis=0)
        power = np.sum((displacement_um / 10**threshold) ** 2)
        out[b] = 10 * np.log10(max(power, 1.0))
    return out


def bands_distance(x, y):
    return float(np.linalg.norm(band_levels_db(x) - band_levels_db(y)))


def balance_db(x):
    """Power of 100 to 1000 Hz over that of 10 to 100 Hz, in dB, each lifted by a millionth of both."""
    power = amplitudes(x - np.mean(x)) ** 2
    f_hz = np.arange(len(power)) * RATE_HZ / len(x)
    low = np.sum(power[(f_hz >= 10) & (f_hz < 100)])
    high = np.sum(power[(f_hz >= 100) & (f_hz <= 1000)])
    least = 1e-6 * (low + high)
    return 10 * np.log10((high + least) / (low + least)) if least > 0 else 0.0


def balance_distance(x, y):
    return float(abs(balance_db(x) - balance_db(y)))


def van_rossum_of_spikes(s, tau_s=0.01):
    """From the kernel: D^2 = 1/2 sum_ij s_i s_j exp(-|t_i - t_j| / tau) over all spikes."""
    place = np.flatnonzero(s)
    gap_s = np.abs(place[:, None] - place[None, :]) / RATE_HZ
    return float(np.sqrt(0.5 * s[place] @ np.exp(-gap_s / tau_s) @ s[place]))


def van_rossum(s, tau_s=0.01):
    """The same sum over a long train: sum_i s_i (s_i / 2 + sum_{j<i} s_j exp(-(t_i - t_j) / tau))."""
    decay = np.exp(-1 / (RATE_HZ * tau_s))
    trace = signal.lfilter([1.0], [1.0, -decay], s)
    return float(np.sqrt(max(0.0, np.sum(s * (trace - s / 2)))))


def van_rossum_of_waveforms(a, b, lines, params):
    """On the weighted sum of the channels, or channel by channel."""
    if not lines:
        return van_rossum(a.pbw - b.pbw)
    parts = [params.weights[c] * van_rossum(a.channels[c].signal - b.channels[c].signal)
             for c in CHANNELS]
    return float(np.linalg.norm(parts))


# ------------------------------------------------------------ Worked examples

def met(label, found, printed, tolerance):
    require(abs(found - printed) <= tolerance, f"{label} is {found!r}, printed {printed}")


def check_spectral_examples():
    n = np.arange(16)
    x = np.sin(2 * np.pi * 2 * n / 16)
    y = 0.5 * x + 0.25 * np.cos(2 * np.pi * 5 * n / 16)
    met("RMSE", spectral_rmse(x, y, rate_hz=16), .186338998124983, 1e-14)
    met("RMSE of bins 1..7", spectral_rmse(x, y, low_hz=1, high_hz=7, rate_hz=16),
        .211288563682129, 1e-14)
    met("normalised RMSE", spectral_rmse(x, y, "normalised", rate_hz=16), .559016994374947, 1e-14)
    met("GFC", 1 - spectral_rmse(x, y, "gfc", rate_hz=16), .894427190999916, 1e-14)
    t_s = np.arange(1000) / 1000
    tone = lambda f_hz: np.sin(2 * np.pi * f_hz * t_s)
    for other, printed in ((tone(104), .0402015126103682), (tone(112), .0630856400442916),
                           (tone(200), .0630458995373182), (tone(100) / 2, .0222474604157305),
                           (0 * t_s, .044494920831461)):
        met("Msm", spectral_matching(tone(100), other, high_hz=500, rate_hz=1000), printed, 1e-14)
    met("Mtm", temporal_matching(np.array([1., 0, -1, 0]), np.array([1., 1, -1, -1])),
        .292893218813453, 1e-14)


def check_van_rossum():
    """Both forms, on spikes of every sign."""
    s = np.random.default_rng(11).integers(-1, 2, 2000) * 0.7
    met("van Rossum", van_rossum(s), van_rossum_of_spikes(s), 1e-11)
    met("van Rossum of one spike", van_rossum(np.array([0., 1, 0])), np.sqrt(0.5), 1e-15)


def check_similarity_examples():
    ref = np.array([.3, -.1, .4, .1, -.5, .9, -.2, .6])
    dist = np.array([.2, -.1, .5, 0, -.5, .7, -.2, .6])
    found = st_sim(ref, dist, 4, 8000)
    for label, f, printed in zip("S T ST".split(), found,
                                 (.919391921531628, .965191737837546, .949677083457203)):
        met(label, f, printed, 1e-14)
    met("ST reversed", st_sim(dist, ref, 4, 8000)[2], 1.00459245178233, 1e-13)
    met("SPQI", spqi(ref, dist, 4, 8000), .251984373133486, 1e-14)
    met("SPQI reversed", spqi(dist, ref, 4, 8000), .120302686163423, 1e-14)
    t_s = np.arange(8000) / 8000
    s70, s210 = (np.sin(2 * np.pi * f_hz * t_s) for f_hz in (70, 210))
    mix, am = .5 * s70 + .5 * s210, np.sin(2 * np.pi * 4 * t_s) * s70
    met("ST of the mix", st_sim(s70, mix, rate_hz=8000)[2], .797462491638, 1e-11)
    met("ST of the AM", st_sim(s70, am, rate_hz=8000)[2], .121003733767, 1e-11)
    met("ST of 210 Hz and the AM", st_sim(s210, am, rate_hz=8000)[2], -.0169350410793, 1e-12)
    met("SPQI of half", spqi(s70, s70 / 2, rate_hz=8000), .0373136811084, 1e-12)
    met("SPQI of twice", spqi(s70 / 2, s70, rate_hz=8000), .0010449637967, 1e-12)
    met("SPQI of the AM", spqi(s70, am, rate_hz=8000), .0749271645587, 1e-12)


# ------------------------------------------------------------------- Matrices

def waveform_metrics():
    """key -> distance of two waveforms."""
    return {"rmse": spectral_rmse, "msm": spectral_matching, "mtm": temporal_matching,
            "st-sim": both_ways(lambda x, y: st_sim(x, y)[2]), "spqi": both_ways(spqi),
            "level": level_difference_db, "bands": bands_distance, "balance": balance_distance}


def changed_metrics():
    """label -> distance of two waveforms with an option that is not the default."""
    one_way = lambda **change: lambda x, y: 1 - st_sim(x, y, **change)[2]
    two_ways = lambda **change: both_ways(lambda x, y: st_sim(x, y, **change)[2])
    return {
        "rmse/decibel": lambda x, y: spectral_rmse(x, y, decibel=True, high_hz=1000, low_hz=1),
        "rmse/normalised": lambda x, y: spectral_rmse(x, y, "normalised"),
        "rmse/smoothed": lambda x, y: spectral_rmse(x, y, smoothing=5),
        "rmse/gfc": lambda x, y: spectral_rmse(x, y, "gfc"),
        "msm/wide": lambda x, y: spectral_matching(x, y, fraction=0.20),
        "msm/mean": lambda x, y: spectral_matching(x, y, mean_of="amplitudes"),
        "msm/normalised": lambda x, y: spectral_matching(x, y, normalised=True),
        "mtm/magnitude": lambda x, y: temporal_matching(x, y, magnitude=True),
        "mtm/with mean": lambda x, y: temporal_matching(x, y, remove_mean=False),
        "st-sim/upper": one_way(), "st-sim/clamped": two_ways(clamped=True),
        "st-sim/8000": two_ways(rate_hz=8000), "st-sim/m_per_s2": two_ways(gain=9.80665),
        "st-sim/skip silent": two_ways(skip_silent=True),
        "spqi/upper": lambda x, y: 1 - spqi(x, y),
        "spqi/error": lambda x, y: (error_distance_db(x, y) + error_distance_db(y, x)) / 2,
    }


def oc_of(name):
    """OC of a set as make_golden.py found it; None where it has not."""
    sets = json.loads((FOLDER / "predictions.json").read_text(encoding="utf-8"))["sets"]
    found = [s for s in sets if s["name"] == name]
    return make_golden.result_of(found[0], {})["oc"] if found else None


def set_table(name, patterns, changes):
    """One set: waveforms padded to the longest, DTW on every tenth sample of the unpadded ones."""
    print(name, flush=True)
    rendered = [model.render_g(p) for p in patterns.values()]
    padded = model.padded_to_longest(rendered)
    params = Params()
    codes = [model.neural_coding(x, params) for x in padded]
    matrices = {key: model.condensed(padded, d).tolist() for key, d in waveform_metrics().items()}
    matrices["dtw of every tenth"] = model.condensed([x[::10] for x in rendered], model.dtw).tolist()
    for key, lines in (("van-rossum", False), ("van-rossum/lines", True)):
        matrices[key] = model.condensed(
            codes, lambda a, b: van_rossum_of_waveforms(a, b, lines, params)).tolist()
    table = {"name": name, "patterns": [{"name": n, **p} for n, p in patterns.items()],
             "matrices": matrices,
             "changed": {label: model.condensed(padded, d).tolist()
                         for label, d in changed_metrics().items()} if changes else {}}
    if (oc := oc_of(name)) is not None:
        ranks = [model.average_ranks(d) for d in (matrices["msm"], matrices["mtm"], oc)]
        table["oc"], table["no-physiology"] = oc, np.mean(ranks, axis=0).tolist()
    return table


def file_patterns(name):
    """The patterns of a set file, in full."""
    text = json.loads((SETS / name).read_text(encoding="utf-8"))
    out = {}
    for p in text["patterns"]:
        require(set(p) <= {"name", "note", "amplitude_g", "carriers", "rhythm"},
                f"{name}: pattern {p['name']} has fields this program does not read")
        carriers = [(c["frequency_hz"], c["weight"]) for c in p["carriers"]]
        rhythm = (p["rhythm"]["text"], p["rhythm"]["unit_s"])
        out[p["name"]] = make_golden.pattern(p["amplitude_g"], carriers, rhythm=rhythm,
                                             duration_s=text["duration_s"])
    return out


def check_published_properties(am):
    """What the design page says of the AM set."""
    levels = np.unique(np.round(am["matrices"]["rmse"], 12))
    require(np.allclose(levels, [.014140721622, .017318776285], atol=2e-12),
            f"RMSE of the AM set has the levels {levels}")
    require(np.allclose(am["matrices"]["mtm"], 1, atol=1e-14), "Mtm of the AM set is not all 1")


def main():
    """Check, compute, write."""
    check_spectral_examples()
    check_similarity_examples()
    check_van_rossum()
    am = set_table("am-8-5Hz", make_golden.am_patterns(5), True)
    check_published_properties(am)
    sets = [am, set_table("twelve", make_golden.twelve_patterns(), False),
            set_table("rhythms-12", file_patterns("rhythms_tactspace.tactspace.json"), False),
            set_table("rhythm-6", make_golden.rhythm_patterns(), True)]
    made_by = {"command": COMMAND, "python": platform.python_version(), "numpy": np.__version__,
               "scipy": scipy.__version__}
    text = json.dumps({"made_by": made_by, "what": "rival and reference metrics of whole sets in "
                       "condensed order", "sets": sets}, separators=(",", ":"), allow_nan=False)
    (FOLDER / "metrics.json").write_text(text + "\n", encoding="utf-8")
    print(f"metrics.json: {len(text) // 1024} KiB")


if __name__ == "__main__":
    main()
