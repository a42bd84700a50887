// What help() says of each function: its signature, as Python reads it from the first line, then
// what it is, arguments and values with shapes and units, errors.
#pragma once

namespace tact::help {

inline constexpr const char* kModule =
    R"(Predicted perceptual dissimilarity of vibrations: the numbers of the program tactspace.

Every function computes what the command of the same name does, to the last bit, on any number of
threads. Waves are accelerations in g. A matrix D of n objects is an array (n, n), or condensed
(n (n - 1) / 2,) as scipy.spatial.distance.squareform has it. Any numeric type and stride is taken;
what comes back is float64. Other threads of Python go on meanwhile, Ctrl+C ends what is running, and
what cannot be used is a ValueError that says what was expected; what is no number is a TypeError, and
a file that is not there a FileNotFoundError. A masked array with anything masked is refused.

    import tactspace
    set = tactspace.read_set("set.tactspace.json")
    D = tactspace.predict(set["waves"], model=set["model"])
    points, stress = tactspace.space(D)

metrics: the keys of all metrics that predict() knows.)";

inline constexpr const char* kPredict =
    R"(predict(waves, metric="pm", rate_hz=10000.0, threads=0, model=None)
--

Dissimilarity of every pair of vibrations.

waves    array (n, samples) in g, or a list of n arrays of any lengths, at most 60 s each; shorter
         ones are padded with silence at the end
metric   one of tactspace.metrics: "pm", its parts "nc" and "oc", "rmse", "dtw", "msm", "mtm",
         "st-sim", "spqi", "level", "bands", "balance", "van-rossum", "no-physiology"
rate_hz  sampling rate of the waves, 100 to 1e7 Hz; other than 10000 they are resampled
threads  0: all cores. The time depends on it, the result does not
model    parameters of PM: None (the paper's), read_set(..)["model"] or train(..)["model"]

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
    R"(space(D, dimensions=3, threads=0)
--

Map of n objects by non-metric multidimensional scaling (Kruskal's stress-1, primary ties, SMACOF).

D           (n, n) or condensed; NaN: pairs that have no say
dimensions  1 to 10
threads     0: all cores

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
    R"(subset(D, k, keep=(), drop=(), objective="max-min", threads=0, time_limit_s=60.0)
--

The k most distinct of n objects, proven.

D             (n, n) or condensed, in any unit; NaN (not known) counts as 0
k             how many, 2 to n
keep, drop    places, from 0, of objects that must and must not be among them; drop=unfelt(waves)
              leaves out what nobody feels, as D does not tell
objective     "max-min": the weakest pair as far apart as can be; "max-sum": the sum of all pairs
threads       0: all cores
time_limit_s  seconds, after which the best so far is returned, not called optimal

Returns a dict: members (k,) places in ascending order, weakest (two places),
weakest_dissimilarity and sum in the unit of D, optimal, and bound, which no subset's objective
exceeds.)";

inline constexpr const char* kCompare =
    R"(compare(D, ratings, metric="", threads=0)
--

How well a metric agrees with people: in the order of the pairs, and in the shape of the map.

D        (n, n) or condensed, as predict() gives it
ratings  what read_ratings() gives, of the same n patterns in their order; or mean dissimilarities,
         (n, n) or condensed, NaN: not rated
metric   which D is by, where known. Only "spqi" needs it: its values are so close to 1 that they
         are compared by their ranks
threads  0: all cores. Ctrl+C is heeded once the running part is done, mostly within seconds

Returns a dict, without units, NaN where undefined:
rho, rho_low, rho_high  Spearman's, its 95 % interval (1.96 standard errors, bootstrap over patterns)
p                       one-sided, Mantel's permutation of patterns
tau_b                   Kendall's
K, K_low, K_high        alienation between the two maps; over maps that fit practically as well
K_paper                 K as Table 2 has it: also NaN where MATLAB's mdscale gives up
K_chance, K_p           mean of unrelated maps; one-sided p
K_corrected             1 - K / K_chance
K_procrustes, protest_p another measure of shape; one-sided p (PROTEST)
stress1                 of the metric's map
reliability             of the mean of people: split halves, Spearman-Brown
one_with_others         mean rho of one of them with the mean of the others
ceiling_of_mean         rho that a metric can reach with their mean
participants, synthetic, participants_left_out, rehearsals_left_out, unrated_patterns, remarks)";

inline constexpr const char* kPlan =
    R"(plan(D, rival, people, rho=None, reliability=None, pilot=None, pairs=0, studies=200, seed=12, threads=0)
--

What a rating study could find, before anybody is asked: whole studies are simulated and analysed.

D, rival     (n, n) or condensed, as predict() gives them, of the same n patterns
people       numbers of people to try
rho          of D with what people feel on average, without noise, 0 to 1; None: the pilot's, or a guess (0.67)
reliability  of one person's ratings, the share that is not their own noise, 0.01 to 1; None: the pilot's,
             or a guess (0.4)
pilot        ratings of a few people, as compare() takes them
pairs        that each person rates; 0: all
studies      simulated for each number of people
seed         of the simulation
threads      0: all cores. Ctrl+C is heeded at once

Returns a dict, without units: simulated (True: nobody was asked), assumed (rho, reliability, source: a pilot, stated or a
guess) and studies, a dict each of people, rho and rho_rival (means), rho_sd, reliability (of the mean
ratings), half_width (of the 95 % interval of rho) and power (the share that finds D above the rival, p < .05,
two-sided), both over "patterns", "people" and "both", NaN where not known)";

inline constexpr const char* kTrain =
    R"(train(sets, objective="mean-rho", step=0.1, leave_out="", rate_hz=10000.0, threads=0, model=None)
--

The eight trained parameters of PM that agree best with people, by exhaustive search.

sets       a list of dicts, each with "waves" (as in predict(), in g), "ratings" (as in compare()) and,
           if it has one, "name": what read_set() gives, with ratings put in
objective  "mean-rho": mean of Spearman's rho over the sets; "mean-abs-rho": of its size
step       of a weight: 1 divided by a whole number up to 40
leave_out  "", "sets", "participants" (who felt the same vibrations) or "patterns": to fit without
           each in turn, and try on just that
rate_hz    sampling rate of all waves, Hz
threads    0: all cores
model      the model before; None: that of the first set, else the paper's. Its other choices stay

Returns a dict: model (for predict()), parameters and parameters_before (L_E, L_I layers; w_.. weights),
value, value_before (of the objective), combinations, equally_good, share_near_best (0 to 1), near_best,
best_of (a dict of arrays, (5,) of layers 0 to 4 and (1 / step + 1,) of weights 0 to 1: the best value
with each), synthetic, sets (a dict each: name, patterns, rated_pairs, synthetic,
participants_left_out, rehearsals_left_out, rho_before,
rho_after), and without_set, without_participant or without_pattern (a dict each) where asked for. A fit flatters itself: only what was left out tells how it does on others.)";

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

inline constexpr const char* kReadSet =
    R"(read_set(path)
--

A set: a .tactspace.json file, a folder of recordings or effects, or a single one.

Returns a dict of n patterns:
name      of the set
names     n texts
waves     n arrays (samples,) in g, unpadded, at
rate_hz   10000.0
patterns  n dicts as render() takes them; None for a recording
model     parameters of PM for predict(); {}: the paper's
ratings   as read_ratings() gives them, where the set has its own; else None
measures  n texts: the pattern that a recording measures, or ""
synthetic n: True for a recording that was computed
locked, dropped  places of patterns to keep and to drop in subset()
remarks   what was guessed or odd, also given as UserWarnings)";

inline constexpr const char* kReadRatings =
    R"(read_ratings(path, names=None, scale="guess")
--

What people said, as compare() and train() take it; only of those who count.

path   a file of ratings, or a folder of them or of a study's participants
names  of the patterns, n texts: the ratings in that order; None: in the order of the file
scale  "guess", "dissimilarity", or "similarity" from 0 to 100

Returns a dict of p passes through m = n (n - 1) / 2 pairs:
names         n texts
named         False: the names are only positions
participants  p texts, equal for repetitions
ratings       (p, m) dissimilarities, condensed, in the unit of the file; NaN: not rated
mean          (n, n): over repetitions, then over participants
synthetic     participants whom nobody asked
participants_left_out, rehearsals_left_out
              how many do not count, and how many of these felt nothing
left_out      a dict for each who does not count: participant, why
remarks       what was guessed or left out, also given as UserWarnings)";

}  // namespace tact::help
