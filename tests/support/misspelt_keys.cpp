#include "tests/support/misspelt_keys.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace tact {

namespace {

using Json = nlohmann::ordered_json;

void collect(const Json& value, const std::string& place, const std::set<std::string>& of_names,
             std::vector<std::pair<std::string, std::string>>& keys) {
    if (!value.is_structured()) return;
    for (const auto& [key, part] : value.items()) {
        if (value.is_object() && !of_names.contains(place)) keys.emplace_back(place, key);
        collect(part, place + "/" + key, of_names, keys);
    }
}

}  // namespace

void check_misspelt_keys_refused(const std::string& document,
                                 const std::function<std::string(const std::string&)>& fault_of,
                                 const std::set<std::string>& of_names) {
    const Json whole = Json::parse(document);
    REQUIRE(fault_of(whole.dump()) == "");
    std::vector<std::pair<std::string, std::string>> keys;
    collect(whole, "", of_names, keys);
    REQUIRE(keys.size() > 3);
    for (const auto& [place, key] : keys) {
        std::string slip = key;
        if (slip.size() < 4 || slip[1] == slip[2]) continue;
        // A document without its format key is another kind of document.
        if (place.empty() && key.starts_with("tact")) continue;
        std::swap(slip[1], slip[2]);
        Json changed = whole;
        Json& object = changed[Json::json_pointer(place)];
        object[slip] = object[key];
        object.erase(key);
        const std::string fault = fault_of(changed.dump());
        CHECK_MESSAGE(!fault.empty(), place << "/" << slip << " was passed over");
        // Where a key is missed that has to be there, that is said first.
        if (fault.find("does not know") == std::string::npos) continue;
        CHECK_MESSAGE(fault.find("\"" + slip + "\"; the nearest key is ") != std::string::npos,
                      fault);
    }
}

}  // namespace tact
