#include "model/text/unique_names.h"

#include <string_view>
#include <unordered_map>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

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

std::string name_fault(const std::string& name) {
    if (name.size() <= kMaxNameBytes) return {};
    return "expected a name of at most " + grouped_digits(kMaxNameBytes) + " bytes, got " +
           grouped_digits(name.size());
}

std::string UnusedNames::unused(const std::string& wanted) {
    std::string name = wanted;
    while (!taken.insert(name).second) {
        int& number = last_number.try_emplace(wanted, 1).first->second;
        const std::string end = " " + std::to_string(++number);
        name = std::string(whole_characters(wanted, kMaxNameBytes - end.size())) + end;
    }
    return name;
}

}  // namespace tact
