// The numbers in a lesson's texts, made by the model: "{spikes | Pacinian | plain}" becomes "100".
//
//     {frequency | A}  {amplitude | A}  {modulation | A}  {duration | A}    what A was made with
//     {displacement | A}           of the skin, peak, at A's first carrier; of a drawn amplitude,
//                                  where it is largest
//     {threshold | TYPE | A}       the least displacement that the type notices, there
//     {felt | A}                   the types that fire, by more than what their filters leak:
//                                  "Meissner and Pacinian"
//     {spikes | TYPE | A}          impulses of the receptor under the probe, in all of A
//     {per cycle | TYPE | A}       the same, for each cycle of A's first carrier; of a type that
//     only
//                                  leaks, both say so
//     {rate | TYPE | A}            its mean rate by Eq. 2
//     {receptors | TYPE | A}  {radius | TYPE | A}       how many answer, and how far out
//     {on | TYPE | A}  {at cap | TYPE | A}   share of the time in which the centre of its network
//                                  sends anything; as much as it can
//     {density | TYPE}  {interval | TYPE}  {weight | TYPE}          Table 1 of the paper: how many
//                                  receptors of the type, how far apart, what its signal counts
//     {excitatory layers}  {inhibitory layers}                      of the relay networks
//     {stress | pm}  {stress | people}                              of the map in three dimensions
//     {k}  {rho}                   how far those two maps are from being one shape; how well PM has
//                                  the order of people's dissimilarities. Both need ratings
//     {nc | A | B}  {oc | A | B}  {pm | A | B}  {pm rank | A | B}   how far two are apart; the rank
//                                  of the pair, from the closest
//     {fact | ID}  {source | ID}   what was measured, with its unit, and by whom: "18 to 25 %",
//                                  "Israr and others 2006, human" (model/textbook)
//
// A frequency that is drawn is no one number: {frequency}, {displacement}, {threshold} and {per
// cycle} are refused of it.
//
// Source    the rooms of the model that are named with each
// Input     names of patterns and of receptor types as the program shows them; spaces around | are
//           nothing
// Output    text with its unit
// Exact     same input, same text.
#pragma once

#include <map>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/lesson/lesson.h"

namespace tact {

// What stands in braces in a text, in order, as it stands there.
std::vector<std::string> placeholders_in(std::string_view text);

// Why it cannot be evaluated; empty: it can.
std::string placeholder_fault(const std::string& placeholder, const PatternSet& set);

// By placeholder.
using LessonNumbers = std::map<std::string, std::string>;

// The text with its numbers; "…" where they are not there yet.
std::string filled(std::string_view text, const LessonNumbers& numbers);

// What a question is answered with.
struct QuestionAnswer {
    std::vector<std::string> options;
    std::vector<std::size_t> right;  // places in options
    std::string model;               // a sentence of what the model says
    std::string people;              // the same of people; empty: nobody rated these
};

struct LessonAnswers {
    LessonNumbers numbers;
    std::vector<QuestionAnswer> questions;  // of each step; of one that asks nothing, empty
};

// Stopped: what was there until then. Without pairs only what patterns say by themselves, which
// takes next to no time.
LessonAnswers lesson_answers(const Lesson& lesson, std::stop_token stop = {},
                             bool with_pairs = true);

}  // namespace tact
