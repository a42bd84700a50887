// Measurements of touch, in skin, fibres, brain and people, for comparison with the model.
//
// Source    assets/physiology/textbook.json: each fact has its own source, and tells how certain it
//           is and what was read for it. No computation uses these facts; they are only compared.
// Output    an Error names the file, the place and what was expected
// Left out  the model's own tables (model/physiology), which have their own sources
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/common/expected.h"
#include "model/pattern/pattern.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

enum class Sure {
    looked_up,   // in the source itself, or in its abstract
    secondary,   // in a text that cites or uses the source
    from_memory  // always shown with this mark, and in no bundled lesson
};

struct TextbookFact {
    std::string id;                   // name of the fact in lessons: "frequency jnd"
    std::string what;                 // words before its number: "density"
    std::string says;                 // a sentence with {value} in place of the number
    std::vector<std::string> stages;  // stages that show it: "spikes"; empty: no stage does
    std::optional<Receptor> receptor{};
    std::optional<double> low{};  // one value: both are equal; a bound: only one is set
    std::optional<double> high{};
    std::vector<std::pair<double, double>> points{};  // ascending points, for a value that depends
                                                      // on another quantity
    std::string over{};                               // unit of that quantity: "Hz"
    std::string unit;
    std::string species;
    std::string site;
    std::string cite;    // a few words, to stand beside a number
    std::string source;  // authors, year, journal, pages
    std::string read;    // the text that was read for it
    Sure sure = Sure::from_memory;
};

// The bundled facts, in the order of their file.
const std::vector<TextbookFact>& textbook();

// The fact with this id, or null.
const TextbookFact* fact_named(std::string_view id);

Expected<std::vector<TextbookFact>> parse_textbook(std::string_view json, const std::string& file);

// "18 to 25 %", "at least 64 Hz", "1 impulse a cycle (from memory)".
std::string value_text(const TextbookFact& fact);

// "Israr and others 2006, human".
std::string source_text(const TextbookFact& fact);

// `says` with its number, and the source behind it: "People ... 18 to 25 % on (..., human)."
std::string sentence_of(const TextbookFact& fact);

// The value at a point, linear between the fact's points over the logarithm; nullopt outside of
// them, or without points.
std::optional<double> value_over(const TextbookFact& fact, double at);

// Whether people notice the difference of two patterns, by the just noticeable differences of the
// textbook.
//
// Source    facts "frequency jnd" and "amplitude jnd"
// Valid     patterns with one carrier each, of constant frequency. If the frequencies differ,
//           nothing is said of the amplitudes, which are then felt at different strengths; if they
//           are equal, the patterns differ in amplitude alone.
// Left out  rhythm and modulation: the textbook has no such difference for them

// "People: 40 and 250 Hz differ by 525 %; they notice from 18 to 25 % on (...)."; empty if there is
// nothing to tell.
std::string noticed_text(const Pattern& a, const Pattern& b);

// Whether people tell the two apart by their frequencies at once: the difference is more than twice
// the noticeable one.
bool tell_by_frequency(const Pattern& a, const Pattern& b);

}  // namespace tact
