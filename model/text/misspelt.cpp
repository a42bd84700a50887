#include "model/text/misspelt.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace tact {

namespace {

constexpr std::size_t kLongestWord = 100;  // bytes
constexpr std::size_t kLettersASlip = 4;

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::size_t slips_between(std::string_view a, std::string_view b) {
    // Rows of the last two letters of `a` and of this one.
    std::array<std::vector<std::size_t>, 3> rows;
    for (auto& row : rows) row.assign(b.size() + 1, 0);
    for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        auto& [before, last, row] = rows;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = small(a[i - 1]) == small(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool exchanged = i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) &&
                                   small(a[i - 2]) == small(b[j - 1]);
            if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::ranges::rotate(rows, rows.begin() + 1);
    }
    return rows[1][b.size()];
}

}  // namespace

std::optional<std::string_view> misspelt(std::string_view word,
                                         std::span<const std::string_view> known) {
    if (word.size() > kLongestWord) return std::nullopt;
    std::optional<std::string_view> nearest;
    std::size_t least = word.size() / kLettersASlip + 1;
    for (const std::string_view one : known) {
        const std::size_t apart =
            std::max(word.size(), one.size()) - std::min(word.size(), one.size());
        if (one.size() > kLongestWord || apart >= least) continue;
        const std::size_t slips = slips_between(word, one);
        if (slips >= least) continue;
        least = slips;
        nearest = one;
    }
    return nearest;
}

}  // namespace tact
