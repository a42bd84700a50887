// The fields of a request's body, each of one type and bounded.
//
// Left out  where a fault is: a page is told "malformed" and no more
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "model/text/json_fields.h"

namespace tact {

// An object whose known keys are taken one by one; one of a wrong type is a fault of the whole.
struct BodyFields {
    Json object;
    bool is_sound = true;

    const Json* at(const char* key) {
        const auto found = object.find(key);
        return found == object.end() ? nullptr : &*found;
    }

    std::string text(const char* key, std::size_t most_bytes) {
        const Json* value = at(key);
        if (value == nullptr) return {};
        is_sound = is_sound && value->is_string() &&
                   value->get_ref<const std::string&>().size() <= most_bytes;
        return is_sound ? value->get<std::string>() : std::string{};
    }

    bool yes_no(const char* key) {
        const Json* value = at(key);
        if (value == nullptr) return false;
        is_sound = is_sound && value->is_boolean();
        return is_sound && value->get<bool>();
    }

    std::optional<std::int64_t> whole(const char* key, std::int64_t most) {
        const Json* value = at(key);
        return value == nullptr ? std::nullopt : whole_of(*value, most);
    }

    std::optional<std::int64_t> whole_of(const Json& value, std::int64_t most) {
        const bool fits = value.is_number_unsigned() &&
                          value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most);
        is_sound = is_sound && fits;
        return fits ? std::optional(value.get<std::int64_t>()) : std::nullopt;
    }
};

}  // namespace tact
