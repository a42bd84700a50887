#include "model/io/lesson/lesson_json.h"

#include <algorithm>
#include <utility>

#include "model/lesson/lesson_numbers.h"
#include "model/lesson/step_numbers.h"
#include "model/text/described_json.h"

namespace tact {

namespace {

// The least number of options or pairs: 0 if the present kind of question does not use them.
std::size_t least_of(const LookUp& look_up, bool is_asked) {
    return look_up.is_draft || !is_asked ? 0 : 2;
}

// Refuses numbers that the model cannot compute.
void need_numbers(JsonReading& reading, const std::string& place, const LookUp& look_up,
                  const std::string& text) {
    if (look_up.is_draft) return;
    for (const std::string& placeholder : placeholders_in(text)) {
        const std::string fault = placeholder_fault(placeholder, look_up.set);
        if (fault.empty()) continue;
        refuse(reading, place,
               "numbers that the model can give: {" + placeholder + "} cannot be (" + fault + ")",
               Json(text));
        break;
    }
}

// The words of the step in a further language.
StepWords& words_at(LessonStep& step, std::size_t place) {
    if (step.words.size() <= place) step.words.resize(place + 1);
    return step.words[place];
}

std::string step_text(JsonObject& object, std::string_view key, const LookUp& look_up,
                      LessonStep& step, std::string StepWords::*translation) {
    return text_of_languages(object, key, look_up, [&](std::size_t place, std::string text) {
        words_at(step, place).*translation = std::move(text);
    });
}

// The step's text in a further language; empty: not translated.
template <class Words, class Text>
Text translation_of(const std::vector<Words>& words, std::size_t place, Text Words::*member) {
    return place < words.size() ? words[place].*member : Text{};
}

std::string option_of(const LessonStep& step, std::size_t place, std::size_t option) {
    const auto options = translation_of(step.words, place, &StepWords::options);
    return option < options.size() ? options[option] : std::string();
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

// Texts, or objects with one text per language.
void read_options(JsonObject& object, const LookUp& look_up, LessonStep& step,
                  LessonQuestion& question) {
    const std::size_t least = least_of(look_up, question.kind == QuestionKind::choice);
    const auto values = array_field(object, "options", least, limits::kMaxOptions);
    for (std::size_t k = 0; k < values.size(); ++k) {
        // As a field, so that it is read like any other text.
        const std::string key = std::to_string(k);
        Json one = Json::object();
        one[key] = *values[k];
        JsonObject option{object.reading, &one, place_of(object, "options"), {}};
        question.options.push_back(
            text_of_languages(option, key, look_up, [&](std::size_t place, std::string text) {
                auto& options = words_at(step, place).options;
                options.resize(std::max(options.size(), k + 1));
                options[k] = std::move(text);
            }));
    }
    const double last =
        question.options.empty() ? 0.0 : static_cast<double>(question.options.size() - 1);
    question.answer = static_cast<std::size_t>(whole_field(object, "answer", 0, {0.0, last}));
}

LessonQuestion question_of(JsonObject& object, const LookUp& look_up, LessonStep& step) {
    LessonQuestion question;
    question.kind = static_cast<QuestionKind>(choice_field(object, "kind", 0, kQuestionKinds));
    question.ask = step_text(object, "ask", look_up, step, &StepWords::ask);
    question.reveal = step_text(object, "reveal", look_up, step, &StepWords::reveal);
    read_options(object, look_up, step, question);
    const bool of_pairs =
        question.kind == QuestionKind::closest || question.kind == QuestionKind::farthest;
    const std::size_t least = least_of(look_up, of_pairs);
    for (const Json* pair : array_field(object, "pairs", least, limits::kMaxOptions)) {
        question.pairs.push_back(
            pair_of(*object.reading, *pair, place_of(object, "pairs"), look_up));
    }
    return question;
}

// Unknown keys of a removed question or camera are removed as well.
void restore(Json& fields, const std::string& unknown_json) {
    if (unknown_json.empty()) return;
    Json unknown = kept_json(unknown_json);
    for (const char* part : {"camera", "question"}) {
        if (!fields.contains(part) && unknown.is_object()) unknown.erase(part);
    }
    if (unknown.is_object()) restore_unknown(fields, unknown);
}

Json step_text_json(const std::string& text, const LessonStep& step,
                    const std::vector<std::string>& languages,
                    std::string StepWords::*translation) {
    return json_of_languages(text, languages, [&](std::size_t place) {
        return translation_of(step.words, place, translation);
    });
}

Json question_json(const LessonStep& step, const std::vector<std::string>& languages) {
    const LessonQuestion& question = *step.question;
    Json fields = {{"kind", kQuestionKinds[static_cast<std::size_t>(question.kind)]},
                   {"ask", step_text_json(question.ask, step, languages, &StepWords::ask)}};
    if (question.kind == QuestionKind::choice || !question.options.empty()) {
        fields["options"] = Json::array();
        for (std::size_t k = 0; k < question.options.size(); ++k) {
            fields["options"].push_back(
                json_of_languages(question.options[k], languages,
                                  [&](std::size_t place) { return option_of(step, place, k); }));
        }
        fields["answer"] = question.answer;
    }
    for (const PatternPair& pair : question.pairs) {
        fields["pairs"].push_back(Json::array({pair.a, pair.b}));
    }
    const Json reveal = step_text_json(question.reveal, step, languages, &StepWords::reveal);
    if (reveal != "") fields["reveal"] = reveal;
    return fields;
}

}  // namespace

std::string text_of_languages(JsonObject& object, std::string_view key, const LookUp& look_up,
                              const std::function<void(std::size_t, std::string)>& translate) {
    JsonReading& reading = *object.reading;
    const Json* value = field(object, key);
    if (value == nullptr || !value->is_object()) {
        std::string text = text_field(object, key, "");
        need_numbers(reading, place_of(object, key), look_up, text);
        return text;
    }
    JsonObject texts = object_field(object, key);
    std::string first;
    for (std::size_t k = 0; k < look_up.languages.size(); ++k) {
        const std::string& language = look_up.languages[k];
        std::string text = text_field(texts, language, "");
        need_numbers(reading, place_of(texts, language), look_up, text);
        if (k == 0) {
            first = std::move(text);
        } else if (!text.empty()) {
            translate(k - 1, std::move(text));
        }
    }
    for (const auto& [language, text] : value->items()) {
        if (std::ranges::find(look_up.languages, language) != look_up.languages.end()) continue;
        refuse(reading, place_of(texts, language),
               "a text in one of the lesson's \"languages\", which do not name this one", text);
    }
    return first;
}

Json json_of_languages(const std::string& text, const std::vector<std::string>& languages,
                       const std::function<std::string(std::size_t)>& translation) {
    Json texts = Json::object();
    for (std::size_t k = 1; k < languages.size(); ++k) {
        const std::string translated = translation(k - 1);
        if (translated.empty()) continue;
        if (texts.empty()) texts[languages[0]] = text;
        texts[languages[k]] = translated;
    }
    return texts.empty() ? Json(text) : texts;
}

LessonStep step_of(JsonObject& object, const LookUp& look_up) {
    LessonStep step;
    step.title = step_text(object, "title", look_up, step, &StepWords::title);
    step.text = step_text(object, "text", look_up, step, &StepWords::text);
    step.note = step_text(object, "note", look_up, step, &StepWords::note);
    step.source = text_field(object, "source", "");
    step.pattern = pattern_field(object, "pattern", look_up);
    step.partner = pattern_field(object, "partner", look_up);
    step.view = kLessonViews[choice_field(object, "view", 0, kLessonViews)];
    step.point_at = text_field(object, "point_at", "");
    Json unknown = Json::object();
    take_fields(object, step, unknown);
    if (object.value != nullptr && object.value->contains("question")) {
        JsonObject question = object_field(object, "question");
        step.question = question_of(question, look_up, step);
        const std::string needed = question_needs(step, look_up.set.vibrations.size());
        if (!needed.empty() && !look_up.is_draft)
            refuse(*question.reading, question.place, needed, *question.value);
        note_unknown(unknown, "question", unknown_fields(question));
    }
    unknown.update(unknown_fields(object));
    if (!unknown.empty()) step.unknown_json = text_of_json(unknown);
    return step;
}

Json json_of(const LessonStep& step, const std::vector<std::string>& languages) {
    const auto in_languages = [&](const std::string& text, std::string StepWords::*translation) {
        return step_text_json(text, step, languages, translation);
    };
    Json fields = {{"title", in_languages(step.title, &StepWords::title)},
                   {"text", in_languages(step.text, &StepWords::text)}};
    const Json note = in_languages(step.note, &StepWords::note);
    if (note != "") fields["note"] = note;
    const auto add_text = [&fields](const char* key, const std::string& text) {
        if (!text.empty()) fields[key] = text;
    };
    add_text("source", step.source);
    add_text("pattern", step.pattern);
    add_text("partner", step.partner);
    if (step.view != kLessonViews[0]) fields["view"] = step.view;
    add_text("point_at", step.point_at);
    const LessonStep usual;
    put_fields(fields, step, &usual);
    if (step.question) fields["question"] = question_json(step, languages);
    restore(fields, step.unknown_json);
    return fields;
}

}  // namespace tact
