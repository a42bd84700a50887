#include "model/text/csv.h"

#include <algorithm>
#include <utility>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::string_view kBlanks = " \t\r";

// The text up to the end of the line, which is taken as well.
std::string_view take_line(CsvReader& reader) {
    const std::size_t end = reader.rest.find('\n');
    const std::string_view line = reader.rest.substr(0, end);
    reader.rest.remove_prefix(end == line.npos ? reader.rest.size() : end + 1);
    ++reader.line;
    return line;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(kBlanks) == line.npos; }

std::vector<std::string> words(std::string_view line) {
    std::vector<std::string> result;
    while (!is_blank(line)) {
        line.remove_prefix(line.find_first_not_of(kBlanks));
        const bool is_last = result.size() + 1 == kMaxCsvFields;
        const std::size_t quote = line[0] == '"' && !is_last ? line.find('"', 1) : line.npos;
        if (quote != line.npos) {  // as R writes names
            result.emplace_back(line.substr(1, quote - 1));
            line.remove_prefix(quote + 1);
            continue;
        }
        const std::size_t end =
            is_last ? line.size() : std::min(line.find_first_of(kBlanks), line.size());
        result.emplace_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return result;
}

// Whether a formula begins there, behind apostrophes if any. Spreadsheets of East Asia take the
// full-width forms of the four signs for them.
bool is_run_behind(std::string_view text, std::size_t first) {
    constexpr std::string_view kRun[] = {"=",  "+",      "-",      "@",      "\t",    "\r",
                                         "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    if (first == text.npos) return false;
    text.remove_prefix(first);
    return std::ranges::any_of(kRun, [text](std::string_view sign) {
        return text.starts_with(sign) && text.size() > sign.size();
    });
}

// Fields of a line; one whose quotes are open at its end continues in the next line.
void take_fields(CsvReader& reader, std::string_view line, CsvRecord& record) {
    std::string field;
    bool quoted = false;
    for (std::size_t k = 0;; ++k) {
        if (k >= line.size()) {
            if (!quoted) break;
            record.is_quote_open = reader.rest.empty();
            if (record.is_quote_open) break;
            field += '\n';
            line = take_line(reader);
            k = static_cast<std::size_t>(-1);
        } else if (line[k] == '\r' && !quoted && k + 1 == line.size()) {
            continue;
        } else if (line[k] == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
            field += line[++k];
        } else if (line[k] == '"' && (quoted || field.empty())) {
            quoted = !quoted;
        } else if (line[k] == reader.separator && !quoted &&
                   record.fields.size() + 1 < kMaxCsvFields) {
            record.fields.push_back(unguarded(std::move(field)));
            field.clear();
        } else {
            field += line[k];
        }
    }
    record.fields.push_back(unguarded(std::move(field)));
}

}  // namespace

std::string guarded(std::string_view text) {
    const bool is_run = is_run_behind(text, text.find_first_not_of('\''));
    if (!is_run || finite_number_in(std::string(text))) return std::string(text);
    return "'" + std::string(text);
}

std::string unguarded(std::string text) {
    const std::size_t first = text.find_first_not_of('\'');
    if (first > 0 && is_run_behind(text, first)) text.erase(0, 1);
    return text;
}

CsvRecord next_record(CsvReader& reader) {
    CsvRecord record;
    while (!reader.rest.empty()) {
        const std::size_t number = reader.line;
        const std::string_view line = take_line(reader);
        if (is_blank(line)) continue;
        record.line = number;
        if (reader.separator == ' ') {
            record.fields = words(line);
        } else {
            take_fields(reader, line, record);
        }
        break;
    }
    return record;
}

}  // namespace tact
