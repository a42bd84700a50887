// JSON of files that people edit: parsed with limits, read field by field, every fault with its
// place.
//
// A reading keeps the first fault and continues with defaults, so that the code that reads a
// document is as plain as the document.
//
// Source    RFC 8259; places are JSON pointers (RFC 6901)
// Valid     at most kMaxJsonDepth levels, kMaxJsonKeys keys an object; text and values together at
//           most kMaxJsonMemory bytes of memory, which is estimated before any value is made
#pragma once

#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/budget.h"
#include "model/common/expected.h"
#include "model/common/units.h"

namespace tact {

using Json = nlohmann::ordered_json;

inline constexpr std::size_t kMaxJsonDepth = 100;
inline constexpr std::size_t kMaxJsonKeys = 20'000;
inline constexpr std::size_t kMaxJsonKeyPairs = 2 * kMaxJsonKeys * kMaxJsonKeys;  // of all objects
inline constexpr std::size_t kMaxJsonMemory = 900'000'000;

// An Error names the line and the column: "set.json, line 3, column 7: ...".
Expected<Json> parse_json(std::string_view text, const std::string& file);

// `indent` spaces a level; default: all on one line. Bytes that are not UTF-8 (of a file's or a
// device's name) become U+FFFD, so that whatever can be named can be printed.
std::string text_of_json(const Json& document, int indent = -1);
std::string text_of_json(const nlohmann::json& document, int indent = -1);

// The document of a text that text_of_json made; a discarded value if it is not JSON. Its parser is
// compiled here alone. The second has its keys by letters.
Json kept_json(std::string_view text);
nlohmann::json kept_sorted_json(std::string_view text);

// What happens to keys that nobody asked for.
enum class UnknownKeys {
    passed_over,  // another program's
    kept,         // a document's, for the version that knows them; a misspelt one is refused
    refused       // of a file that has no place for them
};

struct JsonReading {
    std::string file;   // for messages
    std::string fault;  // the first one, a whole sentence; empty: none so far
    UnknownKeys unknown = UnknownKeys::passed_over;
    const Budget* budget = nullptr;  // by which reading may be stopped; null: it runs to its end
};

// Notes "FILE: PLACE: expected WHAT, got GOT", unless there is a fault already.
void refuse(JsonReading& reading, const std::string& place, const std::string& what,
            const Json& got);

// Whether there is no fault yet, and nobody has stopped the reading.
bool may_go_on(JsonReading& reading);

// An object of the document whose known fields are taken one by one.
struct JsonObject {
    JsonReading* reading = nullptr;
    const Json* value = nullptr;  // null: it is not there, every field takes its default
    std::string place;
    std::vector<std::string_view> known;  // keys asked for
};

JsonObject object_at(JsonReading& reading, const Json& value, const std::string& place);

// The value of a key, or null. It counts as known from now on.
const Json* field(JsonObject& object, std::string_view key);

std::string place_of(const JsonObject& object, std::string_view key);

// Any finite number.
inline constexpr Range kAnyNumber{std::numeric_limits<double>::lowest(),
                                  std::numeric_limits<double>::max()};

// Fields of one type; `fallback` where the key is missing or the value is refused.
double number_field(JsonObject& object, std::string_view key, double fallback, Range range);
int whole_field(JsonObject& object, std::string_view key, int fallback, Range range);
bool yes_no_field(JsonObject& object, std::string_view key, bool fallback);

// Texts that people read are at most so long, names as model/text/names.h has it.
inline constexpr std::size_t kMaxTextBytes = 20'000;
std::string text_field(JsonObject& object, std::string_view key, const std::string& fallback);
std::string name_field(JsonObject& object, std::string_view key, const std::string& fallback);
std::string name_at(JsonReading& reading, const Json& value, const std::string& place);

JsonObject object_field(JsonObject& object, std::string_view key);

// Position of the text among the choices.
std::size_t choice_field(JsonObject& object, std::string_view key, std::size_t fallback,
                         std::span<const char* const> choices);

// The elements of an array of `least` to `most`; none where the key is missing.
std::vector<const Json*> array_field(JsonObject& object, std::string_view key, std::size_t least,
                                     std::size_t most);

// A number outside of any object.
double number_at(JsonReading& reading, const Json& value, const std::string& place, Range range);

// The fields nobody asked for, as an object; to be called once all known ones were. Refuses them as
// the reading says, each by its name with the known one that it is nearest to.
Json unknown_fields(const JsonObject& object);

// Notes the unknown fields of a part of the whole, where there are any; objects and arrays on the
// way are objects, with positions as keys: {"carriers": {"0": {"x": 1}}}.
void note_unknown(Json& unknown, const std::string& key, const Json& of_part);

// Reads each object of an array of `least` to `most`, in their order and as far as there is no
// fault, and notes what it does not know by position; none where the key is missing. `read` gets
// the object, and where parts of it note what they do not know.
void read_objects(JsonObject& object, std::string_view key, std::size_t least, std::size_t most,
                  Json& unknown, const std::function<void(JsonObject&, Json&)>& read);

// Puts such notes back: what the document has already is left alone.
void restore_unknown(Json& document, const Json& unknown);

// Which known word a misspelt one was meant to be, of equals the first: at most one slip (a letter
// more, less, other, or two exchanged) a four letters of the word; letters of either case count as
// the same. None where no word is as near. Source: optimal string alignment distance, Damerau 1964
// and Levenshtein 1966.
std::optional<std::string_view> misspelt(std::string_view word,
                                         std::span<const std::string_view> known);

}  // namespace tact
