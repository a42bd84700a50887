// Steps of a lesson as JSON and back. Private to the lesson file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/lesson/lesson.h"
#include "model/text/json_fields.h"

namespace tact {

// The set and the languages that texts, names and numbers of a lesson must match.
struct LookUp {
    const PatternSet& set;
    const std::vector<std::string>& languages;
    bool is_draft = false;  // patterns and numbers may be missing
};

// A text, which may be given in several languages: {"en": "..", "de": ".."}. `translate` gets the
// index of each further language, from 0, and its text.
std::string text_of_languages(JsonObject& object, std::string_view key, const LookUp& look_up,
                              const std::function<void(std::size_t, std::string)>& translate);

// The inverse: a plain text if only the first language has one.
Json json_of_languages(const std::string& text, const std::vector<std::string>& languages,
                       const std::function<std::string(std::size_t)>& translation);

// A step. A draft may lack the parts listed in model/lesson/lesson_lacks.h.
LessonStep step_of(JsonObject& object, const LookUp& look_up);

// Only fields that differ from the defaults.
Json json_of(const LessonStep& step, const std::vector<std::string>& languages);

}  // namespace tact
