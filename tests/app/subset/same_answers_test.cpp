// One question, one answer: window, command line and Python are asked the same of one set, both as
// it is meant and as a device plays it, and every bit of what they say is compared.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/ask/ask.h"
#include "app/candidates/candidates.h"
#include "app/map/map.h"
#include "app/patterns/patterns.h"
#include "app/rendering/rendering.h"
#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "model/io/set/set_file.h"
#include "model/set/pattern_set.h"
#include "model/subset/set_subset.h"
#include "model/tasks/set_report.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace same_answers_test {

using namespace tact;
using Json = nlohmann::json;

namespace {

constexpr std::array kAsked{Metric::pm,   Metric::nc,     Metric::oc,           Metric::rmse,
                            Metric::dtw,  Metric::msm,    Metric::level,        Metric::van_rossum,
                            Metric::spqi, Metric::st_sim, Metric::no_physiology};
constexpr std::size_t kPicked = 4;
constexpr std::size_t kDraws = 3;

// One that is locked, one that is dropped, one that nobody feels, and one that lasts longer.
// Waiting costs, so that OC is not the one of the default model.
PatternSet asked_set() {
    PatternSet set = short_patterns(9);
    set.vibrations[1].locked = true;
    set.vibrations[4].dropped = true;
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 0.0;
    std::get<Pattern>(set.vibrations[6].source).duration_s = 0.16;
    std::get<Pattern>(set.vibrations[7].source).amplitude_g = 1.7;
    set.model.envelope.waiting_cost = 0.1;
    return set;
}

Json json_of(const Subset& subset, const std::vector<std::string>& names) {
    Json json{{"weakest", subset.weakest_dissimilarity}, {"sum", subset.sum}};
    for (const std::size_t member : subset.members) json["patterns"].push_back(names[member]);
    return json;
}

Json json_of(const Json& subset) {
    return {{"weakest", subset.at("weakest").at("dissimilarity")},
            {"sum", subset.at("sum")},
            {"patterns", subset.at("patterns")}};
}

// The part of the answers that all of them say.
Json json_of(const SubsetAnswer& answer, const std::vector<std::string>& names) {
    Json json{{"best", json_of(answer.best, names)}, {"bound", answer.bound}};
    for (const Subset& other : answer.alternatives) {
        json["alternatives"].push_back(json_of(other, names));
    }
    return json;
}

struct Asked {
    TemporaryFolder folder;
    std::string file = (folder.path / "asked.tactspace.json").string();
    Program program{asked_set()};
    App& app = program.app;
    std::optional<RenderedBy> by;

    explicit Asked(std::optional<RenderedBy> device) : by(std::move(device)) {
        REQUIRE(write_set_file(file, app.work.document.set));
        app.rendered.on = by.has_value();
        if (by) app.rendered.by = *by;
        app.layout.bench = BenchTab::subset;
        app.picking.count = kPicked;
        program.compute_map();
    }

    PatternSet felt() const {
        const PatternSet& set = app.work.document.set;
        return by ? rendered_set(set, *by)->played : set;
    }
    std::vector<std::string> names() const { return names_of(app.work.document.set); }

    template <class Arrived>
    void wait(const Arrived& arrived) {
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (!arrived());
    }

    const Pick& picked_in_window(Metric metric) {
        SubsetState& picking = app.picking;
        picking.metric = metric;
        wait([&] {
            return picking.asked.metric == metric && picking.pick &&
                   picking.pick->request == picking.asked && !is_subset_busy(picking);
        });
        REQUIRE(picking.pick->fault.empty());
        return *picking.pick;
    }

    Json told(std::vector<std::string> words) const {
        words.insert(words.begin() + 1, file);
        words.emplace_back("--json");
        if (by) {
            words.insert(words.end(), {"--rendered-by", traits(by->kind).key, "--level",
                                       std::to_string(by->level)});
        }
        return Json::parse(output_of(words));
    }

    Json picked_in_terminal(Metric metric, std::size_t alternatives) const {
        const Json json =
            told({"subset", "--metric", traits(metric).key, "-k", std::to_string(kPicked),
                  "--alternatives", std::to_string(alternatives)});
        Json picked{{"best", json_of(json)}, {"bound", json.at("bound")}};
        for (const Json& other : json.at("alternatives")) {
            picked["alternatives"].push_back(json_of(other));
        }
        CHECK(json.at("left_out_unfelt") == std::vector<std::string>{"p3"});
        return picked;
    }

    // As a notebook asks: waves, a matrix of them, what nobody feels, and the most distinct.
    std::pair<Dissimilarity, SubsetAnswer> picked_in_python(Metric metric,
                                                            std::size_t alternatives) const {
        const std::vector<Waveform> waves = own_waveforms(felt());
        const PerceptualModelParams& model = app.work.document.set.model;
        const auto pairs = set_pairs(waves, model, {metric, false});
        const auto unfelt = unfelt_in(waves, model);
        REQUIRE(pairs);
        REQUIRE(unfelt);
        SubsetProblem problem{kPicked, SubsetObjective::max_min, {1}, *unfelt};
        problem.drop.push_back(4);
        SubsetOptions options;
        options.alternatives = alternatives;
        return {pairs->apart, *most_distinct_subset(pairs->apart, problem, options)};
    }
};

std::optional<RenderedBy> dualshock() {
    RenderedBy by{ActuatorKind::dualshock_4};
    by.level = 0.5;
    return by;
}

}  // namespace

TEST_CASE("same answers: the most distinct by every metric, meant and as a device plays them" *
          doctest::test_suite("long")) {
    for (const auto& by : {std::optional<RenderedBy>(), dualshock()}) {
        CAPTURE(by.has_value());
        Asked asked(by);
        for (const Metric metric : kAsked) {
            CAPTURE(std::string(traits(metric).key));
            const Pick& pick = asked.picked_in_window(metric);
            const std::size_t alternatives = pick.answer.alternatives.size();
            const Json window = json_of(pick.answer, asked.names());
            const auto [matrix, answer] = asked.picked_in_python(metric, alternatives);
            CHECK(*pick.dissimilarity == matrix);
            CHECK(window == json_of(answer, asked.names()));
            CHECK(window == asked.picked_in_terminal(metric, alternatives));
            CHECK(pick.request.unfelt == 1);
        }
    }
}

TEST_CASE("same answers: a device makes other patterns distinct, by any metric") {
    const PatternSet set = asked_set();
    const PatternSet played = rendered_set(set, *dualshock())->played;
    for (const Metric metric : kAsked) {
        CAPTURE(std::string(traits(metric).key));
        CHECK(set_pairs(set, {metric})->apart != set_pairs(played, {metric})->apart);
    }
}

TEST_CASE("same answers: how sure a subset is, and groups, are of what the device plays" *
          doctest::test_suite("long")) {
    Asked asked(dualshock());
    const Pick& pick = asked.picked_in_window(Metric::pm);
    SubsetState& picking = asked.app.picking;
    ask_for_stability(asked.app.ui, picking, kDraws);
    asked.wait([&] { return !is_subset_busy(picking) && shown_stability(picking) != nullptr; });
    const Stability& window = *shown_stability(picking);
    const Json terminal = asked.told(
        {"subset", "-k", std::to_string(kPicked), "--sensitivity", std::to_string(kDraws)});
    const Json& sure = terminal.at("sensitivity");
    CHECK(sure.at("draws") == window.draws);
    CHECK(sure.at("same") == window.share_same);
    CHECK(sure.at("same_weakest") == window.share_weakest);
    for (std::size_t k = 0; k < window.share_picked.size(); ++k) {
        CHECK(sure.at("picked").at(asked.names()[k]) == window.share_picked[k]);
    }

    picking.view = SubsetView::groups;
    asked.wait([&] { return shown_groups(asked.app.shown_map, picking) != nullptr; });
    const auto pairs = set_pairs(asked.felt());
    CHECK(*pick.dissimilarity == pairs->apart);
    CHECK(shown_groups(asked.app.shown_map, picking)->groups ==
          groups_of_set(asked.app.work.document.set, pairs->apart, pairs->unfelt));
    const Json groups = asked.told({"groups"});
    CHECK(groups.at("joins").size() == 6);
    std::vector<double> heights;
    for (const Json& join : groups.at("joins")) heights.push_back(join.at(2));
    std::vector<double> shown;
    for (const auto& join : shown_groups(asked.app.shown_map, picking)->groups.tree.joins) {
        shown.push_back(join.height);
    }
    CHECK(heights == shown);
}

TEST_CASE("same answers: the window and the terminal write the same page" *
          doctest::test_suite("long")) {
    for (const auto& by : {std::optional<RenderedBy>(), dualshock()}) {
        CAPTURE(by.has_value());
        Asked asked(by);
        asked.picked_in_window(Metric::pm);
        const auto from_window = asked.folder.path / "window.html";
        const std::string from_terminal = (asked.folder.path / "terminal.html").string();
        export_report(asked.app.ui, asked.app.picking, from_window);
        asked.wait([&] {
            const App& app = asked.app;
            continue_subset_export(asked.app.ui, app.work, app.shown_map, asked.app.picking);
            return std::filesystem::exists(from_window);
        });
        const Json terminal =
            asked.told({"report", "--out", from_terminal, "-k", std::to_string(kPicked)});
        CHECK((bytes_of(from_window) == bytes_of(from_terminal)));
        SetReportRequest request;
        request.count = kPicked;
        const auto report = set_report(asked.app.work.document.set, asked.felt(), request);
        REQUIRE(report);
        Json python = json_of(*report, asked.app.work.document.set);
        for (const auto& [key, value] : python.items()) {
            CAPTURE(key);
            CHECK(terminal.at(key) == value);
        }
    }
}

TEST_CASE("same answers: what parts a pair, and steps between two" * doctest::test_suite("long")) {
    Asked asked(dualshock());
    SubsetState& picking = asked.app.picking;
    asked.picked_in_window(Metric::pm);
    picking.view = SubsetView::confusable;
    picking.too_close = TooClose::share;
    picking.share = 0.2;
    const TooClosePairs& pairs = too_close_pairs(asked.app.shown_map, picking);
    const auto pair = std::ranges::find_if(pairs.pairs, [&](const ConfusablePair& one) {
        return fixed_because(asked.app.work, asked.app.shown_map, one.a).empty();
    });
    REQUIRE(pair != pairs.pairs.end());
    const std::string a = asked.names()[pair->a];
    const std::string b = asked.names()[pair->b];
    ask_for_separation(asked.app.ui, asked.app.work, asked.app.shown_map, picking, pair->a);
    asked.wait([&] { return picking.separations && !is_subset_busy(picking); });
    Json window = Json::array();
    for (const Separation& one : picking.separations->all) {
        window.push_back(
            {{"pattern", a},
             {"parameter", traits(one.parameter).key},
             {"from", one.from},
             {"to", one.to},
             {"felt_steps", one.steps},
             {"nearest",
              {{"pattern", asked.names()[one.nearest_to]}, {"dissimilarity", one.nearest}}}});
    }
    const Json terminal =
        asked.told({"separate", "--pair", a + "," + b, "--change", a, "--closest", "20"});
    CHECK(terminal.at("dissimilarity") == pair->dissimilarity);
    CHECK(terminal.at("threshold") == pairs.threshold);
    CHECK(terminal.at("changes") == window);

    open_steps(asked.app.ui, asked.app.work, asked.app.steps, "p1", "p8");
    asked.wait([&] { return current_steps(asked.app.work, asked.app.steps) != nullptr; });
    const EvenSteps& steps = current_steps(asked.app.work, asked.app.steps)->steps;
    const auto out = (asked.folder.path / "steps.tactspace.json").string();
    const Json placed = Json::parse(
        output_of({"steps", asked.file, "--from", "p1", "--to", "p8", "--out", out, "--json"}));
    CHECK(placed.at("shares") == steps.shares);
    CHECK(placed.at("apart") == steps.apart);
    CHECK(placed.at("pm") == steps.pm);
}

TEST_CASE("same answers: what is nearest to each pattern, and NC, OC and PM as they are told" *
          doctest::test_suite("long")) {
    for (const auto& by : {std::optional<RenderedBy>(), dualshock()}) {
        CAPTURE(by.has_value());
        Asked asked(by);
        App& app = asked.app;
        const LiveMap& map = *app.shown_map.transition.shown;
        const auto out = (asked.folder.path / "page.html").string();
        const Json nearest =
            asked.told({"report", "--out", out, "-k", std::to_string(kPicked)}).at("nearest");
        const auto rows = candidate_rows(app.work, app.shown_map, app.candidates);
        REQUIRE(rows.size() == asked.names().size());
        for (const CandidateRow& row : rows) {
            const std::string name = asked.names()[row.place];
            CAPTURE(name);
            const Json& told = nearest.at(name);
            select_only(app.work, row.place);
            const auto card = neighbour_of(app.work, app.shown_map);
            CHECK(told.at("dissimilarity").is_null() == !row.nearest_pm.has_value());
            CHECK(card.has_value() == row.nearest_pm.has_value());
            if (!row.nearest_pm || !card) continue;
            CHECK(told.at("dissimilarity") == *row.nearest_pm);
            CHECK(told.at("pattern") == row.nearest_name);
            CHECK(asked.names()[card->closest] == row.nearest_name);
        }
        CHECK(nearest.at("p3").at("dissimilarity").is_null());  // nobody feels it
        for (const Metric metric : {Metric::pm, Metric::nc, Metric::oc}) {
            CAPTURE(std::string(traits(metric).key));
            std::vector<std::string> words{"predict", asked.file, "--metric", traits(metric).key};
            if (by) {
                words.insert(words.end(), {"--rendered-by", traits(by->kind).key, "--level",
                                           std::to_string(by->level)});
            }
            const Dissimilarity& window = metric == Metric::pm   ? map.prediction.pm
                                          : metric == Metric::nc ? map.nc
                                                                 : map.oc;
            CHECK(condensed_in(output_of(words)) == window.condensed);
        }
    }
}

}  // namespace same_answers_test
