// tactspace groups: the patterns of a set in groups of alike ones.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "model/grouping/set_groups.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/subset/set_subset.h"
#include "model/tasks/set_pairs.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

using Names = std::vector<std::string>;

struct GroupsAnswer {
    PatternSet set;  // as it is meant
    Labels labels;
    NumberMark matrix_mark{};  // of the file of a matrix
    Dissimilarity dissimilarity;
    SetGroups groups;
    std::vector<PatternGroup> cut;
};

constexpr const char* kStoppedGrouping = "stopped before all patterns were compared";

// A matrix says nothing of what is felt: that is asked of the model, which takes a moment.
Expected<std::vector<std::size_t>> compare(const GroupsCommand& command, const PatternSet& felt,
                                           std::stop_token stop, GroupsAnswer& answer) {
    if (!command.matrix.empty()) {
        Expected<Dissimilarity> read = dissimilarities_in(command.matrix, names_of(answer.set),
                                                          command.written, &answer.matrix_mark);
        if (!read) return read.error();
        answer.dissimilarity = *std::move(read);
        auto unfelt = unfelt_in(felt, command.common.threads, std::move(stop));
        if (!unfelt) return Error{kStoppedGrouping};
        return *std::move(unfelt);
    }
    PairsRequest request;
    request.options.threads = command.common.threads;
    request.options.stop = std::move(stop);
    request.options.progress = progress_line("comparing patterns");
    auto pairs = set_pairs(felt, request);
    if (!pairs) return Error{kStoppedGrouping};
    answer.dissimilarity = std::move(pairs->apart);
    return std::move(pairs->unfelt);
}

Expected<GroupsAnswer> answered(const GroupsCommand& command, std::stop_token stop) {
    Expected<FeltSet> sets = load_felt(command.common);
    if (!sets) return sets.error();
    if (const auto pair = need_a_pair(sets->meant, command.common); !pair) return pair.error();
    GroupsAnswer answer;
    answer.set = std::move(sets->meant);
    answer.labels = std::move(sets->labels);
    const auto unfelt = compare(command, sets->felt, stop, answer);
    if (!unfelt) return unfelt.error();
    answer.groups = groups_of_set(answer.set, answer.dissimilarity, *unfelt);
    AskedGroups asked{{}, command.cut};
    if (command.count) asked.count = static_cast<std::size_t>(*command.count);
    const Expected<std::size_t> count = asked_group_count(answer.groups, asked);
    if (!count) return Error{"--count: " + count.error().message};
    answer.cut = groups_at(answer.groups, answer.dissimilarity, *count);
    return answer;
}

const char* quantity(const GroupsCommand& command) {
    return command.matrix.empty() ? "PM" : "dissimilarity";
}

std::string list_of(std::span<const std::size_t> places, const Names& names) {
    std::string text;
    for (const std::size_t place : places) text += (text.empty() ? " " : ", ") + names[place];
    return text;
}

std::string cut_text(const GroupsCommand& command, const GroupsAnswer& answer) {
    const auto [from, below] = cuts_of(answer.groups.tree, answer.cut.size());
    const std::string all = counted(answer.cut.size(), "group", "groups") + " of " +
                            counted(answer.groups.grouped.size(), "pattern", "patterns");
    const std::string range = std::isfinite(below) ? significant_digits(from, 6) + " to below " +
                                                         significant_digits(below, 6)
                                                   : significant_digits(from, 6) + " and above";
    return all + ", cut at " + quantity(command) + " " + range +
           " (mean of the pairs between two groups; average linkage)\n";
}

std::string text_of(const GroupsCommand& command, const GroupsAnswer& answer, const Names& names) {
    std::string text = cut_text(command, answer);
    if (std::isfinite(answer.groups.agreement)) {
        text += "the tree keeps the order of the pairs with rho " +
                fixed_digits(answer.groups.agreement, 2) + "\n";
    }
    for (const PatternGroup& group : answer.cut) {
        text += "\n" + names[group.central];
        if (group.members.size() > 1) {
            text += ", the most central of " + std::to_string(group.members.size()) +
                    "; farthest apart: " + names[group.far_a] + " and " + names[group.far_b] +
                    ", " + quantity(command) + " " + significant_digits(group.farthest, 6);
        }
        text += "\n ";
        text += list_of(group.members, names) + "\n";
    }
    if (!answer.groups.unfelt.empty()) {
        text += "\nnot felt, apart:" + list_of(answer.groups.unfelt, names) + "\n";
    }
    if (!answer.groups.dropped.empty()) {
        text += "\ndropped, apart:" + list_of(answer.groups.dropped, names) + "\n";
    }
    return text;
}

// The mark of the numbers stands above the names, as in matrices.
void write_table(std::ostream& stream, const GroupsAnswer& answer, const Names& names) {
    const std::string corner = corner_of(answer.labels);
    const std::string mark = corner.empty() ? corner_text(answer.matrix_mark) : corner;
    const Names head{mark.empty() ? "pattern" : mark, "group", "central"};
    stream << csv_row(head);
    for (std::size_t k = 0; k < answer.cut.size(); ++k) {
        for (const std::size_t place : answer.cut[k].members) {
            const Names cells{names[place], std::to_string(k + 1),
                              place == answer.cut[k].central ? "1" : "0"};
            stream << csv_row(cells);
        }
    }
    for (const std::size_t place : answer.groups.unfelt) {
        const Names cells{names[place], "not felt", "0"};
        stream << csv_row(cells);
    }
    for (const std::size_t place : answer.groups.dropped) {
        const Names cells{names[place], "dropped", "0"};
        stream << csv_row(cells);
    }
}

}  // namespace

Expected<Done> run(const GroupsCommand& command) {
    const Interrupt interrupt;
    for (const auto* out : {&command.out, &command.central}) {
        if (const auto writable = writable_result(*out); !writable) return writable.error();
    }
    const Expected<GroupsAnswer> answer = answered(command, interrupt.token());
    if (!answer) return answer.error();
    const Names names = names_of(answer->set);
    if (!command.central.empty()) {
        const PatternSet part = part_of(answer->set, standing_for(answer->set, answer->cut));
        if (const auto written = write_set_file(command.central, part); !written) return written;
    }
    if (!command.out.empty()) {
        const auto written = write_result(
            command.out, [&](std::ostream& stream) { write_table(stream, *answer, names); });
        if (!written) return written;
    }
    const std::string mark = corner_text(answer->matrix_mark);
    return write_result({}, [&](std::ostream& stream) {
        if (command.common.json) {
            nlohmann::json json = json_of(answer->groups, answer->cut, names);
            add_labels(json, answer->labels);
            if (!mark.empty()) json["mark"] = mark;
            stream << text_of_json(json) << "\n";
        } else {
            if (!mark.empty()) stream << mark << "\n";
            stream << text_of(answer->labels) << text_of(command, *answer, shown_texts(names));
        }
    });
}

}  // namespace tact
