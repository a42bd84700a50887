#include "model/table/table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Limits of the text that is looked at.
constexpr std::size_t kMostSampledBytes = 1 << 18;
constexpr std::size_t kMostSampledRows = 200;

// Windows-1252 where it is no Latin-1: 0x80 to 0x9F. What it does not know becomes U+FFFD.
constexpr std::array<char16_t, 32> kWindows{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::string from_windows(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char one : bytes) {
        const auto byte = static_cast<unsigned char>(one);
        append_utf8(text, byte >= 0x80 && byte < 0xA0 ? kWindows[byte - 0x80U] : byte);
    }
    return text;
}

void end_lines_by_lf(std::string& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '\r' && (k + 1 == text.size() || text[k + 1] != '\n')) text[k] = '\n';
    }
}

std::string_view line_at(std::string_view text, std::size_t from) {
    return trimmed(text.substr(from, text.find('\n', from) - from));
}

struct Beginning {
    std::size_t lines = 0;  // that are no rows
    std::size_t bytes = 0;
    char separator = '\0';  // as "sep=" says
};

Beginning beginning_of(std::string_view text) {
    Beginning found;
    std::size_t lines = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view line = line_at(text, at);
        const std::size_t end = text.find('\n', at);
        const bool is_mark =
            line.size() == 5 && lower_case(std::string(line.substr(0, 4))) == "sep=";
        if (!line.empty() && !is_table_comment(line) && !is_mark) break;
        at = end == text.npos ? text.size() : end + 1;
        ++lines;
        if (line.empty()) continue;  // it counts to what follows, as readers pass over it
        if (is_mark) found.separator = line[4];
        found.lines = lines;
        found.bytes = at;
    }
    return found;
}

using Rows = std::vector<std::vector<std::string>>;

Rows sampled(std::string_view text, char separator) {
    std::string_view head = text.substr(0, kMostSampledBytes);
    if (head.size() < text.size() && head.find('\n') != head.npos) {
        head = head.substr(0, head.rfind('\n'));
    }
    CsvReader reader{head, 1, separator};
    Rows rows;
    while (rows.size() < kMostSampledRows) {
        CsvRecord record = next_record(reader);
        if (record.line == 0) break;
        rows.push_back(std::move(record.fields));
    }
    return rows;
}

bool is_split(const Rows& rows) {
    const auto split = std::ranges::count_if(rows, [](const auto& row) { return row.size() > 1; });
    return !rows.empty() && 10 * split >= 9 * std::ssize(rows);
}

// "5 0" between commas: the numbers are parted by blanks, and the commas are theirs.
bool holds_two_numbers(const Rows& rows) {
    return std::ranges::any_of(rows, [](const auto& row) {
        return std::ranges::any_of(row, [](const std::string& cell) {
            const std::string_view text = trimmed(cell);
            const std::size_t blank = text.find(' ');
            return blank != text.npos && finite_number_in(text.substr(0, blank)) &&
                   finite_number_in(text.substr(blank + 1));
        });
    });
}

// As many cells in each row, and several.
bool is_even(const Rows& rows) {
    return !rows.empty() && rows[0].size() > 1 &&
           std::ranges::all_of(rows,
                               [&rows](const auto& row) { return row.size() == rows[0].size(); });
}

bool begins_with_comma(const Rows& rows) {
    return std::ranges::any_of(rows, [](const auto& row) {
        return std::ranges::any_of(row,
                                   [](const std::string& cell) { return cell.starts_with(','); });
    });
}

char separator_of(std::string_view text) {
    const Rows by_comma = sampled(text, ',');
    for (const char one : {';', '\t'}) {
        // Names may have semicolons of their own.
        const Rows rows = sampled(text, one);
        if (is_split(rows) && (is_even(rows) || !is_even(by_comma))) return one;
    }
    const bool any_comma =
        std::ranges::any_of(by_comma, [](const auto& row) { return row.size() > 1; });
    if (!any_comma || holds_two_numbers(by_comma)) return ' ';
    // Words between blanks, and commas in numbers alone.
    const Rows by_blank = sampled(text, ' ');
    return !is_even(by_comma) && is_even(by_blank) && !begins_with_comma(by_blank) ? ' ' : ',';
}

// What a cell says of the decimal sign.
enum class Sign { none, point, comma, doubtful };

bool are_digits(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

Sign sign_of(std::string_view cell) {
    cell = trimmed(cell);
    const std::size_t comma = cell.find(',');
    if (comma == cell.npos) {
        return cell.find('.') != cell.npos && finite_number_in(cell) ? Sign::point : Sign::none;
    }
    std::string as_point(cell);
    as_point[comma] = '.';
    if (!finite_number_in(as_point)) return Sign::none;
    std::string_view whole = cell.substr(0, comma);
    if (whole.starts_with('-') || whole.starts_with('+')) whole.remove_prefix(1);
    const std::string_view part = cell.substr(comma + 1);
    const bool may_be_thousands = part.size() == 3 && are_digits(part) && !whole.empty() &&
                                  whole.size() <= 3 && whole[0] != '0';
    return may_be_thousands ? Sign::doubtful : Sign::comma;
}

}  // namespace

bool is_table_comment(std::string_view line) {
    return line.starts_with('#') || line.starts_with('%');
}

TableText table_text(std::string bytes) {
    TableText table;
    if (auto text = utf8_of_utf16(bytes)) {
        table.encoding = TableEncoding::utf16;
        table.text = *std::move(text);
    } else if (first_invalid_utf8(bytes)) {
        table.encoding = TableEncoding::windows_1252;
        table.text = from_windows(bytes);
    } else {
        table.text = std::move(bytes);
    }
    if (without_bom(table.text).size() != table.text.size()) table.text.erase(0, 3);
    end_lines_by_lf(table.text);
    return table;
}

TableDialect dialect_of(std::string_view text, const TableHints& hints) {
    const Beginning begin = beginning_of(text);
    TableDialect dialect;
    dialect.skipped_lines = begin.lines;
    const std::string_view rows_text = text.substr(begin.bytes);
    dialect.separator = hints.separator           ? *hints.separator
                        : begin.separator != '\0' ? begin.separator
                                                  : separator_of(rows_text);
    if (hints.decimal) {
        dialect.decimal = *hints.decimal;
        return dialect;
    }
    std::array<std::size_t, 4> signs{};
    for (const auto& row : sampled(rows_text, dialect.separator)) {
        for (const std::string& cell : row) ++signs[static_cast<std::size_t>(sign_of(cell))];
    }
    const auto count = [&signs](Sign sign) { return signs[static_cast<std::size_t>(sign)]; };
    if (count(Sign::comma) > 0 && count(Sign::point) == 0) dialect.decimal = ',';
    dialect.is_doubtful = count(Sign::doubtful) > 0 && count(Sign::comma) == 0;
    return dialect;
}

CsvReader reader_of(std::string_view text, const TableDialect& dialect) {
    CsvReader reader{text, 1, dialect.separator};
    for (std::size_t k = 0; k < dialect.skipped_lines; ++k) {
        const std::size_t end = reader.rest.find('\n');
        reader.rest.remove_prefix(end == reader.rest.npos ? reader.rest.size() : end + 1);
        ++reader.line;
    }
    return reader;
}

std::optional<double> number_in(std::string_view cell, const TableDialect& dialect) {
    if (dialect.decimal == '.' || cell.find(',') == cell.npos) return finite_number_in(cell);
    std::string text(trimmed(cell));
    if (text.find('.') != text.npos) return std::nullopt;
    text[text.find(',')] = '.';
    return finite_number_in(text);
}

bool says_unknown(std::string_view cell) {
    constexpr std::array<std::string_view, 6> kWords{"", "NA", "NaN", "nan", "na", "-"};
    return std::ranges::find(kWords, trimmed(cell)) != kWords.end();
}

std::string words_on(const TableDialect& dialect, TableEncoding encoding) {
    std::string words;
    const auto say = [&words](const char* more) {
        words += (words.empty() ? "" : ", ") + std::string(more);
    };
    if (dialect.separator == ';') say("semicolons between cells");
    if (dialect.separator == '\t') say("tabs between cells");
    if (dialect.separator == ' ') say("blanks between cells");
    if (dialect.decimal == ',') say("decimal commas");
    if (encoding == TableEncoding::utf16) say("UTF-16");
    if (encoding == TableEncoding::windows_1252) say("Windows-1252");
    return words;
}

std::string_view without_sound_ending(std::string_view name) {
    for (const std::string_view ending : {".wav", ".mp3", ".ogg", ".flac", ".aiff", ".haptic"}) {
        const bool ends =
            name.size() > ending.size() &&
            lower_case(std::string(name.substr(name.size() - ending.size()))) == ending;
        if (ends) return name.substr(0, name.size() - ending.size());
    }
    return name;
}

namespace {

// "a, b and rating", of all roles.
std::string words_on(std::initializer_list<ColumnRole> roles) {
    std::string words;
    for (const ColumnRole& one : roles) {
        const bool is_last = &one + 1 == roles.end();
        words += (words.empty() ? "" : is_last ? " and " : ", ") + std::string(one.role);
    }
    return words;
}

std::string* column_of(std::initializer_list<ColumnRole> roles, std::string_view role) {
    for (const ColumnRole& one : roles) {
        if (role == one.role) return one.column;
    }
    return nullptr;
}

}  // namespace

std::string take_column_roles(std::string_view text, std::initializer_list<ColumnRole> roles) {
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), part.size() + 1));
        const std::size_t equals = std::min(part.find('='), part.size());
        std::string* const column = column_of(roles, trimmed(part.substr(0, equals)));
        const std::string name{trimmed(part.substr(std::min(equals + 1, part.size())))};
        if (column == nullptr || name.empty() || !column->empty()) {
            return "expected " + words_on(roles) + ", each once as ROLE=COLUMN, got " +
                   in_quotes(part);
        }
        *column = name;
    }
    return {};
}

Expected<std::size_t> place_of_column(std::span<const std::string> head, std::string_view column) {
    const auto found = std::ranges::find_if(
        head, [column](const std::string& name) { return trimmed(name) == column; });
    if (found != head.end()) return static_cast<std::size_t>(found - head.begin());
    for (std::size_t k = 0; k < head.size(); ++k) {
        if (column == std::to_string(k + 1)) return k;
    }
    return Error{"expected a column " + in_quotes(column) + ", the columns are " +
                 column_names(head)};
}

std::string column_names(std::span<const std::string> head) {
    constexpr std::size_t kMost = 12;
    std::string names;
    for (std::size_t k = 0; k < std::min(head.size(), kMost); ++k) {
        names += (k == 0 ? "" : ", ") + shortened(trimmed(head[k]));
    }
    if (head.size() > kMost) names += " and " + grouped_digits(head.size() - kMost) + " more";
    return names;
}

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
