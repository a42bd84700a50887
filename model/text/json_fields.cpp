#include "model/text/json_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/text/described.h"
#include "model/text/enough_memory.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

template <class Document>
std::string printed(const Document& document, int indent) {
    return document.dump(indent, ' ', false, Document::error_handler_t::replace);
}

std::string at_offset(const std::string& file, std::string_view text, std::size_t offset) {
    const TextPosition position = position_of(text, offset);
    return file + ", line " + std::to_string(position.line) + ", column " +
           std::to_string(position.column) + ": ";
}

// What the parser needs for the pieces of a text, in bytes and rather too many: measured with
// 64 bits, the C library's least pieces of memory and arrays that double when they grow.
constexpr std::size_t kContainerBytes = 72;
constexpr std::size_t kElementBytes = 40;  // with its share of room to grow
constexpr std::size_t kKeyBytes = 112;
constexpr std::size_t kTextBytes = 48;
constexpr std::size_t kCharacterBytes = 3;  // of a text, which the parser keeps and copies

// A text looked at before a parser trusts it: its depth, as values nested too deep overflow the
// stack; its keys, as the parser compares each with all before it; and the memory it will take.
struct SizeScan {
    std::vector<std::size_t> keys;  // of every level that is open
    std::size_t key_pairs = 0;
    std::size_t memory = 0;
};

std::string take_sign(SizeScan& scan, char c) {
    if (c == '{' || c == '[') {
        scan.memory += kContainerBytes;
        scan.keys.push_back(0);
        if (scan.keys.size() <= kMaxJsonDepth) return {};
        return "expected at most " + std::to_string(kMaxJsonDepth) + " levels of { and [";
    }
    if (c == ',') scan.memory += kElementBytes;
    if (scan.keys.empty()) return {};
    if (c == '}' || c == ']') scan.keys.pop_back();
    if (c != ':') return {};
    scan.memory += kKeyBytes;
    scan.key_pairs += 2 * ++scan.keys.back() - 1;
    if (scan.keys.back() > kMaxJsonKeys) {
        return "expected at most " + grouped_digits(kMaxJsonKeys) + " keys in an object";
    }
    return scan.key_pairs > kMaxJsonKeyPairs ? "expected fewer keys in its objects" : "";
}

std::string size_fault(const std::string& file, std::string_view text) {
    SizeScan scan;
    scan.memory = text.size();
    bool in_string = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        std::string fault;
        if (in_string) {
            scan.memory += kCharacterBytes;
            if (c == '\\') ++k;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
            scan.memory += kTextBytes;
        } else {
            fault = take_sign(scan, c);
        }
        if (scan.memory > kMaxJsonMemory) fault = "expected a file that takes less than 1 GB";
        if (!fault.empty()) return at_offset(file, text, k) + fault;
    }
    return {};
}

// The parser's words without its own position and error number.
std::string syntax_fault(const std::string& words) {
    const std::size_t expected = words.rfind("; expected ");
    if (expected != words.npos) return "expected " + shortened(words.substr(expected + 11), 60);
    const std::size_t unexpected = words.rfind(" - ");
    if (unexpected == words.npos) return "expected JSON";
    const std::string found = words.substr(unexpected + 3);
    return "expected JSON, found " + shortened(found.substr(0, found.find("; last read")), 60);
}

std::string described(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    return shortened(text_of_json(value));
}

constexpr std::size_t kLongestWord = 100;  // bytes
constexpr std::size_t kLettersASlip = 4;

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::size_t slips_between(std::string_view a, std::string_view b) {
    // Rows of the last two letters of `a` and of this one.
    std::array<std::vector<std::size_t>, 3> rows;
    for (auto& row : rows) row.assign(b.size() + 1, 0);
    for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        auto& [before, last, row] = rows;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = small(a[i - 1]) == small(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool exchanged = i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) &&
                                   small(a[i - 2]) == small(b[j - 1]);
            if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::ranges::rotate(rows, rows.begin() + 1);
    }
    return rows[1][b.size()];
}

// "FILE: /model: does not know "nc_wieght"; the nearest key is "nc_weight""
void refuse_unknown(const JsonObject& object, const std::string& key) {
    JsonReading& reading = *object.reading;
    if (reading.unknown == UnknownKeys::passed_over || !reading.fault.empty()) return;
    const auto nearest = misspelt(key, object.known);
    if (reading.unknown == UnknownKeys::kept && !nearest) return;
    reading.fault = reading.file + ": " + (object.place.empty() ? "/" : object.place) +
                    ": does not know " + in_quotes(key);
    if (nearest) reading.fault += "; the nearest key is " + in_quotes(std::string(*nearest));
}

}  // namespace

std::string text_of_json(const Json& document, int indent) { return printed(document, indent); }

std::string text_of_json(const nlohmann::json& document, int indent) {
    return printed(document, indent);
}

Json kept_json(std::string_view text) { return Json::parse(text, nullptr, false); }

nlohmann::json kept_sorted_json(std::string_view text) {
    return nlohmann::json::parse(text, nullptr, false);
}

Expected<Json> parse_json(std::string_view text, const std::string& file) {
    const std::optional<std::string> decoded = utf8_of_utf16(text);
    if (decoded) text = *decoded;
    text = without_bom(text);
    if (const auto invalid = first_invalid_utf8(text)) {
        return Error{at_offset(file, text, *invalid) + "expected text in UTF-8"};
    }
    if (std::string fault = size_fault(file, text); !fault.empty()) return Error{fault};
    const auto parsed = [&]() -> Expected<Json> {
        try {
            return Json::parse(text);
        } catch (const Json::parse_error& fault) {
            // `byte` counts from 1 and is the last byte that was read.
            const std::size_t offset = fault.byte > 0 ? fault.byte - 1 : 0;
            return Error{at_offset(file, text, offset) + syntax_fault(fault.what())};
        } catch (const Json::exception&) {
            return Error{file + ": expected numbers below 1.8e308"};
        }
    };
    return with_enough_memory(file, parsed);
}

void refuse(JsonReading& reading, const std::string& place, const std::string& what,
            const Json& got) {
    if (!reading.fault.empty()) return;
    reading.fault = reading.file + ": " + place + ": expected " + what + ", got " + described(got);
}

bool may_go_on(JsonReading& reading) {
    if (!reading.fault.empty()) return false;
    const std::string why = reading.budget != nullptr ? halted(*reading.budget) : "";
    if (!why.empty()) reading.fault = reading.file + ": " + why;
    return why.empty();
}

JsonObject object_at(JsonReading& reading, const Json& value, const std::string& place) {
    if (value.is_object()) return {&reading, &value, place, {}};
    refuse(reading, place.empty() ? "/" : place, "an object", value);
    return {&reading, nullptr, place, {}};
}

const Json* field(JsonObject& object, std::string_view key) {
    object.known.push_back(key);
    if (object.value == nullptr) return nullptr;
    const auto found = object.value->find(key);
    return found == object.value->end() ? nullptr : &*found;
}

std::string place_of(const JsonObject& object, std::string_view key) {
    return object.place + "/" + std::string(key);
}

double number_at(JsonReading& reading, const Json& value, const std::string& place, Range range) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (range.contains(number)) return number;
    refuse(reading, place, range_words(range), value);
    return range.low;
}

double number_field(JsonObject& object, std::string_view key, double fallback, Range range) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    return number_at(*object.reading, *value, place_of(object, key), range);
}

int whole_field(JsonObject& object, std::string_view key, int fallback, Range range) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (range.contains(number) && number == std::floor(number)) return static_cast<int>(number);
    refuse(*object.reading, place_of(object, key), range_words(range, "a whole number"), *value);
    return fallback;
}

bool yes_no_field(JsonObject& object, std::string_view key, bool fallback) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    if (value->is_boolean()) return value->get<bool>();
    refuse(*object.reading, place_of(object, key), "true or false", *value);
    return fallback;
}

namespace {

// A text of at most `most_bytes`; empty if refused.
std::string text_at(JsonReading& reading, const Json& value, const std::string& place,
                    const char* what, std::size_t most_bytes) {
    const auto* text = value.get_ptr<const std::string*>();
    if (text != nullptr && text->size() <= most_bytes) return *text;
    if (text == nullptr) {
        refuse(reading, place, what, value);
    } else if (reading.fault.empty()) {
        reading.fault = reading.file + ": " + place + ": expected " + what + " of at most " +
                        grouped_digits(most_bytes) + " bytes, got " + grouped_digits(text->size());
    }
    return {};
}

}  // namespace

std::string text_field(JsonObject& object, std::string_view key, const std::string& fallback) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    return text_at(*object.reading, *value, place_of(object, key), "a text", kMaxTextBytes);
}

std::string name_field(JsonObject& object, std::string_view key, const std::string& fallback) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    return name_at(*object.reading, *value, place_of(object, key));
}

std::string name_at(JsonReading& reading, const Json& value, const std::string& place) {
    return text_at(reading, value, place, "a text", kMaxNameBytes);
}

JsonObject object_field(JsonObject& object, std::string_view key) {
    const Json* value = field(object, key);
    if (value == nullptr) return {object.reading, nullptr, place_of(object, key), {}};
    return object_at(*object.reading, *value, place_of(object, key));
}

std::size_t choice_field(JsonObject& object, std::string_view key, std::size_t fallback,
                         std::span<const char* const> choices) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    if (value->is_string()) {
        const auto found = std::ranges::find(choices, value->get<std::string>());
        if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    }
    std::string all;
    for (const char* choice : choices) {
        all += (all.empty() ? "\"" : " or \"") + std::string(choice) + "\"";
    }
    refuse(*object.reading, place_of(object, key), all, *value);
    return fallback;
}

std::vector<const Json*> array_field(JsonObject& object, std::string_view key, std::size_t least,
                                     std::size_t most) {
    const Json* value = field(object, key);
    std::vector<const Json*> elements;
    if (value == nullptr) return elements;
    if (!value->is_array() || value->size() < least || value->size() > most) {
        const std::string size = least == most
                                     ? std::to_string(least)
                                     : std::to_string(least) + " to " + std::to_string(most);
        refuse(*object.reading, place_of(object, key), "an array of " + size, *value);
        return elements;
    }
    for (const Json& element : *value) elements.push_back(&element);
    return elements;
}

Json unknown_fields(const JsonObject& object) {
    Json unknown = Json::object();
    if (object.value == nullptr) return unknown;
    for (const auto& [key, value] : object.value->items()) {
        if (std::ranges::find(object.known, key) != object.known.end()) continue;
        unknown[key] = value;
        refuse_unknown(object, key);
    }
    return unknown;
}

void note_unknown(Json& unknown, const std::string& key, const Json& of_part) {
    if (!of_part.empty()) unknown[key] = of_part;
}

void read_objects(JsonObject& object, std::string_view key, std::size_t least, std::size_t most,
                  Json& unknown, const std::function<void(JsonObject&, Json&)>& read) {
    const auto elements = array_field(object, key, least, most);
    Json of_all = Json::object();
    for (std::size_t k = 0; k < elements.size() && may_go_on(*object.reading); ++k) {
        const std::string position = std::to_string(k);
        JsonObject fields =
            object_at(*object.reading, *elements[k], place_of(object, key) + "/" + position);
        Json of_one = Json::object();
        read(fields, of_one);
        of_one.update(unknown_fields(fields));
        note_unknown(of_all, position, of_one);
    }
    note_unknown(unknown, std::string(key), of_all);
}

void restore_unknown(Json& document, const Json& unknown) {
    for (const auto& [key, value] : unknown.items()) {
        if (document.is_array()) {
            // Positions beyond the end belonged to elements that were removed since.
            std::size_t k = 0;
            const auto [end, fault] = std::from_chars(key.data(), key.data() + key.size(), k);
            if (fault != std::errc{} || k >= document.size()) continue;
            if (document[k].is_structured() && value.is_object()) {
                restore_unknown(document[k], value);
            }
        } else if (!document.contains(key)) {
            document[key] = value;
        } else if (document[key].is_structured() && value.is_object()) {
            restore_unknown(document[key], value);
        }
    }
}

std::optional<std::string_view> misspelt(std::string_view word,
                                         std::span<const std::string_view> known) {
    if (word.size() > kLongestWord) return std::nullopt;
    std::optional<std::string_view> nearest;
    std::size_t least = word.size() / kLettersASlip + 1;
    for (const std::string_view one : known) {
        const std::size_t apart =
            std::max(word.size(), one.size()) - std::min(word.size(), one.size());
        if (one.size() > kLongestWord || apart >= least) continue;
        const std::size_t slips = slips_between(word, one);
        if (slips >= least) continue;
        least = slips;
        nearest = one;
    }
    return nearest;
}

}  // namespace tact
