// The program with the physiology of strong patterns on screen, and a mouse for its plots.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tact {

// Strong and rich enough for all four types to fire, short enough for a test.
inline PatternSet rich_patterns() {
    PatternSet set = short_patterns(3);
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        Pattern& pattern = std::get<Pattern>(set.vibrations[k].source);
        pattern.amplitude_g = 1.5 + static_cast<double>(k);
        pattern.carriers = {{70.0 + 10.0 * static_cast<double>(k), 0.5, 0.0}, {210.0, 0.5, 0.0}};
        pattern.modulation.frequency_hz = 20.0;
    }
    return set;
}

struct PhysiologyProgram : ProgramWithStages {
    explicit PhysiologyProgram(const PatternSet& set = rich_patterns()) : ProgramWithStages(set) {}

    ImVec2 in_row(const std::string& id, float share) const {
        const Place& row = at("plot:" + id);
        return {row.min.x + share * (row.max.x - row.min.x), row.middle().y};
    }

    void wheel(ImVec2 where, float notches, bool ctrl) {
        window.move(where);
        settle();
        if (ctrl) push(window.input, {window.now_s, KeyChange{key::kLeftControl, true, false, 0}});
        push(window.input, {window.now_s, MouseWheel{0.0F, notches}});
        settle();
        if (ctrl) push(window.input, {window.now_s, KeyChange{key::kLeftControl, false, false, 0}});
        settle();
    }

    std::vector<std::string> under_the_mouse(const std::string& what) const {
        std::istringstream words(at("under the mouse:" + what).value);
        std::vector<std::string> cells;
        for (std::string word; words >> word;) cells.push_back(word);
        return cells;
    }
};

}  // namespace tact
