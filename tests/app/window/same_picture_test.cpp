// Pictures of the window and of its panes agree with the window: the same results, marks, device,
// selection and scroll positions.

#include <imgui_internal.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/subset/subset.h"
#include "app/window/window.h"
#include "tests/support/drawn_texts.h"
#include "tests/support/scene_steps.h"
#include "tests/support/scenes.h"
#include "tests/support/svg_elements.h"

namespace same_picture_test {

using namespace tact;

namespace {

// Progress, and buttons for it, come from the job, which a picture does not have.
bool tells_of_work(const std::string& name) {
    return name == "training" || name == "a map of an earlier state" ||
           name == "compare, pairs with people";
}

// Popups, and the pages of a participant and a class, are in no picture.
bool is_in_pictures(const std::string& name) {
    for (const char* over :
         {"dialog, ", "menu ", "popup ", "tooltip ", "participant", "lesson", "present"}) {
        if (name.starts_with(over)) return false;
    }
    return !name.ends_with(", explained");  // the window beside a stage
}

std::vector<std::string> drawn_texts(SceneWindow& window) {
    window.frame();
    std::vector<std::string> texts;
    for (const DrawnText& text : texts_of(*ImGui::GetDrawData(), window.app.ui.theme.fonts).texts) {
        texts.push_back(text.words);
    }
    std::ranges::sort(texts);
    return texts;
}

std::vector<std::string> texts_on_screen(SceneWindow& window) {
    window.window.move({-100.0F, -100.0F});
    window.settle();
    ImGui::GetStyle().AntiAliasedLines = false;
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    ImGui::GetStyle().AntiAliasedFill = false;
    // A picture waits for the stages that it shows, and leaves no message and no room for a running
    // map.
    const auto is_awaited = [](const std::string& text) {
        return text.find("on their way") != text.npos || text.starts_with("computing");
    };
    std::vector<std::string> texts = drawn_texts(window);
    for (const auto until = end_of_patience();
         (std::ranges::any_of(texts, is_awaited) || window.app.shown_map.full_job.busy() ||
          is_picking(window.app.picking)) &&
         std::chrono::steady_clock::now() < until;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        texts = drawn_texts(window);
    }
    window.settle();  // since the last of these
    return drawn_texts(window);
}

std::vector<std::string> texts_in_picture(const App& app, PictureView view, ImVec2 size) {
    const auto still = snapshot_of(app);
    PictureSize of;
    of.width = static_cast<int>(size.x);
    of.height = static_cast<int>(size.y);
    of.scale = app.ui.text_scale;
    of.dark = app.ui.dark;
    of.format = PictureFormat::svg;
    const Picture picture = view_picture(*still, view, app.timeline.playhead.at_s, of);
    std::vector<std::string> texts;
    for (const SvgElement& element : elements_of(std::get<Svg>(picture).text)) {
        if (element.name == "text") texts.push_back(element.text);
    }
    std::ranges::sort(texts);
    return texts;
}

void check_same(const std::vector<std::string>& window, const std::vector<std::string>& picture) {
    std::vector<std::string> lacking;
    std::vector<std::string> added;
    std::ranges::set_difference(window, picture, std::back_inserter(lacking));
    std::ranges::set_difference(picture, window, std::back_inserter(added));
    for (const std::string& one : lacking) FAIL_CHECK("not in the picture: " << one);
    for (const std::string& one : added) FAIL_CHECK("only in the picture: " << one);
}

}  // namespace

TEST_CASE("same picture: of whatever is open, the picture of the window says the same" *
          doctest::test_suite("long")) {
    SceneWindow window;
    for (const auto& [size, scale] :
         {std::pair{ImVec2{1600.0F, 1000.0F}, 1.0F}, {ImVec2{1280.0F, 720.0F}, 1.5F}}) {
        CAPTURE(size.x);
        window.resize(size, scale);
        for (const Scene& scene : scenes()) {
            if (!is_in_pictures(scene.name) || tells_of_work(scene.name)) continue;
            if (scene.is_costly && scale > 1.0F) continue;
            CAPTURE(scene.name);
            window.show(scene);
            const std::vector<std::string> texts = texts_on_screen(window);
            check_same(texts, texts_in_picture(window.app, PictureView::window, size));
        }
    }
}

TEST_CASE("same picture: a pane that is scrolled is so in the picture, too") {
    SceneWindow window;
    window.resize({1280.0F, 720.0F}, 1.5F);
    show_model(window, ModelView::parameters);
    const std::vector<std::string> at_begin = texts_on_screen(window);
    for (ImGuiWindow* one : ImGui::GetCurrentContext()->Windows) {
        const bool is_list = std::string_view(one->Name).find("parameters") != std::string::npos;
        if (is_list) ImGui::SetScrollY(one, 200.0F);
    }
    const std::vector<std::string> scrolled = texts_on_screen(window);
    REQUIRE_FALSE(scrolled == at_begin);
    check_same(scrolled,
               texts_in_picture(window.app, PictureView::window, ImGui::GetIO().DisplaySize));
}

TEST_CASE("same picture: every one names the set, and of panes shows nothing that those do not" *
          doctest::test_suite("long")) {
    SceneWindow window;
    window.resize({1600.0F, 1000.0F}, 1.0F);
    window.app.work.document.edit().name = "twelve to draw";
    const auto check = [&](PictureView view) {
        CAPTURE(name_of(view));
        const std::vector<std::string> screen = texts_on_screen(window);
        const std::set<std::string> known(screen.begin(), screen.end());
        bool is_named = false;
        for (const std::string& text :
             texts_in_picture(window.app, view, ImGui::GetIO().DisplaySize)) {
            const bool is_title = text.find("twelve to draw") != text.npos;
            is_named |= is_title;
            if (!is_title && !known.contains(text)) FAIL_CHECK("only in the picture: " << text);
        }
        CHECK(is_named);
    };
    show_bench(window, BenchTab::candidates);
    maximise(window, Pane::matrix);
    check(PictureView::table);
    show_subset(window, SubsetView::pick);
    wait_until(window, [&] { return window.app.picking.curve != nullptr; });
    maximise(window, Pane::matrix);
    check(PictureView::subset);
    show_compare(window, CompareView::table);
    wait_for_comparison(window);
    maximise(window, Pane::matrix);
    check(PictureView::compare);
    show_why(window);
    maximise(window, Pane::matrix);
    check(PictureView::why);
}

}  // namespace same_picture_test
