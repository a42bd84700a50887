// import tactspace: the same numbers for Python and R.
#pragma once

namespace tact::help {

// What help() says of each function: its signature, as Python reads it from the first line, then
// what it is, arguments and values with shapes and units, errors.

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
metric   one of tactspace.metrics: "pm", its parts "nc" and "oc"{, others}
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

// What help() says of the functions that take what people said.

inline constexpr const char* kCompare =
    R"(compare(D, ratings, metric="", threads=0, *, given=None, progress=None)
--

How well a metric agrees with people: in the order of the pairs, and in the shape of the map.

D        (n, n) or condensed, as predict() gives it; or a dict of such by names of metrics, "pm" and
         others, also of one's own: then PM's rho less that of each is tested, too
ratings  what read_ratings() gives, of the same n patterns in their order; or mean dissimilarities,
         (n, n) or condensed, NaN: not rated
metric   which D is by, where known. Only "spqi" needs it: its values are so close to 1 that they
         are compared by their ranks
threads  0: all cores
given    a dict of (n, n) or condensed matrices by names, such as differences of duration: rho of what
         these leave
progress None, True or a function of (share, text)

Returns a dict, or of a dict of matrices a dict of these; without units, NaN where undefined; what
compare --json has, under its keys:
rho, rho_low, rho_high  Spearman's, its 95 % interval (1.96 standard errors, bootstrap over patterns)
rho_resampled, K_resampled  dicts of "patterns", "people" and "both", over which was resampled: se, low,
                        high (95 %), and not_known, the reason, where there is none
rho_person, K_person    over people, each alone: mean, median, quartiles, known (how many)
p                       one-sided, Mantel's permutation of patterns
tau_b                   Kendall's
K, K_low, K_high        alienation between the two maps; over maps that fit practically as well
K_paper                 K as Table 2 has it: also NaN where MATLAB's mdscale gives up
K_chance, K_p           mean of unrelated maps; one-sided p
K_corrected             1 - K / K_chance
K_procrustes, protest_p another measure of shape; one-sided p (PROTEST)
stress1                 of the metric's map
pm_less_this            PM's rho less this one's: rho, and over patterns, people and both se, low, high, p
                        (two-sided), p_holm (corrected for all differences)
given                   by name: rho (partial), low, high, rho_alone
reliability             of the mean of people: split halves, Spearman-Brown
one_with_others         mean rho of one of them with the mean of the others
ceiling_of_mean         rho that a metric can reach with their mean
ceiling_person_lower, ceiling_person_upper  rho of each with the mean of the others, and of all: mean,
                        median, quartiles, known
icc_single, icc_mean    ICC(2,1), ICC(3,k), each with _low and _high (95 %): icc_single_low,
                        icc_single_high, icc_mean_low, icc_mean_high; icc_pairs: rated by all
alpha, alpha_pairs      Krippendorff's, of pairs rated by two people at least
participants, synthetic, participants_left_out, rehearsals_left_out, unrated_patterns, remarks)";

inline constexpr const char* kPaper =
    R"(paper(sets, threads=0, *, progress=None)
--

Table 2 of Lim & Park 2023 for one's own sets, and what it rests on.

sets      a list of dicts, each with "waves" (n arrays in g at 10000 Hz), "ratings" of all n of them
          (as in compare()) and, if it has them, "name" and "model": what read_set() gives, with
          ratings put in
threads   0: all cores
progress  None, True or a function of (share, text)

Returns a dict of lists of dicts, a row each, as pandas.DataFrame() takes them; without units but those
of the metrics, NaN where undefined; the numbers of the command paper:
table2    set, metric, rho, K, signed_rho, best_K, participants, synthetic, left_out: a row a set and
          metric, then the averages of the publication's bookkeeping (set "average")
pairs     set, a, b, people, a key a metric, synthetic
maps      set, map ("people" or a metric), pattern, x, y, z, by the publication's procedure)";

inline constexpr const char* kPlan =
    R"(plan(D, rival, people, rho=None, reliability=None, pilot=None, pairs=0, studies=200, seed=12, threads=0, *, progress=None)
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
threads      0: all cores
progress     None, True or a function of (share, text)

Returns a dict, without units: simulated (True: nobody was asked), assumed (rho, reliability, source: a pilot, stated or a
guess) and studies, a dict each of people, rho and rho_rival (means), rho_sd, reliability (of the mean
ratings), half_width (of the 95 % interval of rho) and power (the share that finds D above the rival, p < .05,
two-sided), both over "patterns", "people" and "both", NaN where not known)";

inline constexpr const char* kTrain =
    R"(train(sets, objective="mean-rho", step=0.1, leave_out="", rate_hz=10000.0, threads=0, model=None, *, progress=None)
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
progress   None, True or a function of (share, text)

Returns a dict: model (for predict() and write_set(), with its origin), parameters and
parameters_before (L_E, L_I layers; w_.. weights),
objective, step, value, value_before (of the objective), combinations, equally_good,
equally_good_classes, ties (a dict each, of a class of proportional weights: parameters, None where any
will do, and combinations), share_near_best (0 to 1), near_best,
best_of (a dict of arrays, (5,) of layers 0 to 4 and (1 / step + 1,) of weights 0 to 1: the best value
with each), synthetic, sets (a dict each: name, patterns, rated_pairs, participants, synthetic,
unrated_patterns, participants_left_out, rehearsals_left_out, rho_before,
rho_after), and without_set (of several sets), without_participant and without_pattern (a dict each;
none where they were not asked for). A fit flatters itself: only what was left out tells how it does on others.)";

// What help() says of the functions that take, read and write sets.

inline constexpr const char* kSeparate =
    R"(separate(set, pair, change=None, among=(), closest=5.0, threshold=None, threads=0, *, progress=None)
--

The smallest change of a single number that parts two patterns that people may confuse.

set        a dict of n patterns, as write_set() takes it
pair       two patterns, each by its name or its place from 0
change     the one of them to change; None: either that is not locked
among      others to keep away from, by names or places; (): all n
closest    %: a change must bring the pattern farther from each other pattern than that share of all
           pairs are apart, and farther than this pair is now
threshold  instead: farther than this PM
threads    0: all cores
progress   None, True or a function of (share, text)

Returns a dict: pair (names), dissimilarity and threshold (PM, without unit), and changes, the smallest
first, a dict each of pattern, parameter, from and to (in the unit of its name, as amplitude_g),
felt_steps and nearest (a dict: pattern and dissimilarity of the closest of the others then).)";

inline constexpr const char* kReport =
    R"(report(set, count=None, closer_than=None, include_unfelt=False, threads=0, time_limit_s=60.0, *, progress=None)
--

What is told of a set as a whole, by PM: what feels the same, what to pick, what is close.

set             a dict of n patterns, as write_set() takes it; locked ones are picked, dropped ones
                are not
count           how many most distinct patterns to pick, 2 to n; None: 8, or half of a small set
closer_than     a PM, or two patterns, each by its name or its place from 0: pairs closer than that
                are counted; None: closer than the weakest pair of the picked ones
include_unfelt  True: patterns that no receptor answers to may be picked, too
threads         0: all cores
time_limit_s    seconds, after which the best subset so far is taken, not called optimal
progress        None, True or a function of (share, text)

Returns a dict. picked (names), optimal, and bound, which the weakest pair of no such subset exceeds; PM has
no unit. groups (lists of names that feel the same, within a felt step of each other), confused_pairs (how
many such pairs) and distinct (patterns, each group as one). closer_below (PM), closer_pairs and
closer_groups, of what is closer than that. alike (a dict each of central and patterns): as many groups as
are picked. nearest (by name a dict: pattern, dissimilarity, and verdict by felt steps; None where a pattern
is compared with none). Where there are any, not_felt, and left_out_unfelt of these, which were not picked for that.)";

inline constexpr const char* kSteps =
    R"(steps(set, start, end, count=5, parameter="", metric="pm", threads=0, *, progress=None)
--

Patterns between two, as far apart from each other as the model can make them even.

set         a dict of patterns, as write_set() takes it
start, end  two of them, each made of parameters, by its name or its place from 0
count       how many, both ends included, 2 to 16
parameter   only this number of start changes, to what end has, such as "carrier_hz"; "": all numbers
metric      what is even: "pm", its parts before they are ranked, or one of these, "nc" or "oc"
threads     0: all cores
progress    None, True or a function of (share, text)

Returns a dict: set (a dict of the count patterns, as read_set() gives it), patterns (names), shares (of
the way, 0 to 1), apart (count - 1 of neighbours, in what was to be even, without unit), ends_apart, pm
(of neighbours), largest_pm, uneven (largest of apart to smallest, less 1), even, and where the way
goes far at once jump (a dict: share, distance).)";

inline constexpr const char* kGroups =
    R"(groups(set, count=None, cut=None, threads=0, *, progress=None)
--

Patterns in groups of alike ones, by average linkage of PM: a tree that is cut.

set       a dict of n patterns, as write_set() takes it; dropped ones stay apart
count     how many groups; None: 8, or half of a small set
cut       instead: groups stay apart where the mean PM of their pairs (no unit) is above this
threads   0: all cores
progress  None, True or a function of (share, text)

Returns a dict, that of groups --json: linkage, count, cut (a dict: from, and below, None where there
is one group), agreement (rho of the tree's heights and PM), groups (a dict each: patterns, central,
mean, farthest), not_felt, dropped, order (the m patterns of the tree) and joins ((m - 1, 4), as SciPy's
linkage of the patterns in order).)";

inline constexpr const char* kExport =
    R"(export(set, folder, format, patterns=(), onto="", rate_hz=None, bits=None, count=0, loss=True, overwrite=False, threads=0, *, progress=None)
--

Patterns as files of other programs, in words what each loses, and what the whole costs in perception.

set        a dict of n patterns, as write_set() takes it
folder     for the files; made where it is missing
format     "haptic", "ahap", "ahap-pair", "hjif", "android-xml", "android-kotlin", "android-timings",
           "hla", "web", "pulsar", "he", "openxr", "wav" or "csv"
patterns   names; (): all that the format holds
onto       the actuator that 0 to 1 are written for: a name that the program knows, or a file; "": the
           one that was chosen when the effects were read, or the format's own
rate_hz    of "wav" and "csv": 10000, 44100 or 48000 Hz; None: the format's
bits       of "wav": "16", "24" or "float"; None: 24
count      of the most distinct patterns, which are held against what the target makes of them; 0: half
           of them, at most 8
loss       False: only the files; what they cost takes two predictions of the set
overwrite  True: files of the same names are replaced; else they are a FileExistsError
threads    0: all cores
progress   None, True or a function of (share, text)

Returns a dict, that of export --json: format, actuator and actuator_source, or rate_hz, full_scale_g
and bits, files (a dict each: pattern, file, beside, remarks) and loss (labels, patterns, before, after:
condensed (n (n - 1) / 2,) PM, closest, most_moved, subset, map). Left out: the page export_report.html,
which the program writes.)";

inline constexpr const char* kReadSet =
    R"(read_set(path, *, actuator="", progress=None)
--

A set: a .tactspace.json file, a folder or zip file of recordings or effects of other programs (AHAP,
.haptic, HJIF, .haps, .he, .hla, Pulsar presets, Android's XML or timings as JSON, on-off times of
browsers as JSON), a single one, or a list of such as one set.

path      one, or a list
actuator  what turns the 0 to 1 of effects into g and Hz: a name that the program knows, or a file; "":
          each format's own
progress  None, True or a function of (share, text)

Returns a dict of n patterns:
name      of the set
names     n texts
waves     n arrays (samples,) in g, unpadded, at
rate_hz   10000.0
patterns  n dicts as render() takes them; None for a recording
model     parameters of PM for predict(), and their origin where they were trained; {}: the paper's
ratings   as read_ratings() gives them, where the set has its own; else None
measures  n texts: the pattern that a recording measures, or ""
synthetic n: True for a recording that was computed
locked, dropped  places of patterns to keep and to drop in subset()
remarks   what was guessed or odd, also given as UserWarnings
document  the set file as a dict: what write_set() keeps besides the above)";

inline constexpr const char* kWriteSet =
    R"(write_set(path, set)
--

A set as a .tactspace.json file, for the window, the terminal and read_set().

path  of a name that ends in .json. A set file of this name is replaced, whole or not at all; effects
      of another program are not
set   a dict of n patterns as read_set() gives it, changed or not, or made by hand: "names" (n texts),
      "patterns" (n dicts as render() takes them, or None) and, if there are recordings, "waves" (their
      samples in g, at "rate_hz"); if it has them, "name", "model", "ratings", "measures", "synthetic",
      "locked", "dropped". Of "document" comes what these do not have: colours, notes, study design

Recordings are written to a folder "measured" beside the file. Returns None. A layer that is a recording
is a ValueError, and so is what could not be read back: two equal names, a number out of its range.)";

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
