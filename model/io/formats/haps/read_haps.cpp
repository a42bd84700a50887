// Interhaptics' .haps, version 5.
//
// Source    its documentation's page on the format: perceptions of melodies of notes; a transient
// or
//           keyframes of amplitude (0 to 1) and frequency (Hz). The names of the keys were read off
//           files, as there is no schema.
// Guessed   gains of note, melody, perception and file multiply; keyframes are joined by straight
//           lines and end with their note; a transient's Hz.
// Left out  slopes of keyframes, loops, stiffness and texture.

#include <nlohmann/json.hpp>

#include "model/io/formats/haps/haps.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr Range kHapsGain{0.0, 100.0};
constexpr Range kHapsHz{0.0, 1e6};
constexpr double kHapsSignalHz = 75.0;  // of all stock effects

struct HapsReading {
    const ActuatorMap& map;
    Sketch sketch;
    std::vector<std::string> remarks;
};

// The note begins at `start_s`.
AmplitudeCurve keyframes_of(JsonObject& effect, std::string_view key, double start_s, Range values,
                            HapsReading& haps) {
    AmplitudeCurve curve;
    JsonObject modulation = object_field(effect, key);
    Json unknown;
    read_objects(
        modulation, "m_keyframes", 0, kMostVoicePoints, unknown, [&](JsonObject& frame, Json&) {
            const double time_s = start_s + needed_number_of(frame, "m_time", kEffectTimeS);
            if (!curve.empty() && time_s < curve.back().time_s) {
                refuse(*frame.reading, place_of(frame, "m_time"),
                       "a time not before the last keyframe's", time_s - start_s);
            }
            if (frame.value != nullptr &&
                (frame.value->contains("m_inSlope") || frame.value->contains("m_outSlope"))) {
                remark_once(haps.remarks, "slopes of keyframes are left out: straight lines");
            }
            curve.push_back({time_s, needed_number_of(frame, "m_value", values)});
        });
    return curve;
}

void add_note(JsonObject& note, JsonObject& effect, double gain, HapsReading& haps) {
    const double start_s = needed_number_of(note, "m_startingPoint", kEffectTimeS);
    const double length_s = needed_number_of(note, "m_length", kEffectTimeS);
    Voice voice{start_s, start_s + length_s, {}, {}, 0.0};
    JsonObject signal = object_field(effect, "m_underlyingSignal");
    const double own_hz = number_field(signal, "m_frequency", kHapsSignalHz, kHapsHz);
    const double own_gain = number_field(signal, "m_amplitude", 1.0, kHapsGain);
    AmplitudeCurve shares = keyframes_of(effect, "m_amplitudeModulation", start_s, kHapsGain, haps);
    if (shares.empty()) shares.push_back({start_s, 1.0});
    const AmplitudeCurve hz = keyframes_of(effect, "m_frequencyModulation", start_s, kHapsHz, haps);
    for (const AmplitudePoint& point : hz) voice.frequency.push_back({point.time_s, point.value});
    if (voice.frequency.empty()) voice.frequency.push_back({start_s, own_hz});
    for (AmplitudePoint& point : shares) {
        point.value *= haps.map.full_scale_g * haps.map.continuous_gain * gain * own_gain;
    }
    voice.amplitude = std::move(shares);
    if (length_s > 0.0) haps.sketch.voices.push_back(cut_out(std::move(voice)));
}

void read_note(JsonObject& note, double gain, HapsReading& haps) {
    const double own = gain * number_field(note, "m_gain", 1.0, kHapsGain);
    if (note.value == nullptr || !note.value->contains("m_hapticEffect")) {
        return refuse_plainly(*note.reading, place_of(note, "m_hapticEffect"),
                              "expected an object, it is missing");
    }
    JsonObject effect = object_field(note, "m_hapticEffect");
    const bool keyed =
        effect.value != nullptr && (effect.value->contains("m_amplitudeModulation") ||
                                    effect.value->contains("m_frequencyModulation"));
    if (keyed) return add_note(note, effect, own, haps);
    if (number_field(effect, "m_type", 0.0, kAnyNumber) != 0.0) {
        return remark_once(haps.remarks, "notes of a kind that is not known are left out");
    }
    const double time_s = needed_number_of(note, "m_startingPoint", kEffectTimeS);
    std::vector<Transient> bursts = transients_on(haps.map, time_s, 1.0, 0.5);
    for (Transient& burst : bursts) burst.amplitude_g *= own;  // gains above 1 are there
    add_bursts(haps.sketch.transients, bursts);
}

void read_melodies(JsonObject& perception, double gain, HapsReading& haps) {
    Json unknown;
    read_objects(perception, "m_melodies", 0, 10'000, unknown, [&](JsonObject& melody, Json&) {
        if (number_field(melody, "m_mute", 0.0, kAnyNumber) != 0.0) {
            return remark_once(haps.remarks, "muted melodies are left out");
        }
        const double own = gain * number_field(melody, "m_gain", 1.0, kHapsGain);
        Json inner;
        read_objects(melody, "m_notes", 0, kMostVoicePoints, inner,
                     [&](JsonObject& note, Json&) { read_note(note, own, haps); });
    });
}

}  // namespace

Likeness haps_likeness(const Json& document, std::string_view) {
    return document.contains("m_vibration") || document.contains("m_version") ? Likeness::certain
                                                                              : Likeness::none;
}

Expected<Effects> read_haps(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    HapsReading haps{file.map, {}, {}};
    haps.sketch.unit_g = file.map.full_scale_g * file.map.continuous_gain;
    const std::string version = text_field(object, "m_version", "");
    if (version != "5") remark_once(haps.remarks, "version " + in_quotes(version) + " read as 5");
    if (field(object, "m_vibration") == nullptr) {
        return Error{file.path + ": /m_vibration: expected an object, it is missing"};
    }
    JsonObject vibration = object_field(object, "m_vibration");
    const double gain = number_field(object, "m_gain", 1.0, kHapsGain) *
                        number_field(vibration, "m_gain", 1.0, kHapsGain);
    if (number_field(vibration, "m_loop", 0.0, kAnyNumber) != 0.0) {
        remark_once(haps.remarks, "loops in its player; once here");
    }
    read_melodies(vibration, gain, haps);
    if (!reading.fault.empty()) return Error{reading.fault};
    const bool has_others = document.contains("m_stiffness") || document.contains("m_texture");
    if (has_others) {
        remark_once(haps.remarks, "its stiffness and texture are left out");
    }
    if (haps.sketch.voices.empty() && haps.sketch.transients.empty()) {
        return Error{file.path + ": /m_vibration: expected at least one note, got none" +
                     (has_others ? ", as it holds stiffness or texture alone" : "")};
    }
    auto effect = finished(file, file.stem, haps.sketch, std::move(haps.remarks));
    if (!effect) return effect.error();
    return Effects{*std::move(effect)};
}

}  // namespace tact
