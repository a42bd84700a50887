#include "model/study/cluster_sorting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "model/study/study_design.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::array<int, 5> kPresets{3, 6, 9, 12, 15};

}  // namespace

std::size_t group_count(const Sorting& sorting) {
    std::vector<std::size_t> groups;
    for (const std::size_t group : sorting) {
        if (group != kUnsorted) groups.push_back(group);
    }
    std::ranges::sort(groups);
    return static_cast<std::size_t>(std::unique(groups.begin(), groups.end()) - groups.begin());
}

Dissimilarity sorting_dissimilarity(std::size_t patterns, std::span<const Sorting> sortings) {
    Dissimilarity result{patterns, std::vector<double>(pair_count(patterns))};
    std::vector<double> counts;
    for (const Sorting& sorting : sortings) {
        counts.push_back(static_cast<double>(group_count(sorting)));
    }
    std::size_t pair = 0;
    for (std::size_t i = 0; i < patterns; ++i) {
        for (std::size_t j = i + 1; j < patterns; ++j, ++pair) {
            double together = 0.0;
            double all = 0.0;
            for (std::size_t t = 0; t < sortings.size(); ++t) {
                const Sorting& sorting = sortings[t];
                if (sorting[i] == kUnsorted || sorting[j] == kUnsorted) continue;
                all += counts[t];
                if (sorting[i] == sorting[j]) together += counts[t];
            }
            result.condensed[pair] =
                all > 0.0 ? 1.0 - together / all : std::numeric_limits<double>::quiet_NaN();
        }
    }
    return result;
}

std::vector<int> sorting_rounds(std::size_t patterns, std::size_t free_choice) {
    const auto nearest = std::ranges::min_element(kPresets, {}, [free_choice](int groups) {
        return std::abs(groups - static_cast<int>(free_choice));
    });
    std::vector<int> rounds{0};
    for (const int& groups : kPresets) {
        if (&groups != &*nearest && static_cast<std::size_t>(groups) < patterns) {
            rounds.push_back(groups);
        }
    }
    return rounds;
}

std::string rounds_text(const std::vector<int>& rounds) {
    std::string text;
    for (const int groups : rounds) {
        text += (text.empty() ? "" : ", ") + (groups == 0 ? "free" : std::to_string(groups));
    }
    return text;
}

std::optional<std::vector<int>> rounds_in(std::string_view text, std::size_t patterns) {
    constexpr std::string_view kSeparators = " ,;\t";
    std::vector<int> rounds;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find_first_not_of(kSeparators), text.size());
        text.remove_prefix(begin);
        const std::size_t end = std::min(text.find_first_of(kSeparators), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(end);
        if (word.empty()) continue;
        const std::optional<double> number = word == "free" ? 0.0 : finite_number_in(word);
        const bool is_count = number && (*number == 0.0 || *number >= 2.0) &&
                              *number <= static_cast<double>(patterns) &&
                              *number == std::floor(*number);
        if (!is_count || rounds.size() == limits::kMaxRounds) return std::nullopt;
        rounds.push_back(static_cast<int>(*number));
    }
    return rounds;
}

}  // namespace tact
