// What help() says of each function: its signature, as Python reads it from the first line, then
// what it is, arguments and values with shapes and units, errors.
#pragma once

namespace tact::help {

inline constexpr const char* kModule =
    R"(Predicted perceptual dissimilarity of vibrations: the numbers of the program tactspace.

Every function computes what the command of the same name does, to the last bit, on any number of
threads. Waves are accelerations in g. A matrix D of n objects is an array (n, n), or condensed
(n (n - 1) / 2,) as scipy.spatial.distance.squareform has it. Any numeric type and stride is taken;
what comes back is float64. Other threads of Python go on meanwhile, and Ctrl+C is answered at once;
what heeds no stop (a comparison, a rendering) then ends by itself in the background, and Python waits
for it at its end. A masked array with anything masked is refused.

What has the wrong type is a TypeError, what cannot be used a ValueError; both name the argument, its
element or key, and what was expected. A file that the system refuses is an OSError with errno and
filename, such as FileNotFoundError or PermissionError.

progress: None; a function that is called as progress(share, text), share from 0 to 1, in the thread
that called; or True: a bar, in a notebook below its cell, elsewhere on standard error. What the
function raises stops the work. Functions can be pickled.

    import tactspace
    set = tactspace.read_set("set.tactspace.json")
    D = tactspace.predict(set["waves"], model=set["model"])
    points, stress = tactspace.space(D)

metrics: the keys of all metrics that predict() knows.)";

inline constexpr const char* kPredict =
    R"(predict(waves, metric="pm", rate_hz=10000.0, threads=0, model=None, *, progress=None)
--

Dissimilarity of every pair of vibrations.

waves    array (n, samples) in g, or a list of n arrays of any lengths, at most 60 s each; shorter
         ones are padded with silence at the end
metric   one of tactspace.metrics: "pm", its parts "nc" and "oc", "rmse", "dtw", "msm", "mtm",
         "st-sim", "spqi", "level", "bands", "balance", "van-rossum", "no-physiology"
rate_hz  sampling rate of the waves, 100 to 1e7 Hz; other than 10000 they are resampled
threads  0: all cores. The time depends on it, the result does not
model    parameters of PM: None (the paper's), read_set(..)["model"] or train(..)["model"]
progress None, True or a function of (share, text)

Returns an array (n, n), symmetric, 0 on the diagonal. PM is a sum of ranks, without a unit, and
depends on the whole set; so is "no-physiology". Units of the others: nc none, oc and rmse, dtw, msm,
level, bands those of the metric's source. Lim & Park 2023.)";

inline constexpr const char* kStages =
    R"(stages(wave, rate_hz=10000.0, model=None)
--

What one vibration goes through between skin and cortex.

wave     array (samples,) in g. In a set the model pads it with silence to the longest; pad it, and
         these are the stages behind the set's numbers
rate_hz  its sampling rate, Hz; other than 10000 it is resampled
model    as in predict()

Returns a dict. With N samples at 10 kHz, and S = 2 ceil(N / 100) steps of 5 ms:
wave        (N,) g
components  dict of arrays (c,): frequency_hz, acceleration_g (peak), skin_um (peak displacement)
channels    dict of FA1, FA2, SA1, SA2, each a dict:
            rate_imp_per_s, slope_sum_imp_per_s (per log10 um), radius_mm, receptors (how many are
            activated), silent, filtered_g (N,), perceived (N,) normalised; of the r receptors on the
            grid x_mm (r,), y_mm (r,), receptor_rate_imp_per_s (r,), spikes (r, S) counts;
            central (S,) counts of the central neuron
brain       (100 ceil(N / 100),) predicted brain waveform, sum of the weights of channels that fire
envelope    (N,) rhythm envelope, 0 to 1 unless model has it raw, then g)";

inline constexpr const char* kSpace =
    R"(space(D, dimensions=3, threads=0, *, progress=None)
--

Map of n objects by non-metric multidimensional scaling (Kruskal's stress-1, primary ties, SMACOF).

D           (n, n) or condensed; NaN: pairs that have no say
dimensions  1 to 10
threads     0: all cores
progress    None, True or a function of (share, text)

Returns (coordinates, stress): coordinates (n, dimensions) without a unit, centred, on principal axes,
mean squared distance 1; stress-1 from 0 to 1. A map that says nothing is a UserWarning.)";

inline constexpr const char* kUnfelt =
    R"(unfelt(waves, rate_hz=10000.0, threads=0, model=None)
--

Places of the vibrations that no receptor answers to: nobody could tell them from nothing.

waves    array (n, samples) in g, or a list of n arrays of any lengths, at most 60 s each
rate_hz  sampling rate of the waves, 100 to 1e7 Hz
threads  0: all cores. The time depends on it, the result does not
model    parameters of PM: None (the paper's), read_set(..)["model"] or train(..)["model"]

Returns an array of places, from 0, ascending. tactspace subset, report and the window leave them
out; subset(D, k, drop=unfelt(waves)) does as well.)";

inline constexpr const char* kSubset =
    R"(subset(D, k, keep=(), drop=(), objective="max-min", threads=0, time_limit_s=60.0, *, progress=None)
--

The k most distinct of n objects, proven.

D             (n, n) or condensed, in any unit; NaN (not known) counts as 0
k             how many, 2 to n
keep, drop    places, from 0, in a list or an array, of objects that must and must not be among
              them; drop=unfelt(waves) leaves out what nobody feels, as D does not tell
objective     "max-min": the weakest pair as far apart as can be; "max-sum": the sum of all pairs
threads       0: all cores
time_limit_s  seconds, after which the best so far is returned, not called optimal
progress      None, True or a function of (share, text)

Returns a dict: members (k,) places in ascending order, weakest (two places),
weakest_dissimilarity and sum in the unit of D, optimal, and bound, which no subset's objective
exceeds.)";

inline constexpr const char* kRender =
    R"(render(pattern, rate_hz=10000.0)
--

Samples of a parametric vibration.

pattern  dict with the keys of a pattern in a set file, such as {"amplitude_g": 1, "carriers":
         [{"frequency_hz": 150}], "rhythm": {"text": "x-x-", "unit_s": 0.125}, "duration_s": 1};
         letters in the text are notes of "notes": {"A": {"velocity": 0.4, "pitch": 1.5}};
         what is missing takes its default, what is unknown is a ValueError; or {"layers": [...]},
         one to four such dicts with name, gain, offset_s, mute and solo
rate_hz  100 to 1e7 Hz

Returns an array (N,) in g, N = round(duration_s rate_hz).)";

inline constexpr const char* kEdit =
    R"(edit(pattern, edits, model=None)
--

A pattern made of patterns, as the command edit makes it.

pattern  dict as render() takes it
edits    in their order, each a text or a tuple of one with what it needs: "reverse", "trim",
         ("stretch", times), ("stretch-notes", times), ("stretch-curves", times), ("repeat", n),
         ("join", pattern), ("mix", pattern), ("fade-in", s), ("fade-out", s), ("normalise", g),
         ("felt", dB above threshold), ("quantise", s), ("quantise-bpm", BPM),
         ("transpose", times), ("thin", %), "find-notes"
model    as in predict(), for the thresholds that "felt" goes by

Returns a dict for render(); what cannot be mixed into one pattern, as layers. A rhythm stays a
rhythm where its notes lie on the grid of the result; elsewhere they are drawn as an amplitude
curve. What cannot be is a ValueError that begins with the edit.)";

}  // namespace tact::help
