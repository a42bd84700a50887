// A table as a spreadsheet reads it, and as the program reads it again.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "model/text/csv.h"
#include "model/text/numbers.h"

namespace tact {

// By RFC 4180, as a spreadsheet reads it: without what the program's own reader takes back.
inline std::vector<std::vector<std::string>> cells_of_spreadsheet(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
    bool is_quoted = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        std::string& cell = rows.back().back();
        const char c = text[k];
        if (c == '"' && is_quoted && k + 1 < text.size() && text[k + 1] == '"') {
            cell += text[++k];
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (c == ',' && !is_quoted) {
            rows.back().emplace_back();
        } else if (c == '\n' && !is_quoted) {
            rows.emplace_back(1);
        } else {
            cell += c;
        }
    }
    CHECK_FALSE(is_quoted);
    if (rows.back() == std::vector<std::string>{""}) rows.pop_back();
    return rows;
}

inline bool is_run(const std::string& cell) {
    static const std::vector<std::string> kSigns{"=",  "+",      "-",      "@",      "\t",    "\r",
                                                 "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    const auto begins = [&cell](const std::string& sign) { return cell.starts_with(sign); };
    return std::ranges::any_of(kSigns, begins) && cell.size() > 1 && !finite_number_in(cell);
}

inline std::set<std::string> cells_read_back(const std::string& text) {
    std::set<std::string> cells;
    CsvReader reader{text, 1, ','};
    for (CsvRecord record = next_record(reader); record.line != 0; record = next_record(reader)) {
        cells.insert(record.fields.begin(), record.fields.end());
    }
    return cells;
}

inline void check_table(const std::string& what, const std::string& text,
                        const std::vector<std::string>& wanted) {
    CAPTURE(what);
    const std::vector<std::vector<std::string>> rows = cells_of_spreadsheet(text);
    for (const std::vector<std::string>& row : rows) {
        CHECK(row.size() == rows.front().size());
        for (const std::string& cell : row) CHECK_MESSAGE(!is_run(cell), cell);
    }
    const std::set<std::string> cells = cells_read_back(text);
    for (const std::string& name : wanted) CHECK_MESSAGE(cells.contains(name), name);
}

}  // namespace tact
