#include "model/io/tables/coordinates_file.h"

#include "model/text/atomic_file.h"
#include "model/text/csv.h"
#include "model/text/enough_memory.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kHeadExpected = "expected a head such as name,D1,D2,D3";

}  // namespace

Expected<LabelledPoints> parse_coordinates(std::string_view bytes, const std::string& file,
                                           const TableHints& hints) {
    const TableText table = table_text(std::string(bytes));
    const TableDialect dialect = dialect_of(table.text, hints);
    CsvReader reader = reader_of(table.text, dialect);
    const CsvRecord head = next_record(reader);
    if (head.line == 0) return at_line(file, 1, kHeadExpected);
    if (dialect.is_doubtful) return at_line(file, head.line, kDoubtfulNumbers);
    LabelledPoints result;
    result.mark = mark_in(head.fields[0]);
    if (const std::string words = words_on(dialect, table.encoding); !words.empty()) {
        result.remarks.push_back("read with " + words);
    }
    std::vector<double> values;
    std::size_t fields = head.fields.size();
    for (CsvRecord row = next_record(reader); row.line != 0; row = next_record(reader)) {
        if (row.is_quote_open) return at_line(file, row.line, "expected a closing quote");
        // R's write.table names no column of names.
        const bool has_no_corner = result.labels.empty() && row.fields.size() == fields + 1 &&
                                   head.fields[0] != "name" && result.mark == NumberMark{};
        if (has_no_corner) ++fields;
        if (fields < 2) return at_line(file, head.line, kHeadExpected);
        if (row.fields.size() != fields) {
            return at_line(file, row.line,
                           "expected " + std::to_string(fields) + " fields, got " +
                               std::to_string(row.fields.size()));
        }
        if (const std::string fault = name_fault(row.fields[0]); !fault.empty()) {
            return at_line(file, row.line, fault);
        }
        result.labels.push_back(row.fields[0]);
        for (std::size_t k = 1; k < fields; ++k) {
            const auto value = number_in(row.fields[k], dialect);
            if (!value) {
                return at_line(file, row.line,
                               "expected a number, got " + in_quotes(row.fields[k]));
            }
            values.push_back(*value);
        }
    }
    if (fields < 2) return at_line(file, head.line, kHeadExpected);
    const auto columns = static_cast<Eigen::Index>(fields) - 1;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    result.points = Eigen::Map<const Rows>(
        values.data(), static_cast<Eigen::Index>(result.labels.size()), columns);
    return result;
}

Expected<LabelledPoints> read_coordinates_file(const std::filesystem::path& path,
                                               const TableHints& hints) {
    return with_enough_memory(path.string(), [&]() -> Expected<LabelledPoints> {
        const Expected<std::string> text = read_text_file(path, kMaxCoordinatesBytes);
        if (!text) return text.error();
        return parse_coordinates(*text, path.string(), hints);
    });
}

}  // namespace tact
