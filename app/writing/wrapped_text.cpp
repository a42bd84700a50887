#include "app/writing/wrapped_text.h"

#include <algorithm>

namespace tact {

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
