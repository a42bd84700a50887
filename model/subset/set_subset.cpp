#include "model/subset/set_subset.h"

#include <algorithm>
#include <optional>

namespace tact {

namespace {

// The ratings of the pairs within; none where fewer than two of the patterns were rated.
std::optional<Ratings> part_of(const Ratings& ratings, const std::vector<std::string>& names) {
    std::vector<std::size_t> places;
    Ratings part{ratings.name, {}, {}, ratings.unknown_json, ratings.file};
    for (const std::string& name : names) {
        const auto found = std::ranges::find(ratings.labels, name);
        if (found == ratings.labels.end()) continue;
        places.push_back(static_cast<std::size_t>(found - ratings.labels.begin()));
        part.labels.push_back(name);
    }
    if (places.size() < 2) return std::nullopt;
    for (std::size_t a = 0; a < places.size(); ++a) {
        for (std::size_t b = a + 1; b < places.size(); ++b) {
            const auto [i, j] = std::minmax(places[a], places[b]);
            part.condensed.push_back(ratings.condensed[pair_index(ratings.labels.size(), i, j)]);
        }
    }
    return part;
}

}  // namespace

std::vector<std::size_t> left_out_unfelt(const PatternSet& set,
                                         std::span<const std::size_t> unfelt) {
    std::vector<std::size_t> places;
    for (const std::size_t k : unfelt) {
        const Vibration& one = set.vibrations[k];
        if (!one.locked && !one.dropped) places.push_back(k);
    }
    return places;
}

std::string left_out_words(std::size_t count) {
    if (count == 0) return {};
    return std::to_string(count) + (count == 1 ? " not felt pattern" : " not felt patterns") +
           " left out";
}

std::size_t possible_count(const SubsetProblem& problem, std::size_t objects, std::size_t wanted) {
    const std::size_t most = objects - std::min(objects, problem.drop.size());
    const std::size_t least = std::max<std::size_t>(2, problem.keep.size());
    return std::clamp(std::max<std::size_t>(wanted, 2), std::min(least, most), most);
}

SubsetProblem subset_problem(const PatternSet& set, std::size_t count, SubsetObjective objective,
                             std::span<const std::size_t> unfelt) {
    SubsetProblem problem{count, objective};
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        if (set.vibrations[k].locked) problem.keep.push_back(k);
        if (set.vibrations[k].dropped) problem.drop.push_back(k);
    }
    for (const std::size_t k : left_out_unfelt(set, unfelt)) problem.drop.push_back(k);
    return problem;
}

PatternSet part_of(const PatternSet& set, std::span<const std::size_t> members) {
    PatternSet part = set;
    part.vibrations.clear();
    part.ratings.clear();
    part.told_apart.clear();
    for (const std::size_t member : members) part.vibrations.push_back(set.vibrations[member]);
    for (const Ratings& ratings : set.ratings) {
        if (auto rated = part_of(ratings, names_of(part))) part.ratings.push_back(*rated);
    }
    for (const ToldApart& told : set.told_apart) {
        ToldApart within = among(told, names_of(part));
        if (!within.answers.empty()) part.told_apart.push_back(std::move(within));
    }
    return part;
}

}  // namespace tact
