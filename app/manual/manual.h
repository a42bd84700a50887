// The manual: chapters, and what the program knows itself; F1.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/common/expected.h"

namespace tact {

// What the window keeps of the manual.

// The page that is to be made, by this program.
struct ManualRequest {
    std::filesystem::path program;
    std::filesystem::path page;
};

struct ManualMade {
    std::filesystem::path page;
    std::string fault;  // empty: it is there
};

struct ManualState {
    std::filesystem::path program;  // itself; empty: nothing is started, as in tests
    Query<ManualRequest, ManualMade> job;
    std::shared_ptr<const ManualMade> shown;  // the last that was opened
    std::vector<int> openers;                 // processes that opened it, until they have ended
    std::string wanted_keys;                  // what the list of keys is searched for
    float keys_height_px = 0.0F;              // of the whole list, as it was drawn last
};

// The list of keys and of what the mouse does: groups in columns, and a search.

struct KeyRow {
    std::string group;  // "Edit", "Map"
    std::string keys;
    std::string what;  // of a command the way through the menus, which may begin with the group
};

inline constexpr Dialog kKeysDialog{.title = "Keys and mouse"};
void draw_keys_dialog(Ui& ui, ManualState& manual, std::span<const KeyRow> rows);

// The manual: one page that stands alone, of the chapters in assets/manual.
//
// Chapters hold the text. Whatever the program knows itself stands there as {{WORD REST}}:
// pictures, the model's numbers, tables, keys, options, files of every format. So none of it is
// typed twice, and none can grow old.
//
// Input     what only the window and the command line know: commands, keys, options, pictures
// Output    HTML (app/report/report.h); an Error where a chapter asks for what there is not
// Exact     same input, same bytes.

// A command of the window, as its menus have it.
struct ManualCommandRow {
    std::string menu;
    std::string name;
    std::string keys;  // empty: none
};

struct ManualKeyRow {
    std::string keys;
    std::string what;
};

// A command of the command line, as its --help has it.
struct ManualCommandHelp {
    std::string name;
    std::string summary;
    std::string text;  // with the usage and the options
};

// A picture on the grounds of both themes: SVG documents, the names in which begin with `ids`.
struct ManualPicture {
    std::string light;
    std::string dark;
};

struct ManualSource {
    std::vector<ManualCommandRow> commands{};
    std::vector<ManualKeyRow> keys{};
    std::vector<ManualCommandHelp> command_line{};
    std::function<Expected<ManualPicture>(const std::string& name)> picture{};
    std::string program{};  // "tactspace 0.1.0"
};

struct ManualChapter {
    const char* id;  // of its file, assets/manual/ID.html, too
    const char* heading;
};
std::span<const ManualChapter> manual_chapters();

Expected<std::string> manual_page(const ManualSource& source);

// Tables of what the program knows itself, for the manual.

// "stages", "stages_left_out", "metrics", "devices", "sets", "targets", "maps", "receptors",
// "pattern", "model", "study" or "textbook".
Expected<std::string> table_html(std::string_view name);

std::string keys_html(const ManualSource& source);
std::string menus_html(const ManualSource& source);

// Every command of the command line with its options; its section is called "command-NAME".
std::string commands_html(const ManualSource& source);

// The manual from within the window: the installed page, or one that is made in the background and
// kept, in the reader's browser.
//
// Source    XDG Base Directory Specification 0.8; xdg-open of xdg-utils
// Output    where the page is, in the status line, whether or not there is a browser
// Left out  what a browser says of it.

// Beside a program in bin/, as packages have it.
std::filesystem::path installed_manual(const std::filesystem::path& program);

// A page per version, in the cache folder; empty without a home.
std::filesystem::path kept_manual();

// Opens a page at once, or as soon as it is made.
void open_manual(Ui& ui, ManualState& manual);

// Once a frame: opens what was made.
void take_manual(Ui& ui, ManualState& manual);

}  // namespace tact
