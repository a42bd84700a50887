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

// What the texts, the names and the numbers of a lesson have to be found in.
struct LookUp {
    const PatternSet& set;
    const std::vector<std::string>& languages;
    bool is_draft = false;  // then patterns and numbers need not be there yet
};

// A text, which may be there in several languages: {"en": "..", "de": ".."}. `translate` gets the
// place of each further language among them, from 0, and its text.
std::string text_of_languages(JsonObject& object, std::string_view key, const LookUp& look_up,
                              const std::function<void(std::size_t, std::string)>& translate);

// The other way: a plain text where no language but the first has one.
Json json_of_languages(const std::string& text, const std::vector<std::string>& languages,
                       const std::function<std::string(std::size_t)>& translation);

// A step. A draft may lack what model/lesson/lesson_lacks.h lists.
LessonStep step_of(JsonObject& object, const LookUp& look_up);

// Only what differs from the defaults.
Json json_of(const LessonStep& step, const std::vector<std::string>& languages);

}  // namespace tact
