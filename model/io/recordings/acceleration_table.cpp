#include "model/io/recordings/acceleration_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/signal/waveform.h"
#include "model/text/csv.h"
#include "model/text/line_error.h"
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
    Fields names;  // empty: none
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

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::optional<double> number_in(std::string field, char separator) {
    if (separator != ',') std::ranges::replace(field, ',', '.');
    return finite_number_in(field);
}

// A number or what stands for a missing one: such a line is no heading.
bool is_like_a_number(const std::string& field, char separator) {
    if (number_in(field, separator)) return true;
    const std::string word = lower(std::string(trimmed(field)));
    return word == "nan" || word == "inf" || word == "-inf" || word == "-nan";
}

// Lines of comments made blank, which keeps the others' numbers.
std::string without_comments(std::string_view text) {
    std::string result(text);
    bool at_start = true;
    bool in_comment = false;
    for (char& c : result) {
        if (c == '\n') {
            at_start = true;
            in_comment = false;
            continue;
        }
        if (at_start && c == '#') in_comment = true;
        if (c != ' ' && c != '\t') at_start = false;
        if (in_comment) c = ' ';
    }
    return result;
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
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
        if (line.empty()) continue;
        for (const char separator : {';', '\t', ',', ' '}) {
            if (separator != ' ' && line.find(separator) == line.npos) continue;
            const Fields fields = record_of(line, separator).fields;
            const auto is_number = [separator](const std::string& field) {
                return is_like_a_number(field, separator);
            };
            if (!std::ranges::all_of(fields, is_number)) continue;
            Layout layout{separator, number, fields.size(), {}};
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
        for (const char* unit : {"s", "ms", "us", "g", "v", "mps2", "ms2", "m/s2", "m/s^2"}) {
            if (end == unit) return {text.substr(0, underscore), end};
        }
    }
    return {text, ""};
}

std::optional<double> time_unit_of(const std::string& unit) {
    if (unit == "s" || unit == "sec" || unit == "seconds") return 1.0;
    if (unit == "ms" || unit == "msec" || unit == "milliseconds") return 1e-3;
    if (unit == "us" || unit == "\u00b5s" || unit == "\u03bcs") return 1e-6;
    return std::nullopt;
}

std::optional<AccelerationUnit> unit_of(const std::string& unit) {
    if (unit == "g") return AccelerationUnit::g;
    if (unit == "v" || unit == "volt" || unit == "volts") return AccelerationUnit::volt;
    for (const char* same :
         {"m/s2", "m/s^2", "m/s\u00b2", "m/s/s", "mps2", "ms2", "ms-2", "m s-2"}) {
        if (unit == same) return AccelerationUnit::m_per_s2;
    }
    return std::nullopt;
}

bool is_time(const std::string& word) {
    return word == "t" || word.starts_with("time") || word.starts_with("zeit") ||
           word.starts_with("elapsed");
}

// Names that stand for an axis in loggers' files; others ("sample", "temperature") are passed over
// where some of these are there.
bool is_axis(const std::string& word) {
    for (const char* letter : {"x", "y", "z"}) {
        for (const char* prefix : {"", "a", "acc", "acc ", "acc_", "accel_", "accel ", "accel",
                                   "acceleration ", "acceleration_", "axis "}) {
            if (word == std::string(prefix) + letter) return true;
        }
    }
    return word.starts_with("acc") || word == "a" || word == "g" || word.starts_with("volt");
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
        } else {
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

// The numbers of one line into the table; what is wrong, or empty.
std::string take(const CsvRecord& record, const Layout& layout, const Columns& columns,
                 AccelerationTable& table) {
    if (record.fields.size() != layout.columns) {
        return "expected " + std::to_string(layout.columns) + " columns as before, got " +
               std::to_string(record.fields.size());
    }
    const auto number = [&](std::size_t column) {
        return number_in(record.fields[column], layout.separator);
    };
    for (std::size_t a = 0; a < columns.axes.size(); ++a) {
        const auto value = number(columns.axes[a]);
        if (!value) {
            return "expected a finite number, got " + in_quotes(record.fields[columns.axes[a]]);
        }
        table.axes[a].push_back(*value);
    }
    if (!columns.time) return {};
    const auto time = number(*columns.time);
    if (!time) return "expected a time, got " + in_quotes(record.fields[*columns.time]);
    table.time.push_back(*time);
    return {};
}

void take_units(const Layout& layout, const Columns& columns, AccelerationTable& table) {
    if (layout.names.empty()) return;
    const std::string& axis = layout.names[columns.axes.front()];
    table.unit = unit_of(word_and_unit(axis).second);
    if (columns.time) {
        table.time_unit_s = time_unit_of(word_and_unit(layout.names[*columns.time]).second);
    }
}

}  // namespace

Expected<AccelerationTable> parse_acceleration_table(std::string_view bytes,
                                                     const std::string& file, bool rising_time) {
    const std::string text = without_comments(without_bom(bytes));
    const std::optional<Layout> layout = layout_of(text);
    if (!layout) return at_line(file, 1, "expected a line of numbers, got none");
    const Columns columns = columns_of(*layout);
    AccelerationTable table;
    table.axes.resize(columns.axes.size());
    take_units(*layout, columns, table);
    CsvReader reader{text, 1, layout->separator};
    while (reader.line < layout->first_line) {
        const std::size_t end = reader.rest.find('\n');
        reader.rest.remove_prefix(end + 1);
        ++reader.line;
    }
    for (CsvRecord record = next_record(reader); record.line > 0; record = next_record(reader)) {
        const std::string fault = take(record, *layout, columns, table);
        if (!fault.empty()) return at_line(file, record.line, fault);
        const std::size_t count = table.time.size();
        if (rising_time && count > 1 && !(table.time[count - 1] > table.time[count - 2])) {
            return at_line(file, record.line,
                           "expected a later time than " + shortest_digits(table.time[count - 2]) +
                               ", got " + shortest_digits(table.time[count - 1]) +
                               " (with a rate of your own the times do not matter)");
        }
    }
    return table;
}

}  // namespace tact
