// What help() says of the functions that take, read and write sets: as help.h.
#pragma once

namespace tact::help {

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
.haptic, HJIF, HAPS, Android XML, ..), a single one, or a list of such as one set.

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
