#include "model/io/tables/matrix_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <unordered_map>
#include <utility>

#include "model/pattern/pattern.h"
#include "model/table/table.h"
#include "model/text/atomic_file.h"
#include "model/text/csv.h"
#include "model/text/enough_memory.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kAsymmetry = 1e-9;  // of the larger value: rounding of other programs
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string head_row(std::span<const std::string> labels, const std::string& corner) {
    std::string row = csv_field(corner);
    for (const std::string& label : labels) row += "," + csv_field(label);
    return row + "\n";
}

std::string matrix_row(std::span<const std::string> labels, const Dissimilarity& dissimilarity,
                       std::size_t i) {
    std::string row = csv_field(labels[i]);
    for (std::size_t j = 0; j < dissimilarity.size; ++j) {
        row += ',';
        append_digits(row, dissimilarity(i, j));
    }
    return row + "\n";
}

// How rows and columns are named.
enum class MatrixShape {
    bare,         // numbers alone
    labelled,     // a corner, names in the first row and the first column
    names_above,  // in the first row alone
    no_corner,    // names in the first row begin above the first number, as R's write.table has it
    triangle      // as R prints distances: no row for the first, no column for the last
};

// A matrix while its lines are read.
struct MatrixReading {
    std::string file;
    std::size_t text_bytes = 0;
    TableDialect dialect;
    MatrixShape shape = MatrixShape::labelled;
    LabelledMatrix matrix;
    std::unordered_map<std::string, std::size_t> place_of;
    std::vector<bool> has_row;
    std::vector<double> diagonal;        // NaN: not told
    std::vector<std::uint8_t> decimals;  // of each pair, as it was written first
    std::size_t rows = 0;
    bool is_permuted = false;
    bool has_lower = false, has_upper = false;
    std::size_t rounded = 0;  // pairs that are written with other digits in reverse
    std::optional<Error> short_row{};
    std::size_t diagonal_line = 0;  // of the first number on it that is not 0
    std::string diagonal_text;
};

Error at_line(const MatrixReading& reading, std::size_t line, const std::string& fault) {
    return Error{reading.file + ":" + std::to_string(line) + ": " + fault};
}

bool is_value(const MatrixReading& reading, std::string_view cell) {
    return says_unknown(cell) || number_in(cell, reading.dialect).has_value();
}

MatrixShape shape_of(const MatrixReading& reading, const CsvRecord& first,
                     const CsvRecord& second) {
    const std::size_t columns = first.fields.size();
    if (number_in(first.fields[0], reading.dialect)) {
        const bool are_numbers = std::ranges::all_of(
            first.fields, [&](const std::string& cell) { return is_value(reading, cell); });
        if (are_numbers) return MatrixShape::bare;
    }
    const auto& cells = second.fields;
    if (cells.size() == columns + 1) return MatrixShape::no_corner;
    const bool is_named = !trimmed(first.fields[0]).empty();
    const bool is_triangle = reading.dialect.separator == ' ' && is_named && cells.size() == 2 &&
                             (columns == 1 || cells[0] == first.fields[1]);
    if (is_triangle) return MatrixShape::triangle;
    const bool begins_with_number =
        !cells.empty() && cells.size() == columns && is_value(reading, cells[0]);
    const bool is_first_name = columns > 1 && !cells.empty() && cells[0] == first.fields[1];
    return is_named && begins_with_number && !is_first_name ? MatrixShape::names_above
                                                            : MatrixShape::labelled;
}

// The labels of the first record; what is wrong with them, or empty.
std::string take_labels(MatrixReading& reading, const CsvRecord& first, const CsvRecord& last) {
    auto& labels = reading.matrix.labels;
    if (reading.shape == MatrixShape::bare) {
        for (std::size_t k = 0; k < first.fields.size(); ++k) {
            labels.push_back(std::to_string(k + 1));
        }
    } else {
        const bool has_corner = reading.shape == MatrixShape::labelled;
        if (has_corner) reading.matrix.mark = mark_in(first.fields.front());
        labels.assign(first.fields.begin() + (has_corner ? 1 : 0), first.fields.end());
        while (!labels.empty() && labels.back().empty()) labels.pop_back();  // a sign at the end
        if (reading.shape == MatrixShape::triangle) labels.push_back(last.fields.front());
    }
    if (labels.empty()) return "expected names after the first comma";
    if (labels.size() > limits::kMaxPatterns) return "expected at most 10,000 columns";
    for (const std::string& label : labels) {
        if (std::string fault = name_fault(label); !fault.empty()) return fault;
        if (!reading.place_of.emplace(label, reading.place_of.size()).second)
            return "expected names that differ, got " + in_quotes(label) + " twice";
    }
    const std::size_t pairs = pair_count(labels.size());
    // A number takes two characters at least: names alone make no memory.
    if (2 * pairs > reading.text_bytes) {
        return "expected " + std::to_string(labels.size()) +
               " rows, as there are columns, got too few numbers for them";
    }
    reading.matrix.dissimilarity.size = labels.size();
    reading.matrix.dissimilarity.condensed.assign(pairs, kUnknown);
    reading.decimals.assign(pairs, 0);
    reading.diagonal.assign(labels.size(), kUnknown);
    reading.has_row.assign(labels.size(), false);
    return {};
}

std::uint8_t decimals_of(std::string_view cell) {
    cell = trimmed(cell);
    const std::size_t point = cell.find_first_of(".,");
    if (point == cell.npos || cell.find_first_of("eE") != cell.npos) return 0;
    return static_cast<std::uint8_t>(std::min<std::size_t>(cell.size() - point - 1, 255));
}

// Whether two numbers are one, but for rounding of the last bits, or of decimals that one of them
// is written with.
bool is_reverse(double value, double other, int decimals) {
    constexpr int kFewestDecimals = 4;
    const double difference = std::abs(value - other);
    if (difference <= kAsymmetry * std::max(std::abs(value), std::abs(other))) return true;
    return decimals >= kFewestDecimals && difference <= 0.5000001 * std::pow(10.0, -decimals);
}

// A number of the row of i in the column of j; what is wrong with it, or empty.
std::string take_number(MatrixReading& reading, std::size_t i, std::size_t j,
                        const CsvRecord& record, const std::string& cell) {
    const auto& labels = reading.matrix.labels;
    if (says_unknown(cell)) return {};
    const auto value = number_in(cell, reading.dialect);
    if (!value) {
        return "column " + in_quotes(labels[j]) + ": expected a finite number, got " +
               in_quotes(cell);
    }
    if (i == j) {
        reading.diagonal[i] = *value;
        if (*value != 0.0 && reading.diagonal_line == 0) {
            reading.diagonal_line = record.line;
            reading.diagonal_text = cell;
        }
        return {};
    }
    (i < j ? reading.has_upper : reading.has_lower) = true;
    Dissimilarity& all = reading.matrix.dissimilarity;
    const std::size_t pair = pair_index(all.size, std::min(i, j), std::max(i, j));
    double& known = all.condensed[pair];
    if (std::isnan(known)) {
        known = *value;
        reading.decimals[pair] = decimals_of(cell);
    } else if (!is_reverse(*value, known, std::min(reading.decimals[pair], decimals_of(cell)))) {
        return "expected a symmetric matrix, got other values for " + in_quotes(labels[i]) +
               " and " + in_quotes(labels[j]) + " than for the reverse";
    } else {
        const double larger = std::max(std::abs(*value), std::abs(known));
        if (std::abs(*value - known) > kAsymmetry * larger) ++reading.rounded;
        if (i < j) known = *value;
    }
    return {};
}

// Which pattern a row is of; what is wrong with that, or empty.
std::string take_place(MatrixReading& reading, const CsvRecord& record, std::size_t& place) {
    const auto& labels = reading.matrix.labels;
    const bool is_named =
        reading.shape != MatrixShape::bare && reading.shape != MatrixShape::names_above;
    const std::size_t next = reading.rows + (reading.shape == MatrixShape::triangle ? 1 : 0);
    if (next == labels.size()) return "expected as many rows as columns, got more";
    place = next;
    if (is_named) {
        const auto found = reading.place_of.find(record.fields[0]);
        if (found == reading.place_of.end()) {
            return "expected the row of " + in_quotes(labels[next]) + ", got " +
                   in_quotes(record.fields[0]);
        }
        place = found->second;
        reading.is_permuted |= place != next;
    }
    if (reading.has_row[place]) {
        return "expected one row of " + in_quotes(labels[place]) + ", got another";
    }
    reading.has_row[place] = true;
    return {};
}

// One row; what is wrong with it, or empty.
std::string take_row(MatrixReading& reading, const CsvRecord& record) {
    const std::size_t count = reading.matrix.labels.size();
    std::size_t i = 0;
    if (std::string fault = take_place(reading, record, i); !fault.empty()) return fault;
    const bool has_names =
        reading.shape != MatrixShape::bare && reading.shape != MatrixShape::names_above;
    const std::size_t head = has_names ? 1 : 0;
    std::size_t cells = record.fields.size() - std::min(head, record.fields.size());
    while (cells > count && trimmed(record.fields[head + cells - 1]).empty()) --cells;
    const std::string fault =
        "expected " + std::to_string(count) + " numbers, got " + std::to_string(cells);
    if (cells > count) return fault;
    if (cells < count && !reading.short_row) {
        reading.short_row = at_line(reading, record.line, fault);
    }
    for (std::size_t j = 0; j < cells; ++j) {
        std::string wrong = take_number(reading, i, j, record, record.fields[head + j]);
        if (!wrong.empty()) return wrong;
    }
    ++reading.rows;
    return {};
}

// A diagonal that no other number exceeds is one of similarities: nothing is as like another
// as it is to itself.
std::optional<Error> judge_diagonal(MatrixReading& reading) {
    if (reading.diagonal_line == 0) return std::nullopt;
    auto& values = reading.matrix.dissimilarity.condensed;
    const double same = reading.diagonal.front();
    const bool is_similarity =
        same > 0.0 && !values.empty() &&
        std::ranges::all_of(reading.diagonal, [same](double one) { return one == same; }) &&
        std::ranges::all_of(values, [same](double one) { return one >= 0.0 && one <= same; });
    if (!is_similarity) {
        return at_line(reading, reading.diagonal_line,
                       "expected 0 on the diagonal, got " + in_quotes(reading.diagonal_text));
    }
    for (double& value : values) value = same - value;
    reading.matrix.remarks.push_back("taken as similarities from 0 to " + shortest_digits(same) +
                                     ", as that stands on the diagonal");
    return std::nullopt;
}

void remark(MatrixReading& reading, TableEncoding encoding) {
    auto& remarks = reading.matrix.remarks;
    const std::string words = words_on(reading.dialect, encoding);
    const bool is_usual = reading.shape == MatrixShape::bare && encoding == TableEncoding::utf8 &&
                          reading.dialect.decimal == '.';
    if (!words.empty() && !is_usual) remarks.push_back("read with " + words);
    if (reading.is_permuted) remarks.push_back("its rows are in another order than its columns");
    if (reading.has_upper != reading.has_lower) {
        remarks.emplace_back(reading.has_upper ? "only the numbers above the diagonal are there"
                                               : "only the numbers below the diagonal are there");
    }
    if (reading.rounded > 0) {
        remarks.push_back(counted(reading.rounded, "pair is", "pairs are") +
                          " written with other digits in reverse; those above the diagonal count");
    }
}

// What is not there, if anything.
std::optional<Error> missing(const MatrixReading& reading, std::size_t last_line) {
    const auto& all = reading.matrix.dissimilarity;
    const std::size_t wanted = all.size - (reading.shape == MatrixShape::triangle ? 1 : 0);
    if (reading.rows < wanted) {
        return at_line(reading, last_line,
                       "expected " + std::to_string(wanted) + " rows, as there are columns, got " +
                           std::to_string(reading.rows));
    }
    // Rows of a triangle are short, and there is no other one.
    if (reading.short_row && reading.has_upper) return reading.short_row;
    for (std::size_t k = 0; k < all.condensed.size(); ++k) {
        if (!std::isnan(all.condensed[k])) continue;
        if (reading.short_row) return reading.short_row;
        const auto [i, j] = pair_at(all.size, k);
        return Error{reading.file + ": expected a finite number for " +
                     in_quotes(reading.matrix.labels[i]) + " and " +
                     in_quotes(reading.matrix.labels[j]) + ", got none"};
    }
    return std::nullopt;
}

Expected<LabelledMatrix> matrix_of(const TableText& table, const std::string& file,
                                   const TableHints& hints) {
    MatrixReading reading;
    reading.file = file;
    reading.text_bytes = table.text.size();
    reading.dialect = dialect_of(table.text, hints);
    CsvReader reader = reader_of(table.text, reading.dialect);
    CsvReader ahead = reader;
    const CsvRecord first = next_record(ahead);
    if (first.line == 0) return at_line(reading, 1, "expected a matrix, got an empty file");
    if (reading.dialect.is_doubtful) {
        return at_line(reading, first.line, kDoubtfulNumbers);
    }
    const CsvReader behind_first = ahead;
    const CsvRecord second = next_record(ahead);
    reading.shape = shape_of(reading, first, second);
    CsvRecord last = second;
    while (reading.shape == MatrixShape::triangle) {
        CsvRecord next = next_record(ahead);
        if (next.line == 0) break;
        last = std::move(next);
    }
    if (first.is_quote_open) return at_line(reading, first.line, "expected a closing quote");
    if (std::string fault = take_labels(reading, first, last); !fault.empty()) {
        return at_line(reading, first.line, fault);
    }
    if (reading.shape != MatrixShape::bare) reader = behind_first;
    for (CsvRecord record = next_record(reader); record.line != 0; record = next_record(reader)) {
        if (record.is_quote_open) return at_line(reading, record.line, "expected a closing quote");
        const std::string fault = take_row(reading, record);
        if (!fault.empty()) return at_line(reading, record.line, fault);
    }
    if (auto fault = missing(reading, reader.line)) return *fault;
    if (auto fault = judge_diagonal(reading)) return *fault;
    remark(reading, table.encoding);
    return std::move(reading.matrix);
}

}  // namespace

std::string csv_row(std::span<const std::string> texts) {
    std::string row;
    for (const std::string& text : texts)
        row += (&text == texts.data() ? "" : ",") + csv_field(text);
    return row + "\n";
}

std::string csv_field(std::string_view plain) {
    const std::string text = guarded(plain);
    // Blanks at the ends get quotes too: some programs drop bare ones.
    const bool is_bare = text.find_first_of(",\"\r\n") == text.npos && !text.starts_with(' ') &&
                         !text.ends_with(' ');
    if (is_bare) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
}

void write_matrix_csv(std::ostream& stream, std::span<const std::string> labels,
                      const Dissimilarity& dissimilarity, const std::string& corner) {
    assert(labels.size() == dissimilarity.size && "one label for each object");
    stream << head_row(labels, corner);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        stream << matrix_row(labels, dissimilarity, i);
    }
}

Expected<Done> write_matrix_file(const std::filesystem::path& path,
                                 std::span<const std::string> labels,
                                 const Dissimilarity& dissimilarity) {
    assert(labels.size() == dissimilarity.size && "one label for each object");
    remove_abandoned_files(path.has_parent_path() ? path.parent_path() : ".");
    auto file = AtomicFile::open(path);
    if (!file) return file.error();
    if (auto appended = file->append(head_row(labels, {})); !appended) return appended;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        auto appended = file->append(matrix_row(labels, dissimilarity, i));
        if (!appended) return appended;
    }
    return file->commit();
}

void write_coordinates_csv(std::ostream& stream, std::span<const std::string> labels,
                           const Eigen::MatrixXd& points, const std::string& corner) {
    assert(static_cast<Eigen::Index>(labels.size()) == points.rows() && "one label for each point");
    stream << (corner.empty() ? "name" : csv_field(corner));
    for (Eigen::Index k = 0; k < points.cols(); ++k) stream << ",D" << k + 1;
    stream << '\n';
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        std::string row = csv_field(labels[static_cast<std::size_t>(i)]);
        for (Eigen::Index k = 0; k < points.cols(); ++k) {
            row += ',';
            append_digits(row, points(i, k));
        }
        stream << row << '\n';
    }
}

Expected<LabelledMatrix> parse_matrix(std::string_view text, const std::string& file,
                                      const TableHints& hints) {
    return matrix_of(table_text(std::string(text)), file, hints);
}

Expected<LabelledMatrix> read_matrix_file(const std::filesystem::path& path,
                                          const TableHints& hints) {
    return with_enough_memory(path.string(), [&]() -> Expected<LabelledMatrix> {
        auto text = read_text_file(path);
        if (!text) return text.error();
        return matrix_of(table_text(*std::move(text)), path.string(), hints);
    });
}

Expected<Dissimilarity> dissimilarities_of(const LabelledMatrix& matrix,
                                           std::span<const std::string> names,
                                           const std::string& file) {
    std::vector<std::size_t> places;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(matrix.labels, name);
        if (found == matrix.labels.end()) {
            return Error{file + ": expected a row \"" + name + "\" as the set has such a pattern"};
        }
        places.push_back(static_cast<std::size_t>(found - matrix.labels.begin()));
    }
    Dissimilarity result{names.size(), {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = i + 1; j < places.size(); ++j) {
            result.condensed.push_back(matrix.dissimilarity(places[i], places[j]));
        }
    }
    return result;
}

}  // namespace tact
