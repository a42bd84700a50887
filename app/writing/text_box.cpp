#include "app/writing/writing.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tact {

namespace {

WrappedText wrapped_at(std::string_view text, float width_px) {
    const ImFont& font = *ImGui::GetFont();
    const float scale = ImGui::GetFontSize() / font.FontSize;
    return wrapped(text, [&](std::string_view line) {
        const char* end = line.data() + line.size();
        const char* broken = font.CalcWordWrapPositionA(scale, line.data(), end, width_px);
        return static_cast<std::size_t>(broken - line.data());
    });
}

int lines_of(const WrappedText& wrapped) {
    return 1 + static_cast<int>(std::ranges::count(wrapped.shown, '\n'));
}

// What a frame knows of the box that is written in.
struct Writing {
    TextBox& box;
    float width_px;
    std::string& text;
    bool changed = false;
};

std::size_t at(int place) { return static_cast<std::size_t>(std::max(0, place)); }

// Where the part ends that is not as it was.
std::size_t end_of_change(std::string_view was, std::string_view now) {
    std::size_t foot = 0;
    const std::size_t least = std::min(was.size(), now.size());
    while (foot < least && was[was.size() - 1 - foot] == now[now.size() - 1 - foot]) ++foot;
    std::size_t end = now.size() - foot;
    while (end < now.size() && (static_cast<unsigned char>(now[end]) & 0xC0U) == 0x80U) ++end;
    return end;
}

// ImGui's buffer has what is shown. An edit of it is one of the text; then it is broken again.
int follow_writing(ImGuiInputTextCallbackData* data) {
    auto& writing = *static_cast<Writing*>(data->UserData);
    TextBox& box = writing.box;
    const std::string_view now(data->Buf, at(data->BufTextLen));
    std::size_t cursor = place_in_text(box.wrapped, std::min(at(data->CursorPos), now.size()));
    std::size_t select_a = cursor;
    std::size_t select_b = cursor;
    if (now != box.wrapped.shown) {
        const bool has_selection = box.select_b > box.select_a;
        const std::size_t first = has_selection ? box.select_a : box.cursor;
        EditedText after = edited(box.wrapped, now, {first, box.cursor}, at(data->CursorPos));
        cursor = select_a = select_b = after.cursor;
        const bool is_elsewhere = place_in_text(box.wrapped, box.cursor) != box.edited_at;
        box.begins_word = after.begins_word || is_elsewhere;
        box.edited_at = after.cursor;
        writing.changed = after.text != writing.text;
        writing.text = std::move(after.text);
    } else {
        select_a = place_in_text(box.wrapped, at(data->SelectionStart));
        select_b = place_in_text(box.wrapped, at(data->SelectionEnd));
        const std::string own = text_of(box.wrapped);
        if (own != writing.text) {  // changed from outside: undone
            cursor = select_a = select_b = end_of_change(own, writing.text);
        }
    }
    box.wrapped = wrapped_at(writing.text, writing.width_px);
    if (box.wrapped.shown != std::string_view(data->Buf, at(data->BufTextLen))) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, box.wrapped.shown.c_str());
        data->CursorPos = static_cast<int>(place_shown(box.wrapped, cursor));
        data->SelectionStart = static_cast<int>(place_shown(box.wrapped, select_a));
        data->SelectionEnd = static_cast<int>(place_shown(box.wrapped, select_b));
    }
    box.cursor = at(data->CursorPos);
    box.select_a = at(std::min(data->SelectionStart, data->SelectionEnd));
    box.select_b = at(std::max(data->SelectionStart, data->SelectionEnd));
    return 0;
}

}  // namespace

bool draw_text_box(TextBox& box, const char* id, int least, int most, std::string& text) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inner_px = ImGui::GetContentRegionAvail().x - 2.0F * style.FramePadding.x - 1.0F;
    float width_px = inner_px;
    WrappedText shown = wrapped_at(text, width_px);
    if (lines_of(shown) > most) {
        width_px -= style.ScrollbarSize;
        shown = wrapped_at(text, width_px);
    }
    const int lines = std::clamp(lines_of(shown), least, most);
    const float height_px =
        static_cast<float>(lines) * ImGui::GetTextLineHeight() + 2.0F * style.FramePadding.y + 1.0F;
    const ImGuiID own = ImGui::GetID(id);
    const bool was_written = box.id == own;
    const TextBox before = was_written ? box : TextBox{own, shown};
    TextBox now = before;
    Writing writing{now, width_px, text};
    std::string buffer = shown.shown;
    ImGui::InputTextMultiline(id, &buffer, {-1.0F, height_px},
                              ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_NoUndoRedo,
                              follow_writing, &writing);
    if (ImGui::IsItemActive()) {
        box = now;
    } else if (was_written) {
        box = {};
    }
    // A copy is of the text: ImGui took what is shown.
    const ImGuiIO& io = ImGui::GetIO();
    const bool copies = was_written && io.KeyCtrl && before.select_b > before.select_a &&
                        (ImGui::IsKeyPressed(ImGuiKey_C) || ImGui::IsKeyPressed(ImGuiKey_X));
    if (copies) {
        const std::string copy = text_between(before.wrapped, before.select_a, before.select_b);
        ImGui::SetClipboardText(copy.c_str());
    }
    return writing.changed;
}

namespace {

bool is_inside_character(std::string_view text, std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
}

std::size_t after_character(std::string_view text, std::size_t at) {
    do {
        ++at;
    } while (is_inside_character(text, at));
    return std::min(at, text.size());
}

std::size_t before_character(std::string_view text, std::size_t at) {
    do {
        --at;
    } while (at > 0 && is_inside_character(text, at));
    return at;
}

bool is_break(const WrappedText& wrapped, std::size_t at) {
    return std::ranges::binary_search(wrapped.breaks, at);
}

// Breaks before a place.
std::size_t breaks_before(const WrappedText& wrapped, std::size_t at) {
    return static_cast<std::size_t>(std::ranges::lower_bound(wrapped.breaks, at) -
                                    wrapped.breaks.begin());
}

void add_line(std::string_view line, const LineRoom& room, WrappedText& result) {
    for (;;) {
        std::size_t end = room(line);
        if (end >= line.size()) break;
        end = std::max(end, after_character(line, 0));
        while (is_inside_character(line, end)) ++end;
        while (end < line.size() && line[end] == ' ') ++end;  // spaces stay before the break
        if (end >= line.size()) break;
        result.shown += line.substr(0, end);
        result.breaks.push_back(result.shown.size());
        result.shown += '\n';
        line.remove_prefix(end);
    }
    result.shown += line;
}

}  // namespace

WrappedText wrapped(std::string_view text, const LineRoom& room) {
    WrappedText result;
    for (;;) {
        const std::size_t feed = text.find('\n');
        add_line(text.substr(0, feed), room, result);
        if (feed == std::string_view::npos) return result;
        result.shown += '\n';
        text.remove_prefix(feed + 1);
    }
}

std::string text_of(const WrappedText& wrapped) {
    return text_between(wrapped, 0, wrapped.shown.size());
}

std::string text_between(const WrappedText& wrapped, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t at = from; at < std::min(to, wrapped.shown.size()); ++at) {
        if (!is_break(wrapped, at)) text += wrapped.shown[at];
    }
    return text;
}

std::size_t place_in_text(const WrappedText& wrapped, std::size_t shown_at) {
    return shown_at - breaks_before(wrapped, shown_at);
}

std::size_t place_shown(const WrappedText& wrapped, std::size_t text_at) {
    std::size_t at = text_at;
    for (const std::size_t place : wrapped.breaks) {
        if (place > at) break;
        ++at;
    }
    return std::min(at, wrapped.shown.size());
}

EditedText edited(const WrappedText& before, std::string_view now, BoxCursor cursor_before,
                  std::size_t cursor_now) {
    const std::string_view was = before.shown;
    const std::size_t least = std::min(was.size(), now.size());
    // What was typed or taken away ends at the cursor, and begins at the selection or before: a
    // break and a line feed look alike.
    const std::size_t behind = std::min(least, now.size() - std::min(cursor_now, now.size()));
    std::size_t foot = 0;
    while (foot < behind && was[was.size() - 1 - foot] == now[now.size() - 1 - foot]) ++foot;
    std::size_t head = 0;
    while (head < std::min(least - foot, cursor_before.first) && was[head] == now[head]) ++head;
    while (head > 0 && (is_inside_character(was, head) || is_inside_character(now, head))) --head;
    while (foot > 0 && (is_inside_character(was, was.size() - foot) ||
                        is_inside_character(now, now.size() - foot))) {
        --foot;
    }
    std::string first = text_between(before, 0, head);
    const std::string typed(now.substr(head, now.size() - foot - head));
    const std::string gone = text_between(before, head, was.size() - foot);
    std::string last = text_between(before, was.size() - foot, was.size());
    const bool took_break_alone = typed.empty() && gone.empty() && now.size() < was.size();
    EditedText result;
    if (took_break_alone && cursor_before.at > cursor_now && !first.empty()) {
        first.resize(before_character(first, first.size()));
        result.cursor = first.size();
    } else if (took_break_alone && !last.empty()) {
        last.erase(0, after_character(last, 0));
        result.cursor = first.size();
    } else if (cursor_now <= head) {
        result.cursor = place_in_text(before, cursor_now);
    } else if (cursor_now <= head + typed.size()) {
        result.cursor = first.size() + (cursor_now - head);
    } else {
        const std::size_t shift = was.size() + cursor_now - now.size();
        result.cursor =
            first.size() + typed.size() + text_between(before, was.size() - foot, shift).size();
    }
    const auto is_space = [](char c) { return c == ' ' || c == '\n'; };
    result.begins_word =
        !typed.empty() && !is_space(typed.front()) && (first.empty() || is_space(first.back()));
    result.text = first + typed + last;
    return result;
}

}  // namespace tact
