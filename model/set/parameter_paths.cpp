#include "model/set/parameter_paths.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace tact {

std::optional<double> value_of(const Vibration& vibration, PatternParameter parameter) {
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    return pattern == nullptr ? std::nullopt : value_of(*pattern, parameter);
}

std::vector<std::vector<std::size_t>> paths_along(std::span<const Vibration> vibrations,
                                                  PatternParameter parameter) {
    struct Place {
        double value;
        std::size_t row;
    };
    std::vector<std::pair<Pattern, std::vector<Place>>> groups;
    for (std::size_t k = 0; k < vibrations.size(); ++k) {
        const auto value = value_of(vibrations[k], parameter);
        if (!value) continue;
        const Pattern rest = with_value(std::get<Pattern>(vibrations[k].source), parameter, 1.0);
        auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.first == rest; });
        if (group == groups.end()) group = groups.insert(groups.end(), {rest, {}});
        group->second.push_back({*value, k});
    }
    std::vector<std::vector<std::size_t>> paths;
    for (auto& [rest, group] : groups) {
        if (group.size() < 2) continue;
        std::ranges::stable_sort(group, {}, &Place::value);
        std::vector<std::size_t> path;
        for (const Place& place : group) path.push_back(place.row);
        paths.push_back(std::move(path));
    }
    return paths;
}

std::optional<PatternParameter> most_joining(std::span<const Vibration> vibrations) {
    std::optional<PatternParameter> most;
    std::size_t joined = 0;
    for (const PatternParameter parameter : kPatternParameters) {
        std::size_t steps = 0;
        for (const auto& path : paths_along(vibrations, parameter)) steps += path.size() - 1;
        if (steps <= joined) continue;
        joined = steps;
        most = parameter;
    }
    return most;
}

}  // namespace tact
