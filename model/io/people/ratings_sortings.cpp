// Ratings from patterns that people sorted into groups, with a line a sorted pattern.
#include <map>
#include <unordered_map>
#include <utility>

#include "model/io/people/ratings_text.h"
#include "model/study/cluster_sorting.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

struct SortingColumns {
    std::optional<std::size_t> participant, round, group, pattern;
    MarkColumns marks;
};

SortingColumns sorting_columns(const CsvRecord& head) {
    SortingColumns columns;
    columns.marks = mark_columns(head);
    find_columns(head, {{"participant", &columns.participant},
                        {"round", &columns.round},
                        {"group", &columns.group},
                        {"pattern", &columns.pattern}});
    return columns;
}

using Round = std::vector<std::pair<std::size_t, std::string>>;  // pattern and group

struct Sorter {
    std::string name;
    std::map<std::string, Round> counted;
    std::map<std::string, Round> excluded;
    MarkedAnswers marks;
};

struct Sorters {
    std::vector<std::string> labels;
    std::unordered_map<std::string, std::size_t> place;
    std::vector<Sorter> people;
    std::unordered_map<std::string, std::size_t> place_of_person;
    std::string fingerprint;
};

// One line; what is wrong with it, or empty.
std::string take_sorted(Sorters& sorters, const SortingColumns& columns,
                        const std::vector<std::string>& fields) {
    const std::string label{trimmed(fields[*columns.pattern])};
    const std::string round{trimmed(fields[*columns.round])};
    const std::string group{trimmed(fields[*columns.group])};
    if (label.empty() || round.empty() || group.empty()) {
        return "expected a round, a group and the name of a pattern";
    }
    const Expected<Marks> marks = marks_in(columns.marks, fields);
    if (!marks) return marks.error().message;
    const auto [entry, is_new] = sorters.place.emplace(label, sorters.labels.size());
    if (is_new) sorters.labels.push_back(label);
    if (sorters.labels.size() > kMaxRatedPatterns) return "expected at most 500 patterns";
    const std::string name{columns.participant ? trimmed(fields[*columns.participant]) : ""};
    for (const std::string& one : {label, name}) {
        if (std::string fault = name_fault(one); !fault.empty()) return fault;
    }
    const auto [who, is_another] = sorters.place_of_person.emplace(name, sorters.people.size());
    if (is_another) sorters.people.push_back({name, {}, {}, {}});
    if (sorters.people.size() > kMaxParticipants) return "expected at most 1,000 participants";
    Sorter& sorter = sorters.people[who->second];
    note_marks(sorter.marks, *marks);
    if (sorters.fingerprint.empty()) sorters.fingerprint = marks->fingerprint;
    if (marks->rehearsal || !marks->whole) return {};
    auto& rounds = marks->excluded ? sorter.excluded : sorter.counted;
    rounds[round].emplace_back(entry->second, group);
    if (rounds.size() > kMaxPasses) return "expected at most 100 rounds of a participant";
    return {};
}

Judgement judgement_of(const Sorter& sorter, std::size_t patterns) {
    std::vector<Sorting> sortings;
    for (const auto& [number, round] :
         sorter.marks.counted == 0 ? sorter.excluded : sorter.counted) {
        Sorting& sorting = sortings.emplace_back(patterns, kUnsorted);
        std::unordered_map<std::string, std::size_t> groups;
        for (const auto& [pattern, group] : round) {
            sorting[pattern] = groups.emplace(group, groups.size()).first->second;
        }
    }
    std::vector<double> condensed = sorting_dissimilarity(patterns, sortings).condensed;
    for (double& value : condensed) value *= 100.0;  // as the ratings of pairs
    return {sorter.name, std::move(condensed)};
}

}  // namespace

Expected<RatingsText> ratings_of_sortings(const std::string& file,
                                          const std::vector<CsvRecord>& records,
                                          std::size_t text_bytes) {
    const CsvRecord& head = records.front();
    const SortingColumns columns = sorting_columns(head);
    if (const std::string fault = column_fault(head); !fault.empty()) {
        return Error{file + ":" + std::to_string(head.line) + ": " + fault};
    }
    Sorters sorters;
    for (std::size_t k = 1; k < records.size(); ++k) {
        const auto& fields = records[k].fields;
        std::string fault = "expected " + std::to_string(head.fields.size()) + " fields, got " +
                            std::to_string(fields.size());
        if (!columns.round || !columns.group || !columns.pattern) {
            fault = "expected the columns round, group and pattern";
        } else if (fields.size() == head.fields.size()) {
            fault = take_sorted(sorters, columns, fields);
        }
        if (!fault.empty()) {
            return Error{file + ":" + std::to_string(records[k].line) + ": " + fault};
        }
    }
    RatingsText text;
    text.file = file;
    text.study.labels = sorters.labels;
    text.study.fingerprint = sorters.fingerprint;
    text.scale = RatingScale::dissimilarity;
    const std::string fault =
        passes_fault(sorters.people.size(), sorters.labels.size(), text_bytes);
    if (!fault.empty()) return Error{file + ": " + fault};
    for (const Sorter& sorter : sorters.people) {
        text.study.judgements.push_back(judgement_of(sorter, sorters.labels.size()));
        note_standing(text, sorter.name, sorter.marks);
    }
    return text;
}

}  // namespace tact
