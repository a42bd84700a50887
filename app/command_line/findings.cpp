// tactspace findings: what the publication found, checked on what this program predicts.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "assets/assets.h"
#include "model/findings.h"
#include "model/io/set_file.h"
#include "model/perceptual_model.h"

namespace tact {

namespace {

struct Predicted {
    PatternSet set;
    Prediction prediction;
};

// What a set shares with one predicted before is not computed again.
Expected<Predicted> predicted(const std::string& name, const FindingsCommand& command,
                              const Prediction* previous) {
    const std::string path = "sets/" + name + ".tactspace.json";
    Expected<PatternSet> set = parse_set(asset(path), path, {});
    if (!set) return set.error();
    PredictOptions options;
    options.threads = command.threads;
    options.previous = previous;
    options.progress = progress_line("comparing pairs of " + set->name);
    Prediction prediction = *predict(model_waveforms(*set), set->model, options);
    return Predicted{*std::move(set), std::move(prediction)};
}

Expected<KnownSets> known_sets(const FindingsCommand& command) {
    auto am_4hz = predicted(kAm4HzSet, command, nullptr);
    if (!am_4hz) return am_4hz.error();
    auto am_5hz = predicted(kAm5HzSet, command, &am_4hz->prediction);
    if (!am_5hz) return am_5hz.error();
    auto twelve = predicted(kTwelveSet, command, nullptr);
    if (!twelve) return twelve.error();
    return KnownSets{{am_4hz->set, am_4hz->prediction.pm},
                     {am_5hz->set, am_5hz->prediction.pm},
                     {twelve->set, twelve->prediction.pm}};
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

std::size_t count_of(const std::vector<Finding>& all, FindingStatus status) {
    return static_cast<std::size_t>(std::ranges::count(all, status, &Finding::status));
}

std::string text_of(const std::vector<Finding>& all) {
    std::string text;
    for (const Finding& finding : all) {
        text += finding.id + " " + word_of(finding.status) + " (" + finding.set + ", " +
                finding.source + ")\n    " + finding.claim + "\n    " + finding.evidence + "\n";
    }
    return text + "\n" + std::to_string(count_of(all, FindingStatus::holds)) + " hold, " +
           std::to_string(count_of(all, FindingStatus::fails)) + " fail; " +
           std::to_string(count_of(all, FindingStatus::needs_ratings)) + " need ratings and " +
           std::to_string(count_of(all, FindingStatus::needs_stimuli)) +
           " need exact stimuli that are not public\n";
}

nlohmann::json json_of(const std::vector<Finding>& all) {
    nlohmann::json list = nlohmann::json::array();
    for (const Finding& finding : all) {
        list.push_back({{"id", finding.id},
                        {"set", finding.set},
                        {"claim", finding.claim},
                        {"source", finding.source},
                        {"status", word_of(finding.status)},
                        {"evidence", finding.evidence}});
    }
    return list;
}

}  // namespace

Expected<Done> run(const FindingsCommand& command) {
    const Expected<KnownSets> sets = known_sets(command);
    if (!sets) return sets.error();
    const std::vector<Finding> all = findings(*sets);
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.json ? json_of(all).dump() + "\n" : text_of(all));
    });
}

}  // namespace tact
