#include "model/io/studies_out/packed_answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "model/study/pairwise_study.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::size_t kMostPlays = 1000;
constexpr double kLongestAnswerS = 1e6;

// The places of the columns, by their names.
struct Columns {
    std::map<std::string, std::size_t> at;

    std::string_view of(const CsvRecord& record, const char* name) const {
        const auto found = at.find(name);
        if (found == at.end() || found->second >= record.fields.size()) return {};
        return record.fields[found->second];
    }
};

struct Line {
    const Columns& columns;
    const CsvRecord& record;
    const std::string& file;

    std::string text(const char* name) const { return std::string(columns.of(record, name)); }
    Error fault(const std::string& expected) const { return at_line(file, record.line, expected); }

    // A number within limits; `fallback` where the column is missing or empty.
    Expected<double> number(const char* name, double fallback, Range range) const {
        const std::string_view cell = columns.of(record, name);
        if (cell.empty()) return fallback;
        const auto value = finite_number_in(cell);
        if (!value || *value < range.low || *value > range.high) {
            return fault("expected a number from " + significant_digits(range.low, 6) + " to " +
                         significant_digits(range.high, 6) + " as " + name + ", got " +
                         in_quotes(shortened(cell)));
        }
        return *value;
    }
};

Expected<std::size_t> pattern_of(const Line& line, const char* name,
                                 const std::vector<std::string>& patterns) {
    const std::string pattern = line.text(name);
    const auto found = std::ranges::find(patterns, pattern);
    if (found == patterns.end()) {
        return line.fault(std::string("expected the name of a pattern of the study as ") + name +
                          ", got " + in_quotes(shortened(pattern)));
    }
    return static_cast<std::size_t>(found - patterns.begin());
}

Expected<PairAnswer> answer_in(const Line& line, const std::vector<std::string>& patterns) {
    const auto a = pattern_of(line, "a", patterns);
    if (!a) return a.error();
    const auto b = pattern_of(line, "b", patterns);
    if (!b) return b.error();
    const std::string side = line.text("side");
    if (side != "a" && side != "b") {
        return line.fault("expected a or b as side, got " + in_quotes(shortened(side)));
    }
    PairAnswer answer;
    answer.trial = side == "a" ? Trial{*a, *b} : Trial{*b, *a};
    const auto rating = line.number("rating", std::nan(""), limits::kSimilarity);
    if (!rating) return rating.error();
    if (std::isnan(*rating)) return line.fault("expected a number from 0 to 100 as rating");
    answer.similarity = *rating;
    const Range plays{0, static_cast<double>(kMostPlays)};
    const auto left = line.number("plays_left", 1.0, plays);
    if (!left) return left.error();
    const auto right = line.number("plays_right", 1.0, plays);
    if (!right) return right.error();
    const auto response_s = line.number("response_s", 0.0, {0.0, kLongestAnswerS});
    if (!response_s) return response_s.error();
    answer.plays_left = static_cast<int>(*left);
    answer.plays_right = static_cast<int>(*right);
    answer.response_s = *response_s;
    answer.at = line.text("at");
    const std::string first = line.text("felt_first");
    if (first == "a" || first == "b") {
        answer.first = first == side ? FeltFirst::left : FeltFirst::right;
    }
    return answer;
}

struct Placed {
    double trial = 0.0;
    PairAnswer answer;
};

struct Participating {
    StudyRecord record;
    std::vector<Placed> answers;
};

Expected<Columns> columns_of(const CsvRecord& head, const std::string& file) {
    Columns columns;
    for (std::size_t k = 0; k < head.fields.size(); ++k) columns.at.emplace(head.fields[k], k);
    for (const char* needed : {"participant", "a", "b", "side", "rating"}) {
        if (!columns.at.contains(needed)) {
            return at_line(
                file, std::max<std::size_t>(head.line, 1),
                std::string("expected a column ") + needed + ", as a packed experiment writes it");
        }
    }
    return columns;
}

}  // namespace

Expected<std::vector<StudyRecord>> packed_answers(std::string_view text, const std::string& file,
                                                  const StudyHeader& header) {
    CsvReader reader{without_bom(text)};
    const CsvRecord head = next_record(reader);
    const Expected<Columns> columns = columns_of(head, file);
    if (!columns) return columns.error();
    std::vector<Participating> people;  // in the order in which they come
    for (CsvRecord record = next_record(reader); record.line > 0; record = next_record(reader)) {
        const Line line{*columns, record, file};
        if (record.is_quote_open) return line.fault("expected a quote that ends");
        const std::string code = line.text("participant");
        if (code.empty()) return line.fault("expected a participant");
        const Expected<PairAnswer> answer = answer_in(line, header.patterns);
        if (!answer) return answer.error();
        const auto trial = line.number("trial", 0.0, {0.0, 1e9});
        if (!trial) return trial.error();
        auto one = std::ranges::find(people, code, [](const Participating& person) {
            return person.record.header.participant.code;
        });
        if (one == people.end()) {
            Participating person{{header, {}, {}, false}, {}};
            StudyHeader& own = person.record.header;
            own.participant.code = code;
            own.seed = participant_seed(own.design.seed, code);
            own.begun = answer->at;
            if (const std::string device = line.text("device"); !device.empty()) {
                own.device.name = device;
            }
            if (const std::string felt = line.text("fingerprint"); !felt.empty()) {
                own.set_fingerprint = felt;
                // Which version of each pattern that was is known of the packed set alone.
                if (felt != header.set_fingerprint) own.versions.clear();
            }
            people.push_back(std::move(person));
            one = people.end() - 1;
        }
        // One simulated answer makes it nobody's session.
        if (line.text("synthetic") == "1") one->record.header.synthetic = true;
        one->answers.push_back({*trial, *answer});
    }
    if (people.empty()) return at_line(file, 1, "expected answers below the names of columns");
    std::vector<StudyRecord> records;
    for (Participating& person : people) {
        std::ranges::stable_sort(person.answers, {}, &Placed::trial);
        for (Placed& placed : person.answers) {
            person.record.answers.push_back(std::move(placed.answer));
        }
        records.push_back(std::move(person.record));
    }
    return records;
}

}  // namespace tact
