// An effect from a file of another program, and what the readers of such files share.
//
// Output    errors as "FILE: PLACE: expected ..", PLACE a JSON pointer or the path of an XML
// element
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/budget.h"
#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/effects/sketch.h"
#include "model/text/json_fields.h"

namespace tact {

struct Effect {
    std::string name;  // unique in its file
    Pattern pattern;
    std::vector<std::string> remarks;  // what was accepted, left out or changed; without the file
    std::string project{};             // that an AHAP names: the two files of a pair name one
    // What sounds at once of its own course, where the file gives the phases: the sum is the effect
    // then, and `pattern` what one pattern can hold of it. Empty, or two to four.
    std::vector<Pattern> layers{};

    bool operator==(const Effect&) const = default;
};

using Effects = std::vector<Effect>;

// What a reader knows besides the text.
struct EffectFile {
    std::string path;  // for messages
    std::string stem;  // what a single effect is called
    ActuatorMap map;
    Budget& budget;  // what reading it may still cost
};

// The reading of its document, which ends where the budget says so.
JsonReading reading_of(const EffectFile& file);

// Pays for points that a file makes without writing them; what is wrong, or empty.
std::string pay_points(const EffectFile& file, std::size_t count);

inline constexpr Range kEffectTimeS{0.0, 1e6};
inline constexpr Range kEffectTimeMs{0.0, 1e9};
inline constexpr Range kShare{0.0, 1.0};

// A field that a format cannot do without.
double needed_number_of(JsonObject& object, std::string_view key, Range range);

// Refuses in the words of the caller, who has no value to show.
void refuse_plainly(JsonReading& reading, const std::string& place, const std::string& sentence);

// A remark on a key that only its owner knows. The first hundred remarks are kept.
void remark_once(std::vector<std::string>& remarks, const std::string& remark);

// The sketch as an effect of this name; an Error gets the file's name.
Expected<Effect> finished(const EffectFile& file, const std::string& name, const Sketch& sketch,
                          std::vector<std::string> remarks);

// `f` of the curve's values, with points added until straight lines stay within `tolerance` of it.
AmplitudeCurve mapped(const AmplitudeCurve& curve, const std::function<double(double)>& f,
                      double tolerance);

// Shares from 0 to 1 in g and in Hz, within 0.1 % of full scale and 0.1 Hz.
AmplitudeCurve acceleration_curve(const ActuatorMap& map, const AmplitudeCurve& intensities_01);
FrequencyCurve frequency_curve(const ActuatorMap& map, const AmplitudeCurve& frequencies_01);

void add_bursts(std::vector<Transient>& all, const std::vector<Transient>& more);

// Steps of one amplitude each, the first from 0 s on, by where they end: a curve with jumps.
AmplitudeCurve stairs(const std::vector<double>& ends_s, const std::vector<double>& values);

// Steps of one share of full scale each, all at one frequency, as the one effect of a file.
Expected<Effects> effect_of_steps(const EffectFile& file, const std::vector<double>& lengths_ms,
                                  const std::vector<double>& shares, double hz,
                                  std::vector<std::string> remarks);

// Refuses times that are all below 1 ms, which were seconds; of no time but 0 there is no telling.
Expected<Done> times_make_sense(const EffectFile& file, double latest_ms);

}  // namespace tact
