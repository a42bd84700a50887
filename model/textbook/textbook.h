// What has been measured of touch, in skin, fibres, brain and people, to be laid beside the model.
//
// Source    assets/physiology/textbook.json: each fact has its own, and says how sure it is and
//           what was read for it. Nobody computes with these facts; they are compared with.
// Output    an Error names the file, the place and what was expected
// Left out  what the model itself is made of: its tables (model/physiology) have their own sources
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/common/expected.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

enum class Sure {
    looked_up,   // in the source itself, or in its abstract
    secondary,   // in what cites or uses the source
    from_memory  // shown with this mark alone, and in no lesson that comes with the program
};

struct TextbookFact {
    std::string id;                   // words by which lessons ask for it: "frequency jnd"
    std::string what;                 // before its number: "density"
    std::string says;                 // a sentence, {value} in the place of the number
    std::vector<std::string> stages;  // by their keys: "spikes"; none: it is not shown on one
    std::optional<Receptor> receptor{};
    std::optional<double> low{};  // one value: both are it; a bound: only one is there
    std::optional<double> high{};
    std::vector<std::pair<double, double>> points{};  // of a value over something, ascending
    std::string over{};                               // unit of what it goes over: "Hz"
    std::string unit;
    std::string species;
    std::string site;
    std::string cite;    // in a few words, for beside a number
    std::string source;  // authors, year, journal, pages
    std::string read;    // what was read for it
    Sure sure = Sure::from_memory;
};

// The facts that come with the program, in the order of their file.
const std::vector<TextbookFact>& textbook();

// Null where there is none of that id.
const TextbookFact* fact_named(std::string_view id);

Expected<std::vector<TextbookFact>> parse_textbook(std::string_view json, const std::string& file);

// "18 to 25 %", "at least 64 Hz", "1 impulse a cycle (from memory)".
std::string value_text(const TextbookFact& fact);

// "Israr and others 2006, human".
std::string source_text(const TextbookFact& fact);

// `says` with its number, and the source behind it: "People ... 18 to 25 % on (..., human)."
std::string sentence_of(const TextbookFact& fact);

// Linear between the points over the logarithm of what they go over; none outside of them, or where
// a fact has none.
std::optional<double> value_over(const TextbookFact& fact, double at);

}  // namespace tact
