#include "model/io/tables/matrix_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <ostream>
#include <unordered_set>

#include "model/pattern/pattern.h"
#include "model/text/atomic_file.h"
#include "model/text/csv.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kAsymmetry = 1e-9;  // of the larger value: rounding of other programs

std::string head_row(std::span<const std::string> labels, const std::string& mark) {
    std::string row = csv_field(mark);
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

// A matrix while its lines are read.
struct MatrixReading {
    std::string file;
    std::size_t text_bytes = 0;
    bool is_labelled = false;
    LabelledMatrix matrix;
    std::size_t rows = 0;
};

Error at_line(const MatrixReading& reading, std::size_t line, const std::string& fault) {
    return Error{reading.file + ":" + std::to_string(line) + ": " + fault};
}

// The labels of the first record; what is wrong with them, or empty.
std::string take_labels(MatrixReading& reading, const CsvRecord& first) {
    auto& labels = reading.matrix.labels;
    if (reading.is_labelled) {
        reading.matrix.mark = first.fields.front();
        labels.assign(first.fields.begin() + 1, first.fields.end());
    } else {
        for (std::size_t k = 0; k < first.fields.size(); ++k) {
            labels.push_back(std::to_string(k + 1));
        }
    }
    if (labels.empty()) return "expected names after the first comma";
    if (labels.size() > limits::kMaxPatterns) return "expected at most 10,000 columns";
    std::unordered_set<std::string_view> seen;
    for (const std::string& label : labels) {
        if (std::string fault = name_fault(label); !fault.empty()) return fault;
        if (!seen.insert(label).second)
            return "expected names that differ, got " + in_quotes(label) + " twice";
    }
    reading.matrix.dissimilarity.size = labels.size();
    // A number takes two characters at least: names alone make no memory.
    const std::size_t pairs = pair_count(labels.size());
    reading.matrix.dissimilarity.condensed.reserve(std::min(pairs, reading.text_bytes / 4));
    return {};
}

// Whether a value below the diagonal is that above it, but for rounding.
bool is_reverse(double lower, double upper) {
    return std::abs(lower - upper) <= kAsymmetry * std::max(std::abs(lower), std::abs(upper));
}

// One row; what is wrong with it, or empty.
std::string take_row(MatrixReading& reading, const CsvRecord& record) {
    const auto& labels = reading.matrix.labels;
    const std::size_t i = reading.rows;
    const std::size_t head = reading.is_labelled ? 1 : 0;
    if (i == labels.size()) return "expected as many rows as columns, got more";
    if (record.fields.size() != labels.size() + head) {
        return "expected " + std::to_string(labels.size()) + " numbers, got " +
               std::to_string(record.fields.size() - std::min(head, record.fields.size()));
    }
    if (reading.is_labelled && record.fields[0] != labels[i]) {
        return "expected the row of " + in_quotes(labels[i]) + ", got " +
               in_quotes(record.fields[0]);
    }
    for (std::size_t j = 0; j < labels.size(); ++j) {
        const std::string& field = record.fields[j + head];
        const auto value = finite_number_in(field);
        if (!value) {
            return "column " + in_quotes(labels[j]) + ": expected a finite number, got " +
                   in_quotes(field);
        }
        if (j == i && *value != 0.0) {
            return "expected 0 on the diagonal, got " + in_quotes(field);
        }
        if (j < i && !is_reverse(*value, reading.matrix.dissimilarity(j, i))) {
            return "expected a symmetric matrix, got other values for " + in_quotes(labels[i]) +
                   " and " + in_quotes(labels[j]) + " than for the reverse";
        }
        if (j > i) reading.matrix.dissimilarity.condensed.push_back(*value);
    }
    ++reading.rows;
    return {};
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
                      const Dissimilarity& dissimilarity, const std::string& mark) {
    assert(labels.size() == dissimilarity.size && "one label for each object");
    stream << head_row(labels, mark);
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
                           const Eigen::MatrixXd& points, const std::string& mark) {
    assert(static_cast<Eigen::Index>(labels.size()) == points.rows() && "one label for each point");
    stream << (mark.empty() ? "name" : csv_field(mark));
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

Expected<LabelledMatrix> parse_matrix(std::string_view text, const std::string& file) {
    MatrixReading reading;
    reading.file = file;
    text = without_bom(text);
    reading.text_bytes = text.size();
    if (const auto invalid = first_invalid_utf8(text)) {
        return at_line(reading, position_of(text, *invalid).line, "expected text in UTF-8");
    }
    CsvReader reader = reader_of(text);
    for (bool is_first = true;; is_first = false) {
        const CsvRecord record = next_record(reader);
        if (record.line == 0) break;
        if (record.is_quote_open) return at_line(reading, record.line, "expected a closing quote");
        std::string fault;
        if (is_first) {
            reading.is_labelled = reader.separator == ',' && !finite_number_in(record.fields[0]);
            fault = take_labels(reading, record);
            if (fault.empty() && reading.is_labelled) continue;
        }
        if (fault.empty()) fault = take_row(reading, record);
        if (!fault.empty()) return at_line(reading, record.line, fault);
    }
    if (reading.rows < reading.matrix.labels.size() || reading.rows == 0) {
        return at_line(reading, reader.line,
                       "expected " + std::to_string(reading.matrix.labels.size()) +
                           " rows, as there are columns, got " + std::to_string(reading.rows));
    }
    return std::move(reading.matrix);
}

Expected<LabelledMatrix> read_matrix_file(const std::filesystem::path& path) {
    return with_enough_memory(path.string(), [&path]() -> Expected<LabelledMatrix> {
        const auto text = read_text_file(path);
        if (!text) return text.error();
        return parse_matrix(*text, path.string());
    });
}

}  // namespace tact
