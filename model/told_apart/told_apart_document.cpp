#include "model/told_apart/told_apart_document.h"

#include <nlohmann/json.hpp>

#include "model/text/csv.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/told_apart/told_apart_words.h"

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

}  // namespace tact
