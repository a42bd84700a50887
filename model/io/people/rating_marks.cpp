// Which answers count, as the columns of a file with a line an answer say.
#include <algorithm>
#include <array>
#include <string_view>

#include "model/io/people/ratings_text.h"
#include "model/study/who_counts.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Also as R and Python write them.
std::optional<bool> yes_no_in(const std::string& field) {
    constexpr std::array kYes{"1", "TRUE", "True", "true", "yes"};
    constexpr std::array kNo{"", "0", "FALSE", "False", "false", "no", "NA"};
    const std::string text{trimmed(field)};
    if (std::ranges::find(kYes, text) != kYes.end()) return true;
    if (std::ranges::find(kNo, text) != kNo.end()) return false;
    return std::nullopt;
}

}  // namespace

MarkColumns mark_columns(const CsvRecord& head) {
    MarkColumns columns;
    find_columns(head, {{"excluded", &columns.excluded},
                        {"synthetic", &columns.synthetic},
                        {"rehearsal", &columns.rehearsal},
                        {"whole", &columns.whole},
                        {"why", &columns.why},
                        {"fingerprint", &columns.fingerprint}});
    return columns;
}

std::string column_fault(const CsvRecord& head) {
    constexpr std::array<std::string_view, 7> kKnown{
        "participant", "excluded", "synthetic", "rehearsal", "whole", "fingerprint", "attention"};
    const auto has = [&head](std::string_view name) {
        return std::ranges::any_of(head.fields, [name](const std::string& cell) {
            return std::string_view(trimmed(cell)) == name;
        });
    };
    for (const std::string& cell : head.fields) {
        const std::string name{trimmed(cell)};
        const auto nearest = misspelt(name, kKnown);
        if (!nearest || has(*nearest)) continue;
        return "does not know the column " + in_quotes(name) + "; the nearest column is " +
               in_quotes(std::string(*nearest));
    }
    return {};
}

Expected<Marks> marks_in(const MarkColumns& columns, const std::vector<std::string>& fields) {
    Marks marks;
    std::string fault;
    const auto take = [&](std::optional<std::size_t> column, const char* name, bool& into) {
        if (!column || trimmed(fields[*column]).empty()) return;
        const std::optional<bool> value = yes_no_in(fields[*column]);
        if (!value) {
            fault = std::string("expected 0 or 1 in the column ") + name + ", got " +
                    in_quotes(fields[*column]);
            return;
        }
        into = *value;
    };
    take(columns.excluded, "excluded", marks.excluded);
    take(columns.synthetic, "synthetic", marks.synthetic);
    take(columns.rehearsal, "rehearsal", marks.rehearsal);
    take(columns.whole, "whole", marks.whole);
    if (!fault.empty()) return Error{fault};
    if (columns.why) marks.why = trimmed(fields[*columns.why]);
    if (columns.fingerprint) marks.fingerprint = trimmed(fields[*columns.fingerprint]);
    return marks;
}

void note_marks(MarkedAnswers& answers, const Marks& marks) {
    answers.synthetic = answers.synthetic || marks.synthetic;
    if (marks.rehearsal) ++answers.rehearsed;
    if (marks.rehearsal || !marks.whole) {
        ++answers.unfelt;
    } else if (marks.excluded) {
        if (++answers.excluded == 1) answers.why = marks.why;
    } else {
        ++answers.counted;
    }
}

void note_standing(RatingsText& into, const std::string& participant,
                   const MarkedAnswers& answers) {
    const std::size_t all = answers.counted + answers.excluded + answers.unfelt;
    Standing standing{participant, answers.synthetic, answers.rehearsed == all, {}};
    if (standing.rehearsal) {
        standing.excluded = kNothingFelt;
    } else if (answers.counted == 0) {
        standing.excluded = answers.why.empty() ? "excluded in " + into.file : answers.why;
    } else if (const std::size_t left_out = answers.excluded + answers.unfelt; left_out > 0) {
        into.remarks.push_back((participant.empty() ? into.file : participant) + ": " +
                               grouped_digits(left_out) + " of " + grouped_digits(all) +
                               " answers are left out, as they are marked so");
    }
    if (standing.synthetic || !standing.excluded.empty()) {
        into.study.standings.push_back(std::move(standing));
    }
}

}  // namespace tact
