"""Independent reference of the physiology-based model (PM), for the golden tables.

Source   Lim & Park, "Can a Computer Tell Differences between Vibrations?", CHI 2023,
         sections 3-5, with the open choices fixed as in the project's design page of the model.
What     Pattern -> waveform -> receptors -> spikes -> relay networks -> predicted brain
         waveform (NC); waveform -> envelope -> dynamic time warping (OC); ranks -> PM.
         Written for reading, not for speed, and without a look at the C++ code: filters by
         scipy.signal, spectra by numpy.fft, whole relay layers by direct convolution, ranks
         by scipy.stats.
Run      python3 tests/golden/reference_model.py     (compares itself with the published check values)
         python3 tests/golden/make_golden.py         (writes the golden tables)
Needs    Python 3.11, NumPy 1.24, SciPy 1.10 (Debian 12: python3-numpy, python3-scipy).
Omitted  Resampling, multidimensional scaling, training.
"""

from dataclasses import dataclass, field
import math

import numpy as np
from scipy import signal, stats

RATE_HZ = 10_000
GRAVITY_UM_PER_S2 = 9.80665e6
BAND_LOW_HZ, BAND_HIGH_HZ = 1, 500
MIN_AMPLITUDE_G = 1e-9
PEAK_FRACTION = 0.03
SILENCE_ENERGY_FRACTION = 1e-12
NEAR_FIELD_MM = 1.5
WINDOW_SAMPLES = 100
STEP_SAMPLES = 50
FLOOR_GUARD = 1e-9
SPIKE_CAP = 50
QUANTISATION = 1e9
QUANTISATION_MIN_SCALE = 1e-6

CHANNELS = ("FA1", "FA2", "SA1", "SA2")
DENSITY_PER_MM2 = {"FA1": 1.4, "FA2": 0.2, "SA1": 0.7, "SA2": 0.1}
FILTER_EDGES_HZ = {"FA1": (3, 100), "FA2": (10, 500), "SA1": (None, 5), "SA2": (15, 400)}
DIFFERENTIATED = ("FA1", "FA2")
PUBLISHED_WEIGHTS = {"FA1": 0.2, "FA2": 0.7, "SA1": 0.0, "SA2": 0.5}

EXCITATORY = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])
INHIBITORY = np.array([[0, -1, 0], [-1, 5, -1], [0, -1, 0]])

# Knots (frequency_hz, impulses per s per log10 um); firing_rate_slopes.csv.
_SLOW_SLOPES = [(1, 1.4), (5, 7), (10, 14), (20, 28.5), (50, 80.6), (100, 103.9),
                (200, 45), (300, 15), (500, 2)]
SLOPE_KNOTS = {
    "FA1": [(1, 2.3), (5, 11), (10, 22), (20, 44.9), (50, 95.5), (100, 174.7), (300, 450), (500, 450)],
    "FA2": [(1, 3), (5, 10), (10, 18), (20, 34.1), (50, 52), (100, 66.5), (300, 141.4), (500, 240)],
    "SA1": _SLOW_SLOPES,
    "SA2": _SLOW_SLOPES,
}

# Knots (frequency_hz, log10 um peak); absolute_thresholds.csv.
THRESHOLD_KNOTS = {
    "FA1": [(1, 1.920), (3, 1.520), (10, 1.085), (20, 0.835), (40, 0.585), (50, 0.550),
            (100, 0.625), (200, 1.000), (500, 1.650)],
    "FA2": [(1, 3.775), (10, 1.785), (20, 1.185), (40, 0.585), (80, -0.015), (150, -0.560),
            (250, -1.000), (300, -1.000), (400, -0.800), (500, -0.600)],
    "SA1": [(0.4, 1.450), (1, 1.450), (3, 1.450), (10, 1.450), (30, 1.475), (100, 1.550), (500, 1.800)],
    "SA2": [(1, 2.790), (15, 1.715), (30, 1.440), (60, 1.165), (120, 0.890), (250, 0.600),
            (300, 0.600), (500, 0.900)],
}


@dataclass
class Params:
    """The named choices of the model; the defaults are the published ones."""

    L_E: int = 3
    L_I: int = 1
    weights: dict = field(default_factory=lambda: dict(PUBLISHED_WEIGHTS))
    share: str = "total"          # total | own
    components: str = "all"       # all | peaks
    envelope: str = "normalised"  # normalised | raw
    w_NC: float = 0.5
    w_OC: float = 0.5


# ---------------------------------------------------------------- 0. Patterns

def nearest_sample(time_s):
    """Sample index of a time, halves rounded up."""
    return math.floor(time_s * RATE_HZ + 0.5)


def rhythm_notes(text, unit_s, duration_s):
    """Notes (onset_s, length_s) of a rhythm text repeated to fill the duration.

    A '=' that follows no note is a rest. The repeated text is read as one long text.
    """
    if not text:
        return [(0.0, duration_s)]
    slots = math.ceil(duration_s / unit_s - 1e-9)
    notes = []   # [first slot, number of slots]
    sounding = False
    for slot in range(slots):
        mark = text[slot % len(text)]
        if mark == "x":
            notes.append([slot, 1])
            sounding = True
        elif mark == "=" and sounding:
            notes[-1][1] += 1
        else:
            sounding = False
    return [(first * unit_s, count * unit_s) for first, count in notes]


def note_gate(start, end, attack_s, release_s):
    """Gate of the samples start..end-1 of one note: linear ramps, the lower one wins."""
    n = np.arange(start, end)
    gate = np.ones(end - start)
    if attack_s > 0:
        gate = np.minimum(gate, (n - start) / RATE_HZ / attack_s)
    if release_s > 0:
        gate = np.minimum(gate, (end - n) / RATE_HZ / release_s)
    return gate


def rhythm_gate(pattern, samples):
    """r[n] of the whole pattern."""
    rhythm = pattern.get("rhythm") or {}
    gate = np.zeros(samples)
    for onset_s, length_s in rhythm_notes(rhythm.get("text", ""), rhythm.get("unit_s", 0.0),
                                          pattern["duration_s"]):
        start = nearest_sample(onset_s)
        end = min(nearest_sample(onset_s + length_s), samples)
        if end > start:
            gate[start:end] = note_gate(start, end, pattern.get("attack_s", 0.0),
                                        pattern.get("release_s", 0.0))
    return gate


def modulation_factor(modulation, time_s):
    """e(t): 'product' is a sine (1 at 0 Hz), 'am' is 1 + depth * sine."""
    sine = np.sin(2 * np.pi * modulation["frequency_hz"] * time_s)
    if modulation["kind"] == "am":
        return 1 + modulation["depth"] * sine
    return sine if modulation["frequency_hz"] > 0 else np.ones_like(time_s)


def render_g(pattern):
    """Acceleration in g of a parametric pattern at 10 kHz, sample n at n / 10,000 s."""
    samples = nearest_sample(pattern["duration_s"])
    time_s = np.arange(samples) / RATE_HZ
    carriers = sum(c["weight"] * np.sin(2 * np.pi * c["frequency_hz"] * time_s + c["phase_rad"])
                   for c in pattern["carriers"])
    return (pattern["amplitude_g"] * modulation_factor(pattern["modulation"], time_s)
            * rhythm_gate(pattern, samples) * carriers)


def noise_g(seed, samples, amplitude_g):
    """Portable white noise: 32-bit linear congruential generator, stepped before each sample."""
    state = seed
    out = np.empty(samples)
    for n in range(samples):
        state = (1664525 * state + 1013904223) % 2**32
        out[n] = amplitude_g * (state / 2**31 - 1)
    return out


def padded_to_longest(waveforms_g):
    """All waveforms of a set, zero-padded at the end to the longest."""
    longest = max(len(x) for x in waveforms_g)
    return [np.pad(x, (0, longest - len(x))) for x in waveforms_g]


# ------------------------------------------------- 1. Mechanoreceptor activation

@dataclass
class Spectrum:
    """Components of 1-500 Hz above 1e-9 g."""

    bin: np.ndarray
    frequency_hz: np.ndarray
    amplitude_g: np.ndarray
    displacement_um: np.ndarray


def amplitudes_g(x_g):
    """One-sided peak amplitude 2|X_k|/N of every bin."""
    return 2 * np.abs(np.fft.rfft(x_g)) / len(x_g)


def band_bins(samples, bins):
    """Bins whose frequency lies in 1-500 Hz, compared in whole numbers."""
    k = np.arange(bins)
    return k[(k * RATE_HZ >= BAND_LOW_HZ * samples) & (k * RATE_HZ <= BAND_HIGH_HZ * samples)]


def is_peak(amplitude_g, k, largest_g):
    """Local maximum of at least 3 % of the largest; neighbours may lie outside the band."""
    above = amplitude_g[k + 1] if k + 1 < len(amplitude_g) else 0.0
    return (amplitude_g[k] >= amplitude_g[k - 1] and amplitude_g[k] > above
            and amplitude_g[k] >= PEAK_FRACTION * largest_g)


def spectrum(x_g, components="all"):
    """Components of the mean-removed signal with their displacement."""
    amplitude_g = amplitudes_g(x_g)
    band = band_bins(len(x_g), len(amplitude_g))
    kept = band[amplitude_g[band] > MIN_AMPLITUDE_G]
    if components == "peaks" and len(kept):
        largest_g = amplitude_g[band].max()
        kept = np.array([k for k in kept if is_peak(amplitude_g, k, largest_g)], dtype=int)
    frequency_hz = kept * RATE_HZ / len(x_g)
    displacement_um = amplitude_g[kept] * GRAVITY_UM_PER_S2 / (2 * np.pi * frequency_hz) ** 2
    return Spectrum(kept, frequency_hz, amplitude_g[kept], displacement_um)


def table_value(knots, frequency_hz):
    """Linear in log10 f between knots, held outside them."""
    f_hz, value = np.array(knots, dtype=float).T
    return np.interp(np.log10(frequency_hz), np.log10(f_hz), value)


def slope(channel, frequency_hz):
    """alpha(f), impulses per s per log10 um."""
    return table_value(SLOPE_KNOTS[channel], frequency_hz)


def threshold_log10_um(channel, frequency_hz):
    """beta(f), log10 um peak."""
    return table_value(THRESHOLD_KNOTS[channel], frequency_hz)


@dataclass
class Rate:
    """Mean firing rate at the centre, sum of slopes, and the radius it reaches."""

    f0_imp_per_s: float
    slope_sum: float
    r_max_mm: float
    components: int


def firing_rate(channel, components):
    """Eq. 2 and 3 over the components above threshold."""
    if len(components.bin) == 0:
        return Rate(0.0, 0.0, 0.0, 0)
    alpha = slope(channel, components.frequency_hz)
    excess = np.log10(components.displacement_um) - threshold_log10_um(channel, components.frequency_hz)
    heard = excess > 0
    if not heard.any():
        return Rate(0.0, 0.0, 0.0, 0)
    f0 = float(np.sum(alpha[heard] * excess[heard]))
    slope_sum = float(np.sum(alpha[heard]))
    return Rate(f0, slope_sum, NEAR_FIELD_MM * 10 ** (f0 / (2 * slope_sum)), int(heard.sum()))


def rate_at(rate, r_mm):
    """Eq. 1 in the rate: constant up to 1.5 mm, falling with log10 of the distance beyond."""
    far = np.maximum(r_mm, NEAR_FIELD_MM)
    return np.maximum(0.0, rate.f0_imp_per_s - 2 * rate.slope_sum * np.log10(far / NEAR_FIELD_MM))


@dataclass
class Grid:
    """Square of N0 x N0 places; row, column and distance of the activated ones, row-major."""

    n0: int
    row: np.ndarray
    column: np.ndarray
    r_mm: np.ndarray


def receptor_grid(channel, r_max_mm):
    """Eq. 4: grid points within r_max, and always the centre."""
    interval_mm = 1 / math.sqrt(DENSITY_PER_MM2[channel])
    half = math.ceil(r_max_mm / interval_mm)
    offset = np.arange(-half, half + 1)
    y, x = np.meshgrid(offset, offset, indexing="ij")
    r_mm = np.hypot(y * interval_mm, x * interval_mm)
    row, column = np.nonzero((r_mm <= r_max_mm) | (r_mm == 0))
    return Grid(2 * half + 1, row, column, r_mm[row, column])


def channel_filter(channel):
    """Second-order sections of the channel's Butterworth filter, order 10 in total."""
    low_hz, high_hz = FILTER_EDGES_HZ[channel]
    if low_hz is None:
        return signal.butter(10, high_hz, "low", fs=RATE_HZ, output="sos")
    return signal.butter(5, [low_hz, high_hz], "band", fs=RATE_HZ, output="sos")


@dataclass
class Perceived:
    """Perceived waveform of one channel, and the energy the filter let through."""

    waveform: np.ndarray
    filtered_energy: float
    silent: bool


def perceived_waveform(channel, x_g):
    """Filter, divide by the largest magnitude, differentiate for FA1 and FA2."""
    filtered = signal.sosfilt(channel_filter(channel), x_g)
    energy = float(np.sum(filtered**2))
    if energy <= SILENCE_ENERGY_FRACTION * float(np.sum(x_g**2)):
        return Perceived(np.zeros_like(x_g), energy, True)
    shape = filtered / np.max(np.abs(filtered))
    if channel in DIFFERENTIATED:
        shape = np.diff(shape, prepend=0.0) * RATE_HZ
    return Perceived(shape, energy, False)


# ------------------------------------------------------------ 2. Neural spikes

def fires_of_receptors(rate, grid, duration_s, share):
    """Expected number of spikes of every receptor over the whole pattern."""
    f_imp_per_s = rate_at(rate, grid.r_mm)
    if share == "own":
        return f_imp_per_s * duration_s
    total = len(grid.r_mm) * rate.f0_imp_per_s * duration_s
    return total * f_imp_per_s / f_imp_per_s.sum() if total > 0 else np.zeros(len(grid.r_mm))


def cumulative_energy_fraction(waveform):
    """C_j at the end of every 10-ms window, the last window zero-padded."""
    windows = -(-len(waveform) // WINDOW_SAMPLES)
    padded = np.pad(waveform, (0, windows * WINDOW_SAMPLES - len(waveform)))
    energy = np.sum(padded.reshape(windows, WINDOW_SAMPLES) ** 2, axis=1)
    return np.cumsum(energy) / np.sum(energy) if energy.any() else np.zeros(windows)


def window_counts(fires, fraction):
    """Spikes of every receptor (row) in every 10-ms window (column), closed form."""
    cumulative = np.floor(np.outer(fires, fraction) + FLOOR_GUARD).astype(np.int64)
    return np.diff(cumulative, axis=1, prepend=0)


def step_counts(counts_10ms):
    """5-ms steps: the larger half first."""
    steps = np.empty((counts_10ms.shape[0], 2 * counts_10ms.shape[1]), dtype=np.int64)
    steps[:, 0::2] = (counts_10ms + 1) // 2
    steps[:, 1::2] = counts_10ms // 2
    return steps


# ----------------------------------------------------------- 3. Relay networks

def layer_zero(grid, steps):
    """Counts at the receptors' places, one N0 x N0 image per 5-ms step."""
    images = np.zeros((steps.shape[1], grid.n0, grid.n0), dtype=np.int64)
    images[:, grid.row, grid.column] = steps.T
    return images


def excite(images):
    """One excitatory layer: grows by one cell on each side, capped."""
    return np.minimum(signal.convolve(images, EXCITATORY[None], mode="full", method="direct"), SPIKE_CAP)


def inhibit(images):
    """One inhibitory layer: same size, clipped to 0..cap."""
    return np.clip(signal.convolve(images, INHIBITORY[None], mode="same", method="direct"), 0, SPIKE_CAP)


def relay_layers(images, excitatory_layers, inhibitory_layers):
    """All layers after layer 0, whole, in order."""
    layers = []
    for _ in range(excitatory_layers):
        images = excite(images)
        layers.append(images)
    for _ in range(inhibitory_layers):
        images = inhibit(images)
        layers.append(images)
    return layers


def centre(images):
    """Value of the centre cell in every step."""
    middle = images.shape[1] // 2
    return images[:, middle, middle]


def central_signal(counts):
    """Unit spikes spread evenly over each 5-ms step; a sample holds at most one."""
    out = np.zeros(STEP_SAMPLES * len(counts))
    for step, count in enumerate(counts):
        k = np.arange(int(count))
        out[step * STEP_SAMPLES + k * STEP_SAMPLES // max(int(count), 1)] = 1.0
    return out


@dataclass
class ChannelResult:
    """Every stage of one channel."""

    rate: Rate
    grid: Grid
    perceived: Perceived
    fires: np.ndarray
    fraction: np.ndarray
    steps: np.ndarray
    layers: list
    final_counts: np.ndarray
    signal: np.ndarray


def channel_result(channel, x_g, components, params):
    """All stages of one channel; x_g is mean-removed."""
    rate = firing_rate(channel, components)
    grid = receptor_grid(channel, rate.r_max_mm)
    perceived = perceived_waveform(channel, x_g)
    fires = fires_of_receptors(rate, grid, len(x_g) / RATE_HZ, params.share)
    fraction = cumulative_energy_fraction(perceived.waveform)
    steps = step_counts(window_counts(fires, fraction))
    images = layer_zero(grid, steps)
    layers = relay_layers(images, params.L_E, params.L_I)
    final = centre(layers[-1] if layers else images)
    return ChannelResult(rate, grid, perceived, fires, fraction, steps, layers, final, central_signal(final))


@dataclass
class NeuralCoding:
    """Spectrum, the four channels and the predicted brain waveform."""

    components: Spectrum
    channels: dict
    pbw: np.ndarray


def neural_coding(x_g, params):
    """Waveform in g (already padded) -> every stage -> predicted brain waveform."""
    centred_g = x_g - np.mean(x_g)
    components = spectrum(centred_g, params.components)
    channels = {c: channel_result(c, centred_g, components, params) for c in CHANNELS}
    pbw = sum(params.weights[c] * channels[c].signal for c in CHANNELS)
    return NeuralCoding(components, channels, pbw)


def nc_dissimilarity(a, b):
    """Root mean square difference of two predicted brain waveforms."""
    return float(np.sqrt(np.mean((a - b) ** 2)))


# ------------------------------------------------------------------- 4. Rhythm

def envelope(x_g, kind):
    """Causal 10-ms moving average of the magnitude; the mean is not removed."""
    smooth_g = np.convolve(np.abs(x_g), np.full(WINDOW_SAMPLES, 1 / WINDOW_SAMPLES))[:len(x_g)]
    peak_g = smooth_g.max()
    return smooth_g / peak_g if kind == "normalised" and peak_g > 0 else smooth_g


def dtw(a, b):
    """Dynamic time warping: |a - b| summed along the best path, one anti-diagonal at a time.

    Buffers are indexed by row + 1; places not yet reached hold infinity.
    """
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    rows, columns = len(a), len(b)
    reversed_b = b[::-1].copy()
    older, old, new = (np.full(rows + 1, np.inf) for _ in range(3))
    best, cost = np.empty(rows), np.empty(rows)
    for s in range(rows + columns - 1):
        low, high = max(0, s - columns + 1), min(rows - 1, s) + 1
        m, c = best[:high - low], cost[:high - low]
        np.minimum(old[low:high], old[low + 1:high + 1], out=m)
        np.minimum(m, older[low:high], out=m)
        if s == 0:
            m[0] = 0.0
        shift = columns - 1 - s
        np.subtract(a[low:high], reversed_b[low + shift:high + shift], out=c)
        np.abs(c, out=c)
        np.add(m, c, out=new[low + 1:high + 1])
        older, old, new = old, new, older
    return float(old[rows])


# -------------------------------------------------------------- 5. Integration

def condensed(items, distance):
    """Distances in the order (1,2), (1,3) .. (2,3) .."""
    n = len(items)
    return np.array([distance(items[i], items[j]) for i in range(n) for j in range(i + 1, n)])


def quantised(d):
    """Distances as whole numbers of 1e-9 of the largest."""
    d = np.asarray(d, dtype=float)
    return np.round(d / max(float(np.max(d)), QUANTISATION_MIN_SCALE) * QUANTISATION)


def average_ranks(d):
    """Ranks 1..m after quantisation, ties by their average."""
    return stats.rankdata(quantised(d), method="average")


def perceptual_dissimilarity(nc, oc, params):
    """PM: weighted sum of the two rankings."""
    return params.w_NC * average_ranks(nc) + params.w_OC * average_ranks(oc)


def predict_nc(waveforms_g, params):
    """Condensed NC distances of a set."""
    pbws = [neural_coding(x, params).pbw for x in padded_to_longest(waveforms_g)]
    return condensed(pbws, nc_dissimilarity)


def predict_oc(waveforms_g, params):
    """Condensed OC distances of a set."""
    return condensed([envelope(x, params.envelope) for x in padded_to_longest(waveforms_g)], dtw)


# ----------------------------------------------------------- Published checks

def tone(amplitude_g, frequency_hz, duration_s=1.0):
    """A plain tone as a pattern."""
    return {"amplitude_g": amplitude_g, "duration_s": duration_s, "attack_s": 0.0, "release_s": 0.0,
            "carriers": [{"frequency_hz": frequency_hz, "weight": 1.0, "phase_rad": 0.0}],
            "modulation": {"kind": "product", "frequency_hz": 0.0, "depth": 1.0},
            "rhythm": {"text": "", "unit_s": 0.125}}


def require(condition, sentence):
    """Stop with a sentence unless the condition holds."""
    if not condition:
        raise SystemExit("check failed: " + sentence)


def check_tone(amplitude_g, frequency_hz, f0, r_max_mm, n0, receptors, components):
    """One plain tone against the printed FA2 numbers (f0 and r_max with their tolerance)."""
    fa2 = neural_coding(render_g(tone(amplitude_g, frequency_hz)), Params()).channels["FA2"]
    label = f"{amplitude_g} g at {frequency_hz} Hz"
    require(abs(fa2.rate.f0_imp_per_s - f0[0]) <= f0[1], f"{label}: f0 {fa2.rate.f0_imp_per_s}")
    require(r_max_mm is None or abs(fa2.rate.r_max_mm - r_max_mm[0]) <= r_max_mm[1],
            f"{label}: r_max {fa2.rate.r_max_mm}")
    require(n0 is None or fa2.grid.n0 == n0, f"{label}: N0 {fa2.grid.n0}")
    require(receptors is None or len(fa2.grid.row) == receptors, f"{label}: N {len(fa2.grid.row)}")
    require(components is None or fa2.rate.components == components, f"{label}: n {fa2.rate.components}")


def check_published_values():
    """Single-pattern values the design page prints (sections 1.1, 1.3, 7)."""
    for frequency_hz, expected_um, tolerance_um in ((150, 11.04, 5e-3), (70, 50.7, 5e-2), (250, 3.97, 5e-3)):
        found_um = spectrum(render_g(tone(1.0, frequency_hz))).displacement_um[0]
        require(abs(found_um - expected_um) <= tolerance_um, f"1 g at {frequency_hz} Hz is {found_um} um")
    check_tone(0.1, 150, (57, 0.5), (3.0, 0.05), 5, None, 1)
    check_tone(1.0, 150, (150.91, 5e-3), (9.4969, 5e-5), 11, 61, 1)
    check_tone(1.0, 150.5, (1017, 0.5), None, None, None, 25)


if __name__ == "__main__":
    check_published_values()
    print("all published single-pattern values are met")
