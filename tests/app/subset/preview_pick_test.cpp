// A subset is picked as soon as there is a map, says that it is of a preview, and is picked again
// once the map is exact.
#include "app/jobs/jobs.h"
#include "app/subset/subset.h"
#include "model/common/fingerprint.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace preview_pick_test {

using namespace tact;

namespace {

struct Previewed : Program {
    explicit Previewed(std::size_t patterns = 6) : Program(short_patterns(patterns)) {
        app.ui.motion = false;
        begin_jobs(app);
        app.layout.bench = BenchTab::subset;
        app.picking.count = 3;
    }

    void show(bool preview) {
        const LiveMapRequest request{app.work.revision, app.work.document_number,
                                     std::make_shared<const PatternSet>(app.work.document.set), 3,
                                     preview};
        std::atomic<float> progress = 0.0F;
        auto map = LiveMapWork{}(request, {}, progress);
        REQUIRE(map);
        show(*std::move(map));
    }
    void show(LiveMap map) {
        show_map(app.ui, app.shown_map, std::make_shared<const LiveMap>(std::move(map)));
    }

    // The sum of 20 of them takes longer than anyone waits.
    void show_distances_by_chance() {
        LiveMap map = *app.shown_map.transition.shown;
        std::uint64_t mixed_so_far = 1;
        for (double& value : map.prediction.pm.condensed) {
            mixed_so_far = mixed(mixed_so_far, std::uint64_t{7});
            value = static_cast<double>(mixed_so_far >> 40U);
        }
        app.picking.count = 20;
        app.picking.objective = SubsetObjective::max_sum;
        show(std::move(map));
    }

    template <class IsSo>
    void until(const IsSo& is_so) {
        const auto end = end_of_patience();
        while (!is_so()) {
            REQUIRE(std::chrono::steady_clock::now() < end);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }
    void until_proof_begins(const std::string& words) {
        until([&] { return shows("subset:proof") && at("subset:proof").value.starts_with(words); });
    }
};

}  // namespace

TEST_CASE("subset: it is picked on the preview, says so, and is picked again on the exact map") {
    Previewed program;
    program.show(true);
    program.until_proof_begins("A preview");
    CHECK(program.app.work.selection.is_pick_preview);
    CHECK(program.app.work.selection.picked.size() == 3);
    const std::string member = *program.app.work.selection.picked.begin();
    CHECK(program.at("picked:" + member).value == "preview");
    program.show(false);
    program.until_proof_begins("Proven");
    CHECK_FALSE(program.app.work.selection.is_pick_preview);
    CHECK_FALSE(is_of_preview(program.app.picking.pick->request));
    const auto& map = *program.app.shown_map.transition.shown;
    CHECK(program.app.picking.pick->answer.best.weakest_dissimilarity ==
          most_distinct_subset(map.prediction.pm, {3, SubsetObjective::max_min, {}, {}})
              ->best.weakest_dissimilarity);
}

TEST_CASE("subset: an export waits while the map is a preview, and is of the exact one") {
    Previewed program;
    program.show(true);
    program.until_proof_begins("A preview");
    const TemporaryFolder folder;
    const auto to = folder.path / "subset";
    const auto write = [&] {
        continue_subset_export(program.app.ui, program.app.work, program.app.shown_map,
                               program.app.picking);
    };
    export_subset(program.app.ui, program.app.picking, to);
    write();
    CHECK_FALSE(std::filesystem::exists(to));
    CHECK_FALSE(program.app.ui.status.is_error);
    CHECK(program.app.picking.export_to == to);
    program.show(false);
    program.until_proof_begins("Proven");
    write();
    CHECK(std::filesystem::exists(to));
    CHECK(program.app.picking.export_to.empty());
}

TEST_CASE(
    "subset: a long search shows the best by now and its bound, and keeps it when cancelled") {
    Previewed program(90);
    SubsetState& picking = program.app.picking;
    program.show(false);
    program.show_distances_by_chance();
    const Dissimilarity pm = program.app.shown_map.transition.shown->prediction.pm;
    program.until_proof_begins("The best by now; no sum is above ");
    CHECK(is_picking(picking));
    CHECK(program.app.work.selection.is_pick_preview);
    CHECK(picking.pick->answer.best == subset_of(pm, picking.pick->answer.best.members));
    CHECK(picking.pick->answer.best.members.size() == 20);
    CHECK(picking.pick->answer.best.sum <= picking.pick->answer.bound);
    program.click("link:cancel picking");
    program.until_proof_begins("The best when it was cancelled; no sum is above ");
    program.until([&] { return program.shows("link:pick again"); });  // once the search heeds it
    CHECK(shown_subset(program.app.shown_map, picking) != nullptr);
    picking.view = SubsetView::stability;
    program.settle();
    CHECK(program.at("stability obstacle").value ==
          "The search for the subset is not at its end: see Pick.");
}

TEST_CASE("subset: without threads a search gives its turn back, and ends unproven or cancelled") {
    pretend_no_threads(true);
    {
        Previewed program(90);
        SubsetState& picking = program.app.picking;
        program.show(false);
        program.show_distances_by_chance();
        program.frame();
        int turns = 0;
        const auto give_one = [&] {
            REQUIRE(give_turn(true));
            program.frame();
            ++turns;
        };
        while (!picking.pick) give_one();
        CHECK(picking.pick->is_so_far);
        CHECK(is_picking(picking));
        const auto apart = picking.pick->dissimilarity;
        while (is_picking(picking)) give_one();
        CHECK(picking.pick->dissimilarity == apart);  // found once, not in each turn
        CHECK(turns >= 5);                            // of 0.1, 0.2, 0.4, 0.8 and 1.6 s
        CHECK_FALSE(picking.pick->is_so_far);
        CHECK(picking.pick->answer.proof == SubsetProof::open);
        picking.count = 19;
        program.frame();
        while (!picking.pick->is_so_far) give_one();
        cancel_picking(picking);
        CHECK_FALSE(picking.pick_job.busy());
    }
    pretend_no_threads(false);
}

TEST_CASE("subset: an export does not wait for a picking that was cancelled") {
    Previewed program;
    program.show(false);
    program.until_proof_begins("Proven");
    cancel_picking(program.app.picking);
    const TemporaryFolder folder;
    export_subset(program.app.ui, program.app.picking, folder.path / "subset");
    continue_subset_export(program.app.ui, program.app.work, program.app.shown_map,
                           program.app.picking);
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.picking.export_to.empty());
    CHECK_FALSE(std::filesystem::exists(folder.path / "subset"));
}

}  // namespace preview_pick_test
