#include "devices/phone/phone_requests.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "devices/phone/phone_names.h"
#include "devices/phone/phone_values.h"

namespace tact {

namespace {

constexpr std::int64_t kMostSerial = std::int64_t{1} << 53;  // JavaScript counts so far exactly
constexpr std::int64_t kMostMs = 24 * 3600 * 1000;
constexpr std::size_t kMostLanguageBytes = 35;  // RFC 5646, 4.4.1

std::optional<BodyFields> fields_of(std::string_view body) {
    if (body.size() > kMostBodyBytes) return {};
    auto parsed = parse_json(body, "request");
    if (!parsed || !parsed->is_object()) return {};
    return BodyFields{*std::move(parsed)};
}

std::string language_of(const std::string& told) {
    const auto is_plain = [](char sign) {
        return (sign >= '0' && sign <= '9') || (sign >= 'A' && sign <= 'Z') ||
               (sign >= 'a' && sign <= 'z') || sign == '-';
    };
    return std::ranges::all_of(told, is_plain) ? told : std::string{};
}

void keep_whole(Json& answer, BodyFields& given, const char* key, std::int64_t most) {
    if (const auto value = given.whole(key, most)) answer[key] = *value;
}

void keep_plays(Json& answer, BodyFields& given) {
    const Json* plays = given.at("plays");
    if (plays == nullptr) return;
    given.is_sound = given.is_sound && plays->is_array() && plays->size() <= kMostPlaysTold;
    if (!given.is_sound) return;
    Json kept = Json::array();
    for (const Json& count : *plays) kept.push_back(given.whole_of(count, 1'000'000).value_or(0));
    answer["plays"] = std::move(kept);
}

void keep_similarity(Json& answer, BodyFields& given) {
    const Json* value = given.at("similarity");
    if (value == nullptr) return;
    const double similarity = value->is_number() ? value->get<double>() : -1.0;
    given.is_sound = given.is_sound && similarity >= 0.0 && similarity <= 100.0;
    if (given.is_sound) answer["similarity"] = *value;
}

// The answer with known keys alone, or nothing.
std::optional<std::string> checked_answer(const Json& value) {
    if (!value.is_object()) return {};
    BodyFields given{value};
    Json answer = Json::object();
    keep_whole(answer, given, "option", 1000);
    keep_whole(answer, given, "k", 100'000);
    keep_similarity(answer, given);
    keep_plays(answer, given);
    if (const std::string first = given.text("first", 5); !first.empty()) {
        given.is_sound = given.is_sound && (first == "left" || first == "right");
        answer["first"] = first;
    }
    keep_whole(answer, given, "response_ms", kMostMs);
    const bool says_something = answer.contains("option") || answer.contains("similarity");
    if (!given.is_sound || !says_something) return {};
    return text_of_json(answer);
}

}  // namespace

std::optional<JoinRequest> parse_join(std::string_view body) {
    auto fields = fields_of(body);
    if (!fields) return {};
    JoinRequest join;
    join.phone = fields->text("phone", kMostBodyBytes);
    if (!is_secret(join.phone)) join.phone.clear();
    join.nickname = cleaned_nickname(fields->text("nickname", kMostBodyBytes));
    join.vibrates = fields->yes_no("vibrates");
    join.language = language_of(fields->text("language", kMostLanguageBytes));
    return fields->is_sound ? std::optional(join) : std::nullopt;
}

std::optional<NextRequest> parse_next(std::string_view body) {
    auto fields = fields_of(body);
    if (!fields) return {};
    NextRequest next;
    next.phone = fields->text("phone", kSecretLength);
    next.card = fields->whole("card", kMostSerial).value_or(0);
    next.play = fields->whole("play", kMostSerial).value_or(0);
    return fields->is_sound && is_secret(next.phone) ? std::optional(next) : std::nullopt;
}

std::optional<TellRequest> parse_tell(std::string_view body) {
    auto fields = fields_of(body);
    if (!fields) return {};
    TellRequest tell;
    tell.phone = fields->text("phone", kSecretLength);
    tell.card = fields->text("card", kMostCardIdBytes);
    tell.played = fields->whole("played", kMostSerial);
    const Json* answer = fields->at("answer");
    if (!fields->is_sound || !is_secret(tell.phone)) return {};
    if (tell.played) return answer == nullptr ? std::optional(tell) : std::nullopt;
    const auto checked = answer != nullptr ? checked_answer(*answer) : std::nullopt;
    if (!checked || tell.card.empty()) return {};
    tell.answer = *checked;
    return tell;
}

}  // namespace tact
