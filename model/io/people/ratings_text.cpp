#include "model/io/people/ratings_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/io/people/foreign_answers.h"
#include "model/io/tables/matrix_file.h"
#include "model/table/table.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Numbers of a row from a column on; what is wrong with it, or empty.
std::string take_numbers(const CsvRecord& record, std::size_t from, std::vector<double>& numbers) {
    for (std::size_t k = from; k < record.fields.size(); ++k) {
        const auto value = rating_in(record.fields[k]);
        if (!value) return expected_rating(record.fields[k]);
        numbers.push_back(*value);
    }
    return {};
}

std::vector<std::string> positions(std::size_t count) {
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < count; ++k) labels.push_back(std::to_string(k + 1));
    return labels;
}

// A square of numbers as one judgement: the mean of both triangles, or what is known of them.
void take_square(RatingsText& into, const std::vector<std::vector<double>>& rows) {
    Judgement judgement;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!std::isnan(rows[i][i])) into.identical.push_back(rows[i][i]);
        for (std::size_t j = i + 1; j < rows.size(); ++j) {
            const double upper = rows[i][j];
            const double lower = rows[j][i];
            const double larger = std::max(std::abs(upper), std::abs(lower));
            if (std::abs(upper - lower) > 1e-9 * larger) ++into.averaged;
            const double mean = upper == lower ? upper : upper / 2 + lower / 2;
            judgement.condensed.push_back(std::isnan(upper)   ? lower
                                          : std::isnan(lower) ? upper
                                                              : mean);
        }
    }
    into.study.judgements.push_back(std::move(judgement));
}

Expected<RatingsText> labelled_square(const std::string& file,
                                      const std::vector<CsvRecord>& records) {
    RatingsText into;
    into.file = file;
    std::vector<std::string>& labels = into.study.labels;
    for (std::size_t k = 1; k < records[0].fields.size(); ++k) {
        labels.emplace_back(trimmed(records[0].fields[k]));
        if (const std::string fault = name_fault(labels.back()); !fault.empty()) {
            return at_line(file, records[0].line, fault);
        }
    }
    if (const auto equal = first_equal(labels)) {
        return at_line(
            file, records[0].line,
            "expected names that differ, got " + in_quotes(labels[equal->second]) + " twice");
    }
    std::vector<std::vector<double>> rows(labels.size());
    bool is_permuted = false;
    for (std::size_t i = 1; i < records.size(); ++i) {
        const CsvRecord& record = records[i];
        const std::string name{trimmed(record.fields[0])};
        if (i > labels.size()) {
            return at_line(file, record.line, "expected as many rows as columns, got more");
        }
        const auto found = std::ranges::find(labels, name);
        std::vector<double>& row = rows[found == labels.end() ? 0 : found - labels.begin()];
        if (found == labels.end() || !row.empty()) {
            return at_line(
                file, record.line,
                "expected the row of " + in_quotes(labels[i - 1]) + ", got " + in_quotes(name));
        }
        is_permuted |= name != labels[i - 1];
        if (record.fields.size() != labels.size() + 1) {
            return at_line(file, record.line,
                           "expected " + std::to_string(labels.size()) + " ratings, got " +
                               std::to_string(record.fields.size() - 1));
        }
        if (auto fault = take_numbers(record, 1, row); !fault.empty()) {
            return at_line(file, record.line, fault);
        }
    }
    if (is_permuted) {
        into.remarks.push_back(into.file + ": its rows are in another order than its columns");
    }
    const NumberMark mark = mark_in(records[0].fields[0]);
    if (mark.synthetic) into.study.standings.push_back({.participant = {}, .synthetic = true});
    into.study.left_out = mark.left_out;
    into.study.rehearsals = mark.rehearsals;
    if (records.size() - 1 != labels.size()) {
        return at_line(file, records.back().line,
                       "expected " + std::to_string(labels.size()) +
                           " rows, as there are columns, got " +
                           std::to_string(records.size() - 1));
    }
    take_square(into, rows);
    return into;
}

// The number of patterns that have `pairs` pairs; 0 if no number has.
std::size_t patterns_of(std::size_t pairs) {
    std::size_t n = 2;
    while (pair_count(n) < pairs) ++n;
    return pair_count(n) == pairs ? n : 0;
}

// Numbers without names: a square, or a judgement a row, or one in a column.
Expected<RatingsText> bare_numbers(const std::string& file, const std::vector<CsvRecord>& records) {
    RatingsText into;
    into.file = file;
    into.study.is_named = false;
    std::vector<std::vector<double>> rows;
    for (const CsvRecord& record : records) {
        if (auto fault = take_numbers(record, 0, rows.emplace_back()); !fault.empty()) {
            return at_line(file, record.line, fault);
        }
        if (rows.back().size() == rows[0].size()) continue;
        return at_line(file, record.line,
                       "expected " + std::to_string(rows[0].size()) +
                           " ratings, as in the first row, got " +
                           std::to_string(rows.back().size()));
    }
    const std::size_t columns = rows[0].size();
    if (rows.size() == columns && columns > 1) {
        into.study.labels = positions(columns);
        take_square(into, rows);
        return into;
    }
    const bool is_column = columns == 1;
    const std::size_t n = patterns_of(is_column ? rows.size() : columns);
    if (n < 2) {
        return at_line(file, records[0].line,
                       "expected a square, or the n(n-1)/2 pairs of n patterns in every row, got " +
                           std::to_string(rows.size()) + " rows of " + std::to_string(columns));
    }
    into.study.labels = positions(n);
    if (is_column) {
        Judgement& judgement = into.study.judgements.emplace_back();
        for (const auto& row : rows) judgement.condensed.push_back(row[0]);
        return into;
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        // A single row is one participant, who goes by the name of the file.
        const std::string name = rows.size() == 1 ? "" : std::to_string(k + 1);
        into.study.judgements.push_back({name, std::move(rows[k])});
    }
    return into;
}

// The records as they stand there, or as other programs' answers are understood.
Expected<OwnAnswers> records_of(const std::string& file, std::string_view bytes,
                                const AnswerColumns& columns) {
    const TableText table = table_text(std::string(bytes));
    const TableDialect dialect = dialect_of(table.text, columns.written);
    CsvReader reader = reader_of(table.text, dialect);
    std::vector<CsvRecord> records;
    for (;;) {
        CsvRecord record = next_record(reader);
        if (record.line == 0) break;
        if (record.is_quote_open) return at_line(file, record.line, "expected a closing quote");
        records.push_back(std::move(record));
    }
    if (records.empty()) return at_line(file, 1, "expected ratings, got an empty file");
    if (dialect.is_doubtful) {
        return at_line(file, records.front().line, kDoubtfulNumbers);
    }
    OwnAnswers own = own_answers(std::move(records), dialect, columns);
    if (!own.fault.empty()) return at_line(file, own.records.front().line, own.fault);
    if (own.records.empty()) return at_line(file, 1, "expected ratings, got an empty file");
    // Numbers between blanks are this program's own form, too.
    const bool is_own =
        dialect.separator == ' ' && dialect.decimal == '.' && table.encoding == TableEncoding::utf8;
    const std::string words = words_on(dialect, table.encoding);
    if (!words.empty() && !is_own) own.remarks.insert(own.remarks.begin(), "read with " + words);
    return own;
}

}  // namespace

std::string passes_fault(std::size_t passes, std::size_t patterns, std::size_t text_bytes) {
    const std::size_t pairs = std::max<std::size_t>(pair_count(patterns), 1);
    const std::size_t most = (kMostUnratedCells + text_bytes) / pairs;
    if (passes <= most) return {};
    return "expected at most " + grouped_digits(most) + " passes through " + grouped_digits(pairs) +
           " pairs, got " + grouped_digits(passes);
}

Expected<RatingsText> ratings_text(std::string_view text, const std::string& file,
                                   const AnswerColumns& columns) {
    const auto own = records_of(file, text, columns);
    if (!own) return own.error();
    const std::vector<CsvRecord>& records = own->records;
    const CsvRecord& head = records.front();
    const auto has_column = [&head](const char* name) {
        return std::ranges::any_of(
            head.fields, [name](const std::string& field) { return trimmed(field) == name; });
    };
    const bool is_sorted = has_column("group") && has_column("pattern");
    const bool has_columns = is_sorted || has_column("rating");
    if (!has_columns && head.fields.size() > pair_count(kMaxRatedPatterns)) {
        return at_line(file, head.line, "expected at most 500 patterns");
    }
    const std::string_view corner = trimmed(head.fields[0]);
    const bool has_names =
        head.fields.size() > 1 && (corner.empty() || mark_in(corner) != NumberMark{});
    const bool are_words =
        head.fields.size() > 1 && std::ranges::none_of(head.fields, [](const std::string& cell) {
            return rating_in(cell).has_value();
        });
    if (!has_columns && !has_names && are_words) {
        return at_line(file, head.line,
                       "expected the columns a, b and rating, or a square of names; the columns "
                       "are " +
                           column_names(head.fields));
    }
    auto answer = is_sorted     ? ratings_of_sortings(file, records, text.size())
                  : has_columns ? ratings_of_lines(file, records, text.size())
                  : has_names   ? labelled_square(file, records)
                                : bare_numbers(file, records);
    if (!answer) return answer;
    if (answer->scale == RatingScale::guess) answer->scale = own->scale;
    std::vector<std::string> remarks;
    for (const std::string& one : own->remarks) remarks.push_back(file + ": " + one);
    answer->remarks.insert(answer->remarks.begin(), remarks.begin(), remarks.end());
    if (answer->study.labels.size() < 2) {
        return Error{file + ": expected ratings of at least two patterns"};
    }
    if (answer->study.labels.size() > kMaxRatedPatterns) {
        return Error{file + ": expected at most 500 patterns"};
    }
    return answer;
}

// A rating, NaN if the cell says that it is missing, nothing if it is neither.
std::optional<double> rating_in(const std::string& field) {
    if (says_unknown(field)) return std::numeric_limits<double>::quiet_NaN();
    return finite_number_in(trimmed(field));
}

std::string expected_rating(const std::string& field) {
    return "expected a rating, or an empty cell, got " + in_quotes(field);
}

void find_columns(const CsvRecord& head, std::initializer_list<NamedColumn> wanted) {
    for (std::size_t k = 0; k < head.fields.size(); ++k) {
        const std::string name{trimmed(head.fields[k])};
        for (const NamedColumn& column : wanted) {
            if (name == column.name) *column.place = k;
        }
    }
}

}  // namespace tact
