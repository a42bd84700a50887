#include "model/io/set/study_json.h"

#include "model/study/study_numbers.h"
#include "model/text/described_json.h"

namespace tact {

namespace {

// The default when files left it out.
constexpr int kOnceUsualAttentionPairs = 1;

}  // namespace

StudyDesign study_design_of(JsonObject& object, Json& unknown) {
    StudyDesign design;
    // Files that do not say how many are older than the present default, or have no study yet.
    if (object.value != nullptr) design.attention_pairs = kOnceUsualAttentionPairs;
    take_fields(object, design, unknown);
    unknown.update(unknown_fields(object));
    return design;
}

Json json_of(const StudyDesign& design) {
    const StudyDesign standard;
    Json fields = Json::object();
    if (design != standard) put_fields(fields, design, &standard);
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
