#include "app/compare/check_findings.h"

#include <cassert>
#include <utility>

#include "assets/assets.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/set_waveforms.h"

namespace tact {

namespace {

struct Predicted {
    PatternSet set;
    Prediction prediction;
};

// A set reuses the matrices of a set predicted before if it shares them.
std::optional<Predicted> predicted(const std::string& name, const CheckOptions& check,
                                   const Prediction* previous) {
    const std::string path = "sets/" + name + ".tactspace.json";
    Expected<PatternSet> set = parse_set(asset(path), path, {});
    assert(set && "a compiled-in set does not parse");
    PredictOptions options;
    options.threads = check.threads;
    options.previous = previous;
    options.stop = check.stop;
    if (check.progress_of) options.progress = check.progress_of(set->name);
    auto prediction =
        predict(own_waveforms(*set, options.threads), check.model.value_or(set->model), options);
    if (!prediction) return std::nullopt;
    return Predicted{*std::move(set), *std::move(prediction)};
}

}  // namespace

std::optional<std::vector<Finding>> check_findings(const CheckOptions& options) {
    const auto am_4hz = predicted(kAm4HzSet, options, nullptr);
    if (!am_4hz) return std::nullopt;
    const auto am_5hz = predicted(kAm5HzSet, options, &am_4hz->prediction);
    if (!am_5hz) return std::nullopt;
    const auto twelve = predicted(kTwelveSet, options, nullptr);
    if (!twelve) return std::nullopt;
    return findings({{am_4hz->set, am_4hz->prediction.pm},
                     {am_5hz->set, am_5hz->prediction.pm},
                     {twelve->set, twelve->prediction.pm}});
}

const char* word_of(FindingStatus status) {
    switch (status) {
        case FindingStatus::holds:
            return "holds";
        case FindingStatus::fails:
            return "fails";
        case FindingStatus::needs_ratings:
            return "needs ratings";
        case FindingStatus::needs_stimuli:
            return "needs stimuli";
    }
    return "";
}

}  // namespace tact
