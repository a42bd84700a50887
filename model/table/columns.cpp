#include "model/table/columns.h"

#include <algorithm>
#include <vector>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// "a, b and rating", of all roles.
std::string words_on(std::initializer_list<ColumnRole> roles) {
    std::string words;
    for (const ColumnRole& one : roles) {
        const bool is_last = &one + 1 == roles.end();
        words += (words.empty() ? "" : is_last ? " and " : ", ") + std::string(one.role);
    }
    return words;
}

std::string* column_of(std::initializer_list<ColumnRole> roles, std::string_view role) {
    for (const ColumnRole& one : roles) {
        if (role == one.role) return one.column;
    }
    return nullptr;
}

}  // namespace

std::string take_column_roles(std::string_view text, std::initializer_list<ColumnRole> roles) {
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), part.size() + 1));
        const std::size_t equals = std::min(part.find('='), part.size());
        std::string* const column = column_of(roles, trimmed(part.substr(0, equals)));
        const std::string name{trimmed(part.substr(std::min(equals + 1, part.size())))};
        if (column == nullptr || name.empty() || !column->empty()) {
            return "expected " + words_on(roles) + ", each once as ROLE=COLUMN, got " +
                   in_quotes(part);
        }
        *column = name;
    }
    return {};
}

Expected<std::size_t> place_of_column(std::span<const std::string> head, std::string_view column) {
    const auto found = std::ranges::find_if(
        head, [column](const std::string& name) { return trimmed(name) == column; });
    if (found != head.end()) return static_cast<std::size_t>(found - head.begin());
    for (std::size_t k = 0; k < head.size(); ++k) {
        if (column == std::to_string(k + 1)) return k;
    }
    return Error{"expected a column " + in_quotes(column) + ", the columns are " +
                 column_names(head)};
}

std::string column_names(std::span<const std::string> head) {
    constexpr std::size_t kMost = 12;
    std::string names;
    for (std::size_t k = 0; k < std::min(head.size(), kMost); ++k) {
        names += (k == 0 ? "" : ", ") + shortened(trimmed(head[k]));
    }
    if (head.size() > kMost) names += " and " + grouped_digits(head.size() - kMost) + " more";
    return names;
}

}  // namespace tact
