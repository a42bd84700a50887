#include "model/io/tables/coordinates_file.h"

#include "model/text/atomic_file.h"
#include "model/text/csv.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"
#include "model/text/utf8.h"

namespace tact {

Expected<LabelledPoints> parse_coordinates(std::string_view text, const std::string& file) {
    text = without_bom(text);
    if (const auto invalid = first_invalid_utf8(text)) {
        return at_line(file, position_of(text, *invalid).line, "expected text in UTF-8");
    }
    CsvReader reader{text};
    const CsvRecord head = next_record(reader);
    if (head.line == 0 || head.fields.size() < 2) {
        return Error{file + ":1: expected a head such as name,D1,D2,D3"};
    }
    LabelledPoints result;
    result.mark = mark_in(head.fields[0]);
    std::vector<double> values;
    for (CsvRecord row = next_record(reader); row.line != 0; row = next_record(reader)) {
        const std::string place = file + ":" + std::to_string(row.line) + ": expected ";
        if (row.is_quote_open) return at_line(file, row.line, "expected a closing quote");
        if (row.fields.size() != head.fields.size()) {
            return Error{place + std::to_string(head.fields.size()) + " fields, got " +
                         std::to_string(row.fields.size())};
        }
        if (const std::string fault = name_fault(row.fields[0]); !fault.empty()) {
            return at_line(file, row.line, fault);
        }
        result.labels.push_back(row.fields[0]);
        for (std::size_t k = 1; k < row.fields.size(); ++k) {
            const auto value = finite_number_in(row.fields[k]);
            if (!value) return Error{place + "a number, got " + in_quotes(row.fields[k])};
            values.push_back(*value);
        }
    }
    const auto columns = static_cast<Eigen::Index>(head.fields.size()) - 1;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    result.points = Eigen::Map<const Rows>(
        values.data(), static_cast<Eigen::Index>(result.labels.size()), columns);
    return result;
}

Expected<LabelledPoints> read_coordinates_file(const std::filesystem::path& path) {
    return with_enough_memory(path.string(), [&path]() -> Expected<LabelledPoints> {
        const Expected<std::string> text = read_text_file(path, kMaxCoordinatesBytes);
        if (!text) return text.error();
        return parse_coordinates(*text, path.string());
    });
}

}  // namespace tact
