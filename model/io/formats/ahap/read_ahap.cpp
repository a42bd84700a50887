// Apple's haptic and audio patterns (AHAP).
//
// Source    Apple's "Representing haptic patterns in AHAP files": intensity controls multiply,
//           sharpness controls add, both act on all events; what is missing takes its default, what
//           is out of range is clamped, keys that mean nothing are ignored. Times of control points
//           count from their curve's. Hz, g and the transient's length are the map's.
//           Meta's and Lofelt's writers give points in the file's time instead: taken so where the
//           first point of every curve that begins late is at the curve's own time.
// Guessed   defaults of 1 for intensity and 0.5 for sharpness; a control is held behind its last
//           point.
// Refused   an entry of the pattern that is not one of the three, as in Meta's reader; no event.
// Left out  sounds; attack, decay and release.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/io/formats/ahap/ahap.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kLongestEventS = 30.0;

struct AhapEvent {
    double time_s = 0.0;
    double duration_s = 0.0;  // 0: a transient
    double intensity = 1.0;
    double sharpness = 0.5;
};

struct Control {
    double time_s = 0.0;
    AmplitudeCurve points;  // in the curve's time until all are read, then in the file's
    bool is_curve = false;  // else one value from its time on
};

struct AhapPattern {
    std::vector<AhapEvent> events;
    std::vector<Control> intensity;
    std::vector<Control> sharpness;
    std::vector<std::string> remarks;
    double percent = 0.0;  // the largest value that may be one; 0: none
};

constexpr double kLeastPercent = 1.5;  // above it, a share of 1 is not one by rounding

double clamped_to(AhapPattern& pattern, double value, Range range, const std::string& what) {
    if (!range.contains(value)) {
        remark_once(pattern.remarks, what + " out of range is clamped, as Core Haptics does");
    }
    if (value > kLeastPercent && value <= 100.0) pattern.percent = std::max(pattern.percent, value);
    return std::clamp(value, range.low, range.high);
}

// A list of {"ParameterID": .., "ParameterValue": ..}.
void read_parameters(JsonObject& event, AhapEvent& result, AhapPattern& pattern) {
    Json unknown;
    read_objects(event, "EventParameters", 0, 1000, unknown, [&](JsonObject& one, Json&) {
        const std::string id = text_field(one, "ParameterID", "");
        const double value = needed_number_of(one, "ParameterValue", kAnyNumber);
        if (id == "HapticIntensity") {
            result.intensity = clamped_to(pattern, value, kShare, "intensity");
        } else if (id == "HapticSharpness") {
            result.sharpness = clamped_to(pattern, value, kShare, "sharpness");
        } else {
            remark_once(pattern.remarks, in_quotes(id) + " of events is left out");
        }
    });
}

void read_event(JsonObject& event, AhapPattern& pattern) {
    const std::string type = text_field(event, "EventType", "");
    AhapEvent result;
    result.time_s = number_field(event, "Time", 0.0, kEffectTimeS);
    read_parameters(event, result, pattern);
    if (type == "AudioContinuous" || type == "AudioCustom") {
        return remark_once(pattern.remarks, "its sounds are left out");
    }
    if (type != "HapticContinuous" && type != "HapticTransient") {
        return refuse_plainly(*event.reading, place_of(event, "EventType"),
                              "expected HapticTransient, HapticContinuous, AudioContinuous or "
                              "AudioCustom, got " +
                                  in_quotes(type));
    }
    if (type == "HapticContinuous") {
        const double length_s = number_field(event, "EventDuration", 0.0, kEffectTimeS);
        if (!(length_s > 0.0)) {
            return remark_once(pattern.remarks, "continuous events without a duration are silent");
        }
        if (length_s > kLongestEventS) {
            remark_once(pattern.remarks,
                        "a continuous event is longer than the 30 s that Core "
                        "Haptics plays");
        }
        result.duration_s = length_s;
    }
    pattern.events.push_back(result);
}

// To the controls of that name; none where it is not one of ours.
std::vector<Control>* controls_of(AhapPattern& pattern, const std::string& id) {
    if (id == "HapticIntensityControl") return &pattern.intensity;
    if (id == "HapticSharpnessControl") return &pattern.sharpness;
    remark_once(pattern.remarks, in_quotes(id) + " is left out");
    return nullptr;
}

Range range_of(const AhapPattern& pattern, const std::vector<Control>* controls) {
    return controls == &pattern.intensity ? Range{0.0, 1.0} : Range{-1.0, 1.0};
}

void read_curve(JsonObject& curve, AhapPattern& pattern) {
    Control control;
    control.is_curve = true;
    const std::string id = text_field(curve, "ParameterID", "");
    control.time_s = number_field(curve, "Time", 0.0, kEffectTimeS);
    std::vector<Control>* controls = controls_of(pattern, id);
    Json unknown;
    read_objects(curve, "ParameterCurveControlPoints", 0, kMostVoicePoints, unknown,
                 [&](JsonObject& point, Json&) {
                     const double time_s = number_field(point, "Time", 0.0, kEffectTimeS);
                     const double value = needed_number_of(point, "ParameterValue", kAnyNumber);
                     if (controls == nullptr) return;
                     control.points.push_back(
                         {time_s, clamped_to(pattern, value, range_of(pattern, controls), id)});
                 });
    if (controls == nullptr || control.points.empty()) return;
    std::ranges::stable_sort(control.points, {}, &AmplitudePoint::time_s);
    controls->push_back(std::move(control));
}

// Whether the points of a curve that begins late begin at its own time.
bool looks_absolute(const Control& control) {
    return std::abs(control.points.front().time_s - control.time_s) < 1e-6;
}

// Points count from their curve's time, unless every late curve of the file speaks against it.
void place_curves(AhapPattern& pattern) {
    std::size_t late = 0;
    std::size_t absolute = 0;
    for (const auto* controls : {&pattern.intensity, &pattern.sharpness}) {
        for (const Control& control : *controls) {
            const bool counts = control.is_curve && control.time_s > 0.0;
            late += counts ? 1 : 0;
            absolute += counts && looks_absolute(control) ? 1 : 0;
        }
    }
    const bool all_absolute = late > 0 && absolute == late;
    if (all_absolute) {
        remark_once(pattern.remarks,
                    "times of control points are taken as the file's, not the curve's, as Meta's "
                    "writer gives them");
    }
    for (auto* controls : {&pattern.intensity, &pattern.sharpness}) {
        for (Control& control : *controls) {
            if (control.is_curve && all_absolute) continue;
            for (AmplitudePoint& point : control.points) point.time_s += control.time_s;
        }
    }
}

void read_parameter(JsonObject& parameter, AhapPattern& pattern) {
    const std::string id = text_field(parameter, "ParameterID", "");
    const double time_s = number_field(parameter, "Time", 0.0, kEffectTimeS);
    const double value = needed_number_of(parameter, "ParameterValue", kAnyNumber);
    std::vector<Control>* controls = controls_of(pattern, id);
    if (controls == nullptr) return;
    const double share = clamped_to(pattern, value, range_of(pattern, controls), id);
    controls->push_back({time_s, {{0.0, share}}});
}

void read_entry(JsonObject& entry, AhapPattern& pattern) {
    const auto has = [&](const char* key) {
        return entry.value != nullptr && entry.value->contains(key);
    };
    if (has("Event")) {
        JsonObject event = object_field(entry, "Event");
        read_event(event, pattern);
    } else if (has("ParameterCurve")) {
        JsonObject curve = object_field(entry, "ParameterCurve");
        read_curve(curve, pattern);
    } else if (has("Parameter")) {
        JsonObject parameter = object_field(entry, "Parameter");
        read_parameter(parameter, pattern);
    } else {
        const bool empty = entry.value == nullptr || entry.value->empty();
        refuse_plainly(*entry.reading, entry.place,
                       "expected \"Event\", \"ParameterCurve\" or \"Parameter\", got " +
                           (empty ? "none" : in_quotes(entry.value->begin().key())));
    }
}

// One after the other, each until the next begins, the last value held: one curve.
AmplitudeCurve joined_controls(std::vector<Control> controls, double fallback) {
    std::ranges::stable_sort(controls, {},
                             [](const Control& control) { return control.points.front().time_s; });
    AmplitudeCurve all;
    double held = fallback;
    for (std::size_t k = 0; k < controls.size(); ++k) {
        const AmplitudeCurve& points = controls[k].points;
        if (held != points.front().value) all.push_back({points.front().time_s, held});
        const bool last = k + 1 == controls.size();
        const double until_s = last ? points.back().time_s : controls[k + 1].points[0].time_s;
        for (const AmplitudePoint& point : points) {
            if (last || point.time_s < until_s) all.push_back(point);
        }
        held = points.back().value;
        if (!last && points.back().time_s >= until_s) {
            held = sides_at(points, until_s).before;
            all.push_back({until_s, held});
        }
    }
    if (all.empty()) all.push_back({0.0, fallback});
    return all;
}

AmplitudeCurve with_base(AmplitudeCurve curve, const std::function<double(double)>& base) {
    for (AmplitudePoint& point : curve) point.value = base(point.value);
    return curve;
}

// The points that a curve has over a voice, with the last before it and the first behind it.
AmplitudeCurve around(const AmplitudeCurve& curve, const Voice& voice) {
    auto from = std::ranges::upper_bound(curve, voice.start_s, {}, &AmplitudePoint::time_s);
    if (from != curve.begin()) --from;
    auto to = std::ranges::lower_bound(from, curve.end(), voice.end_s, {}, &AmplitudePoint::time_s);
    if (to != curve.end()) ++to;
    return {from, to};
}

Voice voice_of(const AhapEvent& event, const AmplitudeCurve& intensity,
               const AmplitudeCurve& sharpness, const ActuatorMap& map) {
    Voice voice;
    voice.start_s = event.time_s;
    voice.end_s = event.time_s + event.duration_s;
    voice.amplitude = acceleration_curve(
        map, with_base(around(intensity, voice),
                       [&](double control) { return control * event.intensity; }));
    voice.frequency = frequency_curve(map, with_base(around(sharpness, voice), [&](double control) {
                                          return control + event.sharpness;
                                      }));
    return voice;
}

Expected<Sketch> sketch_of(const AhapPattern& pattern, const EffectFile& file) {
    const AmplitudeCurve intensity = joined_controls(pattern.intensity, 1.0);
    const AmplitudeCurve sharpness = joined_controls(pattern.sharpness, 0.0);
    Sketch sketch;
    sketch.unit_g = continuous_g(file.map, 1.0);
    std::size_t points = 0;  // each continuous event has the controls once more
    for (const AhapEvent& event : pattern.events) {
        if (event.duration_s > 0.0) {
            Voice voice = cut_out(voice_of(event, intensity, sharpness, file.map));
            points += voice.amplitude.size() + voice.frequency.size();
            if (const std::string fault = size_fault(sketch, points); !fault.empty()) {
                return Error{file.path + ": " + fault};
            }
            sketch.voices.push_back(std::move(voice));
        } else {
            const double level = event.intensity * sides_at(intensity, event.time_s).behind;
            const double sharp = event.sharpness + sides_at(sharpness, event.time_s).behind;
            add_bursts(sketch.transients, transients_on(file.map, event.time_s, level, sharp));
        }
    }
    return sketch;
}

// Apple leaves the metadata free: what is no text is no name of a project.
std::string project_of(const Json& document) {
    const auto metadata = document.find("Metadata");
    if (metadata == document.end() || !metadata->is_object()) return {};
    const auto project = metadata->find("Project");
    return project != metadata->end() && project->is_string() ? project->get<std::string>() : "";
}

// Files whose numbers are in other units play, but not as they were meant.
void remark_units(AhapPattern& pattern) {
    if (pattern.percent > 0.0) {
        remark_once(pattern.remarks, "values of up to " + significant_digits(pattern.percent, 4) +
                                         " where 1 is the most: these may be percent");
    }
    double end_s = 0.0;
    bool whole = true;
    for (const AhapEvent& event : pattern.events) {
        end_s = std::max(end_s, event.time_s + event.duration_s);
        whole = whole && event.time_s == std::floor(event.time_s);
    }
    if (!whole || !(end_s > limits::kDurationS.high)) return;
    remark_once(pattern.remarks, "times of up to " + significant_digits(end_s, 4) +
                                     " s, all whole: these may be ms");
}

}  // namespace

Likeness ahap_likeness(const Json& document, std::string_view) {
    return document.contains("Pattern") ? Likeness::likely : Likeness::none;
}

std::string ahap_stranger(const std::filesystem::path&, std::string_view head) {
    const auto has = [&head](const char* key) { return head.find(key) != head.npos; };
    const bool is_of_ahap = has("\"EventType\"") || has("\"ParameterID\"");
    if (!is_of_ahap || has("\"Pattern\"")) return {};
    return "is a fragment of AHAP: expected its events in \"Pattern\"";
}

Expected<Effects> read_ahap(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    AhapPattern pattern;
    Json unknown;
    read_objects(object, "Pattern", 1, kMostVoicePoints, unknown,
                 [&](JsonObject& entry, Json&) { read_entry(entry, pattern); });
    if (!reading.fault.empty()) return Error{reading.fault};
    if (pattern.events.empty()) {
        return Error{file.path + ": /Pattern: expected at least one haptic event, got none"};
    }
    place_curves(pattern);
    remark_units(pattern);
    const auto sketch = sketch_of(pattern, file);
    if (!sketch) return sketch.error();
    auto effect = finished(file, file.stem, *sketch, std::move(pattern.remarks));
    if (!effect) return effect.error();
    effect->project = project_of(document);
    return Effects{*std::move(effect)};
}

}  // namespace tact
