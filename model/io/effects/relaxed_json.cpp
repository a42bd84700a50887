#include "model/io/effects/relaxed_json.h"

#include <algorithm>

namespace tact {

namespace {

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '$';
}

// Behind the text that begins at `k`, whose quotes become double ones.
std::size_t copy_text(std::string_view relaxed, std::size_t k, std::string& strict) {
    const char quote = relaxed[k++];
    strict += '"';
    for (; k < relaxed.size() && relaxed[k] != quote; ++k) {
        if (relaxed[k] == '\\' && k + 1 < relaxed.size()) {
            const bool plain = relaxed[k + 1] == '\'';
            if (!plain) strict += '\\';
            strict += relaxed[++k];
        } else {
            if (relaxed[k] == '"') strict += '\\';
            strict += relaxed[k];
        }
    }
    // A text without its end stays one: the parser says where.
    if (k < relaxed.size()) strict += '"';
    return k + 1;
}

// Behind a comment at `k`, or `k`.
std::size_t behind_comment(std::string_view relaxed, std::size_t k, std::string& strict) {
    if (relaxed.substr(k, 2) == "//") return std::min(relaxed.find('\n', k), relaxed.size());
    if (relaxed.substr(k, 2) != "/*") return k;
    const std::size_t close = relaxed.find("*/", k + 2);
    const std::size_t end = close == relaxed.npos ? relaxed.size() : close + 2;
    const std::string_view comment = relaxed.substr(k, end - k);
    strict.append(static_cast<std::size_t>(std::ranges::count(comment, '\n')), '\n');
    return end;
}

void drop_last_comma(std::string& strict) {
    const std::size_t last = strict.find_last_not_of(" \t\r\n");
    if (last != strict.npos && strict[last] == ',') strict[last] = ' ';
}

// Behind a bare word at `k`: quoted where a colon follows, so that true and 1e5 stay.
std::size_t copy_word(std::string_view relaxed, std::size_t k, std::string& strict) {
    std::size_t end = k;
    while (end < relaxed.size() && is_name_character(relaxed[end])) ++end;
    const std::size_t next = relaxed.find_first_not_of(" \t\r\n", end);
    const bool is_key = next != relaxed.npos && relaxed[next] == ':';
    const std::string word(relaxed.substr(k, end - k));
    strict += is_key ? '"' + word + '"' : word;
    return end;
}

}  // namespace

std::string strict_json(std::string_view relaxed) {
    std::string strict;
    strict.reserve(relaxed.size());
    for (std::size_t k = 0; k < relaxed.size();) {
        const char c = relaxed[k];
        const std::size_t behind = c == '/' ? behind_comment(relaxed, k, strict) : k;
        if (behind != k) {
            k = behind;
        } else if (c == '"' || c == '\'') {
            k = copy_text(relaxed, k, strict);
        } else if (is_name_character(c)) {
            k = copy_word(relaxed, k, strict);
        } else {
            if (c == ']' || c == '}') drop_last_comma(strict);
            strict += c;
            ++k;
        }
    }
    return strict;
}

}  // namespace tact
