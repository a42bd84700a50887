// What help() says of the functions that take what people said: as help.h.
#pragma once

namespace tact::help {

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
value, value_before (of the objective), combinations, equally_good, share_near_best (0 to 1), near_best,
best_of (a dict of arrays, (5,) of layers 0 to 4 and (1 / step + 1,) of weights 0 to 1: the best value
with each), synthetic, sets (a dict each: name, patterns, rated_pairs, synthetic,
participants_left_out, rehearsals_left_out, rho_before,
rho_after), and without_set, without_participant or without_pattern (a dict each) where asked for. A fit flatters itself: only what was left out tells how it does on others.)";

}  // namespace tact::help
