#include "viz/picture/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "viz/picture/changed_area.h"
#include "viz/picture/palette.h"

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

}  // namespace tact
