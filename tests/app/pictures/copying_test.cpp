// What is copied is text on the clipboard of the desktop, and what others put there can be pasted.

#include "app/pictures/pictures.h"

#include <doctest/doctest.h>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/window/window.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/matrix_file.h"
#include "tests/support/program.h"

namespace copying_test {

using namespace tact;

namespace {

std::string clipboard() {
    const char* text = ImGui::GetClipboardText();
    return text == nullptr ? "" : text;
}

std::size_t size_of(const Program& program) {
    return program.app.work.document.set.vibrations.size();
}

}  // namespace

TEST_CASE("copying: what is copied is a set file that reads back as the same patterns") {
    Program program(short_patterns(3));
    program.app.work.selection.others = {2};
    program.press('c', true);
    const auto read = parse_set(clipboard(), "clipboard", {});
    REQUIRE(read);
    REQUIRE(read->vibrations.size() == 2);
    const auto& all = program.app.work.document.set.vibrations;
    CHECK(read->vibrations[0].source == all[0].source);
    CHECK(read->vibrations[1].name == all[2].name);
}

TEST_CASE("copying: a set file from elsewhere is pasted as one step, under free names") {
    Program program(short_patterns(2));
    PatternSet other = short_patterns(3);
    std::get<Pattern>(other.vibrations[0].source).amplitude_g = 0.625;
    ImGui::SetClipboardText(("  \n" + print_set(other)).c_str());
    program.press('v', true);
    REQUIRE(size_of(program) == 5);
    const Vibration& first = program.app.work.document.set.vibrations[1];
    CHECK(std::get<Pattern>(first.source).amplitude_g == 0.625);
    CHECK(first.name != other.vibrations[0].name);
    program.press('z', true);
    CHECK(size_of(program) == 2);
}

TEST_CASE("copying: other text leaves what was copied here; a broken set says what is wrong") {
    Program program(short_patterns(2));
    ImGui::SetClipboardText("shopping list");
    program.press('v', true);
    CHECK(size_of(program) == 2);
    CHECK(program.app.ui.status.text.starts_with("Nothing to paste"));
    program.press('c', true);
    ImGui::SetClipboardText("shopping list");
    program.press('v', true);
    CHECK(size_of(program) == 3);
    ImGui::SetClipboardText(
        R"({"tactspace": 1, "patterns": [{"name": "a", "amplitude_g": "loud"}]})");
    program.press('v', true);
    CHECK(size_of(program) == 3);
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.ui.status.text.find("amplitude_g") != std::string::npos);
}

TEST_CASE("copying: the matrix, and the table of candidates, go as CSV with all digits") {
    Program program(short_patterns(3));
    copy_shown_table(program.app);
    CHECK(program.app.ui.status.text.starts_with("Not copied: the map is not exact yet"));
    program.compute_map();
    copy_shown_table(program.app);
    const auto matrix = parse_matrix(clipboard(), "clipboard");
    REQUIRE(matrix);
    const LiveMap& map = *program.app.shown_map.transition.shown;
    CHECK(matrix->dissimilarity.condensed == map.prediction.pm.condensed);
    program.app.layout.bench = BenchTab::candidates;
    program.settle();
    copy_shown_table(program.app);
    const std::string table = clipboard();
    CHECK(table.starts_with("name,amplitude_g,carriers_hz,"));
    CHECK(std::ranges::count(table, '\n') == 4);
    CHECK(table.find("\np1,") != std::string::npos);
}

}  // namespace copying_test
