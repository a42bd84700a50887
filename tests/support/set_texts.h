// Set files as texts: with one pattern, and what is wrong with one.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "model/io/set/set_file.h"

namespace tact {

// What is wrong with a text, in a line.
inline std::string set_fault(const std::string& text) {
    const auto set = parse_set(text, "s.json", {});
    REQUIRE_FALSE(set);
    CHECK(set.error().message.find('\n') == std::string::npos);
    return set.error().message;
}

// With these fields in its only pattern.
inline std::string with_pattern(const std::string& fields) {
    return R"({"tactspace": 1, "patterns": [{"name": "a")" + fields + "}]}";
}

}  // namespace tact
