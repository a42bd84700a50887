// Numbers in a lesson's texts, computed by the model: "{spikes | Pacinian | plain}" gives "100".
//
//     {frequency | A}  {amplitude | A}  {modulation | A}  {duration | A}    A's parameters
//     {displacement | A}           peak displacement of the skin at A's first carrier; for an
//                                  amplitude curve, at its maximum
//     {threshold | TYPE | A}       the smallest displacement that drives the type there
//     {felt | A}                   the types that fire by more than their filter's leak:
//                                  "Meissner and Pacinian"
//     {spikes | TYPE | A}          impulses of the receptor under the probe during A
//     {per cycle | TYPE | A}       the same per cycle of A's first carrier; both tell if a type
//                                  only follows its filter's leak
//     {rate | TYPE | A}            its mean rate by Eq. 2
//     {receptors | TYPE | A}  {radius | TYPE | A}       number and radius of activated ones
//     {on | TYPE | A}  {at cap | TYPE | A}   share of the time in which the centre of its network
//                                  sends anything; sends the maximum
//     {density | TYPE}  {interval | TYPE}  {weight | TYPE}          Table 1 of the paper: density
//                                  and spacing of receptors, weight of the signal
//     {excitatory layers}  {inhibitory layers}                      numbers of relay layers
//     {stress | pm}  {stress | people}                              of a map in three dimensions
//     {k}  {rho}                   alienation of those two maps; rank correlation of PM with
//                                  people's dissimilarities. Both need ratings
//     {nc | A | B}  {oc | A | B}  {pm | A | B}  {pm rank | A | B}   distances of two patterns; the
//                                  rank of the pair, from the closest
//     {fact | ID}  {source | ID}   a measured value with its unit, and its source: "18 to 25 %",
//                                  "Israr and others 2006, human" (model/textbook)
//
// A frequency curve is not a single number: {frequency}, {displacement}, {threshold} and {per
// cycle} are refused for it.
//
// Source    the rooms of the model that compute each
// Input     names of patterns and of receptor types as the program shows them; spaces around | are
//           ignored
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

// Contents of the braces in a text, in order, unchanged.
std::vector<std::string> placeholders_in(std::string_view text);

// The reason why it cannot be evaluated; empty: it can.
std::string placeholder_fault(const std::string& placeholder, const PatternSet& set);

// By placeholder.
using LessonNumbers = std::map<std::string, std::string>;

// The text with its numbers; "…" for numbers that are not computed yet.
std::string filled(std::string_view text, const LessonNumbers& numbers);

// The answer to a step's question.
struct QuestionAnswer {
    std::vector<std::string> options;
    std::vector<std::size_t> right;  // indices into options
    std::string model;               // a sentence on the model's answer
    std::string people;              // a sentence on people's; empty: nobody rated these
};

struct LessonAnswers {
    LessonNumbers numbers;
    std::vector<QuestionAnswer> questions;  // one per step; empty without a question
};

// If stopped: the answers so far. Without pairs, only numbers of single patterns, which take
// negligible time.
LessonAnswers lesson_answers(const Lesson& lesson, std::stop_token stop = {},
                             bool with_pairs = true);

}  // namespace tact
