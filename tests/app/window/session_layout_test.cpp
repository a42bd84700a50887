// The window begins as it was left.

#include "app/window/window.h"

#include "app/document/editing.h"
#include "tests/support/program.h"
#include "tests/support/state_home.h"
#include "tests/support/temporary_folder.h"

namespace session_layout_test {

using namespace tact;

TEST_CASE("session: the window begins as it was left") {
    const TemporaryFolder folder;
    const StateHome home{folder.path / "state"};
    const std::filesystem::path file = folder.path / "three.json";
    {
        Program left(short_patterns(3));
        REQUIRE(start_session(left.app, {}));
        left.app.layout = Layout{};
        left.settle();
        REQUIRE(left.shows("hint:editor"));
        left.click("hint:editor");
        CHECK(!left.shows("hint:editor"));
        left.app.ui.dark = !left.app.ui.dark;
        left.app.ui.motion = !left.app.ui.motion;
        left.app.ui.text_scale = 1.25F;
        left.app.layout.left = 0.22F;
        left.app.layout.right = 0.31F;
        left.app.layout.left_split = 0.41F;
        left.app.layout.right_split = 0.51F;
        left.app.shown_map.camera = {.yaw_rad = 0.6, .pitch_rad = 0.7, .zoom = 1.3};
        left.app.shown_map.dimensions = 2;
        left.app.lesson.left_at = {{kTourLesson, 2}, {"/home/mine.tactlesson.json", 5}};
        left.app.work.own_heights = true;
        left.app.pattern_panes.strip.height = 222.0F;
        left.app.work.document.edit() = short_patterns(3);
        save_as(left.app.ui, left.app.work, file);
        end_session(left.app);
    }
    Program begun(short_patterns(1));
    const Ui untouched;
    REQUIRE(start_session(begun.app, {}));
    begun.settle();
    CHECK(!begun.shows("hint:editor"));
    CHECK(begun.shows("hint:physiology"));
    CHECK(begun.app.ui.dark != untouched.dark);
    CHECK(begun.app.ui.motion != untouched.motion);
    CHECK(begun.app.ui.text_scale == 1.25F);
    CHECK(begun.app.layout.left == 0.22F);
    CHECK(begun.app.layout.right == 0.31F);
    CHECK(begun.app.layout.left_split == 0.41F);
    CHECK(begun.app.layout.right_split == 0.51F);
    CHECK(begun.app.shown_map.camera.yaw_rad == 0.6);
    CHECK(begun.app.shown_map.camera.pitch_rad == 0.7);
    CHECK(begun.app.shown_map.camera.zoom == 1.3);
    CHECK(begun.app.shown_map.dimensions == 2);
    CHECK(begun.app.lesson.left_at ==
          std::map<std::string, std::size_t>{{kTourLesson, 2}, {"/home/mine.tactlesson.json", 5}});
    CHECK(begun.app.work.own_heights);
    CHECK(begun.app.pattern_panes.strip.height == 222.0F);
    CHECK(begun.app.work.document.path == file);
    CHECK(begun.app.work.document.set == short_patterns(3));
}

}  // namespace session_layout_test
