#include "model/io/people/foreign_answers.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "model/io/people/ratings_text.h"
#include "model/table/table.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

using Names = std::span<const std::string_view>;

// What experiments call a column; the first is this program's own.
constexpr std::array<std::string_view, 14> kFirst{
    "a",         "pattern_a",  "pattern a",  "stima", "stim_a", "stim1", "stim_1",
    "stimulus1", "stimulus_1", "stimulus_a", "id1",   "first",  "item1", "file1"};
constexpr std::array<std::string_view, 14> kSecond{
    "b",         "pattern_b",  "pattern b",  "stimb", "stim_b", "stim2", "stim_2",
    "stimulus2", "stimulus_2", "stimulus_b", "id2",   "second", "item2", "file2"};
constexpr std::array<std::string_view, 6> kRating{"rating",   "dissimilarity", "slider.response",
                                                  "response", "answer",        "similarity"};
constexpr std::array<std::string_view, 7> kParticipant{
    "participant", "participant_id", "subject", "subject_id", "subj", "pid", "prolific_pid"};

std::string known_form(std::string_view cell) { return lower_case(std::string(trimmed(cell))); }

// The column that bears one of the names, the earlier name first; none, or of several of one name.
std::optional<std::size_t> column_of(const CsvRecord& head, Names names) {
    for (const std::string_view name : names) {
        std::optional<std::size_t> found;
        for (std::size_t k = 0; k < head.fields.size(); ++k) {
            if (known_form(head.fields[k]) != name) continue;
            if (found) return std::nullopt;
            found = k;
        }
        if (found) return found;
    }
    return std::nullopt;
}

bool is_empty(const CsvRecord& record) {
    return std::ranges::all_of(record.fields,
                               [](const std::string& cell) { return trimmed(cell).empty(); });
}

// Without what spreadsheets leave at the ends, and with decimal points.
void tidy(std::vector<CsvRecord>& records, const TableDialect& dialect) {
    std::erase_if(records, is_empty);
    if (records.empty()) return;
    auto& head = records.front().fields;
    while (head.size() > 1 && trimmed(head.back()).empty()) {
        const auto is_used = [&head](const CsvRecord& one) {
            return one.fields.size() >= head.size() &&
                   !trimmed(one.fields[head.size() - 1]).empty();
        };
        if (std::ranges::any_of(records, is_used)) break;
        head.pop_back();
    }
    for (CsvRecord& record : records) {
        while (record.fields.size() > head.size() && trimmed(record.fields.back()).empty()) {
            record.fields.pop_back();
        }
        if (dialect.decimal == '.') continue;
        for (std::string& cell : record.fields) {
            const std::size_t comma = cell.find(',');
            if (comma != cell.npos && number_in(cell, dialect)) cell[comma] = '.';
        }
    }
}

std::string words_on_columns(const CsvRecord& head, const AnswerPlaces& columns) {
    std::string words;
    const auto say = [&](const char* own, const std::optional<std::size_t>& place) {
        if (!place || trimmed(head.fields[*place]) == own) return;
        words += (words.empty() ? "columns read: " : ", ") + std::string(own) + " = " +
                 std::string(trimmed(head.fields[*place]));
    };
    say("a", columns.a);
    say("b", columns.b);
    say("rating", columns.rating);
    say("participant", columns.participant);
    return words;
}

// The two names in a cell that holds an array of two.
std::optional<std::pair<std::string, std::string>> two_in(const std::string& cell) {
    const std::string_view text = trimmed(cell);
    if (!text.starts_with('[') || text.size() > 4096) return std::nullopt;
    const auto json = kept_json(text);
    const bool are_two =
        json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_string();
    if (!are_two) return std::nullopt;
    return std::pair{json[0].get<std::string>(), json[1].get<std::string>()};
}

// A column of arrays as two columns behind the others.
bool part_stimuli(std::vector<CsvRecord>& records) {
    constexpr std::array<std::string_view, 2> kStimuli{"stimulus", "stimuli"};
    const auto place = column_of(records.front(), kStimuli);
    if (!place) return false;
    std::vector<std::optional<std::pair<std::string, std::string>>> pairs(records.size());
    for (std::size_t k = 1; k < records.size(); ++k) {
        if (records[k].fields.size() > *place) pairs[k] = two_in(records[k].fields[*place]);
    }
    if (std::ranges::none_of(pairs, [](const auto& one) { return one.has_value(); })) return false;
    const std::size_t columns = records.front().fields.size();
    records.front().fields.insert(records.front().fields.end(), {"a", "b"});
    for (std::size_t k = 1; k < records.size(); ++k) {
        auto& fields = records[k].fields;
        fields.resize(columns);
        fields.push_back(pairs[k] ? std::move(pairs[k]->first) : "");
        fields.push_back(pairs[k] ? std::move(pairs[k]->second) : "");
    }
    return true;
}

// The two patterns that a column of a pair is named after.
std::optional<std::pair<std::string, std::string>> pair_in(std::string_view cell) {
    cell = trimmed(cell);
    const std::size_t dash = cell.find('-');
    if (dash == cell.npos || cell.find('-', dash + 1) != cell.npos) return std::nullopt;
    std::string a{trimmed(cell.substr(0, dash))};
    std::string b{trimmed(cell.substr(dash + 1))};
    if (a.empty() || b.empty()) return std::nullopt;
    return std::pair{std::move(a), std::move(b)};
}

// A row a participant with a column a pair, as a line a rating; nothing where it is no such table.
std::optional<std::vector<CsvRecord>> lines_of_wide(const std::vector<CsvRecord>& records) {
    const CsvRecord& head = records.front();
    const auto who = column_of(head, kParticipant);
    std::vector<CsvRecord> lines{{head.line, {"participant", "a", "b", "rating"}, false}};
    std::vector<std::optional<std::pair<std::string, std::string>>> pairs;
    std::size_t known = 0;
    for (std::size_t k = 0; k < head.fields.size(); ++k) {
        pairs.push_back(k == who ? std::nullopt : pair_in(head.fields[k]));
        known += pairs.back() ? 1 : 0;
    }
    // A line takes a hundred times the memory of its cell.
    constexpr std::size_t kMostLines = 1'000'000;
    if (known * records.size() > kMostLines) return std::nullopt;
    if (known < 3 || known + (who ? 1 : 0) != head.fields.size()) return std::nullopt;
    for (std::size_t row = 1; row < records.size(); ++row) {
        const auto& fields = records[row].fields;
        for (std::size_t k = 0; k < std::min(fields.size(), pairs.size()); ++k) {
            if (!pairs[k]) continue;
            const std::string name = who ? fields[*who] : std::to_string(row);
            lines.push_back(
                {records[row].line, {name, pairs[k]->first, pairs[k]->second, fields[k]}, false});
        }
    }
    return lines;
}

// Trials without a pair, such as instructions.
std::size_t drop_other_trials(std::vector<CsvRecord>& records, const AnswerPlaces& columns) {
    const auto is_other = [&](const CsvRecord& one) {
        const auto is_bare = [&](std::size_t place) {
            return one.fields.size() <= place || trimmed(one.fields[place]).empty();
        };
        return is_bare(*columns.a) && is_bare(*columns.b);
    };
    const auto gone = std::remove_if(records.begin() + 1, records.end(), is_other);
    const auto count = static_cast<std::size_t>(std::distance(gone, records.end()));
    records.erase(gone, records.end());
    return count;
}

// Where every name is that of a file, the patterns are called as the files are.
bool strip_endings(std::vector<CsvRecord>& records, const AnswerPlaces& columns) {
    const std::array<std::size_t, 2> places{*columns.a, *columns.b};
    const auto is_file = [](const std::string& cell) {
        return without_sound_ending(trimmed(cell)).size() < trimmed(cell).size();
    };
    for (std::size_t k = 1; k < records.size(); ++k) {
        for (const std::size_t place : places) {
            if (records[k].fields.size() <= place || !is_file(records[k].fields[place]))
                return false;
        }
    }
    for (std::size_t k = 1; k < records.size(); ++k) {
        for (const std::size_t place : places) {
            std::string& cell = records[k].fields[place];
            const std::string_view name = without_sound_ending(trimmed(cell));
            const std::size_t folder = name.find_last_of('/');
            cell = std::string(folder == name.npos ? name : name.substr(folder + 1));
        }
    }
    return records.size() > 1;
}

// A square whose names stand above alone, or begin above the first number, as one with a corner.
void give_corner(std::vector<CsvRecord>& records) {
    auto& head = records.front().fields;
    const std::size_t n = head.size();
    if (n < 2 || records.size() != n + 1 || trimmed(head[0]).empty()) return;
    if (std::ranges::any_of(head,
                            [](const std::string& cell) { return rating_in(cell).has_value(); }))
        return;
    const auto have = [&records](std::size_t cells) {
        return std::all_of(records.begin() + 1, records.end(),
                           [cells](const CsvRecord& one) { return one.fields.size() == cells; });
    };
    const bool are_named = have(n + 1);
    const auto are_numbers = [](const CsvRecord& one) {
        return std::ranges::all_of(
            one.fields, [](const std::string& cell) { return rating_in(cell).has_value(); });
    };
    if (!are_named && !(have(n) && std::all_of(records.begin() + 1, records.end(), are_numbers))) {
        return;
    }
    for (std::size_t k = 1; k <= n && !are_named; ++k) {
        records[k].fields.insert(records[k].fields.begin(), head[k - 1]);
    }
    head.insert(head.begin(), "");
}

AnswerPlaces places_in(const CsvRecord& head) {
    return {column_of(head, kFirst), column_of(head, kSecond), column_of(head, kRating),
            column_of(head, kParticipant)};
}

// Gives the columns that somebody named this program's names, which no other column may have then;
// what is wrong, or empty.
std::string call_columns(CsvRecord& head, const AnswerColumns& named) {
    std::vector<std::string> fresh = head.fields;
    for (const auto& [own_name, name] : {std::pair{"a", &named.a},
                                         {"b", &named.b},
                                         {"rating", &named.rating},
                                         {"participant", &named.participant}}) {
        if (name->empty()) continue;
        const Expected<std::size_t> place = place_of_column(head.fields, *name);
        if (!place) return place.error().message;
        for (std::size_t k = 0; k < fresh.size(); ++k) {
            if (k == *place) fresh[k] = own_name;
            if (k != *place && known_form(head.fields[k]) == own_name) fresh[k] += " (not read)";
        }
    }
    head.fields = std::move(fresh);
    return {};
}

}  // namespace

Expected<AnswerColumns> answer_columns(std::string_view text) {
    AnswerColumns columns;
    const std::string fault = take_column_roles(text, {{"a", &columns.a},
                                                       {"b", &columns.b},
                                                       {"rating", &columns.rating},
                                                       {"participant", &columns.participant}});
    if (!fault.empty()) return Error{fault};
    return columns;
}

AnswerPlaces answer_places(std::span<const std::string> head, const AnswerColumns& named) {
    CsvRecord record{1, {head.begin(), head.end()}, false};
    return call_columns(record, named).empty() ? places_in(record) : AnswerPlaces{};
}

OwnAnswers own_answers(std::vector<CsvRecord> records, const TableDialect& dialect,
                       const AnswerColumns& named) {
    OwnAnswers own;
    tidy(records, dialect);
    own.records = std::move(records);
    if (own.records.empty()) return own;
    own.fault = call_columns(own.records.front(), named);
    if (!own.fault.empty()) return own;
    give_corner(own.records);
    if (auto lines = lines_of_wide(own.records)) {
        own.records = *std::move(lines);
        own.remarks.push_back("a column for each pair");
    }
    const bool had_arrays = part_stimuli(own.records);
    CsvRecord& head = own.records.front();
    const AnswerPlaces columns = places_in(head);
    if (!columns.a || !columns.b || !columns.rating) return own;
    const std::string words = words_on_columns(head, columns);
    if (!words.empty()) own.remarks.push_back(words);
    if (had_arrays) own.remarks.push_back("the two of each array in stimulus are taken as a pair");
    if (known_form(head.fields[*columns.rating]) == "similarity") {
        own.scale = RatingScale::similarity;
    }
    if (known_form(head.fields[*columns.rating]) == "dissimilarity") {
        own.scale = RatingScale::dissimilarity;
    }
    head.fields[*columns.a] = "a";
    head.fields[*columns.b] = "b";
    head.fields[*columns.rating] = "rating";
    if (columns.participant) head.fields[*columns.participant] = "participant";
    if (!words.empty() || had_arrays) {
        const std::size_t others = drop_other_trials(own.records, columns);
        if (others > 0) {
            own.remarks.push_back(
                counted(others, "row without a pair is", "rows without a pair are") +
                " passed over");
        }
    }
    if (strip_endings(own.records, columns)) {
        own.remarks.push_back(
            "names of files are taken as those of patterns, without their endings");
    }
    return own;
}

}  // namespace tact
