#include "app/ui/ui.h"

#include <doctest/doctest.h>
#include <imgui_internal.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "tests/support/headless_window.h"

namespace file_chooser_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// A folder of files, and the dialog in a window.
struct Fixture {
    fs::path folder;
    HeadlessWindow window;
    Ui ui;
    FileChooser& chooser = ui.chooser;
    std::optional<fs::path> chosen;
    int answers = 0;

    Fixture() {
        std::string name = (fs::temp_directory_path() / "chooser-test-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        folder = fs::canonical(name);
        fs::create_directories(folder / "inner");
        fs::create_directories(folder / "Alpha");
        fs::create_directories(folder / ".hidden folder");
        for (const char* file : {"b10.wav", "b2.wav", "B1.WAV", "notes.txt", ".hidden.wav",
                                 "inner/deep.wav", "set.tactspace.json", "other.json"}) {
            std::ofstream(folder / file) << file;
        }
        ui.theme = dark_theme(1.0F);
        chooser.extensions = {".wav", ".tactspace.json"};
    }
    ~Fixture() {
        std::error_code none;
        fs::permissions(folder / "inner", fs::perms::owner_all, none);
        fs::remove_all(folder, none);
    }
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

    void open(const std::string& name = "") {
        show(chooser, folder, name);
        settle();
    }
    void settle() {
        window.settle([this] {
            ui.rects = {};
            if (const auto path = draw_file_chooser(ui)) {
                chosen = path;
                ++answers;
            }
        });
    }
    void type(const std::string& text) {
        window.type(text);
        settle();
    }
    void press(int code) {
        window.press(code);
        settle();
    }
    void ctrl_press(int code) {
        push(window.input, {window.now_s, KeyChange{key::kLeftControl, true}});
        window.press(code);
        push(window.input, {window.now_s, KeyChange{key::kLeftControl, false}});
        settle();
    }
};

std::vector<std::string> names(const FolderListing& listing) {
    std::vector<std::string> result;
    for (const FolderEntry& entry : listing.entries) result.push_back(entry.name);
    return result;
}

}  // namespace

TEST_CASE("chooser: a folder lists folders first, then the wanted files, 2 before 10") {
    const Fixture f;
    const FolderListing listing = list_folder(f.folder, {".wav", ".tactspace.json"});
    CHECK(listing.fault.empty());
    CHECK(names(listing) == std::vector<std::string>{"Alpha", "inner", "B1.WAV", "b2.wav",
                                                     "b10.wav", "set.tactspace.json"});
    CHECK(listing.entries[0].is_folder);
    CHECK_FALSE(listing.entries[2].is_folder);
    CHECK(list_folder(f.folder, {}).entries.size() == 8);
}

TEST_CASE("chooser: a folder that cannot be read says why") {
    const Fixture f;
    const FolderListing listing = list_folder(f.folder / "nowhere", {});
    CHECK(listing.entries.empty());
    CHECK(listing.fault.find("nowhere") != std::string::npos);
    CHECK(listing.fault.find("No such file") != std::string::npos);
    fs::permissions(f.folder / "inner", fs::perms::none);
    if (geteuid() == 0) return;  // root may read everything
    CHECK(list_folder(f.folder / "inner", {}).fault.find("denied") != std::string::npos);
}

TEST_CASE("chooser: a typed name and Enter choose a file, once, and close the dialog") {
    Fixture f;
    f.open();
    f.type("b2.wav");
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "b2.wav");
    CHECK(f.answers == 1);
    CHECK_FALSE(f.chooser.is_open);
}

TEST_CASE("chooser: arrows walk through the folder, Enter goes in, Backspace goes out") {
    Fixture f;
    f.open();
    f.press(key::kDown);
    f.press(key::kDown);
    CHECK(f.chooser.name == "inner");
    f.press(key::kEnter);
    CHECK(f.chooser.listing.folder == f.folder / "inner");
    CHECK(f.chooser.name.empty());
    CHECK_FALSE(f.chosen.has_value());
    f.press(key::kBackspace);
    CHECK(f.chooser.listing.folder == f.folder);
    f.press(key::kUp);
    CHECK(f.chooser.name == "set.tactspace.json");
    f.press(key::kUp);
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "b10.wav");
}

TEST_CASE("chooser: Backspace in a name takes a character and stays in the folder") {
    Fixture f;
    f.open();
    f.type("ab");
    f.press(key::kBackspace);
    f.press(key::kBackspace);
    CHECK(f.chooser.name.empty());
    CHECK(f.chooser.listing.folder == f.folder);
}

TEST_CASE("chooser: paths may be typed whole, relative, with dots, or from home") {
    Fixture f;
    for (const std::string& typed :
         {(f.folder / "inner/deep.wav").string(), std::string("inner/deep.wav"),
          std::string("Alpha/../inner/./deep.wav")}) {
        f.chosen.reset();
        f.open();
        f.type(typed);
        f.press(key::kEnter);
        REQUIRE(f.chosen.has_value());
        CHECK(*f.chosen == f.folder / "inner/deep.wav");
    }
    const char* home = std::getenv("HOME");
    const std::string before = home == nullptr ? "" : home;
    setenv("HOME", f.folder.c_str(), 1);
    f.open();
    f.type("~/inner");
    f.press(key::kEnter);
    CHECK(f.chooser.listing.folder == f.folder / "inner");
    f.type("~");
    f.press(key::kEnter);
    CHECK(f.chooser.listing.folder == f.folder);
    if (home != nullptr) setenv("HOME", before.c_str(), 1);
}

TEST_CASE("chooser: a name that is not there is said and can be mended") {
    Fixture f;
    f.open();
    f.press(key::kEnter);
    CHECK(f.chooser.remark.find("Type a name") != std::string::npos);
    f.type("b3.wav");
    f.press(key::kEnter);
    CHECK(f.chooser.is_open);
    CHECK(f.chooser.remark.find("b3.wav") != std::string::npos);
    f.press(key::kEnd);
    for (int i = 0; i < 5; ++i) f.window.press(key::kBackspace);
    f.type("2.wav");
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "b2.wav");
}

TEST_CASE("chooser: with nothing named it says so, and a folder without such files names them") {
    Fixture f;
    f.chooser.extensions = {".csv", ".flac"};
    f.open();
    CHECK(lack_of_files(f.chooser) == "No .csv, .flac here.");
    CHECK_FALSE(std::string(lack_of_name(f.chooser)).empty());
    f.type("b2.wav");
    CHECK(std::string(lack_of_name(f.chooser)).empty());
    f.chooser.extensions = {".wav"};
    f.open();
    CHECK(lack_of_files(f.chooser).empty());
    f.chooser.use = ChooserUse::save_folder;  // the folder itself may be meant
    CHECK(std::string(lack_of_name(f.chooser)).empty());
}

TEST_CASE("chooser: Esc leaves without an answer") {
    Fixture f;
    f.open();
    f.type("b2.wav");
    f.press(key::kEscape);
    CHECK_FALSE(f.chooser.is_open);
    CHECK_FALSE(f.chosen.has_value());
}

TEST_CASE("chooser: a folder is an answer only where it may be one") {
    Fixture f;
    f.open();
    f.ctrl_press(key::kEnter);
    CHECK_FALSE(f.chosen.has_value());
    f.chooser.folders_too = true;
    f.open();
    f.ctrl_press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder);
}

TEST_CASE("chooser: saving adds the extension and keeps the name offered") {
    Fixture f;
    f.chooser.use = ChooserUse::save;
    f.chooser.extensions = {".tactspace.json"};
    f.open("mine");
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "mine.tactspace.json");
}

TEST_CASE("chooser: the name to save under survives a walk to another folder") {
    Fixture f;
    f.chooser.use = ChooserUse::save;
    f.chooser.extensions = {".wav"};
    f.open("mine.wav");
    f.press(key::kDown);
    f.press(key::kDown);
    CHECK(f.chooser.name == "inner");
    f.press(key::kEnter);
    CHECK(f.chooser.listing.folder == f.folder / "inner");
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "inner/mine.wav");
}

TEST_CASE("chooser: an existing file is replaced only after a yes") {
    Fixture f;
    f.chooser.use = ChooserUse::save;
    f.open("b2.wav");
    f.press(key::kEnter);
    CHECK_FALSE(f.chosen.has_value());
    CHECK(f.chooser.replacing == f.folder / "b2.wav");
    f.press(key::kEscape);
    CHECK(f.chooser.is_open);
    CHECK(f.chooser.replacing.empty());
    f.press(key::kEnter);
    f.press(key::kEnter);
    REQUIRE(f.chosen.has_value());
    CHECK(*f.chosen == f.folder / "b2.wav");
    CHECK(f.answers == 1);
}

TEST_CASE("chooser: saving into a folder that is not there is refused in words") {
    Fixture f;
    f.chooser.use = ChooserUse::save;
    f.open("nowhere/mine.wav");
    f.press(key::kEnter);
    CHECK_FALSE(f.chosen.has_value());
    CHECK(f.chooser.remark.find("no folder") != std::string::npos);
}

TEST_CASE("chooser: a double click on a row opens it") {
    Fixture f;
    f.open();
    const ImGuiWindow* list = nullptr;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (std::string(window->Name).find("##list") != std::string::npos) list = window;
    }
    REQUIRE(list != nullptr);
    // Below the names of the columns.
    const float row = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const ImVec2 second{list->InnerClipRect.Min.x + 30.0F, list->DC.CursorStartPos.y + 2.5F * row};
    f.window.click(second);
    f.settle();
    CHECK(f.chooser.name == "inner");
    f.window.click(second);
    f.window.click(second);
    f.settle();
    CHECK(f.chooser.listing.folder == f.folder / "inner");
}

TEST_CASE("chooser: a start in a folder that is gone is a start at home") {
    Fixture f;
    const char* home = std::getenv("HOME");
    const std::string before = home == nullptr ? "" : home;
    setenv("HOME", f.folder.c_str(), 1);
    show(f.chooser, f.folder / "gone");
    CHECK(f.chooser.listing.folder == f.folder);
    if (home != nullptr) setenv("HOME", before.c_str(), 1);
}

}  // namespace file_chooser_test
