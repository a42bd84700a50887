// Paths in JSON: names of files are bytes, JSON is UTF-8. A path that is no UTF-8 is an object,
// {"percent_encoded": "/home/na%EFve"}; any other is its text.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "model/text/percent_code.h"
#include "model/text/utf8.h"

namespace tact {

inline nlohmann::json path_json(const std::filesystem::path& path) {
    if (!first_invalid_utf8(path.native())) return path.native();
    return {{"percent_encoded", percent_encoded(path.native())}};
}

// None: it is no path.
inline std::optional<std::filesystem::path> path_of(const nlohmann::json& json) {
    if (json.is_string()) return json.get<std::string>();
    if (!json.is_object()) return std::nullopt;
    const auto code = json.find("percent_encoded");
    if (code == json.end() || !code->is_string()) return std::nullopt;
    const auto bytes = percent_decoded(code->get<std::string>());
    if (!bytes) return std::nullopt;
    return std::filesystem::path(*bytes);
}

}  // namespace tact
