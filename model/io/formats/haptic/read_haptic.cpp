// Meta's .haptic, version 1.
//
// Source    .haptic File Specification 1.0 and the renderer of Meta's Haptics SDK (MIT): a sine
//           whose phase runs on, from the lowest to the highest Hz of the map; 0.5 until the first
//           frequency point; silent before the first amplitude point. An emphasis is a burst that
//           the next one cuts; the sine is ducked as long as it lasts. Where the last point has an
//           emphasis the renderer holds its amplitude for 0.1 s more.
// Refused   what the specification calls invalid. Frequency points behind the end pass in files of
//           Lofelt's or Meta's studio, as in its owner's mode for those.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/formats/haptic/haptic.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kHeldForEmphasisS = 0.1;
constexpr double kMissingFrequency = 0.5;

struct Emphasis {
    double time_s;
    double amplitude;
    double frequency;
};

struct Envelopes {
    bool of_studio = false;
    bool cut = false;  // frequency points behind the end
    AmplitudeCurve amplitude;
    AmplitudeCurve frequency;
    std::vector<Emphasis> emphases;
};

void refuse_falling_time(JsonObject& point, const AmplitudeCurve& curve, double time_s) {
    if (curve.empty() || time_s >= curve.back().time_s) return;
    refuse(*point.reading, place_of(point, "time"), "a time not before the last point's", time_s);
}

void read_emphasis(JsonObject& point, double amplitude, double time_s, Envelopes& result) {
    const Json* value = field(point, "emphasis");
    if (value == nullptr || value->is_null()) return;
    JsonObject emphasis = object_field(point, "emphasis");
    Emphasis one{time_s, needed_number_of(emphasis, "amplitude", kShare),
                 needed_number_of(emphasis, "frequency", kShare)};
    if (one.amplitude < amplitude) {
        refuse(*point.reading, place_of(emphasis, "amplitude"),
               "at least the amplitude of its point", one.amplitude);
    }
    result.emphases.push_back(one);
}

void read_amplitude(JsonObject& envelopes, Envelopes& result) {
    if (field(envelopes, "amplitude") == nullptr) {
        refuse_plainly(*envelopes.reading, place_of(envelopes, "amplitude"),
                       "expected an array of at least 2 points, it is missing");
    }
    Json unknown;
    read_objects(envelopes, "amplitude", 2, kMostVoicePoints, unknown,
                 [&](JsonObject& point, Json&) {
                     const double time_s = needed_number_of(point, "time", kEffectTimeS);
                     const double amplitude = needed_number_of(point, "amplitude", kShare);
                     refuse_falling_time(point, result.amplitude, time_s);
                     read_emphasis(point, amplitude, time_s, result);
                     result.amplitude.push_back({time_s, amplitude});
                 });
    const bool is_read = envelopes.reading->fault.empty();
    if (is_read && !(result.amplitude.front().time_s < result.amplitude.back().time_s)) {
        refuse_plainly(*envelopes.reading, place_of(envelopes, "amplitude"),
                       "expected a duration above 0, all points are at one time");
    }
}

void read_frequency(JsonObject& envelopes, Envelopes& result) {
    const Json* value = field(envelopes, "frequency");
    if (value == nullptr || value->is_null() || result.amplitude.empty()) return;
    const double end_s = result.amplitude.back().time_s;
    Json unknown;
    read_objects(
        envelopes, "frequency", 0, kMostVoicePoints, unknown, [&](JsonObject& point, Json&) {
            const double time_s = needed_number_of(point, "time", kEffectTimeS);
            refuse_falling_time(point, result.frequency, time_s);
            result.cut = result.cut || time_s > end_s;
            if (time_s > end_s && !result.of_studio) {
                refuse(*point.reading, place_of(point, "time"),
                       "a time within the amplitude envelope", time_s);
            }
            result.frequency.push_back({time_s, needed_number_of(point, "frequency", kShare)});
        });
}

void read_version(JsonObject& object) {
    if (field(object, "version") == nullptr) {
        refuse_plainly(*object.reading, "/version", "expected {\"major\": 1, ..}, it is missing");
    }
    JsonObject version = object_field(object, "version");
    const double major = needed_number_of(version, "major", kAnyNumber);
    if (major != 1.0) refuse(*object.reading, "/version/major", "1", major);
}

bool is_of_studio(JsonObject& object) {
    JsonObject metadata = object_field(object, "metadata");
    const Json* editor = field(metadata, "editor");
    if (editor == nullptr || !editor->is_string()) return false;
    const std::string name = editor->get<std::string>();
    return name.find("Lofelt") != name.npos || name.find("Haptics Studio") != name.npos;
}

// When an emphasis sounds: until it ends or the next begins.
struct Span {
    double start_s;
    double end_s;
};

std::vector<Span> spans_of(const ActuatorMap& map, const std::vector<Emphasis>& emphases) {
    std::vector<Span> spans;
    for (std::size_t k = 0; k < emphases.size(); ++k) {
        const double start_s = emphases[k].time_s;
        double end_s = start_s + burst_duration_s(map, emphases[k].frequency);
        if (k + 1 < emphases.size()) end_s = std::min(end_s, emphases[k + 1].time_s);
        spans.push_back({start_s, end_s});
    }
    return spans;
}

// Just behind a time, or just before it.
bool is_within(const std::vector<Span>& spans, double t_s, bool behind) {
    const auto next = behind ? std::ranges::upper_bound(spans, t_s, {}, &Span::start_s)
                             : std::ranges::lower_bound(spans, t_s, {}, &Span::start_s);
    if (next == spans.begin()) return false;
    const Span& span = *(next - 1);
    return behind ? t_s < span.end_s : t_s <= span.end_s;
}

AmplitudeCurve ducked(const AmplitudeCurve& curve, const std::vector<Span>& spans, double gain) {
    if (spans.empty() || gain == 1.0) return curve;
    std::vector<double> times;
    for (const AmplitudePoint& point : curve) times.push_back(point.time_s);
    for (const Span& span : spans) {
        times.push_back(span.start_s);
        times.push_back(std::min(span.end_s, curve.back().time_s));
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    AmplitudeCurve result;
    for (const double t_s : times) {
        const Sides sides = sides_at(curve, t_s);
        const double before = sides.before * (is_within(spans, t_s, false) ? gain : 1.0);
        const double behind = sides.behind * (is_within(spans, t_s, true) ? gain : 1.0);
        result.push_back({t_s, before});
        if (before != behind) result.push_back({t_s, behind});
    }
    return result;
}

FrequencyCurve hz_of(const Envelopes& envelopes, const ActuatorMap& map) {
    AmplitudeCurve shares = envelopes.frequency;
    if (shares.empty() || shares.front().time_s > 0.0) {
        const double until_s = shares.empty() ? 0.0 : shares.front().time_s;
        shares.insert(shares.begin(), {until_s, kMissingFrequency});
    }
    return frequency_curve(map, shares);
}

Sketch sketch_of(Envelopes envelopes, const ActuatorMap& map, std::vector<std::string>& remarks) {
    const std::vector<Emphasis>& emphases = envelopes.emphases;
    const bool held =
        !emphases.empty() && emphases.back().time_s == envelopes.amplitude.back().time_s;
    if (held) {
        const AmplitudePoint last = envelopes.amplitude.back();
        envelopes.amplitude.push_back({last.time_s + kHeldForEmphasisS, last.value});
        remarks.push_back("held 0.1 s longer for the emphasis at its end, as its renderer does");
    }
    const AmplitudeCurve amplitude = acceleration_curve(map, envelopes.amplitude);
    Sketch sketch;
    sketch.unit_g = continuous_g(map, 1.0);
    sketch.duration_s = amplitude.back().time_s;
    sketch.voices.push_back({amplitude.front().time_s, sketch.duration_s,
                             ducked(amplitude, spans_of(map, emphases), map.ducking),
                             hz_of(envelopes, map), 0.0});
    for (std::size_t k = 0; k < emphases.size(); ++k) {
        std::optional<double> cut_s;
        if (k + 1 < emphases.size()) cut_s = emphases[k + 1].time_s - emphases[k].time_s;
        add_bursts(sketch.transients, transients_on(map, emphases[k].time_s, emphases[k].amplitude,
                                                    emphases[k].frequency, cut_s));
    }
    return sketch;
}

}  // namespace

Likeness haptic_likeness(const Json& document, std::string_view) {
    return document.contains("signals") ? Likeness::certain : Likeness::none;
}

std::string haptic_stranger(const std::filesystem::path& path, std::string_view) {
    if (lower_case(path.extension().string()) != ".vij") return {};
    return "is a .vij of an older Lofelt, whose format was never published: its makers' "
           "programs save it as .haptic";
}

Expected<Effects> read_haptic(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    read_version(object);
    JsonObject signals = object_field(object, "signals");
    JsonObject continuous = object_field(signals, "continuous");
    JsonObject fields = object_field(continuous, "envelopes");
    Envelopes envelopes;
    envelopes.of_studio = is_of_studio(object);
    read_amplitude(fields, envelopes);
    read_frequency(fields, envelopes);
    if (!reading.fault.empty()) return Error{reading.fault};
    std::vector<std::string> remarks;
    if (document.contains("impulses")) {
        remarks.push_back("its \"impulses\", of an earlier version, are left out");
    }
    if (envelopes.cut) remarks.push_back("frequency points behind the end are left out");
    const Sketch sketch = sketch_of(std::move(envelopes), file.map, remarks);
    auto effect = finished(file, file.stem, sketch, std::move(remarks));
    if (!effect) return effect.error();
    return Effects{*std::move(effect)};
}

}  // namespace tact
