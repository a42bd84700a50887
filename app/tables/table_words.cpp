#include "app/tables/parts.h"

#include <nlohmann/json.hpp>

#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

using nlohmann::json;

constexpr std::size_t kMostShapes = 100;
constexpr std::size_t kMostShapeBytes = 4096;

std::string shape_of(const TableHead& head) {
    std::string shape;
    if (head.rows.empty()) return shape;
    for (const std::string& cell : head.rows.front()) {
        shape += lower_case(std::string(trimmed(cell))) + '\n';
    }
    return shape;
}

std::string sign_of(const std::optional<char>& sign) { return sign ? std::string(1, *sign) : ""; }

// None: no such number is there.
template <class Choice>
std::optional<Choice> choice_in(const json& from, const char* name, Choice last) {
    const auto at = from.find(name);
    if (at == from.end() || !at->is_number_integer()) return std::nullopt;
    const auto number = at->get<std::int64_t>();
    if (number < 0 || number > static_cast<std::int64_t>(last)) return std::nullopt;
    return static_cast<Choice>(number);
}

void take_text(const json& from, const char* name, std::string& to) {
    const auto at = from.find(name);
    if (at != from.end() && at->is_string()) to = at->get<std::string>();
}

void take_sign(const json& from, const char* name, std::string_view known,
               std::optional<char>& to) {
    std::string text;
    take_text(from, name, text);
    if (text.size() == 1 && known.find(text[0]) != known.npos) to = text[0];
}

}  // namespace

std::string text_of(const TableWords& words) {
    const json columns = {{"a", words.answers.a},
                          {"b", words.answers.b},
                          {"rating", words.answers.rating},
                          {"participant", words.answers.participant},
                          {"time", words.axes.time},
                          {"x", words.axes.x},
                          {"y", words.axes.y},
                          {"z", words.axes.z}};
    json whole = {{"kind", static_cast<int>(words.kind)},
                  {"scale", static_cast<int>(words.scale)},
                  {"separator", sign_of(words.written.separator)},
                  {"decimal", sign_of(words.written.decimal)},
                  {"columns", columns}};
    if (words.time_unit) whole["time_unit"] = static_cast<int>(*words.time_unit);
    if (words.unit) whole["unit"] = static_cast<int>(*words.unit);
    return text_of_json(whole);
}

TableWords words_in(std::string_view text) {
    TableWords words;
    const json whole = kept_sorted_json(text);
    if (!whole.is_object()) return words;
    words.kind = choice_in(whole, "kind", TableKind::recording).value_or(words.kind);
    words.scale = choice_in(whole, "scale", RatingScale::similarity).value_or(words.scale);
    take_sign(whole, "separator", ",;\t ", words.written.separator);
    take_sign(whole, "decimal", ".,", words.written.decimal);
    words.time_unit = choice_in(whole, "time_unit", TimeUnit::ns);
    words.unit = choice_in(whole, "unit", AccelerationUnit::volt);
    const auto at = whole.find("columns");
    if (at == whole.end() || !at->is_object()) return words;
    take_text(*at, "a", words.answers.a);
    take_text(*at, "b", words.answers.b);
    take_text(*at, "rating", words.answers.rating);
    take_text(*at, "participant", words.answers.participant);
    take_text(*at, "time", words.axes.time);
    take_text(*at, "x", words.axes.x);
    take_text(*at, "y", words.axes.y);
    take_text(*at, "z", words.axes.z);
    return words;
}

TableWords remembered_words(const Session& session, const TableHead& head) {
    const auto at = session.table_words.find(shape_of(head));
    return at == session.table_words.end() ? TableWords{} : words_in(at->second);
}

void remember_words(Session& session, const TableHead& head, const TableWords& words) {
    const std::string shape = shape_of(head);
    if (shape.empty() || shape.size() > kMostShapeBytes) return;
    if (!session.table_words.contains(shape) && session.table_words.size() >= kMostShapes) {
        session.table_words.erase(session.table_words.begin());
    }
    session.table_words[shape] = text_of(words);
}

}  // namespace tact
