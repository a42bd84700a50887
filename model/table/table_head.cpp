#include "model/table/table_head.h"

#include <algorithm>
#include <utility>

#include "model/text/utf8.h"

namespace tact {

TableHead head_of_table(std::string bytes, const TableHints& hints, std::size_t rows,
                        std::size_t first_line) {
    const TableText table = table_text(std::move(bytes));
    TableHead head{dialect_of(table.text, hints), table.encoding, {}};
    CsvReader reader = reader_of(table.text, head.dialect);
    while (head.rows.size() < rows) {
        CsvRecord record = next_record(reader);
        if (record.line == 0) break;
        const bool is_blank = std::ranges::all_of(
            record.fields, [](const std::string& cell) { return trimmed(cell).empty(); });
        if (record.line >= first_line && !is_blank) head.rows.push_back(std::move(record.fields));
    }
    return head;
}

}  // namespace tact
