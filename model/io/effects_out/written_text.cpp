#include "model/io/effects_out/written_text.h"

#include <nlohmann/json.hpp>

namespace tact {

std::string printed(const Json& document) { return text_of_json(document, 2) + "\n"; }

std::string identifier(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        result += letter || (c >= '0' && c <= '9') ? c : '_';
    }
    const bool starts = !result.empty() && !(result.front() >= '0' && result.front() <= '9');
    return starts ? result : "effect_" + result;
}

}  // namespace tact
