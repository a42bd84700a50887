#include "model/text/unique_names.h"

#include <string_view>
#include <unordered_map>

namespace tact {

std::optional<std::pair<std::size_t, std::size_t>> first_equal(
    const std::vector<std::string>& names) {
    std::unordered_map<std::string_view, std::size_t> places;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto [place, is_new] = places.emplace(names[k], k);
        if (!is_new) return std::pair{place->second, k};
    }
    return std::nullopt;
}

std::string UnusedNames::unused(const std::string& wanted) {
    std::string name = wanted;
    while (!taken.insert(name).second) {
        int& number = last_number.try_emplace(wanted, 1).first->second;
        name = wanted + " " + std::to_string(++number);
    }
    return name;
}

}  // namespace tact
