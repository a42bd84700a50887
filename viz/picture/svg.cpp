#include "viz/picture/svg.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "model/text/atomic_file.h"
#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"
#include "viz/picture/frame_shapes.h"

namespace tact {
namespace {

// This many rectangles in a row that abut or lie on whole pixels are the cells of a map: their
// shared edges must not be smoothed, or the ground shines through.
constexpr std::size_t kCells = 16;
constexpr std::size_t kManyCells = 2000;

struct Writer {
    const Fonts& fonts;
    const std::string& ids;
    std::string definitions{};
    std::string body{};
    std::map<std::tuple<float, float, float, float>, int> clips{};
    int gradients = 0;
};

// At most two decimals, none that say nothing; the same in every locale.
std::string number(float value) {
    std::array<char, 64> digits{};
    const float bounded = std::isfinite(value) ? std::clamp(value, -1e7F, 1e7F) : 0.0F;
    const auto [end, fault] =
        std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<double>(bounded),
                      std::chars_format::fixed, 2);
    std::string text(digits.data(), fault == std::errc{} ? end : digits.data());
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string{" "} + name + "=\"" + value + "\"";
}

std::string attribute(const char* name, float value) { return attribute(name, number(value)); }

unsigned component(ImU32 colour, unsigned shift) { return (colour >> shift) & 0xFFU; }

// "fill", "stroke" or "stop": the colour, and its opacity where it is not opaque.
std::string paint(const std::string& what, ImU32 colour) {
    const std::string name = what == "stop" ? "stop-color" : what;
    std::string text = attribute(name.c_str(), hex_text(colour));
    const unsigned alpha = component(colour, IM_COL32_A_SHIFT);
    if (alpha == 255) return text;
    return text + attribute((what + "-opacity").c_str(), static_cast<float>(alpha) / 255.0F);
}

std::string box(const Rect& r) {
    return attribute("x", r.min.x) + attribute("y", r.min.y) + attribute("width", r.width()) +
           attribute("height", r.height());
}

std::string clip_of(Writer& writer, const std::optional<Rect>& clip) {
    if (!clip) return {};
    const std::tuple key{clip->min.x, clip->min.y, clip->max.x, clip->max.y};
    const auto [at, is_new] = writer.clips.insert({key, static_cast<int>(writer.clips.size()) + 1});
    const std::string id = writer.ids + "clip" + std::to_string(at->second);
    if (is_new) {
        writer.definitions +=
            "<clipPath" + attribute("id", id) + "><rect" + box(*clip) + "/></clipPath>\n";
    }
    return attribute("clip-path", "url(#" + id + ")");
}

std::string path_of(const std::vector<ImVec2>& points, bool closed) {
    std::string path;
    std::string before;
    for (const ImVec2 p : points) {
        std::string at = number(p.x) + " " + number(p.y);
        if (at == before) continue;  // they differ by less than is written
        path += (path.empty() ? "M" : "L") + at;
        before = std::move(at);
    }
    return path + (closed ? "Z" : "");
}

std::string escaped(const std::vector<ImWchar>& characters) {
    std::string text;
    for (const ImWchar c : characters) {
        std::array<char, 5> bytes{};
        if (is_steering(c)) {
            text += number_of_character(c);
            continue;
        }
        switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '>':
                text += "&gt;";
                break;
            default:
                text += ImTextCharToUtf8(bytes.data(), c);
        }
    }
    return text;
}

void write(Writer& writer, const Shape& shape, const Rect& rect) {
    writer.body += "<rect" + box(rect) + paint("fill", shape.colour) + "/>\n";
}

void write(Writer& writer, const Shape& shape, const Polygons& polygons) {
    std::string path;
    for (const auto& outline : polygons.outlines) path += path_of(outline, true);
    writer.body += "<path" + attribute("d", path) + paint("fill", shape.colour) +
                   clip_of(writer, shape.clip) + "/>\n";
}

void write(Writer& writer, const Shape& shape, const Polylines& polylines) {
    std::string path;
    for (const Polyline& line : polylines.lines) path += path_of(line.points, line.closed);
    writer.body += "<path" + attribute("d", path) + attribute("fill", "none") +
                   paint("stroke", shape.colour) + attribute("stroke-width", polylines.width_px) +
                   clip_of(writer, shape.clip) + "/>\n";
}

void write(Writer& writer, const Shape& shape, const Circle& circle) {
    writer.body += "<circle" + attribute("cx", circle.centre.x) + attribute("cy", circle.centre.y) +
                   attribute("r", circle.radius_px) + paint("fill", shape.colour) +
                   clip_of(writer, shape.clip) + "/>\n";
}

void write(Writer& writer, const Shape& shape, const GradientPolygon& polygon) {
    const std::string id = writer.ids + "gradient" + std::to_string(++writer.gradients);
    writer.definitions +=
        "<linearGradient" + attribute("id", id) + attribute("gradientUnits", "userSpaceOnUse") +
        attribute("x1", polygon.from.x) + attribute("y1", polygon.from.y) +
        attribute("x2", polygon.to.x) + attribute("y2", polygon.to.y) + "><stop offset=\"0\"" +
        paint("stop", shape.colour) + "/><stop offset=\"1\"" + paint("stop", polygon.to_colour) +
        "/></linearGradient>\n";
    writer.body += "<path" + attribute("d", path_of(polygon.outline, true)) +
                   attribute("fill", "url(#" + id + ")") + clip_of(writer, shape.clip) + "/>\n";
}

void write(Writer& writer, const Shape& shape, const TextRun& run) {
    std::string places;
    for (const float along : run.along_px) places += (places.empty() ? "" : " ") + number(along);
    const bool bold = run.font == writer.fonts.semibold || run.font == writer.fonts.large ||
                      run.font == writer.fonts.headline;
    const float degrees = std::atan2(run.direction.y, run.direction.x) * 57.295780F;
    // A clip rectangle is level, so it goes around what is turned.
    const std::string clip = clip_of(writer, shape.clip);
    if (!clip.empty()) writer.body += "<g" + clip + ">";
    writer.body += "<text" + attribute("x", places) + attribute("y", run.across_px) +
                   attribute("font-size", run.size_px * writer.fonts.em) +
                   (bold ? attribute("font-weight", "600") : "") + paint("fill", shape.colour);
    if (number(degrees) != "0") {
        writer.body += attribute("transform", "rotate(" + number(degrees) + ")");
    }
    if (run.halo_px > 0.0F) {
        writer.body += paint("stroke", run.halo) + attribute("stroke-width", 2.0F * run.halo_px) +
                       attribute("paint-order", "stroke");
    }
    writer.body += ">" + escaped(run.characters) + "</text>";
    writer.body += clip.empty() ? "\n" : "</g>\n";
}

bool on_whole_pixels(const Shape& shape) {
    const auto* rect = std::get_if<Rect>(&shape.form);
    if (rect == nullptr) return false;
    for (const float edge : {rect->min.x, rect->min.y, rect->max.x, rect->max.y}) {
        if (edge != std::round(edge)) return false;
    }
    return true;
}

// Two rectangles with a side in common.
bool abut(const Shape& a, const Shape& b) {
    const auto* r = std::get_if<Rect>(&a.form);
    const auto* s = std::get_if<Rect>(&b.form);
    if (r == nullptr || s == nullptr) return false;
    const bool stacked = r->min.x == s->min.x && r->max.x == s->max.x;
    const bool abreast = r->min.y == s->min.y && r->max.y == s->max.y;
    return (stacked && (r->min.y == s->max.y || r->max.y == s->min.y)) ||
           (abreast && (r->min.x == s->max.x || r->max.x == s->min.x));
}

// How many shapes from here on are cells of a map.
std::size_t cells_from(std::span<const Shape> shapes) {
    std::size_t end = 0;
    const auto is_cell = [&](std::size_t i) {
        return on_whole_pixels(shapes[i]) || (i > 0 && abut(shapes[i - 1], shapes[i])) ||
               (i + 1 < shapes.size() && abut(shapes[i], shapes[i + 1]));
    };
    while (end < shapes.size() && is_cell(end)) ++end;
    return end;
}

// How many of the first cells are on whole pixels and share none of them: their order is free.
std::size_t disjoint_from(std::span<const Shape> cells, ImVec2 size) {
    const auto width = static_cast<std::size_t>(size.x) + 1;
    std::vector<bool> taken(width * (static_cast<std::size_t>(size.y) + 1), false);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!on_whole_pixels(cells[i])) return i;
        const Rect& r = std::get<Rect>(cells[i].form);
        const auto right = static_cast<std::size_t>(r.max.x);
        const auto bottom = static_cast<std::size_t>(r.max.y);
        for (auto y = static_cast<std::size_t>(r.min.y); y < bottom; ++y) {
            for (auto x = static_cast<std::size_t>(r.min.x); x < right; ++x) {
                if (taken[y * width + x]) return i;
                taken[y * width + x] = true;
            }
        }
    }
    return cells.size();
}

// One path a colour: a quarter of the bytes.
void write_by_colour(Writer& writer, std::span<const Shape> cells) {
    std::map<ImU32, std::string> paths;
    for (const Shape& cell : cells) {
        const Rect& r = std::get<Rect>(cell.form);
        const std::string width = number(r.width());
        paths[cell.colour] += "M" + number(r.min.x) + " " + number(r.min.y) + "h" + width + "v" +
                              number(r.height()) + "h-" + width + "z";
    }
    for (const auto& [colour, path] : paths) {
        writer.body += "<path" + attribute("d", path) + paint("fill", colour) + "/>\n";
    }
}

void write_each(Writer& writer, std::span<const Shape> shapes) {
    for (const Shape& shape : shapes) {
        std::visit([&](const auto& form) { write(writer, shape, form); }, shape.form);
    }
}

void write_cells(Writer& writer, std::span<const Shape> cells, ImVec2 size) {
    writer.body += "<g shape-rendering=\"crispEdges\">\n";
    while (!cells.empty()) {
        const std::size_t free = cells.size() < kManyCells ? 0 : disjoint_from(cells, size);
        if (free >= kManyCells) {
            write_by_colour(writer, cells.first(free));
            cells = cells.subspan(free);
        } else {
            const std::size_t count =
                cells.size() < kManyCells ? cells.size() : std::max<std::size_t>(free, 1);
            write_each(writer, cells.first(count));
            cells = cells.subspan(count);
        }
    }
    writer.body += "</g>\n";
}

void write_all(Writer& writer, std::span<const Shape> shapes, ImVec2 size) {
    while (!shapes.empty()) {
        const std::size_t cells = cells_from(shapes);
        const std::size_t count = std::max<std::size_t>(cells, 1);
        if (cells >= kCells) {
            write_cells(writer, shapes.first(count), size);
        } else {
            write_each(writer, shapes.first(count));
        }
        shapes = shapes.subspan(count);
    }
}

}  // namespace

std::string svg_text(const ImDrawData& frame, const Fonts& fonts, ImU32 ground,
                     const std::string& ids) {
    Writer writer{fonts, ids};
    const Rect whole = rect_at({0, 0}, frame.DisplaySize);
    write_all(writer, shapes_of(frame, fonts), frame.DisplaySize);
    std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", whole.width()) +
        attribute("height", whole.height()) +
        attribute("viewBox", "0 0 " + number(whole.width()) + " " + number(whole.height())) +
        attribute("font-family", "Inter, sans-serif") +
        attribute("style", "font-variant-numeric:tabular-nums") +
        attribute("stroke-linejoin", "round") + attribute("xml:space", "preserve") + ">\n";
    if (!writer.definitions.empty()) text += "<defs>\n" + writer.definitions + "</defs>\n";
    text += "<rect" + box(whole) + paint("fill", ground) + "/>\n";
    return text + writer.body + "</svg>\n";
}

Expected<Done> write_svg(const std::string& path, const std::string& text) {
    return write_atomically(path, text);
}

}  // namespace tact
