// What the map's colours say, in the program's frames.

#include "app/map/map.h"

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "app/workspaces/workspaces.h"
#include "model/map/explained_share.h"
#include "tests/support/program.h"

namespace map_look_test {

using namespace tact;

namespace {

// Carriers go round, so that they explain little; amplitudes rise with the number.
PatternSet many(std::size_t count) {
    PatternSet set = short_patterns(count);
    for (std::size_t k = 0; k < count; ++k) {
        Pattern& pattern = std::get<Pattern>(set.vibrations[k].source);
        pattern.amplitude_g = 0.2 + 0.1 * static_cast<double>(k);
        pattern.carriers = {{40.0 + 30.0 * static_cast<double>(k % 3)}};
    }
    return set;
}

}  // namespace

TEST_CASE("map look: many patterns are coloured by what explains most of the map, and it says so") {
    Program program(many(30));
    program.resize({1600.0F, 1000.0F}, 1.0F);
    program.compute_map();
    program.settle();
    const ShownMap& shown = program.app.shown_map;
    REQUIRE(program.shows("map:colour"));
    const std::string words = program.at("map:colour").value;
    // No other number explains more.
    double most = 0.0;
    std::string name;
    for (const PatternParameter parameter :
         {PatternParameter::amplitude, PatternParameter::carrier}) {
        std::vector<double> values;
        for (const Vibration& one : program.app.work.document.set.vibrations) {
            values.push_back(std::log(*value_of(std::get<Pattern>(one.source), parameter)));
        }
        const double share = explained_share(shown.transition.to, values);
        if (share > most) name = traits(parameter).name;
        most = std::max(most, share);
    }
    CHECK(words.find("colour: " + name + ", explains ") == 0);
    // Whoever chooses has the last word.
    program.click("link:map look");
    CHECK(program.at("look:Colour by").value == name);
    program.app.shown_map.look.is_chosen = true;
    program.settle();
    CHECK_FALSE(program.shows("map:colour"));
}

TEST_CASE("map look: a few patterns keep their own colours") {
    Program program(many(24));
    program.resize({1600.0F, 1000.0F}, 1.0F);
    program.compute_map();
    program.settle();
    CHECK_FALSE(program.shows("map:colour"));
}

TEST_CASE("map headline: how many pairs may be confused, by the scale of all panes") {
    PatternSet set = short_patterns(4);
    Program program(set);
    program.resize({1600.0F, 1000.0F}, 1.0F);
    App& app = program.app;
    app.layout = first_layout(Arrangement::design);
    const auto words_with = [&](double hz) {
        std::get<Pattern>(app.work.document.edit().vibrations[1].source) =
            std::get<Pattern>(app.work.document.set.vibrations[0].source);
        std::get<Pattern>(app.work.document.edit().vibrations[1].source).carriers[0].frequency_hz =
            hz;
        document_changed(app.work);
        program.wait_for_exact_map();
        program.settle();
        return program.at("map:verdict").value;
    };
    program.compute_map();
    const double first_hz =
        std::get<Pattern>(app.work.document.set.vibrations[0].source).carriers[0].frequency_hz;
    const double step = step_of(app.work.document.set.felt_steps, PatternParameter::carrier);
    CHECK(words_with(first_hz).starts_with("1 pair the same"));
    CHECK(words_with(first_hz * std::pow(step, 1.5)).starts_with("1 pair may be confused"));
    CHECK(words_with(first_hz * std::pow(step, 2.5)) == "No pair within two felt steps");
}

}  // namespace map_look_test
