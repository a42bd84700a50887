#include "app/command_line/text_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

std::string aligned(const std::vector<TextRow>& exact) {
    std::vector<TextRow> rows;
    for (const TextRow& row : exact) rows.push_back(shown_texts(row));
    std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size(), 0);
    for (const TextRow& row : rows) {
        assert(row.size() == widths.size() && "as many cells in every row");
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    }
    std::string text;
    for (const TextRow& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const std::string blanks(widths[k] - row[k].size(), ' ');
            line += k == 0 ? row[k] + blanks : "  " + blanks + row[k];
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string range_text(double low, double high, int digits) {
    if (std::isnan(low) || std::isnan(high)) return "-";
    return fixed_digits(low, digits) + " to " + fixed_digits(high, digits);
}

std::string csv_line(const TextRow& row) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += (k == 0 ? "" : ",") + csv_field(row[k]);
    return line + "\n";
}

std::string csv_number(double value) {
    return std::isnan(value) ? std::string() : shortest_digits(value);
}

}  // namespace tact
