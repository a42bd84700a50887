// Every view, tab and dialog with two patterns, with some, and with the largest set.

#include <cmath>

#include "app/measured/measured.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/window/window.h"
#include "model/common/distributions.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/separation.h"
#include "tests/support/program.h"

namespace every_view_test {

using namespace tact;

namespace {

// A map as if computed: the exact one of 1,000 patterns takes minutes.
std::shared_ptr<const LiveMap> made_map(const App& app) {
    LiveMap map;
    map.request = {app.work.revision,
                   app.work.document_number,
                   std::make_shared<const PatternSet>(app.work.document.set),
                   3,
                   false,
                   {}};
    map.played = map.request.set;
    const std::size_t n = app.work.document.set.vibrations.size();
    const std::size_t pairs = pair_count(n);
    map.space.points = random_start(static_cast<Eigen::Index>(n), 3, 1, 1);
    map.space.stress1 = 0.1;
    for (Dissimilarity* one : {&map.prediction.pm, &map.prediction.nc, &map.prediction.oc}) {
        one->size = n;
    }
    for (std::size_t k = 0; k < pairs; ++k) {
        // Values from 0 to 1, in no order of the pairs.
        const double value = std::fmod(0.6180339887498949 * static_cast<double>(k + 1), 1.0);
        map.prediction.pm.condensed.push_back(value);
        map.prediction.nc.condensed.push_back(1.0 - value);
        map.prediction.oc.condensed.push_back(value * value);
        map.prediction.nc_rank.push_back(static_cast<double>(pairs - k));
        map.prediction.oc_rank.push_back(static_cast<double>(k + 1));
    }
    note_facts(map);
    return std::make_shared<const LiveMap>(std::move(map));
}

PatternSet shorter_patterns(std::size_t count) {
    PatternSet set = short_patterns(count);
    set.duration_s = 0.05;
    for (Vibration& vibration : set.vibrations) {
        std::get<Pattern>(vibration.source).duration_s = 0.05;
    }
    return set;
}

struct Large : Program {
    explicit Large(std::size_t count) : Program(shorter_patterns(count)) {
        app.ui.motion = false;
        show_map(app.ui, app.shown_map, made_map(app));
        settle();
        REQUIRE(map_state(app.work, app.shown_map) == MapState::exact);
    }

    // Draws it, and tells whether the drawing is nearly empty.
    void look(const std::string& view) {
        CAPTURE(view);
        settle();
        CHECK(ImGui::GetDrawData()->TotalVtxCount > 1000);
        CHECK(ImGui::GetDrawData()->TotalVtxCount < 600'000);
    }

    void look_at_bench() {
        for (const BenchRow& row : kBenchTabs) {
            app.layout.bench = row.tab;
            look(std::string("bench tab ") + row.key);
        }
        app.layout.bench = BenchTab::subset;
        for (const SubsetView view : {SubsetView::pick, SubsetView::confusable,
                                      SubsetView::stability, SubsetView::groups}) {
            app.picking.view = view;
            look("subset view " + std::to_string(static_cast<int>(view)));
        }
        app.layout.bench = BenchTab::compare;
        for (const CompareView view :
             {CompareView::table, CompareView::scatter, CompareView::findings}) {
            app.comparing.panel.view = view;
            look("compare view " + std::to_string(static_cast<int>(view)));
        }
        app.layout.bench = BenchTab::model;
        app.model_bench.panel.view = ModelView::training;
        look("training");
        app.layout.bench = BenchTab::matrix;
    }

    void look_at_map() {
        MapLook& look_of_map = app.shown_map.look;
        look_of_map.clusters = 5;
        look("groups");
        look_of_map.clusters = 0;
        look_of_map.colour = PatternParameter::carrier;
        look_of_map.path = PatternParameter::modulation;
        look("colours and lines");
        look_of_map = {};
    }

    void look_at_panes() {
        for (const Pane pane :
             {Pane::patterns, Pane::editor, Pane::physiology, Pane::space, Pane::matrix}) {
            app.layout.maximised = pane;
            look("pane " + std::to_string(static_cast<int>(pane)));
        }
        app.layout.maximised.reset();
        for (const Stage stage : kStages) {
            app.physiology.view.open = stage;
            look("stage " + std::to_string(static_cast<int>(stage)));
        }
        app.physiology.view.open.reset();
    }

    void look_at_dialogs() {
        for (const Dialog dialog : {kAboutDialog, kKeysDialog, kDevicesDialog, kExportViewDialog,
                                    kExportAnimationDialog, kGenerateDialog, kSimulationDialog}) {
            app.ui.dialog = dialog;
            look("dialog, " + std::string(dialog.title));
            press_key(key::kEscape);
            app.ui.dialog = kNoDialog;
            settle();
        }
        app.palette.open = true;
        look("palette");
        app.palette.open = false;
    }

    void look_at_studies() {
        open_study(app.layout, app.studying);
        for (const StudyKind kind : {StudyKind::pairwise, StudyKind::sorting}) {
            app.studying.kind = kind;
            look("study " + std::to_string(static_cast<int>(kind)));
        }
        close_study(app.studying);
        stop_study(app.studying);
    }
};

// The share of all pairs that the view calls too close.
double share_too_close(Large& program) {
    const TooClosePairs& pairs = too_close_pairs(program.app.shown_map, program.app.picking);
    return static_cast<double>(pairs.count) /
           static_cast<double>(pair_count(program.app.work.document.set.vibrations.size()));
}

}  // namespace

TEST_CASE("every view: it opens with 2, 260 and 1,000 patterns, and draws no more than a screen" *
          doctest::test_suite("long")) {
    for (const std::size_t count : {2U, 260U, 1000U}) {
        CAPTURE(count);
        Large program(count);
        program.look_at_bench();
        program.look_at_map();
        program.look_at_panes();
        program.look_at_dialogs();
        program.look_at_studies();
    }
}

TEST_CASE("every view: the same share of the pairs is too close in a set of any size") {
    for (const std::size_t count : {260U, 1000U}) {
        CAPTURE(count);
        Large program(count);
        program.app.layout.bench = BenchTab::subset;
        program.app.picking.view = SubsetView::confusable;
        program.app.picking.too_close = TooClose::share;
        program.settle();
        // Values are spread evenly: the share is the requested one, to within a pair or two.
        CHECK(std::abs(share_too_close(program) - program.app.picking.share) < 1e-4);
        CHECK(program.app.picking.pairs.pairs.size() == 200);
    }
}

TEST_CASE("every view: a cell of the matrix is the pair that the map joins, and the other way" *
          doctest::test_suite("long")) {
    for (const bool reordered : {false, true}) {
        CAPTURE(reordered);
        Large program(6);
        // The map keeps its rows when the list is reordered.
        if (reordered) move_vibration(program.app.ui, program.app.work, 5, 0);
        program.settle();
        const Place cells = program.at("view:Matrix");
        std::size_t read = 0;
        for (float y = 0.1F; y < 1.0F; y += 0.13F) {
            for (float x = 0.1F; x < 1.0F; x += 0.09F) {
                program.hover({cells.min.x + x * (cells.max.x - cells.min.x),
                               cells.min.y + y * (cells.max.y - cells.min.y)});
                if (!program.shows("pair")) continue;
                const std::string& words = program.at("pair").value;
                const std::string names = words.substr(0, words.find('\t'));
                REQUIRE(program.shows("map pair"));
                std::string joined = program.at("map pair").value;
                joined.replace(joined.find('|'), 1, "   ");
                CHECK(joined == names);
                ++read;
            }
        }
        CHECK(read >= 10);
    }
    Large program(6);
    program.click("row:p2");
    program.hover(program.at("row:p5").middle());
    CHECK(program.at("view:Matrix").value == "p2|p5");
    CHECK(program.at("map pair").value == "p2|p5");
}

}  // namespace every_view_test
