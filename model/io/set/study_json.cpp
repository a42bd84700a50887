#include "model/io/set/study_json.h"

#include <nlohmann/json.hpp>

namespace tact {

namespace {

// The default when files left it out.
constexpr int kOnceUsualAttentionPairs = 1;

constexpr const char* kOrders[] = {"full", "adaptive"};

std::vector<std::string> names_field(JsonObject& object, std::string_view key) {
    std::vector<std::string> names;
    const auto elements = array_field(object, key, 0, limits::kMaxStudyPatterns);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        names.push_back(name_at(*object.reading, *elements[k],
                                place_of(object, key) + "/" + std::to_string(k)));
    }
    return names;
}

std::vector<int> groups_field(JsonObject& object) {
    std::vector<int> groups;
    const auto elements = array_field(object, "groups", 0, limits::kMaxRounds);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const std::string place = place_of(object, "groups") + "/" + std::to_string(k);
        groups.push_back(
            static_cast<int>(number_at(*object.reading, *elements[k], place, limits::kGroups)));
    }
    return groups;
}

AttentionRule attention_of(JsonObject& object, Json& unknown) {
    JsonObject fields = object_field(object, "attention");
    AttentionRule rule;
    rule.above = number_field(fields, "above", rule.above, limits::kSimilarity);
    rule.failures_allowed =
        whole_field(fields, "failures_allowed", rule.failures_allowed, limits::kAttentionPairs);
    note_unknown(unknown, "attention", unknown_fields(fields));
    return rule;
}

}  // namespace

StudyDesign study_design_of(JsonObject& object, Json& unknown) {
    StudyDesign design;
    design.patterns = names_field(object, "patterns");
    design.repetitions =
        whole_field(object, "repetitions", design.repetitions, limits::kRepetitions);
    // Files that do not say how many are older than the present default, or have no study yet.
    const int unsaid = object.value == nullptr ? design.attention_pairs : kOnceUsualAttentionPairs;
    design.attention_pairs =
        whole_field(object, "attention_pairs", unsaid, limits::kAttentionPairs);
    design.seed = whole_field(object, "seed", design.seed, limits::kStudySeed);
    design.order = static_cast<StudyOrder>(choice_field(object, "order", 0, kOrders));
    design.gap_s = number_field(object, "gap_s", design.gap_s, limits::kPauseS);
    design.rest_s = number_field(object, "rest_s", design.rest_s, limits::kPauseS);
    design.break_every =
        whole_field(object, "break_every", design.break_every, limits::kBreakEvery);
    design.masking = number_field(object, "masking", design.masking, {0.0, 1.0});
    design.headphones = name_field(object, "headphones", "");
    design.attention = attention_of(object, unknown);
    design.instructions = text_field(object, "instructions", "");
    design.consent = text_field(object, "consent", "");
    design.groups = groups_field(object);
    unknown.update(unknown_fields(object));
    return design;
}

Json json_of(const StudyDesign& design) {
    const StudyDesign standard;
    Json fields = Json::object();
    const auto note = [&fields](const char* key, const auto& value, const auto& fallback) {
        if (value != fallback) fields[key] = value;
    };
    note("patterns", design.patterns, standard.patterns);
    note("repetitions", design.repetitions, standard.repetitions);
    note("seed", design.seed, standard.seed);
    if (design.order != standard.order) {
        fields["order"] = kOrders[static_cast<std::size_t>(design.order)];
    }
    note("gap_s", design.gap_s, standard.gap_s);
    note("rest_s", design.rest_s, standard.rest_s);
    note("break_every", design.break_every, standard.break_every);
    note("masking", design.masking, standard.masking);
    note("headphones", design.headphones, standard.headphones);
    if (design.attention != standard.attention) {
        fields["attention"] = {{"above", design.attention.above},
                               {"failures_allowed", design.attention.failures_allowed}};
    }
    note("instructions", design.instructions, standard.instructions);
    note("consent", design.consent, standard.consent);
    note("groups", design.groups, standard.groups);
    if (design != standard) fields["attention_pairs"] = design.attention_pairs;
    return fields;
}

FeltSteps felt_steps_of(JsonObject& object, Json& unknown) {
    FeltSteps steps;
    for (std::size_t k = 0; k < steps.size.size(); ++k) {
        const PatternParameter parameter = kPatternParameters[k];
        steps.size[k] =
            number_field(object, traits(parameter).key, steps.size[k], step_range(parameter));
    }
    unknown.update(unknown_fields(object));
    return steps;
}

Json json_of(const FeltSteps& steps) {
    Json json = Json::object();
    const FeltSteps usual;
    for (std::size_t k = 0; k < steps.size.size(); ++k) {
        if (steps.size[k] == usual.size[k]) continue;
        json[traits(kPatternParameters[k]).key] = steps.size[k];
    }
    return json;
}

}  // namespace tact
