#include "model/io/recordings/acceleration_table.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "model/io/recordings/column_names.h"
#include "model/io/recordings/recording.h"
#include "model/table/table.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

using Fields = std::vector<std::string>;

// How the numbers of a file are written, and the names over them.
struct Layout {
    char separator = ',';
    std::optional<char> decimal;  // that somebody says
    std::size_t first_line = 0;   // of the numbers
    std::size_t columns = 0;
    Fields names;              // one a column; empty: none
    std::string_view heading;  // the line before the numbers
    std::size_t heading_line = 0;
    bool names_are_comment = false;
    std::optional<double> rate_hz;  // that a comment says
};

// Which column is what.
struct Columns {
    std::optional<std::size_t> time;  // or how long after the row before
    std::vector<std::size_t> axes;
};

// Commas are decimal ones where nothing else can be meant, as within a cell between commas, which
// then stands in quotes; or somebody says so.
std::optional<double> number_in(std::string field, const Layout& layout) {
    if (layout.decimal.value_or(',') == ',') std::ranges::replace(field, ',', '.');
    return finite_number_in(field);
}

// "2026-01-02T10:00:00.001000" as seconds, whose zero is nobody's concern; nothing where it is no
// such time. The zone behind it is the same throughout a recording.
std::optional<double> clock_s(std::string_view field) {
    field = trimmed(field);
    constexpr std::string_view kShape = "0000-00-00T00:00:00";
    if (field.size() < kShape.size()) return std::nullopt;
    for (std::size_t k = 0; k < kShape.size(); ++k) {
        const bool is_digit = field[k] >= '0' && field[k] <= '9';
        const bool fits = kShape[k] == '0'   ? is_digit
                          : kShape[k] == 'T' ? field[k] == 'T' || field[k] == ' '
                                             : field[k] == kShape[k];
        if (!fits) return std::nullopt;
    }
    const auto part = [field](std::size_t from, std::size_t count) {
        return finite_number_in(field.substr(from, count)).value_or(0.0);
    };
    const std::size_t end = std::min(field.find_first_not_of("0123456789.,", 17), field.size());
    std::string seconds(field.substr(17, end - 17));
    std::ranges::replace(seconds, ',', '.');
    const std::optional<double> s = finite_number_in(seconds);
    if (!s) return std::nullopt;
    // Days of a month count as if each had 31: a recording over its end is refused as uneven.
    const double days = 372.0 * (part(0, 4) - 2000.0) + 31.0 * part(5, 2) + part(8, 2);
    return 86'400.0 * days + 3600.0 * part(11, 2) + 60.0 * part(14, 2) + *s;
}

// A number or what stands for a missing one: such a line is no heading.
bool is_like_a_number(const std::string& field, const Layout& layout) {
    if (number_in(field, layout) || clock_s(field)) return true;
    const std::string word = lower_case(std::string(trimmed(field)));
    return word == "nan" || word == "inf" || word == "-inf" || word == "-nan";
}

// Takes the line at the head of a text.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return line;
}

// Blank lines and comments are passed over.
CsvRecord next_row(CsvReader& reader) {
    while (!reader.rest.empty()) {
        std::string_view rest = reader.rest;
        const std::string_view line = take_line(rest);
        if (!trimmed(line).empty() && !is_table_comment(trimmed(line))) break;
        reader.rest = rest;
        ++reader.line;
    }
    return next_record(reader);
}

CsvRecord record_of(std::string_view line, char separator) {
    CsvReader reader{line, 1, separator};
    return next_record(reader);
}

bool names_something(const Fields& names) {
    return std::ranges::any_of(names, [](const std::string& name) {
        const std::string word = word_and_unit(name).first;
        return is_time(word) || is_axis(word);
    });
}

// Names of `columns` columns in a comment such as "# t, x, y"; empty: another comment.
Fields names_in_comment(std::string_view comment, char separator, std::size_t columns) {
    comment = trimmed(comment);
    comment.remove_prefix(std::min(comment.find_first_not_of("#% \t"), comment.size()));
    for (const char one : {separator, ',', ';', '\t'}) {
        Fields names = record_of(comment, one).fields;
        if (names.size() == columns && names_something(names)) return names;
    }
    return {};
}

// "# sample rate: 2000 Hz", "# sampling_frequency_hz=2000", "# rate 2 kHz".
std::optional<double> rate_in_comment(std::string_view comment) {
    const std::string text = lower_case(std::string(comment));
    std::size_t from = text.find("rate");
    if (from == text.npos) from = text.find("sampling freq");
    if (from == text.npos) from = text.find("sample freq");
    if (from == text.npos) return std::nullopt;
    const std::size_t begin = text.find_first_of("0123456789", from);
    if (begin == text.npos) return std::nullopt;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
    const auto number = finite_number_in(text.substr(begin, end - begin));
    if (!number || !(*number > 0.0)) return std::nullopt;
    return *number * (text.find("khz", from) != text.npos ? 1000.0 : 1.0);
}

// Looks for the first line of numbers under any separator, or the one that somebody says; the
// heading is the line before it.
std::optional<Layout> layout_of(std::string_view text, const TableHints& hints) {
    constexpr std::size_t kMostLines = 100;  // of a heading
    std::string_view heading;
    std::string_view comment;
    std::optional<double> rate_hz;
    std::size_t heading_line = 0;
    for (std::size_t number = 1; !text.empty() && number <= kMostLines; ++number) {
        const std::string_view line = trimmed(take_line(text));
        if (is_table_comment(trimmed(line))) {
            comment = line;
            if (const auto rate = rate_in_comment(line)) rate_hz = rate;
        }
        if (line.empty() || is_table_comment(trimmed(line))) continue;
        for (const char separator : {';', '\t', ',', ' '}) {
            if (separator != hints.separator.value_or(separator)) continue;
            if (separator != ' ' && line.find(separator) == line.npos) continue;
            const Fields fields = record_of(line, separator).fields;
            Layout layout;
            layout.separator = separator;
            layout.decimal = hints.decimal;
            layout.first_line = number;
            layout.columns = fields.size();
            layout.heading = heading;
            layout.heading_line = heading_line;
            layout.rate_hz = rate_hz;
            const auto is_number = [&layout](const std::string& field) {
                return is_like_a_number(field, layout);
            };
            if (!std::ranges::all_of(fields, is_number)) continue;
            Fields names = heading.empty() ? Fields{} : record_of(heading, separator).fields;
            // Blanks within names: "time (s)" over a column of its own.
            if (names.size() != fields.size() && separator == ' ' && fields.size() == 1) {
                names = {std::string(heading)};
            }
            if (names.empty()) {
                names = names_in_comment(comment, separator, fields.size());
                layout.names_are_comment = !names.empty();
            }
            if (names.size() == fields.size()) layout.names = std::move(names);
            return layout;
        }
        heading = line;
        heading_line = number;
    }
    return std::nullopt;
}

bool is_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

// Whether every line of numbers that commas cut could be whole numbers with decimal commas:
// "-0,0471". A single column has numbers without decimals, too.
bool may_be_decimal_commas(CsvReader reader, const Layout& layout) {
    for (CsvRecord row = next_row(reader); row.line > 0; row = next_row(reader)) {
        if (layout.columns == 2 && row.fields.size() == 1) row.fields.emplace_back("0");
        if (row.fields.size() != layout.columns || layout.columns % 2 == 1) return false;
        for (std::size_t k = 0; k < row.fields.size(); k += 2) {
            std::string_view whole = trimmed(row.fields[k]);
            if (whole.starts_with('-') || whole.starts_with('+')) whole.remove_prefix(1);
            std::string_view decimals = row.fields[k + 1];
            if (decimals.ends_with('\r')) decimals.remove_suffix(1);
            if (!is_digits(whole) || !is_digits(decimals)) return false;
        }
    }
    return true;
}

// Tells commas between columns from decimal ones; what is wrong, or empty.
std::string settle_commas(const CsvReader& numbers, Layout& layout) {
    if (layout.separator != ',' || layout.columns < 2 || !layout.names.empty()) return {};
    if (layout.decimal) return {};
    const bool decimal = may_be_decimal_commas(numbers, layout);
    const bool names_one = layout.heading.find(',') == layout.heading.npos &&
                           is_axis(word_and_unit(std::string(layout.heading)).first);
    if (decimal && names_one && layout.columns == 2) {
        layout.separator = ' ';
        layout.columns = 1;
        layout.names = {std::string(layout.heading)};
        return {};
    }
    if (names_one) {
        return "expected one number, as " + in_quotes(layout.heading) + " names one column, got " +
               std::to_string(layout.columns);
    }
    if (!decimal) return {};
    return "expected names of columns before the first number (\"t,x\" or \"x\"), or semicolons "
           "between columns: these commas may be decimal ones";
}

// One number a line, under names of which the first is that of a time.
bool has_times_alone(const Layout& layout) {
    if (layout.columns != 1 || layout.heading.empty()) return false;
    for (const char separator : {';', '\t', ','}) {
        const Fields names = record_of(layout.heading, separator).fields;
        if (names.size() > 1) return is_time(word_and_unit(names[0]).first);
    }
    return is_time(word_and_unit(std::string(layout.heading)).first);
}

Fields names_by_number(std::size_t columns) {
    Fields names;
    for (std::size_t k = 0; k < columns; ++k) names.push_back(std::to_string(k + 1));
    return names;
}

Columns columns_of(const Layout& layout) {
    Columns columns;
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < layout.names.size(); ++k) {
        const std::string word = word_and_unit(layout.names[k]).first;
        if (is_time(word) && !columns.time) {
            columns.time = k;
        } else if (is_axis(word)) {
            columns.axes.push_back(k);
        } else if (!is_total(word)) {
            others.push_back(k);
        }
    }
    if (columns.time && columns.axes.empty()) columns.axes = others;
    if (!columns.axes.empty()) return columns;
    // By their number.
    columns = {};
    if (layout.columns == 2 || layout.columns == 4) columns.time = 0;
    for (std::size_t k = columns.time ? 1 : 0; k < layout.columns; ++k) columns.axes.push_back(k);
    return columns;
}

// The columns that somebody named, in place of those that their names tell.
Expected<Columns> columns_named(const Layout& layout, const AccelerationColumns& named) {
    Columns columns = columns_of(layout);
    const Fields numbers = names_by_number(layout.columns);
    const Fields& head = layout.names.empty() ? numbers : layout.names;
    if (!named.time.empty()) {
        const auto place = place_of_column(head, named.time);
        if (!place) return place.error();
        columns.time = *place;
        std::erase(columns.axes, *place);
    }
    const bool has_axes = !(named.x.empty() && named.y.empty() && named.z.empty());
    if (has_axes) columns.axes.clear();
    for (const std::string* name : {&named.x, &named.y, &named.z}) {
        if (name->empty()) continue;
        const auto place = place_of_column(head, *name);
        if (!place) return place.error();
        const bool is_taken = std::ranges::find(columns.axes, *place) != columns.axes.end();
        if (is_taken || columns.time == *place) {
            return Error{"expected a column of its own for each, got " + in_quotes(*name) +
                         " twice"};
        }
        columns.axes.push_back(*place);
    }
    if (columns.axes.empty()) return Error{"expected an axis beside the time, got none"};
    return columns;
}

// A table while its lines are read.
struct TableReading {
    Layout layout;
    Columns columns;
    AccelerationTable table;
    bool has_steps = false;  // in the place of times: how long after the row before
    char decimal_sign = 0;   // of the numbers so far; 0: none had one
};

// What is wrong with the decimal sign of a number, or empty: where both signs occur, one of them is
// no decimal sign.
std::string sign_fault(TableReading& reading, const std::string& field) {
    if (reading.layout.decimal) return {};
    for (const char c : field) {
        if (c != ',' && c != '.') continue;
        if (reading.decimal_sign != 0 && c != reading.decimal_sign) {
            return "expected one decimal sign in all numbers, got " + in_quotes(field) +
                   (c == ',' ? " after points" : " after commas");
        }
        reading.decimal_sign = c;
    }
    return {};
}

// The numbers of one line into the table; what is wrong, or empty.
std::string take(const CsvRecord& record, TableReading& reading) {
    const Layout& layout = reading.layout;
    const Columns& columns = reading.columns;
    AccelerationTable& table = reading.table;
    if (record.fields.size() != layout.columns) {
        return "expected " + std::to_string(layout.columns) + " columns as before, got " +
               std::to_string(record.fields.size());
    }
    std::string fault;
    const auto number = [&](std::size_t column, const char* what, std::vector<double>& to) {
        const std::string& field = record.fields[column];
        const auto value = number_in(field, layout);
        if (fault.empty()) fault = sign_fault(reading, field);
        if (!value && fault.empty()) {
            fault = std::string("expected ") + what + ", got " + in_quotes(field);
        }
        if (value) to.push_back(*value);
    };
    for (std::size_t a = 0; a < columns.axes.size(); ++a) {
        number(columns.axes[a], "a finite number", table.axes[a]);
    }
    const auto clock = columns.time ? clock_s(record.fields[*columns.time]) : std::nullopt;
    if (clock) {
        table.time.push_back(*clock);
        table.time_unit_s = 1.0;
    } else if (columns.time) {
        number(*columns.time, "a time", table.time);
        const std::size_t count = table.time.size();
        if (reading.has_steps && fault.empty() && count > 1)
            table.time.back() += table.time[count - 2];
    }
    const std::size_t rows = table.axes.front().size();
    if (fault.empty() && rows > kMaxDecodedSamples / (columns.axes.size() + 1)) {
        return "expected at most " + grouped_digits(kMaxDecodedSamples) + " numbers in all";
    }
    return fault;
}

// The unit of one axis; what is wrong with it, or empty.
std::string take_unit(const std::string& name, AccelerationTable& table) {
    const std::string written = word_and_unit(name).second;
    if (written.empty()) return {};
    const std::optional<AccelerationUnit> unit = unit_of(written);
    if (!unit) {
        return "expected a unit of g, m/s2 or V, got " + in_quotes(written) + " in the name " +
               in_quotes(name);
    }
    if (table.unit && *table.unit != *unit) {
        return "expected one unit for all axes, got " + in_quotes(table.unit_column) + " and " +
               in_quotes(name);
    }
    if (!table.unit) table.unit_column = name;
    table.unit = unit;
    return {};
}

// The unit of the times that the name of their column says; what is wrong with it, or empty.
std::string take_named_time_unit(const std::string& name, std::optional<TimeUnit> asked,
                                 AccelerationTable& table) {
    const std::string written = word_and_unit(name).second;
    table.time_unit_s = time_unit_of(written);
    if (written.empty() || asked || table.time_unit_s) return {};
    return "expected a time in s, ms, us or ns, got " + in_quotes(written) + " in the name " +
           in_quotes(name);
}

// The unit of the times that somebody says; what is wrong with it, or empty.
std::string take_time_unit(const Layout& layout, const Columns& columns,
                           std::optional<TimeUnit> asked, AccelerationTable& table) {
    if (asked && !columns.time) {
        return "expected a column of times, as a unit of them is given, got none";
    }
    if (columns.time && !layout.names.empty()) {
        auto fault = take_named_time_unit(layout.names[*columns.time], asked, table);
        if (!fault.empty()) return fault;
    }
    if (!asked) return {};
    const auto place = static_cast<std::size_t>(*asked);
    if (table.time_unit_s && *table.time_unit_s != kTimeUnitsS[place]) {
        return "expected times in the unit that the column " +
               in_quotes(layout.names[*columns.time]) + " says, got the unit " + kTimeUnits[place] +
               " beside it";
    }
    table.time_unit_s = kTimeUnitsS[place];
    return {};
}

// The units that the names and somebody say; what is wrong with them, or empty.
std::string take_units(const Layout& layout, const Columns& columns, std::optional<TimeUnit> asked,
                       AccelerationTable& table) {
    for (const std::size_t axis : columns.axes) {
        if (layout.names.empty()) break;
        if (std::string fault = take_unit(layout.names[axis], table); !fault.empty()) return fault;
    }
    return take_time_unit(layout, columns, asked, table);
}

}  // namespace

Expected<AccelerationColumns> acceleration_columns(std::string_view text) {
    AccelerationColumns columns;
    const std::string fault = take_column_roles(
        text, {{"time", &columns.time}, {"x", &columns.x}, {"y", &columns.y}, {"z", &columns.z}});
    if (!fault.empty()) return Error{fault};
    return columns;
}

Expected<AccelerationTable> parse_acceleration_table(std::string_view text, const std::string& file,
                                                     bool rising_time,
                                                     const AccelerationTableOptions& options) {
    text = without_bom(text);
    const std::optional<Layout> layout = layout_of(text, options.written);
    if (!layout) return at_line(file, 1, "expected a line of numbers, got none");
    TableReading reading{*layout, {}, {}};
    CsvReader reader{text, 1, ','};
    for (; reader.line < layout->first_line; ++reader.line) take_line(reader.rest);
    if (const std::string fault = settle_commas(reader, reading.layout); !fault.empty()) {
        return at_line(file, layout->first_line, fault);
    }
    reader.separator = reading.layout.separator;
    auto columns = columns_named(reading.layout, options.columns);
    if (!columns) return at_line(file, layout->first_line, columns.error().message);
    reading.columns = *std::move(columns);
    if (const auto time = reading.columns.time; time && !reading.layout.names.empty()) {
        reading.has_steps = is_step_of_time(word_and_unit(reading.layout.names[*time]).first);
    }
    AccelerationTable& table = reading.table;
    const auto& names = reading.layout.names;
    if (has_times_alone(*layout)) {
        return at_line(file, layout->first_line,
                       "expected accelerations behind the times, got times alone");
    }
    for (const std::size_t axis : reading.columns.axes) {
        if (!names.empty()) table.axis_names.emplace_back(trimmed(names[axis]));
    }
    table.axes.resize(reading.columns.axes.size());
    table.time_place = reading.columns.time;
    table.rate_hz = layout->rate_hz;
    table.axis_places = reading.columns.axes;
    table.first_line =
        names.empty() || layout->names_are_comment ? layout->first_line : layout->heading_line;
    if (const auto fault = take_units(reading.layout, reading.columns, options.time_unit, table);
        !fault.empty()) {
        return at_line(file, layout->first_line, fault);
    }
    for (CsvRecord record = next_row(reader); record.line > 0; record = next_row(reader)) {
        const std::string fault = take(record, reading);
        if (!fault.empty()) return at_line(file, record.line, fault);
        const std::size_t count = table.time.size();
        if (rising_time && count > 1 && !(table.time[count - 1] > table.time[count - 2])) {
            return at_line(file, record.line,
                           "expected a later time than " + shortest_digits(table.time[count - 2]) +
                               ", got " + shortest_digits(table.time[count - 1]) +
                               " (with a rate of your own the times do not matter)");
        }
    }
    table.dialect.separator = reading.layout.separator;
    table.dialect.decimal =
        reading.layout.decimal.value_or(reading.decimal_sign == ',' ? ',' : '.');
    return std::move(reading.table);
}

}  // namespace tact
