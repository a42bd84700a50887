#include "model/io/recordings/acceleration_table.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "model/io/recordings/recording.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

using Fields = std::vector<std::string>;

// How the numbers of a file are written, and the names over them.
struct Layout {
    char separator = ',';
    std::size_t first_line = 0;  // of the numbers
    std::size_t columns = 0;
    Fields names;              // one a column; empty: none
    std::string_view heading;  // the line before the numbers
};

// Which column is what.
struct Columns {
    std::optional<std::size_t> time;
    std::vector<std::size_t> axes;
};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

std::optional<double> number_in(std::string field, char separator) {
    if (separator != ',') std::ranges::replace(field, ',', '.');
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
bool is_like_a_number(const std::string& field, char separator) {
    if (number_in(field, separator) || clock_s(field)) return true;
    const std::string word = lower(std::string(trimmed(field)));
    return word == "nan" || word == "inf" || word == "-inf" || word == "-nan";
}

// Takes the line at the head of a text.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return line;
}

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#'); }

// Blank lines and comments are passed over.
CsvRecord next_row(CsvReader& reader) {
    while (!reader.rest.empty()) {
        std::string_view rest = reader.rest;
        const std::string_view line = take_line(rest);
        if (!trimmed(line).empty() && !is_comment(line)) break;
        reader.rest = rest;
        ++reader.line;
    }
    return next_record(reader);
}

CsvRecord record_of(std::string_view line, char separator) {
    CsvReader reader{line, 1, separator};
    return next_record(reader);
}

// Looks for the first line of numbers under any separator; the heading is the line before it.
std::optional<Layout> layout_of(std::string_view text) {
    constexpr std::size_t kMostLines = 100;  // of a heading
    std::string_view heading;
    for (std::size_t number = 1; !text.empty() && number <= kMostLines; ++number) {
        const std::string_view line = trimmed(take_line(text));
        if (line.empty() || is_comment(line)) continue;
        for (const char separator : {';', '\t', ',', ' '}) {
            if (separator != ' ' && line.find(separator) == line.npos) continue;
            const Fields fields = record_of(line, separator).fields;
            const auto is_number = [separator](const std::string& field) {
                return is_like_a_number(field, separator);
            };
            if (!std::ranges::all_of(fields, is_number)) continue;
            Layout layout{separator, number, fields.size(), {}, heading};
            Fields names = heading.empty() ? Fields{} : record_of(heading, separator).fields;
            // Blanks within names: "time (s)" over a column of its own.
            if (names.size() != fields.size() && separator == ' ' && fields.size() == 1) {
                names = {std::string(heading)};
            }
            if (names.size() == fields.size()) layout.names = std::move(names);
            return layout;
        }
        heading = line;
    }
    return std::nullopt;
}

// Units behind an underscore; those that are none of ours are known so that they can be refused.
bool is_unit_word(std::string_view text) {
    constexpr std::array kUnits{"s",     "ms",   "us",   "ns",       "min",    "g",     "v",
                                "mps2",  "ms2",  "m/s2", "m/s^2",    "mg",     "ug",    "gal",
                                "mv",    "uv",   "kv",   "mm/s2",    "mm/s^2", "cm/s2", "cm/s^2",
                                "ft/s2", "mms2", "lsb",  "adc",      "counts", "raw",   "mps",
                                "m/s",   "mm/s", "dps",  "m/s\u00b2"};
    return std::ranges::find(kUnits, text) != kUnits.end();
}

// Columns that are called by their unit alone. "a", "g" and "s" are names, too.
bool is_unit_name(std::string_view text) {
    constexpr std::array kUnits{"v",       "volt",   "volts",        "voltage", "mv",
                                "mg",      "gal",    "lsb",          "adc",     "counts",
                                "raw",     "ms",     "us",           "ns",      "second",
                                "seconds", "millis", "milliseconds", "micros",  "microseconds"};
    return std::ranges::find(kUnits, text) != kUnits.end();
}

// "Time [ms]" as its word and its unit: "time", "ms"; "ax_g" has the unit "g".
std::pair<std::string, std::string> word_and_unit(const std::string& name) {
    std::string text = lower(std::string(trimmed(name)));
    const std::size_t bracket = text.find_first_of("([");
    if (bracket != text.npos) {
        std::string unit = text.substr(bracket + 1);
        unit = unit.substr(0, unit.find_first_of(")]"));
        return {std::string(trimmed(text.substr(0, bracket))), std::string(trimmed(unit))};
    }
    const std::size_t underscore = text.rfind('_');
    if (underscore != text.npos && underscore > 0) {
        const std::string end = text.substr(underscore + 1);
        if (is_unit_word(end)) return {text.substr(0, underscore), end};
    }
    // "Beschleunigung in m/s2", "time in ms".
    const std::size_t in = text.rfind(" in ");
    if (in != text.npos) return {text.substr(0, in), std::string(trimmed(text.substr(in + 4)))};
    if (is_unit_name(text) || (text.size() > 1 && is_unit_word(text))) return {text, text};
    // "t/ms", "a / m/s2", "acc g": what stands last.
    for (const std::size_t cut : {text.find('/'), text.rfind(' ')}) {
        if (cut == text.npos || cut == 0) continue;
        const std::string end(trimmed(text.substr(cut + 1)));
        if (is_unit_word(end)) return {std::string(trimmed(text.substr(0, cut))), end};
    }
    return {text, ""};
}

std::optional<double> time_unit_of(const std::string& unit) {
    const auto is = [&unit](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, unit) != names.end();
    };
    if (is({"s", "sec", "secs", "second", "seconds", "sekunden"})) return 1.0;
    if (is({"ms", "msec", "millis", "millisecond", "milliseconds"})) return 1e-3;
    if (is({"us", "usec", "micros", "microsecond", "microseconds", "\u00b5s", "\u03bcs"}))
        return 1e-6;
    if (is({"ns", "nsec", "nanos", "nanosecond", "nanoseconds"})) return 1e-9;
    return std::nullopt;
}

std::optional<AccelerationUnit> unit_of(const std::string& unit) {
    if (unit == "g") return AccelerationUnit::g;
    if (unit == "v" || unit == "volt" || unit == "volts" || unit == "voltage")
        return AccelerationUnit::volt;
    for (const char* same :
         {"m/s2", "m/s^2", "m/s\u00b2", "m/s/s", "mps2", "ms2", "ms-2", "m s-2"}) {
        if (unit == same) return AccelerationUnit::m_per_s2;
    }
    return std::nullopt;
}

bool is_time(const std::string& word) {
    return word == "t" || word.starts_with("time") || word.starts_with("zeit") ||
           word.starts_with("elapsed") || word == "second" || word == "seconds" ||
           word == "millis" || word == "micros";
}

// Names that stand for an axis in loggers' files; others ("sample", "temperature") are passed over
// where some of these are there.
bool is_axis(const std::string& word) {
    if (word.empty()) return false;
    for (const char* letter : {"x", "y", "z"}) {
        for (const char* prefix : {"", "a", "acc", "acc ", "acc_", "accel_", "accel ", "accel",
                                   "acceleration ", "acceleration_", "axis "}) {
            if (word == std::string(prefix) + letter) return true;
        }
    }
    // "linear acceleration x", "user acc y"; forces in g: "gfx".
    const std::string_view last = std::string_view(word).substr(word.size() - 1);
    const bool is_letter = last == "x" || last == "y" || last == "z";
    const bool is_of_acceleration = word.find("acc") != word.npos || word.starts_with("gf");
    const bool is_apart = word.size() > 1 && (word[word.size() - 2] == ' ' || word.size() == 3);
    if (is_letter && is_of_acceleration && is_apart) return true;
    return word.starts_with("acc") || word == "a" || word == "g" || word.starts_with("volt");
}

// Made of the axes, and none itself.
bool is_total(const std::string& word) {
    for (const char* begin : {"abs", "total", "norm", "magnitude", "resultant", "tgf", "|a|"}) {
        if (word.starts_with(begin)) return true;
    }
    return false;
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

// A table while its lines are read.
struct TableReading {
    Layout layout;
    Columns columns;
    AccelerationTable table;
    char decimal_sign = 0;  // of the numbers so far; 0: none had one
};

// What is wrong with the decimal sign of a number, or empty: where both signs occur, one of them is
// no decimal sign.
std::string sign_fault(TableReading& reading, const std::string& field) {
    if (reading.layout.separator == ',') return {};
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
        const auto value = number_in(field, layout.separator);
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

// The units that the names say; what is wrong with them, or empty.
std::string take_units(const Layout& layout, const Columns& columns, AccelerationTable& table) {
    if (layout.names.empty()) return {};
    for (const std::size_t axis : columns.axes) {
        if (std::string fault = take_unit(layout.names[axis], table); !fault.empty()) return fault;
    }
    if (!columns.time) return {};
    const std::string& name = layout.names[*columns.time];
    const std::string written = word_and_unit(name).second;
    table.time_unit_s = time_unit_of(written);
    if (written.empty() || table.time_unit_s) return {};
    return "expected a time in s, ms, us or ns, got " + in_quotes(written) + " in the name " +
           in_quotes(name);
}

}  // namespace

Expected<AccelerationTable> parse_acceleration_table(std::string_view text, const std::string& file,
                                                     bool rising_time) {
    text = without_bom(text);
    const std::optional<Layout> layout = layout_of(text);
    if (!layout) return at_line(file, 1, "expected a line of numbers, got none");
    TableReading reading{*layout, {}, {}, 0};
    CsvReader reader{text, 1, ','};
    for (; reader.line < layout->first_line; ++reader.line) take_line(reader.rest);
    if (const std::string fault = settle_commas(reader, reading.layout); !fault.empty()) {
        return at_line(file, layout->first_line, fault);
    }
    reader.separator = reading.layout.separator;
    reading.columns = columns_of(reading.layout);
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
    if (const auto fault = take_units(reading.layout, reading.columns, table); !fault.empty()) {
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
    return std::move(reading.table);
}

}  // namespace tact
