// Ratings with a line each.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

#include "model/io/people/ratings_text.h"

namespace tact {

namespace {

struct Columns {
    std::optional<std::size_t> participant, a, b, rating;
    bool is_study = false;  // model/io/people/study_csv.h
};

Columns columns_of(const CsvRecord& head) {
    Columns columns;
    for (std::size_t k = 0; k < head.fields.size(); ++k) {
        const std::string name = trimmed(head.fields[k]);
        if (name == "participant") columns.participant = k;
        if (name == "a") columns.a = k;
        if (name == "b") columns.b = k;
        if (name == "rating") columns.rating = k;
        if (name == "attention") columns.is_study = true;
    }
    return columns;
}

using Pair = std::pair<std::size_t, std::size_t>;

// What has been read so far: names in the order in which they came.
struct Lines {
    std::vector<std::string> labels;
    std::unordered_map<std::string, std::size_t> place;
    std::vector<std::string> people;
    std::unordered_map<std::string, std::vector<std::map<Pair, double>>> passes;
    std::vector<double> identical;
};

std::size_t place_of(Lines& lines, const std::string& label) {
    const auto [entry, is_new] = lines.place.emplace(label, lines.labels.size());
    if (is_new) lines.labels.push_back(label);
    return entry->second;
}

// Into the participant's first pass that does not have the pair yet.
void add_rating(std::vector<std::map<Pair, double>>& passes, Pair pair, double rating) {
    for (auto& pass : passes) {
        if (pass.emplace(pair, rating).second) return;
    }
    passes.push_back({{pair, rating}});
}

// One line; what is wrong with it, or empty.
std::string take_line(Lines& lines, const Columns& columns,
                      const std::vector<std::string>& fields) {
    const std::string a = trimmed(fields[*columns.a]);
    const std::string b = trimmed(fields[*columns.b]);
    if (a.empty() || b.empty()) return "expected the names of two patterns";
    const auto rating = rating_in(fields[*columns.rating]);
    if (!rating) return expected_rating(fields[*columns.rating]);
    const std::size_t first = place_of(lines, a);
    const std::size_t second = place_of(lines, b);
    if (lines.labels.size() > kMaxRatedPatterns) return "expected at most 500 patterns";
    const std::string person = columns.participant ? trimmed(fields[*columns.participant]) : "";
    auto& passes = lines.passes[person];
    if (passes.empty()) {
        passes.emplace_back();
        lines.people.push_back(person);
    }
    if (std::isnan(*rating)) return {};
    if (first == second) {
        lines.identical.push_back(*rating);
    } else {
        add_rating(passes, std::minmax(first, second), *rating);
    }
    return {};
}

std::vector<Judgement> judgements_of(const Lines& lines) {
    const std::size_t n = lines.labels.size();
    std::vector<Judgement> judgements;
    for (const std::string& person : lines.people) {
        for (const auto& pass : lines.passes.at(person)) {
            // One more than allowed is enough to be refused.
            if (judgements.size() > kMaxJudgements) return judgements;
            std::vector<double> condensed(pair_count(n), std::numeric_limits<double>::quiet_NaN());
            for (const auto& [pair, rating] : pass) {
                condensed[pair_index(n, pair.first, pair.second)] = rating;
            }
            judgements.push_back({person, std::move(condensed)});
        }
    }
    return judgements;
}

}  // namespace

Expected<RatingsText> ratings_of_lines(const std::string& file,
                                       const std::vector<CsvRecord>& records) {
    const auto at_line = [&file](const CsvRecord& record, const std::string& fault) {
        return Error{file + ":" + std::to_string(record.line) + ": " + fault};
    };
    const CsvRecord& head = records.front();
    const Columns columns = columns_of(head);
    if (!columns.a || !columns.b || !columns.rating) {
        return at_line(head,
                       "expected the columns a, b and rating, and participant where there "
                       "are several");
    }
    Lines lines;
    for (std::size_t k = 1; k < records.size(); ++k) {
        const auto& fields = records[k].fields;
        std::string fault;
        if (fields.size() != head.fields.size()) {
            fault = "expected " + std::to_string(head.fields.size()) + " fields, got " +
                    std::to_string(fields.size());
        } else {
            fault = take_line(lines, columns, fields);
        }
        if (!fault.empty()) return at_line(records[k], fault);
    }
    return RatingsText{
        file, {lines.labels, true, judgements_of(lines)}, lines.identical, columns.is_study, 0};
}

}  // namespace tact
