#include "model/io/studies_out/preregistration_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

constexpr const char* kOrders[] = {"full", "adaptive"};
constexpr Range kCount{0, 1e6};
constexpr Range kShare{0, 1};
constexpr Range kRho{-1, 1};
constexpr double kMostWidth = 1e3;  // half an interval, over few people

using ByResample = std::array<double, kResampledCount>;

Json json_of(const ByResample& values) {
    Json json = Json::object();
    for (std::size_t r = 0; r < kResampledCount; ++r) json[kResampledNames[r]] = values[r];
    return json;
}

// What is not known is null.
ByResample by_resample(JsonObject& object, const char* key, Range range) {
    JsonObject values = object_field(object, key);
    ByResample result{};
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        const Json* value = field(values, kResampledNames[r]);
        result[r] = value == nullptr || value->is_null()
                        ? std::nan("")
                        : number_field(values, kResampledNames[r], 0.0, range);
    }
    return result;
}

std::vector<std::string> texts_field(JsonObject& object, const char* key, std::size_t least) {
    std::vector<std::string> texts;
    for (const Json* value : array_field(object, key, least, limits::kMaxStudyPatterns)) {
        if (!value->is_string()) refuse(*object.reading, place_of(object, key), "texts", *value);
        texts.push_back(value->is_string() ? value->get<std::string>() : std::string());
    }
    return texts;
}

}  // namespace

Expected<Preregistration> parse_preregistration(std::string_view text, const std::string& file) {
    const Expected<Json> document = parse_json(text, file);
    if (!document) return document.error();
    JsonReading reading{file, {}, UnknownKeys::passed_over};
    JsonObject object = object_at(reading, *document, "");
    if (whole_field(object, "tactspace_preregistration", 0, {0, 1e9}) != kPreregistrationFormat) {
        refuse(
            reading, "/tactspace_preregistration", std::to_string(kPreregistrationFormat),
            document->is_object() ? document->value("tactspace_preregistration", Json()) : Json());
    }
    Preregistration plan;
    plan.date = text_field(object, "date", "");
    plan.program = text_field(object, "program", "");
    plan.set_name = text_field(object, "set", "");
    plan.set_fingerprint = text_field(object, "set_fingerprint", "");
    plan.model_fingerprint = text_field(object, "model_fingerprint", "");
    plan.patterns = texts_field(object, "patterns", 3);
    plan.people = static_cast<std::size_t>(whole_field(object, "people", 0, kCount));
    plan.pairs = static_cast<std::size_t>(whole_field(object, "pairs", 0, kCount));
    plan.repetitions = whole_field(object, "repetitions", 4, limits::kRepetitions);
    JsonObject attention = object_field(object, "attention");
    plan.attention_pairs =
        whole_field(attention, "pairs", kAttentionPairs, limits::kAttentionPairs);
    plan.attention.above = number_field(attention, "above", 80.0, limits::kSimilarity);
    plan.attention.failures_allowed = whole_field(attention, "failures_allowed", 0, {0, 100});
    plan.order = static_cast<StudyOrder>(choice_field(object, "order", 0, kOrders));
    plan.scaling = static_cast<RatingScaling>(choice_field(object, "scaling", 0, kScalingNames));
    plan.metric = text_field(object, "metric", "pm");
    plan.rival = text_field(object, "rival", "");
    JsonObject assumed = object_field(object, "assumed");
    plan.assumed = {number_field(assumed, "rho", 0.67, kRho),
                    number_field(assumed, "reliability", 0.4, kShare),
                    text_field(assumed, "source", "")};
    JsonObject expected = object_field(object, "expected");
    plan.expected.people = plan.people;
    plan.expected.rho = number_field(expected, "rho", 0.0, kRho);
    plan.expected.rho_rival = number_field(expected, "rho_rival", 0.0, kRho);
    plan.expected.half_width = by_resample(expected, "half_width", {0, kMostWidth});
    plan.expected.power = by_resample(expected, "power", kShare);
    if (!reading.fault.empty()) return Error{reading.fault};
    return plan;
}

std::string print_preregistration(const Preregistration& plan) {
    const Json document = {{"tactspace_preregistration", kPreregistrationFormat},
                           {"date", plan.date},
                           {"program", plan.program},
                           {"set", plan.set_name},
                           {"set_fingerprint", plan.set_fingerprint},
                           {"model_fingerprint", plan.model_fingerprint},
                           {"patterns", plan.patterns},
                           {"people", plan.people},
                           {"pairs", plan.pairs},
                           {"repetitions", plan.repetitions},
                           {"attention",
                            {{"pairs", plan.attention_pairs},
                             {"above", plan.attention.above},
                             {"failures_allowed", plan.attention.failures_allowed}}},
                           {"order", kOrders[static_cast<std::size_t>(plan.order)]},
                           {"scaling", kScalingNames[static_cast<std::size_t>(plan.scaling)]},
                           {"metric", plan.metric},
                           {"rival", plan.rival},
                           {"assumed",
                            {{"rho", plan.assumed.rho},
                             {"reliability", plan.assumed.reliability},
                             {"source", plan.assumed.source}}},
                           {"expected",
                            {{"rho", plan.expected.rho},
                             {"rho_rival", plan.expected.rho_rival},
                             {"half_width", json_of(plan.expected.half_width)},
                             {"power", json_of(plan.expected.power)}}},
                           {"hypotheses", hypotheses_of(plan)},
                           {"tests", tests_of(plan)},
                           {"exclusion_rules", exclusion_rules_of(plan)}};
    return text_of_json(document, 2) + "\n";
}

Expected<Preregistration> read_preregistration(const std::filesystem::path& path) {
    const Expected<std::string> text = read_text_file(path);
    if (!text) return text.error();
    return parse_preregistration(*text, path.string());
}

}  // namespace tact
