// tactspace report: one page about a set, to be sent.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/document/workspace.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "model/subset/set_subset.h"
#include "model/tasks/set_report.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

// What pairs are held against, in words; a number or a pair that was given, or the picked ones.
Expected<CloserThan> given_closer_than(const ReportCommand& command, const PatternSet& set,
                                       SetReportRequest& request) {
    const std::string& given = command.confused_at;
    if (given.empty()) return CloserThan{};
    if (const auto number = finite_number_in(given)) {
        if (*number < 0.0) return Error{"--closer-than: expected a PM of 0 or more"};
        request.closer_than = *number;
        return CloserThan{*number, "PM " + significant_digits(*number, 4),
                          "a value that was given"};
    }
    const auto pair = pair_of(set, "--closer-than", given);
    if (!pair) return pair.error();
    request.closer_than_pair = {pair->a, pair->b};
    const std::string names = set.vibrations[pair->a].name + " and " + set.vibrations[pair->b].name;
    return CloserThan{0.0, names, "as far apart as " + names + ", a pair that was given"};
}

SetReportRequest request_of(const ReportCommand& command, std::stop_token stop) {
    SetReportRequest request;
    if (command.count) request.count = static_cast<std::size_t>(*command.count);
    request.picks_unfelt = command.include_unfelt;
    request.draws = static_cast<std::size_t>(command.draws);
    request.threads = command.common.threads;
    request.stop = std::move(stop);
    request.comparing = progress_line("comparing patterns");
    request.picking.time_limit_s = command.time_limit_s;
    tell_search(request.picking, "picking", SubsetObjective::max_min);
    request.drawing = progress_line("drawing models");
    return request;
}

struct ReportAnswer {
    SetReport report;
    CloserThan closer_than;
};

Expected<ReportAnswer> answer_of(const ReportCommand& command, const FeltSet& sets,
                                 std::stop_token stop) {
    SetReportRequest request = request_of(command, std::move(stop));
    Expected<CloserThan> than = given_closer_than(command, sets.meant, request);
    if (!than) return than.error();
    auto report = set_report(sets.meant, sets.felt, request);
    if (!report) return Error{"stopped before the report was made"};
    if (!report->fault.empty()) return unpickable(Error{report->fault}, report->left_out.size());
    if (command.confused_at.empty()) than = closer_than_picked(report->subset);
    than->dissimilarity = report->closer_than;
    return ReportAnswer{*std::move(report), *std::move(than)};
}

std::string text_of(const CloseGroups& close, const std::vector<std::string>& names) {
    std::string text;
    for (const CloseGroup& group : close.groups) {
        text += "\n";
        for (const std::size_t place : group.members) text += names[place] + "\n";
    }
    return text;
}

std::string text_of(const ReportAnswer& answer, const std::vector<std::string>& names) {
    const AlikePatterns& alike = answer.report.alike;
    const std::string pairs =
        " of " + grouped_digits(answer.report.pairs.apart.condensed.size()) + " pairs";
    const CloserThan& than = answer.closer_than;
    return "the same, within a felt step: " + grouped_digits(alike.confused.pairs) + pairs + "\n" +
           text_of(alike.confused, names) + "\ncloser than " + shown_text(than.words) +
           ", below PM " + significant_digits(than.dissimilarity, 6) + ", " + than.source + ": " +
           grouped_digits(alike.closer.pairs) + pairs + "\n" + text_of(alike.closer, names);
}

}  // namespace

Expected<Done> run(const ReportCommand& command) {
    const Interrupt interrupt;
    if (const auto writable = writable_result(command.out); !writable) return writable.error();
    Expected<FeltSet> sets = load_felt(command.common);
    if (!sets) return sets.error();
    if (const auto pair = need_a_pair(sets->meant, command.common); !pair) return pair.error();
    give_looks(sets->meant);
    const Expected<ReportAnswer> answer = answer_of(command, *sets, interrupt.token());
    if (!answer) return answer.error();
    const SetReport& told = answer->report;
    Report report{.set = sets->meant,
                  .felt = sets->felt,
                  .dissimilarity = told.pairs.apart,
                  .answer = told.subset,
                  .space = told.space,
                  .alike = told.alike,
                  .unfelt = told.pairs.unfelt,
                  .left_out = left_out_words(told.left_out.size()),
                  .closer_than = answer->closer_than,
                  .by = sets->labels.by,
                  .program = kProgramVersion,
                  .date = utc_today()};
    if (told.stability) report.stability = &*told.stability;
    report.labels = lines_of(sets->labels);
    if (const auto written = write_atomically(command.out, report_page(report)); !written) {
        return written;
    }
    std::cerr << "tactspace: wrote " << command.out.string() << "\n";
    const std::vector<std::string> names = names_of(sets->meant);
    return write_result({}, [&](std::ostream& stream) {
        if (command.common.json) {
            nlohmann::json json = json_of(told, sets->meant);
            json["closer_than"] = answer->closer_than.words;
            json["closer_source"] = answer->closer_than.source;
            add_labels(json, sets->labels);
            stream << text_of_json(json) << "\n";
        } else {
            stream << text_of(sets->labels) << text_of(*answer, shown_texts(names));
        }
    });
}

}  // namespace tact
