// The map of a set on a page: drawings, as large as the page is wide.
#pragma once

#include <string>

#include "app/pictures/pictures.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/set/pattern_set.h"

namespace tact {

struct HtmlMap {
    const PatternSet& set;
    const Dissimilarity& dissimilarity;
    const PerceptualSpace& space;
    SpaceMarks marks{};     // a map before, too: arrows lead from there
    std::string id{"map"};  // of its own in the page
    std::string alt{};      // text: what is seen, for who does not see it
    std::string caption{};  // html
};

// A figure with the map on the ground of either theme.
std::string html_of(const HtmlMap& map);

}  // namespace tact
