// The manual: one page that stands alone, of the chapters in assets/manual.
//
// Chapters hold the text. Whatever the program knows itself stands there as {{WORD REST}}:
// pictures, the model's numbers, tables, keys, options, files of every format. So none of it is
// typed twice, and none can grow old.
//
// Input     what only the window and the command line know: commands, keys, options, pictures
// Output    HTML (app/report/html.h); an Error where a chapter asks for what there is not
// Exact     same input, same bytes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

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

}  // namespace tact
