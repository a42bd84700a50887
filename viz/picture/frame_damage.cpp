#include "viz/picture/frame_damage.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "viz/drawing/imgui_versions.h"

namespace tact {

namespace {

// A multiply-and-xor over words: equal bytes give equal values, unequal ones practically never.
std::uint64_t hashed(std::uint64_t seed, const void* bytes, std::size_t count) {
    constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15U;
    const auto* at = static_cast<const unsigned char*>(bytes);
    const auto mix = [&seed](std::uint64_t word) {
        seed = (seed ^ word) * kFactor;
        seed ^= seed >> 29U;
    };
    for (; count >= 8; count -= 8, at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, 8);
        mix(word);
    }
    std::uint64_t word = count;
    std::memcpy(&word, at, count);
    mix(word ^ static_cast<std::uint64_t>(count) << 56U);
    return seed;
}

Rect whole(ImVec2 size) { return {{0.0F, 0.0F}, size}; }

Rect common_part(const Rect& a, const Rect& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

Rect around_both(const Rect& a, const Rect& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

float surface(const Rect& r) { return r.empty() ? 0.0F : r.width() * r.height(); }

CommandPrint print_of(const ImDrawList& list, const ImDrawCmd& command) {
    const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
    const auto [least, most] = std::minmax_element(indices, indices + command.ElemCount);
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset + *least;
    const std::size_t count = static_cast<std::size_t>(*most - *least) + 1;
    CommandPrint print;
    print.area = {vertices->pos, vertices->pos};
    for (std::size_t k = 0; k < count; ++k) {
        print.area = around_both(print.area, {vertices[k].pos, vertices[k].pos});
    }
    print.area = common_part(inset(print.area, -1.0F), {{command.ClipRect.x, command.ClipRect.y},
                                                        {command.ClipRect.z, command.ClipRect.w}});
    print.hash = hashed(0, &command.ClipRect, sizeof command.ClipRect);
    print.hash = hashed(print.hash, vertices, count * sizeof(ImDrawVert));
    // Where a command's vertices lie in the buffer does not matter, only how they are joined.
    std::vector<ImDrawIdx> joined(indices, indices + command.ElemCount);
    for (ImDrawIdx& index : joined) index = static_cast<ImDrawIdx>(index - *least);
    print.hash = hashed(print.hash, joined.data(), joined.size() * sizeof(ImDrawIdx));
    return print;
}

// What is in one of them and not in the other, each as often as it occurs.
void add_difference(const std::vector<CommandPrint>& a, const std::vector<CommandPrint>& b,
                    std::vector<Rect>& marked) {
    std::unordered_map<std::uint64_t, int> count;
    for (const CommandPrint& print : a) ++count[print.hash];
    for (const CommandPrint& print : b) {
        if (count[print.hash]-- <= 0) marked.push_back(print.area);
    }
    for (const CommandPrint& print : a) {
        if (count[print.hash]-- > 0) marked.push_back(print.area);
    }
}

// Joins the two whose common frame adds least, until few are left and none are better joined.
void join(std::vector<Rect>& rects, std::size_t most) {
    constexpr float kWorthIt = 1.25F;  // a rectangle of its own costs a pass
    while (rects.size() > 1) {
        std::size_t best_a = 0;
        std::size_t best_b = 1;
        float least = INFINITY;
        float share = INFINITY;
        for (std::size_t a = 0; a < rects.size(); ++a) {
            for (std::size_t b = a + 1; b < rects.size(); ++b) {
                const float joint = surface(around_both(rects[a], rects[b]));
                const float apart = surface(rects[a]) + surface(rects[b]);
                if (joint - apart >= least) continue;
                least = joint - apart;
                share = joint / std::max(apart, 1.0F);
                best_a = a;
                best_b = b;
            }
        }
        if (rects.size() <= most && share > kWorthIt) return;
        rects[best_a] = around_both(rects[best_a], rects[best_b]);
        rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(best_b));
    }
}

}  // namespace

FramePrint print_of(const ImDrawData& frame, ImU32 background) {
    FramePrint print{frame.DisplaySize, background, {}, {}};
    for (int n = 0; n < frame.CmdListsCount; ++n) {
        const ImDrawList& list = *frame.CmdLists[n];
        print.windows.emplace_back(list._OwnerName == nullptr ? "" : list._OwnerName);
        print.commands.emplace_back();
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.ElemCount > 0) print.commands.back().push_back(print_of(list, command));
        }
    }
    return print;
}

std::vector<Rect> damage(const FramePrint& before, const FramePrint& now, std::size_t most) {
    const bool same_windows = before.size.x == now.size.x && before.size.y == now.size.y &&
                              before.background == now.background && before.windows == now.windows;
    if (!same_windows) return {whole(now.size)};
    std::vector<Rect> marked;
    for (std::size_t k = 0; k < now.windows.size(); ++k) {
        add_difference(before.commands[k], now.commands[k], marked);
    }
    for (Rect& rect : marked) {
        rect = common_part({{std::floor(rect.min.x), std::floor(rect.min.y)},
                            {std::ceil(rect.max.x), std::ceil(rect.max.y)}},
                           whole(now.size));
    }
    std::erase_if(marked, [](const Rect& rect) { return rect.empty(); });
    constexpr std::size_t kTooMany = 64;  // to look for the best pair among
    if (marked.size() > kTooMany) {
        Rect all = marked[0];
        for (const Rect& rect : marked) all = around_both(all, rect);
        return {all};
    }
    join(marked, most);
    return marked;
}

ClippedFrame::ClippedFrame(ImDrawData& frame, const Rect& rect) : clipped_(frame) {
    for (int n = 0; n < frame.CmdListsCount; ++n) {
        ImDrawList& list = *frame.CmdLists[n];
        bool draws = false;
        for (ImDrawCmd& command : list.CmdBuffer) {
            saved_.push_back({&command, command.ClipRect, command.ElemCount});
            const Rect clip = common_part({{command.ClipRect.x, command.ClipRect.y},
                                           {command.ClipRect.z, command.ClipRect.w}},
                                          rect);
            if (clip.empty()) command.ElemCount = 0;
            command.ClipRect = {clip.min.x, clip.min.y, clip.max.x, clip.max.y};
            draws = draws || command.ElemCount > 0;
        }
        if (draws) lists_.push_back(&list);
    }
    set_draw_lists(clipped_, lists_);
}

ClippedFrame::~ClippedFrame() {
    for (const Saved& saved : saved_) {
        saved.command->ClipRect = saved.clip;
        saved.command->ElemCount = saved.elements;
    }
}

const std::uint8_t* bytes_at(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(x);
    return image.rgba.data() + 4 * at;
}

bool is_same_pixel(const Image& a, const Image& b, int x, int y) {
    return std::memcmp(bytes_at(a, x, y), bytes_at(b, x, y), 4) == 0;
}

ChangedArea changed_area(const Image& before, const Image& after) {
    assert(before.width == after.width && before.height == after.height);
    int left = after.width;
    int right = -1;
    int top = after.height;
    int bottom = -1;
    for (int y = 0; y < after.height; ++y) {
        for (int x = 0; x < after.width; ++x) {
            if (is_same_pixel(before, after, x, y)) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    }
    if (right < 0) return {};
    return {left, top, right - left + 1, bottom - top + 1};
}

}  // namespace tact
