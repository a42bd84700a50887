#include "app/phones/phones.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/text/json_fields.h"

namespace tact {

namespace {

constexpr int kMostPlays = 10'000;          // of one side of a trial: a hand does no more
constexpr double kLongestAnswerMs = 864e5;  // a day

std::string text_of_card(Json card) { return text_of_json(card); }

std::optional<Json> object_of(const std::string& text) {
    Json value = Json::parse(text, nullptr, false);
    if (value.is_discarded() || !value.is_object()) return std::nullopt;
    return value;
}

std::optional<double> number_of(const Json& object, const char* key, Range range) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    if (!(value >= range.low && value <= range.high)) return std::nullopt;
    return value;
}

std::optional<int> whole_of(const Json& object, const char* key, Range range) {
    const auto value = number_of(object, key, range);
    if (!value || std::floor(*value) != *value) return std::nullopt;
    return static_cast<int>(*value);
}

// How often each of `count` was felt whole; none unless all were.
std::optional<std::vector<int>> plays_of(const Json& object, std::size_t count) {
    const auto plays = object.find("plays");
    if (plays == object.end() || !plays->is_array() || plays->size() != count) return std::nullopt;
    std::vector<int> times;
    for (const Json& one : *plays) {
        const auto felt = whole_of({{"felt", one}}, "felt", {1.0, kMostPlays});
        if (!felt) return std::nullopt;
        times.push_back(*felt);
    }
    return times;
}

}  // namespace

std::string wait_card() { return R"({"kind":"wait"})"; }

std::string feel_card(std::span<const PhonePattern> patterns) {
    Json list = Json::array();
    for (const PhonePattern& one : patterns) {
        list.push_back({{"name", one.name}, {"ms", one.ms}, {"loss", one.loss}});
    }
    return text_of_card({{"kind", "feel"}, {"patterns", std::move(list)}});
}

std::string card_of(const ChoiceCard& card) {
    Json json{{"kind", "choice"}, {"id", card.id}, {"ask", card.ask}, {"options", card.options}};
    if (!card.ms.empty()) json["ms"] = card.ms;
    if (card.mine) json["mine"] = *card.mine;
    if (card.revealed) {
        json["revealed"] = {{"right", card.right}, {"votes", card.votes}, {"text", card.reveal}};
    }
    return text_of_card(std::move(json));
}

std::optional<std::size_t> option_answered(const std::string& json, std::size_t options) {
    const auto answer = object_of(json);
    if (!answer || options == 0) return std::nullopt;
    const auto option = whole_of(*answer, "option", {0.0, static_cast<double>(options - 1)});
    return option ? std::optional(static_cast<std::size_t>(*option)) : std::nullopt;
}

std::string card_of(const TrialCard& card) {
    return text_of_card(
        {{"kind", "trial"}, {"id", card.id}, {"at", card.at}, {"of", card.of}, {"ms", card.ms}});
}

std::optional<PhoneTrial> trial_answered(const std::string& json) {
    const auto answer = object_of(json);
    if (!answer || !plays_of(*answer, 3)) return std::nullopt;
    const auto place = whole_of(*answer, "option", {0.0, 2.0});
    const auto response_ms = number_of(*answer, "response_ms", {0.0, kLongestAnswerMs});
    if (!place || !response_ms) return std::nullopt;
    return PhoneTrial{*place, 1e-3 * *response_ms};
}

std::string card_of(const RatingCard& card) {
    Json patterns = Json::array();
    for (const PhonePattern& one : card.patterns) patterns.push_back({{"ms", one.ms}});
    Json trials = Json::array();
    for (const Trial& trial : card.trials) {
        trials.push_back(Json::array({trial.left, trial.right}));
    }
    return text_of_card({{"kind", "rating"},
                         {"id", card.id},
                         {"patterns", std::move(patterns)},
                         {"trials", std::move(trials)},
                         {"done", card.done}});
}

std::optional<PhoneRating> rating_answered(const std::string& json) {
    const auto answer = object_of(json);
    if (!answer) return std::nullopt;
    const auto at = whole_of(*answer, "k", {0.0, 1e6});
    const auto similarity = number_of(*answer, "similarity", limits::kSimilarity);
    const auto response_ms = number_of(*answer, "response_ms", {0.0, kLongestAnswerMs});
    const auto plays = plays_of(*answer, 2);
    if (!at || !similarity || !response_ms || !plays) return std::nullopt;
    PhoneRating rating{static_cast<std::size_t>(*at), *similarity, (*plays)[0], (*plays)[1]};
    const auto first = answer->find("first");
    if (first != answer->end() && *first == "left") rating.first = FeltFirst::left;
    if (first != answer->end() && *first == "right") rating.first = FeltFirst::right;
    rating.response_s = 1e-3 * *response_ms;
    return rating;
}

std::string thanks_card(const std::string& text) {
    return text_of_card({{"kind", "thanks"}, {"text", text}});
}

}  // namespace tact
