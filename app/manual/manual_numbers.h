// What the model says of the sets that come with the program, for the manual's text.
//
//     SET patterns | pairs                 SET: the file's name without its ending
//     SET stress1 | stress_label           of the map of three dimensions
//     SET nearest | nearest_pm | farthest | farthest_pm
//     SET picked K | weakest K             the K most distinct, and how far its weakest pair is
//     metrics | combinations | examples    of the program
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/set/pattern_set.h"

namespace tact {

struct PredictedExample {
    PatternSet set;
    Dissimilarity pm;
    PerceptualSpace space;
};

// Each set is predicted once, when the first number is asked of it.
using KnownNumbers = std::map<std::string, std::shared_ptr<const PredictedExample>, std::less<>>;

Expected<std::string> number_text(KnownNumbers& known, std::string_view what);

}  // namespace tact
