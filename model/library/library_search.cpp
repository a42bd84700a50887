#include "model/library/library_search.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/text/utf8.h"

namespace tact {

namespace {

std::string text_of(const Library& library, const LibraryEntry& entry) {
    const LibraryFile& file = file_of(library, entry);
    return lower_case(entry.name + '\n' + entry.note + '\n' + file.path + '\n' +
                      entry.effect.format + '\n' + file.licence);
}

}  // namespace

std::vector<std::size_t> found_by_words(const Library& library, std::string_view words) {
    std::vector<std::string> all;
    std::istringstream stream(lower_case(std::string(words)));
    for (std::string word; stream >> word;) all.push_back(word);
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < library.entries.size(); ++k) {
        const std::string text = text_of(library, library.entries[k]);
        if (std::ranges::all_of(all,
                                [&](const auto& word) { return text.find(word) != text.npos; }))
            found.push_back(k);
    }
    return found;
}

std::optional<StrengthShape> shape_through(const std::vector<double>& strengths) {
    if (strengths.size() < 2) return std::nullopt;
    const bool is_fine = std::ranges::all_of(
        strengths, [](double strength) { return std::isfinite(strength) && strength >= 0.0; });
    const double largest = std::ranges::max(strengths);
    if (!is_fine || !(largest > 0.0)) return std::nullopt;
    StrengthShape shape{};
    const auto last = static_cast<double>(strengths.size() - 1);
    for (std::size_t part = 0; part < kShapeParts; ++part) {
        const double at = (static_cast<double>(part) + 0.5) / kShapeParts * last;
        const auto before = static_cast<std::size_t>(at);
        const double share = at - std::floor(at);
        shape[part] = std::lerp(strengths[before], strengths[before + 1], share) / largest;
    }
    return shape;
}

double shape_difference(const StrengthShape& a, const StrengthShape& b) {
    double squares = 0.0;
    for (std::size_t k = 0; k < kShapeParts; ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(squares / kShapeParts);
}

}  // namespace tact
