#include "model/io/lesson/lesson_json.h"

#include <nlohmann/json.hpp>

#include "model/lesson/lesson_numbers.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

// What the names and numbers of a step have to be found in.
struct LookUp {
    const PatternSet& set;
    bool is_draft;  // then they need not be there yet
};

// Options or pairs: those that a question of another kind left behind may be as few as they are.
std::size_t least_of(const LookUp& look_up, bool is_asked) {
    return look_up.is_draft || !is_asked ? 0 : 2;
}

// A text whose numbers the model can give.
std::string text_with_numbers(JsonObject& object, std::string_view key, const LookUp& look_up) {
    const std::string text = text_field(object, key, "");
    if (look_up.is_draft) return text;
    for (const std::string& placeholder : placeholders_in(text)) {
        const std::string fault = placeholder_fault(placeholder, look_up.set);
        if (fault.empty()) continue;
        refuse(*object.reading, place_of(object, key),
               "numbers that the model can give: {" + placeholder + "} cannot be (" + fault + ")",
               Json(text));
        break;
    }
    return text;
}

void need_pattern(JsonReading& reading, const std::string& place, const LookUp& look_up,
                  const std::string& name) {
    if (name.empty() || look_up.is_draft || place_named(look_up.set, name)) return;
    refuse(reading, place, "the name of a pattern of the lesson's set", Json(name));
}

std::string pattern_field(JsonObject& object, std::string_view key, const LookUp& look_up) {
    std::string name = name_field(object, key, "");
    need_pattern(*object.reading, place_of(object, key), look_up, name);
    return name;
}

PatternPair pair_of(JsonReading& reading, const Json& value, const std::string& place,
                    const LookUp& look_up) {
    const bool good = value.is_array() && value.size() == 2 && value[0].is_string() &&
                      value[1].is_string() && value[0] != value[1];
    if (!good) {
        refuse(reading, place, "the names of two patterns", value);
        return {};
    }
    PatternPair pair{value[0].get<std::string>(), value[1].get<std::string>()};
    need_pattern(reading, place, look_up, pair.a);
    need_pattern(reading, place, look_up, pair.b);
    return pair;
}

void read_options(JsonObject& object, const LookUp& look_up, LessonQuestion& question) {
    const std::size_t least = least_of(look_up, question.kind == QuestionKind::choice);
    for (const Json* option : array_field(object, "options", least, limits::kMaxOptions)) {
        if (!option->is_string()) {
            refuse(*object.reading, place_of(object, "options"), "texts", *option);
            return;
        }
        question.options.push_back(option->get<std::string>());
        for (const std::string& placeholder : placeholders_in(question.options.back())) {
            if (look_up.is_draft || placeholder_fault(placeholder, look_up.set).empty()) continue;
            refuse(*object.reading, place_of(object, "options"), "numbers that the model can give",
                   *option);
        }
    }
    const double last =
        question.options.empty() ? 0.0 : static_cast<double>(question.options.size() - 1);
    question.answer = static_cast<std::size_t>(whole_field(object, "answer", 0, {0.0, last}));
}

LessonQuestion question_of(JsonObject& object, const LookUp& look_up) {
    LessonQuestion question;
    question.kind = static_cast<QuestionKind>(choice_field(object, "kind", 0, kQuestionKinds));
    question.ask = text_with_numbers(object, "ask", look_up);
    question.reveal = text_with_numbers(object, "reveal", look_up);
    read_options(object, look_up, question);
    const bool of_pairs =
        question.kind == QuestionKind::closest || question.kind == QuestionKind::farthest;
    const std::size_t least = least_of(look_up, of_pairs);
    for (const Json* pair : array_field(object, "pairs", least, limits::kMaxOptions)) {
        question.pairs.push_back(
            pair_of(*object.reading, *pair, place_of(object, "pairs"), look_up));
    }
    return question;
}

LessonCamera camera_of(JsonObject& object) {
    const LessonCamera normal;
    LessonCamera camera;
    camera.yaw_rad = number_field(object, "yaw_rad", normal.yaw_rad, limits::kLessonAngleRad);
    camera.pitch_rad = number_field(object, "pitch_rad", normal.pitch_rad, limits::kLessonAngleRad);
    camera.zoom = number_field(object, "zoom", normal.zoom, limits::kLessonZoom);
    return camera;
}

// What belonged to a question or a camera that the step has no more is gone with it.
void restore(Json& fields, const std::string& unknown_json) {
    if (unknown_json.empty()) return;
    Json unknown = kept_json(unknown_json);
    for (const char* part : {"camera", "question"}) {
        if (!fields.contains(part) && unknown.is_object()) unknown.erase(part);
    }
    if (unknown.is_object()) restore_unknown(fields, unknown);
}

Json json_of(const LessonQuestion& question) {
    Json fields = {{"kind", kQuestionKinds[static_cast<std::size_t>(question.kind)]},
                   {"ask", question.ask}};
    if (question.kind == QuestionKind::choice || !question.options.empty()) {
        fields["options"] = question.options;
        fields["answer"] = question.answer;
    }
    for (const PatternPair& pair : question.pairs) {
        fields["pairs"].push_back(Json::array({pair.a, pair.b}));
    }
    if (!question.reveal.empty()) fields["reveal"] = question.reveal;
    return fields;
}

}  // namespace

LessonStep step_of(JsonObject& object, const PatternSet& set, bool is_draft) {
    const LookUp look_up{set, is_draft};
    LessonStep step;
    step.title = text_with_numbers(object, "title", look_up);
    step.text = text_with_numbers(object, "text", look_up);
    step.note = text_with_numbers(object, "note", look_up);
    step.source = text_field(object, "source", "");
    step.pattern = pattern_field(object, "pattern", look_up);
    step.partner = pattern_field(object, "partner", look_up);
    step.view = kLessonViews[choice_field(object, "view", 0, kLessonViews)];
    step.point_at = text_field(object, "point_at", "");
    step.at_s = number_field(object, "at_s", 0.0, limits::kLessonTimeS);
    step.speed = number_field(object, "speed", 0.0, limits::kLessonSpeed);
    step.from_s = number_field(object, "from_s", 0.0, limits::kLessonTimeS);
    step.to_s = number_field(object, "to_s", 0.0, limits::kLessonTimeS);
    Json unknown = Json::object();
    if (object.value != nullptr && object.value->contains("camera")) {
        JsonObject camera = object_field(object, "camera");
        step.camera = camera_of(camera);
        note_unknown(unknown, "camera", unknown_fields(camera));
    }
    if (object.value != nullptr && object.value->contains("question")) {
        JsonObject question = object_field(object, "question");
        step.question = question_of(question, look_up);
        const std::string needed = question_needs(step, set.vibrations.size());
        if (!needed.empty() && !is_draft)
            refuse(*question.reading, question.place, needed, *question.value);
        note_unknown(unknown, "question", unknown_fields(question));
    }
    unknown.update(unknown_fields(object));
    if (!unknown.empty()) step.unknown_json = text_of_json(unknown);
    return step;
}

Json json_of(const LessonStep& step) {
    Json fields = {{"title", step.title}, {"text", step.text}};
    const auto add_text = [&fields](const char* key, const std::string& text) {
        if (!text.empty()) fields[key] = text;
    };
    const auto add_number = [&fields](const char* key, double value) {
        if (value != 0.0) fields[key] = value;
    };
    add_text("note", step.note);
    add_text("source", step.source);
    add_text("pattern", step.pattern);
    add_text("partner", step.partner);
    if (step.view != kLessonViews[0]) fields["view"] = step.view;
    add_text("point_at", step.point_at);
    add_number("at_s", step.at_s);
    add_number("speed", step.speed);
    add_number("from_s", step.from_s);
    add_number("to_s", step.to_s);
    if (step.camera) {
        fields["camera"] = {{"yaw_rad", step.camera->yaw_rad},
                            {"pitch_rad", step.camera->pitch_rad},
                            {"zoom", step.camera->zoom}};
    }
    if (step.question) fields["question"] = json_of(*step.question);
    restore(fields, step.unknown_json);
    return fields;
}

}  // namespace tact
