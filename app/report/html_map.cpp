#include "app/report/html_map.h"

#include <variant>

#include "app/report/html.h"

namespace tact {

namespace {

constexpr int kMapWidth = 760;
constexpr int kMapHeight = 480;

// As wide as there is room, instead of a size in pixels.
std::string map_svg(const HtmlMap& map, bool dark) {
    PictureSize size;
    size.width = kMapWidth;
    size.height = kMapHeight;
    size.dark = dark;
    size.format = PictureFormat::svg;
    size.titled = false;
    size.svg_ids = map.id + (dark ? "-dark-" : "-light-");
    const std::string svg =
        std::get<Svg>(space_picture(map.set, map.dissimilarity, map.space, size, map.marks)).text;
    const std::size_t view = svg.find(" viewBox");
    return "<svg role=\"img\" aria-label=\"" + html_escaped(map.alt) + "\"" + svg.substr(view);
}

}  // namespace

std::string html_of(const HtmlMap& map) {
    std::string html = "<figure id=\"" + html_escaped(map.id) + "\">\n";
    for (const bool dark : {false, true}) {
        html += std::string("<div class=\"") + (dark ? "dark" : "light") + "\">" +
                map_svg(map, dark) + "</div>\n";
    }
    if (!map.caption.empty()) html += "<figcaption>" + map.caption + "</figcaption>\n";
    return html + "</figure>\n";
}

}  // namespace tact
