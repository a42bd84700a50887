// Ratings with a line each.
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "model/io/people/ratings_text.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

struct LineColumns {
    std::optional<std::size_t> participant, a, b, rating, scaled;
    MarkColumns marks;
    bool is_study = false;  // model/io/people/study_csv.h
};

LineColumns line_columns(const CsvRecord& head) {
    LineColumns columns;
    columns.marks = mark_columns(head);
    std::optional<std::size_t> attention;
    find_columns(head, {{"participant", &columns.participant},
                        {"a", &columns.a},
                        {"b", &columns.b},
                        {"rating", &columns.rating},
                        {"scaled", &columns.scaled},
                        {"attention", &attention}});
    columns.is_study = attention.has_value();
    if (!columns.is_study) columns.scaled.reset();
    return columns;
}

using Pair = std::pair<std::size_t, std::size_t>;
using Pass = std::vector<std::pair<Pair, double>>;

// The ratings of one participant; a pair that is rated again begins or continues a pass.
struct Passes {
    std::unordered_map<std::size_t, std::size_t> times;  // a pair was rated
    std::vector<Pass> passes;
};

struct Rater {
    std::string name;
    Passes counted;
    Passes excluded;
    MarkedAnswers marks;
};

// What has been read so far: names in the order in which they came.
struct Lines {
    std::vector<std::string> labels;
    std::unordered_map<std::string, std::size_t> place;
    std::vector<Rater> people;
    std::unordered_map<std::string, std::size_t> place_of_person;
    std::vector<double> identical;
    std::string fingerprint;
};

std::size_t place_of(Lines& lines, const std::string& label) {
    const auto [entry, is_new] = lines.place.emplace(label, lines.labels.size());
    if (is_new) lines.labels.push_back(label);
    return entry->second;
}

Rater& rater_of(Lines& lines, const std::string& name) {
    const auto [entry, is_new] = lines.place_of_person.emplace(name, lines.people.size());
    if (is_new) lines.people.push_back({name, {}, {}, {}});
    return lines.people[entry->second];
}

// What is wrong with it, or empty.
std::string add_rating(Passes& of, Pair pair, double rating) {
    const std::size_t pass = of.times[pair.first * (kMaxRatedPatterns + 1) + pair.second]++;
    if (pass >= kMaxPasses) return "expected at most 100 ratings of a pair by a participant";
    if (pass == of.passes.size()) of.passes.emplace_back();
    of.passes[pass].emplace_back(pair, rating);
    return {};
}

// One line; what is wrong with it, or empty.
std::string take_line(Lines& lines, const LineColumns& columns,
                      const std::vector<std::string>& fields) {
    const std::string a{trimmed(fields[*columns.a])};
    const std::string b{trimmed(fields[*columns.b])};
    if (a.empty() || b.empty()) return "expected the names of two patterns";
    for (const std::string& name : {a, b}) {
        if (std::string fault = name_fault(name); !fault.empty()) return fault;
    }
    const std::string& cell = fields[columns.scaled.value_or(*columns.rating)];
    const auto rating = rating_in(cell);
    if (!rating) return expected_rating(cell);
    const Expected<Marks> marks = marks_in(columns.marks, fields);
    if (!marks) return marks.error().message;
    const std::size_t first = place_of(lines, a);
    const std::size_t second = place_of(lines, b);
    if (lines.labels.size() > kMaxRatedPatterns) return "expected at most 500 patterns";
    const std::string who{columns.participant ? trimmed(fields[*columns.participant]) : ""};
    if (std::string fault = name_fault(who); !fault.empty()) return fault;
    Rater& rater = rater_of(lines, who);
    if (lines.people.size() > kMaxParticipants) return "expected at most 1,000 participants";
    note_marks(rater.marks, *marks);
    if (lines.fingerprint.empty()) lines.fingerprint = marks->fingerprint;
    if (std::isnan(*rating)) return {};
    if (first == second) {
        lines.identical.push_back(*rating);
        return {};
    }
    if (marks->rehearsal || !marks->whole) return {};
    return add_rating(marks->excluded ? rater.excluded : rater.counted, std::minmax(first, second),
                      *rating);
}

// The passes of all people, for which memory is needed.
std::size_t passes_of(const Lines& lines) {
    std::size_t passes = 0;
    for (const Rater& rater : lines.people) {
        passes +=
            std::max({rater.counted.passes.size(), rater.excluded.passes.size(), std::size_t{1}});
    }
    return passes;
}

void add_judgements(RatingStudy& study, const Rater& rater) {
    const std::size_t n = study.labels.size();
    // Who is excluded throughout may be included by name; of others only what counts is taken.
    const bool is_excluded = rater.marks.counted == 0;
    std::vector<Pass> passes = (is_excluded ? rater.excluded : rater.counted).passes;
    if (passes.empty()) passes.emplace_back();
    for (const Pass& pass : passes) {
        std::vector<double> condensed(pair_count(n), kNoRating);
        for (const auto& [pair, rating] : pass) {
            condensed[pair_index(n, pair.first, pair.second)] = rating;
        }
        study.judgements.push_back({rater.name, std::move(condensed)});
    }
}

}  // namespace

Expected<RatingsText> ratings_of_lines(const std::string& file,
                                       const std::vector<CsvRecord>& records,
                                       std::size_t text_bytes) {
    const auto at_line = [&file](const CsvRecord& record, const std::string& fault) {
        return Error{file + ":" + std::to_string(record.line) + ": " + fault};
    };
    const CsvRecord& head = records.front();
    const LineColumns columns = line_columns(head);
    if (!columns.a || !columns.b || !columns.rating) {
        return at_line(head,
                       "expected the columns a, b and rating, and participant where there "
                       "are several");
    }
    if (const std::string fault = column_fault(head); !fault.empty()) return at_line(head, fault);
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
    RatingsText text;
    text.file = file;
    text.study.labels = lines.labels;
    text.study.fingerprint = lines.fingerprint;
    text.identical = std::move(lines.identical);
    if (columns.is_study) text.scale = RatingScale::similarity;
    text.is_scaled = columns.scaled.has_value();
    const std::string fault = passes_fault(passes_of(lines), lines.labels.size(), text_bytes);
    if (!fault.empty()) return Error{file + ": " + fault};
    for (const Rater& rater : lines.people) {
        add_judgements(text.study, rater);
        note_standing(text, rater.name, rater.marks);
    }
    return text;
}

}  // namespace tact
