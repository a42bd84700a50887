#include "model/io/lesson/lesson_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "assets/assets.h"
#include "model/io/lesson/lesson_json.h"
#include "model/io/set/set_file.h"
#include "model/io/set/set_json.h"
#include "model/lesson/lesson_lacks.h"
#include "model/lesson/lesson_languages.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/json_fields.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::string text_of(const Json& document) { return text_of_json(document, 2) + "\n"; }

std::string bundled_path(const std::string& name) { return "sets/" + name + ".tactspace.json"; }

bool is_bundled(const std::string& name) {
    for (const Asset& file : assets()) {
        if (file.path == bundled_path(name)) return true;
    }
    return false;
}

// Its own set, or a bundled one.
void read_set(JsonObject& object, Lesson& lesson, const fs::path& folder) {
    JsonReading& reading = *object.reading;
    const Json* value = field(object, "set");
    if (value == nullptr || !(value->is_object() || value->is_string())) {
        refuse(reading, "/set", "a set, or the name of one that comes with the program",
               value == nullptr ? Json() : *value);
        return;
    }
    if (value->is_string()) lesson.set_name = value->get<std::string>();
    if (value->is_string() && !is_bundled(lesson.set_name)) {
        refuse(reading, "/set", "the name of a set that comes with the program", *value);
        return;
    }
    const std::string own = value->is_object() ? text_of_json(*value) : std::string();
    const std::string name = reading.file + ": /set";
    auto set = value->is_object() ? parse_set(own, name, folder)
                                  : parse_set(asset(bundled_path(lesson.set_name)), name, {});
    if (set) {
        lesson.set = *std::move(set);
    } else if (reading.fault.empty()) {
        reading.fault = set.error().message;
    }
}

// Each once, with a valid code.
void read_languages(JsonObject& object, Lesson& lesson) {
    for (const Json* value : array_field(object, "languages", 0, limits::kMaxLanguages)) {
        const std::string code = value->is_string() ? value->get<std::string>() : std::string();
        const bool is_there = std::ranges::find(lesson.languages, code) != lesson.languages.end();
        if (!is_language_code(code) || is_there) {
            refuse(*object.reading, "/languages", "codes of languages, each once, as \"en\"",
                   *value);
            return;
        }
        lesson.languages.push_back(code);
    }
}

LessonWords& words_at(Lesson& lesson, std::size_t place) {
    if (lesson.words.size() <= place) lesson.words.resize(place + 1);
    return lesson.words[place];
}

std::string lesson_text(JsonObject& object, std::string_view key, Lesson& lesson,
                        std::string LessonWords::*translation) {
    const PatternSet none;
    return text_of_languages(object, key, {none, lesson.languages, true},
                             [&](std::size_t place, std::string text) {
                                 words_at(lesson, place).*translation = std::move(text);
                             });
}

Json lesson_text_json(const std::string& text, const Lesson& lesson,
                      std::string LessonWords::*translation) {
    return json_of_languages(text, lesson.languages, [&](std::size_t place) {
        return place < lesson.words.size() ? lesson.words[place].*translation : std::string();
    });
}

Lesson lesson_of(JsonReading& reading, const Json& document, const fs::path& folder) {
    Lesson lesson;
    JsonObject object = object_at(reading, document, "");
    if (reading.fault.empty() && field(object, "tactlesson") == nullptr) {
        refuse(reading, "/tactlesson", "the format of the lesson, 1", Json());
    }
    whole_field(object, "tactlesson", kLessonFormat, {1.0, kLessonFormat});
    if (!reading.fault.empty()) return lesson;
    read_languages(object, lesson);
    const std::string name = lesson_text(object, "name", lesson, &LessonWords::name);
    lesson.name = name_at(reading, Json(name), "/name");
    lesson.about = lesson_text(object, "about", lesson, &LessonWords::about);
    read_set(object, lesson, folder);
    if (!reading.fault.empty()) return lesson;
    const bool is_draft = yes_no_field(object, "draft", false);
    const auto steps = array_field(object, "steps", 1, limits::kMaxSteps);
    if (steps.empty()) refuse(reading, "/steps", "at least one step", Json());
    for (std::size_t k = 0; k < steps.size(); ++k) {
        JsonObject step = object_at(reading, *steps[k], "/steps/" + std::to_string(k));
        lesson.steps.push_back(step_of(step, {lesson.set, lesson.languages, is_draft}));
    }
    const Json unknown = unknown_fields(object);
    if (!unknown.empty()) lesson.unknown_json = text_of_json(unknown);
    return lesson;
}

}  // namespace

bool is_lesson_file(const fs::path& path) {
    return path.filename().string().ends_with(kLessonEnding);
}

Expected<Lesson> parse_lesson(std::string_view text, const std::string& name_for_messages,
                              const fs::path& folder) {
    return with_enough_memory(name_for_messages, [&]() -> Expected<Lesson> {
        const auto document = parse_json(text, name_for_messages);
        if (!document) return document.error();
        JsonReading reading{name_for_messages, {}, UnknownKeys::kept};
        Lesson lesson = lesson_of(reading, *document, folder);
        if (!reading.fault.empty()) return Error{reading.fault};
        return lesson;
    });
}

Expected<Lesson> read_lesson_file(const fs::path& path) {
    const auto text = read_text_file(path);
    if (!text) return text.error();
    return parse_lesson(*text, path.string(), path.parent_path());
}

std::string print_lesson(const Lesson& lesson, const fs::path& folder) {
    Json document = Json::object();
    document["tactlesson"] = kLessonFormat;
    if (!lesson.languages.empty()) document["languages"] = lesson.languages;
    document["name"] = lesson_text_json(lesson.name, lesson, &LessonWords::name);
    const Json about = lesson_text_json(lesson.about, lesson, &LessonWords::about);
    if (about != "") document["about"] = about;
    if (lesson.set_name.empty()) {
        document["set"] = json_of(lesson.set, folder);
    } else {
        document["set"] = lesson.set_name;
    }
    if (!lesson_lacks(lesson).empty()) document["draft"] = true;
    document["steps"] = Json::array();
    for (const LessonStep& step : lesson.steps)
        document["steps"].push_back(json_of(step, lesson.languages));
    if (!lesson.unknown_json.empty()) {
        restore_unknown(document, kept_json(lesson.unknown_json));
    }
    return text_of(document);
}

Expected<Done> write_lesson_file(const fs::path& path, const Lesson& lesson) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string text = print_lesson(lesson, folder);
    if (const auto again = parse_lesson(text, path.string(), folder); !again) {
        return again.error();
    }
    return write_atomically(path, text);
}

}  // namespace tact
