// Names that are bytes, in JSON, which is UTF-8: paths, and what a system calls its devices. What
// is no UTF-8 is an object, {"percent_encoded": "/home/na%EFve"}; any other is its text.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "model/io/folders/percent_code.h"
#include "model/text/utf8.h"

namespace tact {

inline nlohmann::json bytes_json(const std::string& bytes) {
    if (!first_invalid_utf8(bytes)) return bytes;
    return {{"percent_encoded", percent_encoded(bytes)}};
}

inline nlohmann::json path_json(const std::filesystem::path& path) {
    return bytes_json(path.native());
}

// None: it is no such name.
inline std::optional<std::string> bytes_named(const nlohmann::json& json) {
    if (json.is_string()) return json.get<std::string>();
    if (!json.is_object()) return std::nullopt;
    const auto code = json.find("percent_encoded");
    if (code == json.end() || !code->is_string()) return std::nullopt;
    return percent_decoded(code->get<std::string>());
}

inline std::optional<std::filesystem::path> path_of(const nlohmann::json& json) {
    const auto bytes = bytes_named(json);
    if (!bytes) return std::nullopt;
    return std::filesystem::path(*bytes);
}

}  // namespace tact
