// Pages that stand alone: one HTML file that needs nothing beside it and asks nothing of a network.
//
// Source    HTML, the living standard; Content Security Policy 3
// Input     text, escaped here; what is called html is taken as it is
// Output    UTF-8; light or dark as the reader's system is, light on paper, A4 upright
// Left out  scripts.
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tact {

// As text or as the value of an attribute. What is not UTF-8 becomes
// U+FFFD, a character that steers the page its number (model/text/shown_text.h).
std::string html_escaped(std::string_view text);

struct HtmlColumn {
    std::string heading;     // text
    bool is_number = false;  // set to the right
};

struct HtmlTable {
    std::vector<HtmlColumn> columns;
    std::vector<std::vector<std::string>> rows;  // html; one cell a column
    std::string kind{};                          // a class of the page's styles, or empty
};

// In a frame of its own, which scrolls where the table is wider than the page.
std::string html_of(const HtmlTable& table);

// Drawings of one thing on the grounds of both themes, as wide as there is room.
struct HtmlFigure {
    std::string id{};
    std::string alt{};      // text: what is seen, for who does not see it
    std::string caption{};  // html
    std::string light{};    // SVG documents, which share no names
    std::string dark{};
};
std::string html_of(const HtmlFigure& figure);

// A part of a page under a heading; `id` is what links lead to.
std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& html);

struct HtmlPage {
    std::string title;    // text: of the window, and above the page
    std::string lead{};   // html: under the title, what the page is about
    std::string body{};   // html
    std::string foot{};   // html: what made the page
    std::string style{};  // CSS beside the frame's own
    std::string language = "en";
};

// The colours of the program's two themes are variables: --background, --pane, --field, --line,
// --text, --dim-text, --accent, --warning, --error. Elements of class "light" and "dark" are there
// in one of the two alone, "screen" not on paper.
std::string html_of(const HtmlPage& page);

}  // namespace tact
