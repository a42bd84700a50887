#include "viz/picture/apng.h"

#include <zlib.h>

#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "viz/picture/frame_damage.h"

namespace tact {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kFrameCountAt = 8 + 25 + 8;  // behind the signature, IHDR and acTL's head

void add_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xFFU);
    }
}

void add_u16(std::string& bytes, std::uint32_t value) {
    bytes += static_cast<char>(value >> 8 & 0xFFU);
    bytes += static_cast<char>(value & 0xFFU);
}

void add_chunk(std::string& bytes, std::string_view type, std::string_view data) {
    add_u32(bytes, static_cast<std::uint32_t>(data.size()));
    const std::size_t from = bytes.size();
    bytes += type;
    bytes += data;
    const auto* begin = reinterpret_cast<const Bytef*>(bytes.data() + from);
    add_u32(bytes,
            static_cast<std::uint32_t>(crc32(0, begin, static_cast<uInt>(bytes.size() - from))));
}

void begin_file(ApngWriter& writer, const Image& image) {
    std::string header;
    add_u32(header, static_cast<std::uint32_t>(image.width));
    add_u32(header, static_cast<std::uint32_t>(image.height));
    header += std::string_view("\x08\x06\x00\x00\x00", 5);  // 8 bits, RGBA
    std::string control;
    add_u32(control, 0);  // how many frames is written at the end
    add_u32(control, 0);  // goes round for ever
    writer.bytes = kSignature;
    add_chunk(writer.bytes, "IHDR", header);
    add_chunk(writer.bytes, "acTL", control);
}

std::string packed(const std::string& rows) {
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string out(size, '\0');
    const int done =
        compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                  reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()), 6);
    assert(done == Z_OK && "the bound is a bound");
    (void)done;
    out.resize(size);
    return out;
}

// Rows of the area; `before` given: what is as it was there stays transparent.
std::string rows_of(const Image& image, const ChangedArea& area, const Image* before) {
    std::string rows;
    rows.reserve(static_cast<std::size_t>(area.height) *
                 (1 + 4 * static_cast<std::size_t>(area.width)));
    for (int y = area.y; y < area.y + area.height; ++y) {
        rows += '\0';  // no filter
        for (int x = area.x; x < area.x + area.width; ++x) {
            if (before != nullptr && is_same_pixel(*before, image, x, y)) {
                rows.append(4, '\0');
            } else {
                rows.append(reinterpret_cast<const char*>(bytes_at(image, x, y)), 4);
            }
        }
    }
    return rows;
}

std::string frame_control(ApngWriter& writer, const ChangedArea& area, bool over) {
    std::string control;
    add_u32(control, writer.chunks++);
    add_u32(control, static_cast<std::uint32_t>(area.width));
    add_u32(control, static_cast<std::uint32_t>(area.height));
    add_u32(control, static_cast<std::uint32_t>(area.x));
    add_u32(control, static_cast<std::uint32_t>(area.y));
    add_u16(control, static_cast<std::uint32_t>(std::lround(1000.0 * writer.frame_s)));
    add_u16(control, 1000);
    control += '\0';                // stays when the next one comes
    control += over ? '\1' : '\0';  // over what is there, or in its place
    return control;
}

}  // namespace

void add_frame(ApngWriter& writer, const Image& image) {
    const bool first = writer.frames++ == 0;
    if (first) begin_file(writer, image);
    const ChangedArea area =
        first ? ChangedArea{0, 0, image.width, image.height} : changed_area(writer.before, image);
    const std::string control = frame_control(writer, area, !first);
    const std::string data = packed(rows_of(image, area, first ? nullptr : &writer.before));
    add_chunk(writer.bytes, "fcTL", control);
    if (first) {
        add_chunk(writer.bytes, "IDAT", data);
    } else {
        std::string numbered;
        add_u32(numbered, writer.chunks++);
        add_chunk(writer.bytes, "fdAT", numbered + data);
    }
    writer.before = image;
}

std::string finished(ApngWriter& writer) {
    assert(writer.frames > 0 && "a picture of nothing");
    std::string count;
    add_u32(count, writer.frames);
    add_u32(count, 0);
    std::string control;
    add_chunk(control, "acTL", count);
    writer.bytes.replace(kFrameCountAt - 8, control.size(), control);
    add_chunk(writer.bytes, "IEND", "");
    return std::exchange(writer, ApngWriter{}).bytes;
}

}  // namespace tact
