#include "model/told_apart/told_apart_document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>

#include "model/common/fingerprint.h"
#include "model/text/csv.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "model/told_apart/told_apart_results.h"

namespace tact {

namespace {

constexpr const char* kSaid[] = {"too few trials", "unclear", "below all asked", "above all asked",
                                 "found"};

Json threshold_document(const ToldApartResults& results) {
    Json json = {{"said", kSaid[static_cast<std::size_t>(results.said)]},
                 {"share_right", kToldApartShare}};
    if (results.said == ThresholdSaid::too_few) return json;
    json["pm"] = results.threshold_pm;
    json["low_pm"] = results.threshold.low;
    json["high_pm"] = results.threshold.high;
    json["smallest_asked_pm"] = results.asked_pm.low;
    json["largest_asked_pm"] = results.asked_pm.high;
    return json;
}

Json document_of(const ToldApartPair& pair) {
    return {{"a", pair.a},
            {"b", pair.b},
            {"pm", pair.pm},
            {"trials", pair.trials},
            {"right", pair.right},
            {"share_right", static_cast<double>(pair.right) / static_cast<double>(pair.trials)},
            {"share_right_low", pair.interval.low},
            {"share_right_high", pair.interval.high},
            {"predicted_share_right", pair.predicted.share},
            {"predicted_share_right_low", pair.predicted.interval.low},
            {"predicted_share_right_high", pair.predicted.interval.high}};
}

std::string csv_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : guarded(text))
        quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + "\"";
}

}  // namespace

Json told_apart_document(const ToldApart& told, const ToldApartResults& results) {
    Json document = {{"measured_on", kMeasuredOn}, {"synthetic", told.synthetic},
                     {"device", told.device},      {"person", told.person},
                     {"date", told.date},          {"trials", results.trials},
                     {"right", results.right},     {"guess_share_right", kOddGuess}};
    if (results.trials > 0) {
        document["share_right"] =
            static_cast<double>(results.right) / static_cast<double>(results.trials);
        document["share_right_low"] = results.interval.low;
        document["share_right_high"] = results.interval.high;
    }
    document["threshold"] = threshold_document(results);
    document["words"] = {share_words(results), threshold_words(results)};
    document["pairs"] = Json::array();
    for (const ToldApartPair& pair : results.pairs) document["pairs"].push_back(document_of(pair));
    return document;
}

std::string told_apart_csv(const ToldApart& told) {
    std::string text =
        "measured_on,synthetic,device,person,date,trial,a,b,pm,odd_place,odd_one,answer,right,"
        "response_s\n";
    const std::string whose = csv_text(kMeasuredOn) + (told.synthetic ? ",1," : ",0,") +
                              csv_text(told.device) + "," + csv_text(told.person) + "," +
                              csv_text(told.date) + ",";
    for (std::size_t k = 0; k < told.answers.size(); ++k) {
        const auto& [trial, place, response_s] = told.answers[k];
        text += whose + std::to_string(k + 1) + "," + csv_text(trial.a) + "," + csv_text(trial.b) +
                "," + shortest_digits(trial.pm) + "," + std::to_string(trial.odd_place + 1) + "," +
                csv_text(trial.odd_is_b ? trial.b : trial.a) + "," + std::to_string(place + 1) +
                (told.answers[k].is_right() ? ",1," : ",0,") + shortest_digits(response_s) + "\n";
    }
    return text;
}

namespace {

constexpr std::array kOddOnes{"a", "b"};
constexpr std::array kMeasuredOnWords{kMeasuredOn};
constexpr Range kPlace{1, 3};

void fault_at(JsonReading& reading, const std::string& place, const std::string& what) {
    if (reading.fault.empty()) reading.fault = reading.file + ": " + place + ": " + what;
}

// What nobody can guess has to be there.
void need(JsonObject& object, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (field(object, key) != nullptr) continue;
        fault_at(*object.reading, object.place, "expected \"" + std::string(key) + "\", got none");
    }
}

std::uint64_t trial_seed_of(JsonObject& object) {
    constexpr int kHexadecimal = 16;
    constexpr std::size_t kDigits = 16;
    const std::string text = text_field(object, "seed", fingerprint_text(std::uint64_t{1}));
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [read, fault] = std::from_chars(text.data(), end, seed, kHexadecimal);
    if (text.size() != kDigits || fault != std::errc{} || read != end) {
        refuse(*object.reading, place_of(object, "seed"), "16 hexadecimal digits", text);
    }
    return seed;
}

std::vector<std::string> names_in(JsonObject& object, const char* key) {
    std::vector<std::string> names;
    const auto elements = array_field(object, key, 0, std::size_t{2} * limits::kMostOddTrials);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const std::string place = place_of(object, key) + "/" + std::to_string(k);
        names.push_back(name_at(*object.reading, *elements[k], place));
    }
    return names;
}

// Names that differ, and a version for each.
void read_asked_patterns(JsonObject& object, ToldApart& told) {
    told.patterns = names_in(object, "patterns");
    told.versions = names_in(object, "versions");
    if (const auto equal = first_equal(told.patterns)) {
        fault_at(*object.reading,
                 place_of(object, "patterns") + "/" + std::to_string(equal->second),
                 "expected names that differ, got " + in_quotes(told.patterns[equal->second]) +
                     " twice");
    }
    if (told.versions.size() == told.patterns.size()) return;
    fault_at(*object.reading, place_of(object, "versions"),
             "expected a version for each of " + grouped_digits(told.patterns.size()) +
                 " patterns, got " + grouped_digits(told.versions.size()));
}

std::string asked_name(JsonObject& object, const char* key, const ToldApart& told) {
    std::string name = name_field(object, key, "");
    if (std::ranges::find(told.patterns, name) == told.patterns.end()) {
        refuse(*object.reading, place_of(object, key), "a name among the patterns of the trials",
               name);
    }
    return name;
}

OddAnswer odd_answer_of(JsonObject& object, const ToldApart& told) {
    need(object, {"a", "b", "pm", "odd_one", "odd_place", "answer"});
    OddAnswer answer;
    answer.trial.a = asked_name(object, "a", told);
    answer.trial.b = asked_name(object, "b", told);
    if (answer.trial.a == answer.trial.b) {
        refuse(*object.reading, place_of(object, "b"), "another pattern than a", answer.trial.b);
    }
    answer.trial.pm = number_field(object, "pm", 0.0, limits::kAskedPm);
    answer.trial.odd_is_b = choice_field(object, "odd_one", 0, kOddOnes) == 1;
    answer.trial.odd_place = whole_field(object, "odd_place", 1, kPlace) - 1;
    answer.place = whole_field(object, "answer", 1, kPlace) - 1;
    answer.response_s = number_field(object, "response_s", 0.0, limits::kOddResponseS);
    return answer;
}

ToldApart told_apart_in(JsonObject& object) {
    ToldApart told;
    Json unknown = Json::object();
    choice_field(object, "measured_on", 0, kMeasuredOnWords);
    told.device = name_field(object, "device", "");
    told.person = name_field(object, "person", "");
    told.date = name_field(object, "date", "");
    told.seed = trial_seed_of(object);
    told.synthetic = yes_no_field(object, "synthetic", false);
    read_asked_patterns(object, told);
    read_objects(
        object, "trials", 0, limits::kMostOddTrials, unknown,
        [&told](JsonObject& trial, Json&) { told.answers.push_back(odd_answer_of(trial, told)); });
    unknown.update(unknown_fields(object));
    if (!unknown.empty()) told.unknown_json = text_of_json(unknown);
    return told;
}

Json json_of(const OddAnswer& answer) {
    const OddOneOut& trial = answer.trial;
    Json fields = {{"a", trial.a},
                   {"b", trial.b},
                   {"pm", trial.pm},
                   {"odd_one", kOddOnes[trial.odd_is_b ? 1 : 0]},
                   {"odd_place", trial.odd_place + 1},
                   {"answer", answer.place + 1}};
    if (answer.response_s != 0.0) fields["response_s"] = answer.response_s;
    return fields;
}

}  // namespace

std::vector<ToldApart> told_apart_field(JsonObject& object) {
    std::vector<ToldApart> all;
    const auto elements = array_field(object, "told_apart", 0, limits::kMostToldApart);
    for (std::size_t k = 0; k < elements.size() && may_go_on(*object.reading); ++k) {
        JsonObject one = object_at(*object.reading, *elements[k],
                                   place_of(object, "told_apart") + "/" + std::to_string(k));
        all.push_back(told_apart_in(one));
    }
    return all;
}

Json json_of(const ToldApart& told) {
    Json fields = {{"measured_on", kMeasuredOn},
                   {"device", told.device},
                   {"person", told.person},
                   {"date", told.date},
                   {"seed", fingerprint_text(told.seed)}};
    if (told.synthetic) fields["synthetic"] = true;
    fields["patterns"] = told.patterns;
    fields["versions"] = told.versions;
    fields["trials"] = Json::array();
    for (const OddAnswer& answer : told.answers) fields["trials"].push_back(json_of(answer));
    const Json unknown = kept_json(told.unknown_json);
    if (unknown.is_object()) restore_unknown(fields, unknown);
    return fields;
}

}  // namespace tact
