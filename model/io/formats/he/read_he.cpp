// RichTap's .he (versions 1 and 2) and its sibling of OpenHarmony.
//
// Source    OpenHarmony's "Vibrator Development": times in ms, intensity and frequency from 0 to
//           100; a curve's intensity multiplies its event's, its frequency is added; channel 0 is
//           both sides. RichTap's files have the same under other names (RelativeTime, Index).
// Guessed   Hz and the length of a transient, as the map says.
// Output    an effect for each side that has events of its own; one where the sides are equal.
// Left out  limits on how many events and points there are: any number is read.

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "model/io/formats/he/he.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr Range kPercent{0.0, 100.0};
constexpr Range kOffset{-100.0, 100.0};
constexpr Range kSides{0.0, 2.0};
constexpr std::array<const char*, 2> kSideNames{" left", " right"};

struct HeReading {
    const ActuatorMap& map;
    std::array<Sketch, 2> sides;
    std::vector<std::string> remarks;
};

template <class Part>
void add_to_sides(HeReading& he, int side, std::vector<Part> Sketch::*parts, const Part& part) {
    if (side != 2) (he.sides[0].*parts).push_back(part);
    if (side != 1) (he.sides[1].*parts).push_back(part);
}

void read_curve_point(JsonObject& point, double start_s, double intensity, double frequency,
                      std::array<AmplitudeCurve, 2>& curves) {
    const double time_s = start_s + needed_number_of(point, "Time", kEffectTimeMs) / 1e3;
    if (!curves[0].empty() && time_s < curves[0].back().time_s) {
        refuse(*point.reading, place_of(point, "Time"), "a time not before the last point's",
               (time_s - start_s) * 1e3);
    }
    curves[0].push_back({time_s, intensity * needed_number_of(point, "Intensity", kShare)});
    curves[1].push_back(
        {time_s, frequency + number_field(point, "Frequency", 0.0, kOffset) / 100.0});
}

void read_continuous(JsonObject& event, JsonObject& parameters, double start_s, int side,
                     HeReading& he) {
    const double length_s = needed_number_of(event, "Duration", kEffectTimeMs) / 1e3;
    const double intensity = needed_number_of(parameters, "Intensity", kPercent) / 100.0;
    const double frequency = needed_number_of(parameters, "Frequency", kPercent) / 100.0;
    std::array<AmplitudeCurve, 2> curves;
    const Json* curve = field(parameters, "Curve");
    Json unknown;
    if (curve != nullptr && !curve->is_null()) {
        read_objects(parameters, "Curve", 0, kMostVoicePoints, unknown,
                     [&](JsonObject& point, Json&) {
                         read_curve_point(point, start_s, intensity, frequency, curves);
                     });
    }
    if (curves[0].empty()) curves = {{{{start_s, intensity}}, {{start_s, frequency}}}};
    const bool outside = std::ranges::any_of(
        curves[1], [](const AmplitudePoint& point) { return !kShare.contains(point.value); });
    if (outside) remark_once(he.remarks, "frequencies beyond 0 to 100 are clamped");
    if (!(length_s > 0.0)) return;
    add_to_sides(he, side, &Sketch::voices,
                 cut_out({start_s, start_s + length_s, acceleration_curve(he.map, curves[0]),
                          frequency_curve(he.map, curves[1]), 0.0}));
}

// The one key, or the sibling's.
double time_of(JsonObject& event) {
    const bool sibling = event.value != nullptr && event.value->contains("StartTime");
    return needed_number_of(event, sibling ? "StartTime" : "RelativeTime", kEffectTimeMs);
}

void read_he_event(JsonObject& entry, double from_ms, int side, HeReading& he) {
    if (entry.value == nullptr || !entry.value->contains("Event")) {
        return refuse_plainly(*entry.reading, place_of(entry, "Event"),
                              "expected an object, it is missing");
    }
    JsonObject event = object_field(entry, "Event");
    const std::string type = text_field(event, "Type", "");
    if (type != "transient" && type != "continuous") {
        return refuse_plainly(*event.reading, place_of(event, "Type"),
                              "expected \"transient\" or \"continuous\", got " + in_quotes(type));
    }
    const double start_s = (from_ms + time_of(event)) / 1e3;
    const int own_side = whole_field(event, "Index", side, kSides);
    JsonObject parameters = object_field(event, "Parameters");
    if (type == "continuous") return read_continuous(event, parameters, start_s, own_side, he);
    const double intensity = needed_number_of(parameters, "Intensity", kPercent) / 100.0;
    const double frequency = needed_number_of(parameters, "Frequency", kPercent) / 100.0;
    for (const Transient& burst : transients_on(he.map, start_s, intensity, frequency)) {
        add_to_sides(he, own_side, &Sketch::transients, burst);
    }
}

void read_he_events(JsonObject& object, double from_ms, int side, HeReading& he) {
    Json unknown;
    read_objects(object, "Pattern", 0, kMostVoicePoints, unknown,
                 [&](JsonObject& entry, Json&) { read_he_event(entry, from_ms, side, he); });
}

// Version 2 has a list of patterns, version 1 one pattern, OpenHarmony channels.
void read_he_parts(JsonObject& object, const Json& document, HeReading& he) {
    Json unknown;
    if (document.contains("PatternList")) {
        read_objects(
            object, "PatternList", 1, kMostVoicePoints, unknown, [&](JsonObject& part, Json&) {
                const double from_ms = number_field(part, "AbsoluteTime", 0.0, kEffectTimeMs);
                read_he_events(part, from_ms, 0, he);
            });
    } else if (document.contains("Channels")) {
        read_objects(object, "Channels", 1, 2, unknown, [&](JsonObject& channel, Json&) {
            JsonObject parameters = object_field(channel, "Parameters");
            read_he_events(channel, 0.0, whole_field(parameters, "Index", 0, kSides), he);
        });
    } else {
        read_he_events(object, 0.0, 0, he);
    }
}

bool is_empty(const Sketch& sketch) { return sketch.voices.empty() && sketch.transients.empty(); }

double latest_of(const Sketch& sketch) {
    double latest_s = 0.0;
    for (const Voice& voice : sketch.voices) latest_s = std::max(latest_s, voice.end_s);
    for (const Transient& one : sketch.transients) latest_s = std::max(latest_s, one.time_s);
    return latest_s;
}

// Whether an event of "Pattern" has a type, which tells the first version of .he from AHAP.
bool has_typed_event(const Json& document) {
    const auto entries = document.find("Pattern");
    if (entries == document.end() || !entries->is_array()) return false;
    return std::ranges::any_of(*entries, [](const Json& entry) {
        if (!entry.is_object()) return false;
        const auto event = entry.find("Event");
        return event != entry.end() && event->is_object() && event->contains("Type");
    });
}

}  // namespace

Likeness he_likeness(const Json& document, std::string_view) {
    const auto has = [&](const char* key) { return document.contains(key); };
    const bool has_list = has("PatternList");
    const bool has_channels = has("Channels") && (has("MetaData") || has("Metadata"));
    return has_list || has_channels || has_typed_event(document) ? Likeness::certain
                                                                 : Likeness::none;
}

Expected<Effects> read_he(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    HeReading he{file.map, {}, {}};
    read_he_parts(object, document, he);
    if (!reading.fault.empty()) return Error{reading.fault};
    if (is_empty(he.sides[0]) && is_empty(he.sides[1])) {
        return Error{file.path + ": expected at least one event, got none"};
    }
    const double latest_s = std::max(latest_of(he.sides[0]), latest_of(he.sides[1]));
    if (const auto times = times_make_sense(file, 1e3 * latest_s); !times) return times.error();
    std::vector<Effect> sides;
    for (std::size_t k = 0; k < he.sides.size(); ++k) {
        if (is_empty(he.sides[k])) continue;
        he.sides[k].unit_g = continuous_g(file.map, 1.0);
        auto effect = finished(file, file.stem + kSideNames[k], he.sides[k], he.remarks);
        if (!effect) return effect.error();
        sides.push_back(*std::move(effect));
    }
    const bool one = sides.size() == 1 || sides[0].pattern == sides[1].pattern;
    if (one) {
        sides.resize(1);
        sides[0].name = file.stem;
    } else {
        for (Effect& side : sides) {
            side.remarks.push_back("its left and right channel are two patterns");
        }
    }
    return sides;
}

}  // namespace tact
