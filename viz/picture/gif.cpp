#include "viz/picture/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "viz/picture/frame_damage.h"

namespace tact {

namespace {

constexpr std::size_t kMostColours = 255;  // and a transparent one
constexpr int kTransparent = 255;
constexpr int kBits = 8;

int append_bytes(GifFileType* file, const GifByteType* bytes, int count) {
    static_cast<std::string*>(file->UserData)
        ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
}

Error gif_error(int code) {
    const char* words = GifErrorString(code);
    return Error{std::string("the picture could not be encoded as GIF: ") +
                 (words == nullptr ? "no reason given" : words)};
}

Expected<Done> begin_gif(GifWriter& writer, const Image& image) {
    int code = 0;
    writer.file = EGifOpen(&writer.bytes, append_bytes, &code);
    if (writer.file == nullptr) return gif_error(code);
    EGifSetGifVersion(writer.file, true);
    bool good =
        EGifPutScreenDesc(writer.file, image.width, image.height, kBits, 0, nullptr) == GIF_OK;
    // Goes round for ever.
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    good = good && EGifPutExtensionLeader(writer.file, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(writer.file, 11, "NETSCAPE2.0") == GIF_OK &&
           EGifPutExtensionBlock(writer.file, 3, kForEver.data()) == GIF_OK &&
           EGifPutExtensionTrailer(writer.file) == GIF_OK;
    if (!good) return gif_error(writer.file->Error);
    return Done{};
}

Rgb colour_at(const Image& image, int x, int y) {
    const std::uint8_t* p = bytes_at(image, x, y);
    return {p[0], p[1], p[2]};
}

bool is_new(const GifWriter& writer, const Image& image, int x, int y) {
    return writer.frames == 0 || !is_same_pixel(writer.before, image, x, y);
}

Palette palette_of_changes(const GifWriter& writer, const Image& image, const ChangedArea& area) {
    std::vector<Rgb> pixels;
    for (int y = area.y; y < area.y + area.height; ++y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            if (is_new(writer, image, x, y)) pixels.push_back(colour_at(image, x, y));
        }
    }
    return palette_of(pixels, kMostColours);
}

// How long it stays, that it is left there, and which colour is transparent.
bool put_control(const GifWriter& writer) {
    const GraphicsControlBlock control{
        DISPOSE_DO_NOT, false, static_cast<int>(std::lround(100.0 * writer.frame_s)), kTransparent};
    std::array<GifByteType, 4> block{};
    EGifGCBToExtension(&control, block.data());
    return EGifPutExtension(writer.file, GRAPHICS_EXT_FUNC_CODE, 4, block.data()) == GIF_OK;
}

bool put_area(const GifWriter& writer, const Palette& palette, const ChangedArea& area) {
    std::array<GifColorType, 256> colours{};
    for (std::size_t k = 0; k < palette.colours.size(); ++k) {
        const Rgb& c = palette.colours[k];
        colours[k] = {c.r, c.g, c.b};
    }
    ColorMapObject* map = GifMakeMapObject(256, colours.data());
    if (map == nullptr) return false;
    const int done =
        EGifPutImageDesc(writer.file, area.x, area.y, area.width, area.height, false, map);
    GifFreeMapObject(map);
    return done == GIF_OK;
}

bool put_rows(const GifWriter& writer, const Image& image, Palette& palette,
              const ChangedArea& area) {
    std::vector<GifPixelType> row(static_cast<std::size_t>(area.width));
    for (int y = area.y; y < area.y + area.height; ++y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            row[static_cast<std::size_t>(x - area.x)] =
                is_new(writer, image, x, y) ? nearest_colour(palette, colour_at(image, x, y))
                                            : static_cast<GifPixelType>(kTransparent);
        }
        if (EGifPutLine(writer.file, row.data(), area.width) != GIF_OK) return false;
    }
    return true;
}

}  // namespace

GifWriter::~GifWriter() {
    int ignored = 0;
    if (file != nullptr) EGifCloseFile(file, &ignored);
}

Expected<Done> add_frame(GifWriter& writer, const Image& image) {
    if (writer.frames == 0) {
        if (const Expected<Done> begun = begin_gif(writer, image); !begun) return begun;
    }
    const ChangedArea area = writer.frames == 0 ? ChangedArea{0, 0, image.width, image.height}
                                                : changed_area(writer.before, image);
    Palette palette = palette_of_changes(writer, image, area);
    if (!put_control(writer) || !put_area(writer, palette, area) ||
        !put_rows(writer, image, palette, area)) {
        return gif_error(writer.file->Error);
    }
    writer.before = image;
    ++writer.frames;
    return Done{};
}

Expected<std::string> finished(GifWriter& writer) {
    int code = 0;
    if (EGifCloseFile(std::exchange(writer.file, nullptr), &code) != GIF_OK) return gif_error(code);
    return std::exchange(writer.bytes, {});
}

namespace {

struct Counted {
    std::array<int, 3> rgb{};
    std::int64_t count = 0;
};

// A run of `all`.
struct Box {
    std::size_t from = 0;
    std::size_t to = 0;
    int axis = 0;
    std::int64_t weight = 0;  // extent along the axis, by how many pixels are in it
};

std::uint32_t key_of(Rgb c) {
    return static_cast<std::uint32_t>(c.r) << 16 | static_cast<std::uint32_t>(c.g) << 8 | c.b;
}

Box box_of(const std::vector<Counted>& all, std::size_t from, std::size_t to) {
    Box box{from, to, 0, 0};
    std::int64_t pixels = 0;
    for (std::size_t k = from; k < to; ++k) pixels += all[k].count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        int low = 255;
        int high = 0;
        for (std::size_t k = from; k < to; ++k) {
            low = std::min(low, all[k].rgb[axis]);
            high = std::max(high, all[k].rgb[axis]);
        }
        // Colours of few pixels count, too: thin lines and text are few.
        const std::int64_t weight = static_cast<std::int64_t>(high - low) * (1 + pixels / 64);
        if (weight <= box.weight) continue;
        box.weight = weight;
        box.axis = static_cast<int>(axis);
    }
    return box;
}

// Where half of the pixels lie on either side, and a colour at least.
std::size_t middle_of(const std::vector<Counted>& all, const Box& box) {
    std::int64_t pixels = 0;
    for (std::size_t k = box.from; k < box.to; ++k) pixels += all[k].count;
    std::int64_t below = 0;
    std::size_t at = box.from;
    while (at + 1 < box.to && 2 * below < pixels) below += all[at++].count;
    return std::max(at, box.from + 1);
}

Rgb mean_of(const std::vector<Counted>& all, const Box& box) {
    std::array<std::int64_t, 3> sum{};
    std::int64_t pixels = 0;
    for (std::size_t k = box.from; k < box.to; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += all[k].rgb[axis] * all[k].count;
        pixels += all[k].count;
    }
    const auto part = [&](std::size_t axis) {
        return static_cast<std::uint8_t>((sum[axis] + pixels / 2) / pixels);
    };
    return {part(0), part(1), part(2)};
}

void split_largest(std::vector<Counted>& all, std::vector<Box>& boxes) {
    const auto largest = std::ranges::max_element(boxes, {}, &Box::weight);
    const Box box = *largest;
    const auto axis = static_cast<std::size_t>(box.axis);
    std::stable_sort(
        all.begin() + static_cast<std::ptrdiff_t>(box.from),
        all.begin() + static_cast<std::ptrdiff_t>(box.to),
        [axis](const Counted& a, const Counted& b) { return a.rgb[axis] < b.rgb[axis]; });
    const std::size_t middle = middle_of(all, box);
    *largest = box_of(all, box.from, middle);
    boxes.push_back(box_of(all, middle, box.to));
}

}  // namespace

Palette palette_of(const std::vector<Rgb>& pixels, std::size_t most) {
    assert(most > 0 && most <= 256);
    std::map<std::uint32_t, Counted> counts;
    for (const Rgb& c : pixels) {
        Counted& counted = counts[key_of(c)];
        counted.rgb = {c.r, c.g, c.b};
        ++counted.count;
    }
    std::vector<Counted> all;
    for (const auto& [key, counted] : counts) all.push_back(counted);
    std::vector<Box> boxes;
    if (all.size() <= most) {
        for (std::size_t k = 0; k < all.size(); ++k) boxes.push_back({k, k + 1, 0, 0});
    } else {
        boxes.push_back(box_of(all, 0, all.size()));
        while (boxes.size() < most) split_largest(all, boxes);
    }
    Palette palette;
    for (const Box& box : boxes) palette.colours.push_back(mean_of(all, box));
    if (palette.colours.empty()) palette.colours.push_back({});
    return palette;
}

std::uint8_t nearest_colour(Palette& palette, Rgb colour) {
    const auto known = palette.known.find(key_of(colour));
    if (known != palette.known.end()) return known->second;
    std::size_t best = 0;
    int least = 1 << 30;
    for (std::size_t k = 0; k < palette.colours.size(); ++k) {
        const Rgb& c = palette.colours[k];
        const int r = c.r - colour.r;
        const int g = c.g - colour.g;
        const int b = c.b - colour.b;
        const int away = r * r + g * g + b * b;
        if (away >= least) continue;
        least = away;
        best = k;
    }
    const auto index = static_cast<std::uint8_t>(best);
    palette.known[key_of(colour)] = index;
    return index;
}

}  // namespace tact
