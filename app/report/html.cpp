#include "app/report/report.h"

#include <cassert>
#include <variant>

#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/theme.h"

namespace tact {

namespace {

// Names of fonts, sizes and what is laid out: the colours come from the themes.
constexpr const char* kStyle = R"css(
*{box-sizing:border-box}
html{font:15px/1.5 Inter,system-ui,sans-serif;color:var(--text);background:var(--background);
  font-variant-numeric:tabular-nums;-webkit-text-size-adjust:100%;print-color-adjust:exact;
  -webkit-print-color-adjust:exact}
body{max-width:960px;margin:0 auto;padding:32px 24px 48px;overflow-wrap:anywhere}
h1{font-size:26px;line-height:1.2;margin:0 0 8px}
h2{font-size:18px;line-height:1.3;margin:0 0 12px}
h3{font-size:15px;margin:16px 0 4px}
p{margin:0 0 10px;max-width:44em}
section{background:var(--pane);border:1px solid var(--line);border-radius:8px;padding:20px;
  margin:16px 0}
section>:last-child{margin-bottom:0}
a{color:var(--accent)}
.dim,figcaption,footer{color:var(--dim-text)}
.lead{font-size:17px}
figure{margin:0 0 12px}
figure svg{display:block;width:100%;height:auto}
figcaption,footer{font-size:13px}
.frame{overflow-x:auto;margin:0 0 12px}
table{border-collapse:collapse;width:100%;font-size:13px}
th,td{text-align:left;padding:5px 10px 5px 0;border-bottom:1px solid var(--line);
  vertical-align:middle}
thead th{color:var(--dim-text);font-weight:600;vertical-align:bottom;line-height:1.25}
.number{text-align:right;white-space:nowrap}
.dark{display:none}
)css";

constexpr const char* kPrintStyle = R"css(
@page{size:A4;margin:14mm}
@media print{
html{font-size:9.5pt;background:none}
body{max-width:none;padding:0}
section{border:0;border-radius:0;padding:0;margin:0 0 8mm}
h2{break-after:avoid}
tr,figure{break-inside:avoid}
thead{display:table-header-group}
.frame{overflow:visible}
.screen{display:none!important}
}
)css";

std::string colours_of(const Theme& theme) {
    std::string css = std::string(":root{color-scheme:") + (theme.is_dark ? "dark" : "light");
    const auto add = [&](const char* name, ImU32 colour) {
        css += std::string(";--") + name + ":" + hex_text(colour);
    };
    add("background", theme.background);
    add("pane", theme.pane);
    add("field", theme.field);
    add("line", theme.line);
    add("text", theme.text);
    add("dim-text", theme.dim_text);
    add("accent", theme.accent);
    add("warning", theme.warning);
    add("error", theme.error);
    return css + "}\n";
}

// Paper is white, whatever the screen is.
std::string whole_style(const std::string& own) {
    return colours_of(light_theme(1.0F)) + kStyle + own +
           "@media screen and (prefers-color-scheme:dark){\n" + colours_of(dark_theme(1.0F)) +
           ".light{display:none}.dark{display:block}\n}\n" + kPrintStyle;
}

std::string cell_of(const char* element, const HtmlColumn& column, const std::string& html) {
    return std::string("<") + element + (column.is_number ? " class=\"number\">" : ">") + html +
           "</" + element + ">";
}

}  // namespace

std::string html_escaped(std::string_view text) {
    std::string html;
    for (const char c : shown_lines(text)) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            case '\'':
                html += "&#39;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string html_of(const HtmlTable& table) {
    std::string html = "<div class=\"frame\"><table" +
                       (table.kind.empty() ? "" : " class=\"" + html_escaped(table.kind) + "\"") +
                       ">\n<thead><tr>";
    for (const HtmlColumn& column : table.columns) {
        html += cell_of("th", column, html_escaped(column.heading));
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        assert(row.size() == table.columns.size() && "a cell for each column");
        html += "<tr>";
        for (std::size_t k = 0; k < row.size(); ++k) {
            html += cell_of("td", table.columns[k], row[k]);
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string html_of(const HtmlFigure& figure) {
    std::string html = "<figure id=\"" + html_escaped(figure.id) + "\">\n";
    const auto add = [&](const char* kind, const std::string& svg) {
        // Without its size in pixels.
        const std::size_t view = svg.find(" viewBox");
        assert(view != std::string::npos && "an SVG document with a view box");
        html += std::string("<div class=\"") + kind + "\"><svg role=\"img\" aria-label=\"" +
                html_escaped(figure.alt) + "\"" + svg.substr(view) + "</div>\n";
    };
    add("light", figure.light);
    add("dark", figure.dark);
    if (!figure.caption.empty()) html += "<figcaption>" + figure.caption + "</figcaption>\n";
    return html + "</figure>\n";
}

std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& html) {
    return "<section id=\"" + html_escaped(id) + "\">\n<h2>" + html_escaped(heading) + "</h2>\n" +
           html + "</section>\n";
}

std::string html_of(const HtmlPage& page) {
    // What comes with the page may be shown and heard; nothing may be fetched, and nothing runs.
    const std::string policy =
        "default-src 'none'; style-src 'unsafe-inline'; img-src data:; media-src data:";
    std::string html = "<!DOCTYPE html>\n<html lang=\"" + html_escaped(page.language) +
                       "\">\n<head>\n<meta charset=\"utf-8\">\n";
    html += "<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\">\n";
    html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    html += "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
            html_escaped(page.title) + "</title>\n";
    html += "<style>" + whole_style(page.style) + "</style>\n</head>\n<body>\n<header>\n<h1>" +
            html_escaped(page.title) + "</h1>\n";
    if (!page.lead.empty()) html += "<p class=\"lead\">" + page.lead + "</p>\n";
    html += "</header>\n<main>\n" + page.body + "</main>\n";
    if (!page.foot.empty()) html += "<footer>\n" + page.foot + "</footer>\n";
    return html + "</body>\n</html>\n";
}

namespace {

constexpr int kMapWidth = 760;
constexpr int kMapHeight = 480;

std::string map_svg(const HtmlMap& map, bool dark) {
    PictureSize size;
    size.width = kMapWidth;
    size.height = kMapHeight;
    size.dark = dark;
    size.format = PictureFormat::svg;
    size.titled = false;
    size.svg_ids = map.id + (dark ? "-dark-" : "-light-");
    return std::get<Svg>(space_picture(map.set, map.dissimilarity, map.space, size, map.marks))
        .text;
}

}  // namespace

std::string html_of(const HtmlMap& map) {
    return html_of(HtmlFigure{.id = map.id,
                              .alt = map.alt,
                              .caption = map.caption,
                              .light = map_svg(map, false),
                              .dark = map_svg(map, true)});
}

}  // namespace tact
