// tactspace findings: what the publication found, checked on what this program predicts.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/compare/check_findings.h"

namespace tact {

namespace {

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
    CheckOptions options;
    options.threads = command.threads;
    options.progress_of = [](const std::string& set) {
        return progress_line("comparing pairs of " + set);
    };
    const std::vector<Finding> all = *check_findings(options);
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.json ? json_of(all).dump() + "\n" : text_of(all));
    });
}

}  // namespace tact
