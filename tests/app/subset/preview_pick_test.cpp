// A subset is picked as soon as there is a map, says that it is of a preview, and is picked again
// once the map is exact.
#include "app/subset/subset_export.h"
#include "app/subset/subset_follow.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace preview_pick_test {

using namespace tact;

namespace {

struct Previewed : Program {
    Previewed() : Program(short_patterns(6)) {
        app.ui.motion = false;
        make_jobs(app);
        app.layout.bench = BenchTab::subset;
        app.picking.count = 3;
    }
    ~Previewed() { stop_jobs(app); }

    void show(bool preview) {
        const LiveMapRequest request{app.work.revision, app.work.document_number,
                                     std::make_shared<const PatternSet>(app.work.document.set), 3,
                                     preview};
        std::atomic<float> progress = 0.0F;
        auto map = LiveMapWork{}(request, {}, progress);
        REQUIRE(map);
        show_map(app.ui, app.shown_map, std::make_shared<const LiveMap>(*std::move(map)));
    }

    void until_proof_begins(const std::string& words) {
        const auto until = end_of_patience();
        while (!shows("subset:proof") || !at("subset:proof").value.starts_with(words)) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
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
