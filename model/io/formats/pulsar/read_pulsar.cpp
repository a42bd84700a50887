// Presets of Pulsar (Software Mansion).
//
// Source    its documentation: times in ms, amplitude and frequency from 0 to 1; either part may be
//           empty. Its own players map frequency to Core Haptics' sharpness, hence the map.
// Guessed   a continuous part without frequencies has 0.5; it is silent before its first point and
//           ends with its last one.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/formats/pulsar/pulsar.h"

namespace tact {

namespace {

AmplitudeCurve points_of(JsonObject& object, std::string_view key) {
    AmplitudeCurve curve;
    const Json* value = field(object, key);
    if (value == nullptr || value->is_null()) return curve;
    Json unknown;
    read_objects(object, key, 0, kMostVoicePoints, unknown, [&](JsonObject& point, Json&) {
        const double time_s = needed_number_of(point, "time", kEffectTimeMs) / 1e3;
        if (!curve.empty() && time_s < curve.back().time_s) {
            refuse(*point.reading, place_of(point, "time"), "a time not before the last point's",
                   time_s * 1e3);
        }
        curve.push_back({time_s, needed_number_of(point, "value", kShare)});
    });
    return curve;
}

}  // namespace

Likeness pulsar_likeness(const Json& document, std::string_view) {
    return document.contains("continuousPattern") || document.contains("discretePattern")
               ? Likeness::certain
               : Likeness::none;
}

Expected<Effects> read_pulsar(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    Sketch sketch;
    sketch.unit_g = continuous_g(file.map, 1.0);
    sketch.duration_s = number_field(object, "duration", 0.0, kEffectTimeMs) / 1e3;
    JsonObject continuous = object_field(object, "continuousPattern");
    const AmplitudeCurve amplitude = points_of(continuous, "amplitude");
    AmplitudeCurve frequency = points_of(continuous, "frequency");
    if (frequency.empty()) frequency.push_back({0.0, 0.5});
    double end_s = 0.0;
    Json unknown;
    read_objects(object, "discretePattern", 0, kMostVoicePoints, unknown,
                 [&](JsonObject& point, Json&) {
                     const double time_s = needed_number_of(point, "time", kEffectTimeMs) / 1e3;
                     const double level = needed_number_of(point, "amplitude", kShare);
                     const double share = needed_number_of(point, "frequency", kShare);
                     add_bursts(sketch.transients, transients_on(file.map, time_s, level, share));
                     end_s = std::max(end_s, time_s);
                 });
    if (!reading.fault.empty()) return Error{reading.fault};
    if (amplitude.empty() && sketch.transients.empty()) {
        return Error{file.path +
                     ": expected points in \"continuousPattern\" or \"discretePattern\", "
                     "both are empty"};
    }
    if (amplitude.size() > 1) {
        sketch.voices.push_back({amplitude.front().time_s, amplitude.back().time_s,
                                 acceleration_curve(file.map, amplitude),
                                 frequency_curve(file.map, frequency), 0.0});
    }
    std::vector<std::string> remarks;
    if (amplitude.size() == 1) remarks.push_back("one point of amplitude alone lasts no time");
    double latest_s = std::max(sketch.duration_s, end_s);
    if (!amplitude.empty()) latest_s = std::max(latest_s, amplitude.back().time_s);
    if (const auto times = times_make_sense(file, 1e3 * latest_s); !times) return times.error();
    // A last point of amplitude 0 says how long the preset is.
    sketch.duration_s = std::max(sketch.duration_s, end_s);
    auto effect = finished(file, file.stem, sketch, std::move(remarks));
    if (!effect) return effect.error();
    return Effects{*std::move(effect)};
}

}  // namespace tact
