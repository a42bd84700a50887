// Parts that the files of this room share.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/pattern/pattern.h"
#include "model/set/pattern_set.h"

namespace tact {

// Files of every format, for the manual: small ones that are read by the program's own readers.

// A file of assets/manual/examples, with its name above it.
Expected<std::string> example_html(std::string_view file);

// What effects are shown of: a swell with a tick in it.
Pattern manual_pattern();

// That pattern as a file of each other program that effects are written for.
std::string effects_html();

// What the model says of the sets that come with the program, for the manual's text.
//
//     SET patterns | pairs                 SET: the file's name without its ending
//     SET stress1 | stress_label           of the map of three dimensions
//     SET nearest | nearest_pm | farthest | farthest_pm
//     SET picked K | weakest K             the K most distinct, and how far its weakest pair is
//     metrics | combinations | examples    of the program

struct PredictedExample {
    PatternSet set;
    Dissimilarity pm;
    PerceptualSpace space;
};

// Each set is predicted once, when the first number is asked of it.
using KnownNumbers = std::map<std::string, std::shared_ptr<const PredictedExample>, std::less<>>;

Expected<std::string> number_text(KnownNumbers& known, std::string_view what);

// Text in which {{WORD REST}} stands for something that is made.
//
// Valid     a placeholder on one line, without braces in it
// Output    an Error as "NAME:LINE: expected .."

// What a placeholder stands for; an Error says what was expected instead, without a full stop.
using PartOf = std::function<Expected<std::string>(std::string_view word, std::string_view rest)>;

// `name` is that of the text, for messages.
Expected<std::string> filled(std::string_view text, std::string_view name, const PartOf& part_of);

}  // namespace tact
