#include "app/report/html_map.h"

#include <variant>

#include "app/report/html.h"

namespace tact {

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
