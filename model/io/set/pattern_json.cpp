#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "model/io/set/design_space_json.h"
#include "model/io/set/set_json.h"
#include "model/pattern/drawn_fault.h"
#include "model/pattern/rhythm_edit.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::array<const char*, 2> kTransientShapes{"sine", "square"};
constexpr std::array<const char*, 2> kAccents{"joined", "added"};
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

Carrier carrier_of(JsonObject& object) {
    Carrier carrier;
    carrier.frequency_hz =
        number_field(object, "frequency_hz", carrier.frequency_hz, limits::kCarrierHz);
    carrier.weight = number_field(object, "weight", carrier.weight, limits::kCarrierWeight);
    carrier.phase_rad = number_field(object, "phase_rad", carrier.phase_rad, limits::kPhaseRad);
    return carrier;
}

std::vector<Carrier> carriers_of(JsonObject& object, Json& unknown) {
    std::vector<Carrier> carriers;
    read_objects(object, "carriers", 1, limits::kMaxCarriers, unknown,
                 [&](JsonObject& one, Json&) { carriers.push_back(carrier_of(one)); });
    return carriers.empty() ? std::vector<Carrier>(1) : carriers;
}

Modulation modulation_of(JsonObject& object, Json& unknown) {
    JsonObject fields = object_field(object, "modulation");
    Modulation modulation;
    modulation.kind =
        static_cast<ModulationKind>(choice_field(fields, "kind", 0, kModulationKinds));
    modulation.frequency_hz = number_field(fields, "frequency_hz", 0.0, limits::kModulationHz);
    modulation.depth = number_field(fields, "depth", modulation.depth, limits::kDepth);
    note_unknown(unknown, "modulation", unknown_fields(fields));
    return modulation;
}

// The kinds of notes by their letters: {"A": {"velocity": 0.37, "pitch": 1.5}}.
std::map<char, NoteKind> kinds_of(JsonObject& rhythm, Json& unknown) {
    JsonObject fields = object_field(rhythm, "notes");
    std::map<char, NoteKind> kinds;
    Json of_kinds = Json::object();
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        const std::string key(1, letter);
        if (fields.value == nullptr || !fields.value->contains(key)) continue;
        JsonObject one = object_field(fields, kLetters.substr(letter - 'A', 1));
        NoteKind& kind = kinds[letter];
        kind.velocity = number_field(one, "velocity", kind.velocity, limits::kVelocity);
        kind.pitch = number_field(one, "pitch", kind.pitch, limits::kPitch);
        note_unknown(of_kinds, key, unknown_fields(one));
    }
    of_kinds.update(unknown_fields(fields));
    note_unknown(unknown, "notes", of_kinds);
    return kinds;
}

// The length of a step, or of a beat by its tempo; of both, the first where they agree.
void read_tempo(JsonObject& fields, Rhythm& rhythm) {
    Meter& meter = rhythm.meter;
    meter.steps_a_beat =
        whole_field(fields, "steps_a_beat", meter.steps_a_beat, limits::kStepsABeat);
    meter.beats_a_bar = whole_field(fields, "beats_a_bar", meter.beats_a_bar, limits::kBeatsABar);
    const bool has_unit = field(fields, "unit_s") != nullptr;
    rhythm.unit_s = number_field(fields, "unit_s", rhythm.unit_s, limits::kRhythmUnitS);
    if (field(fields, "bpm") == nullptr) return;
    const auto tempo = [&meter](double unit_s) { return tempo_bpm(unit_s, meter.steps_a_beat); };
    const double own_bpm = tempo(rhythm.unit_s);
    const Range allowed{tempo(limits::kRhythmUnitS.high), tempo(limits::kRhythmUnitS.low)};
    const double bpm = number_field(fields, "bpm", own_bpm, allowed);
    if (!has_unit) {
        rhythm.unit_s = unit_at_tempo(bpm, meter.steps_a_beat);
    } else if (std::abs(bpm - own_bpm) > 1e-9 * own_bpm) {
        refuse(*fields.reading, place_of(fields, "bpm"),
               "either unit_s or bpm, or the " + shortest_digits(own_bpm) + " that unit_s makes",
               bpm);
    }
}

Rhythm rhythm_of(JsonObject& object, Json& unknown) {
    JsonObject fields = object_field(object, "rhythm");
    Rhythm rhythm;
    rhythm.text = text_field(fields, "text", "");
    if (const std::string fault = rhythm_fault(rhythm.text); !fault.empty()) {
        refuse(*object.reading, place_of(fields, "text"), "a rhythm (" + fault + ")", rhythm.text);
        rhythm.text.clear();
    }
    Json of_rhythm = Json::object();
    rhythm.kinds = kinds_of(fields, of_rhythm);
    read_tempo(fields, rhythm);
    of_rhythm.update(unknown_fields(fields));
    note_unknown(unknown, "rhythm", of_rhythm);
    return rhythm;
}

// A point without one of its numbers is no point.
double needed_number(JsonObject& object, std::string_view key, Range range) {
    JsonReading& reading = *object.reading;
    if (field(object, key) == nullptr && reading.fault.empty()) {
        reading.fault =
            reading.file + ": " + place_of(object, key) + ": expected a number, it is missing";
    }
    return number_field(object, key, range.low, range);
}

// `height`: the key of what stands over the time.
template <class Point>
std::vector<Point> curve_of(JsonObject& object, std::string_view key, std::string_view height,
                            const Range& heights, Json& unknown) {
    std::vector<Point> curve;
    read_objects(object, key, 0, limits::kMaxCurvePoints, unknown, [&](JsonObject& one, Json&) {
        curve.push_back(
            {needed_number(one, "time_s", kAnyNumber), needed_number(one, height, heights)});
    });
    return curve;
}

std::vector<Transient> transients_of(JsonObject& object, Json& unknown) {
    std::vector<Transient> transients;
    read_objects(
        object, "transients", 0, limits::kMaxTransients, unknown, [&](JsonObject& one, Json&) {
            Transient got;
            got.time_s = needed_number(one, "time_s", kAnyNumber);
            got.amplitude_g =
                number_field(one, "amplitude_g", got.amplitude_g, limits::kAmplitudeG);
            got.frequency_hz =
                number_field(one, "frequency_hz", got.frequency_hz, limits::kCarrierHz);
            got.duration_s = number_field(one, "duration_s", got.duration_s, limits::kTransientS);
            got.shape =
                static_cast<TransientShape>(choice_field(one, "shape", 0, kTransientShapes));
            transients.push_back(got);
        });
    return transients;
}

void put_drawn(Json& fields, const Pattern& pattern) {
    for (const AmplitudePoint& point : pattern.amplitude_curve) {
        fields["amplitude_curve"].push_back({{"time_s", point.time_s}, {"value", point.value}});
    }
    for (const FrequencyPoint& point : pattern.frequency_curve) {
        fields["frequency_curve"].push_back(
            {{"time_s", point.time_s}, {"frequency_hz", point.frequency_hz}});
    }
    for (const Transient& one : pattern.transients) {
        fields["transients"].push_back(
            {{"time_s", one.time_s},
             {"amplitude_g", one.amplitude_g},
             {"frequency_hz", one.frequency_hz},
             {"duration_s", one.duration_s},
             {"shape", kTransientShapes[static_cast<std::size_t>(one.shape)]}});
    }
    if (pattern.accents != Accents::joined) {
        fields["accents"] = kAccents[static_cast<std::size_t>(pattern.accents)];
    }
}

Json json_of(const Rhythm& rhythm) {
    Json fields{{"text", rhythm.text}, {"unit_s", rhythm.unit_s}};
    const Meter defaults;
    if (rhythm.meter.steps_a_beat != defaults.steps_a_beat) {
        fields["steps_a_beat"] = rhythm.meter.steps_a_beat;
    }
    if (rhythm.meter.beats_a_bar != 0) fields["beats_a_bar"] = rhythm.meter.beats_a_bar;
    for (const auto& [letter, kind] : rhythm.kinds) {
        Json& one = fields["notes"][std::string(1, letter)];
        one = Json::object();
        if (kind.velocity != 1.0) one["velocity"] = kind.velocity;
        if (kind.pitch != 1.0) one["pitch"] = kind.pitch;
    }
    return fields;
}

}  // namespace

Pattern pattern_of(JsonObject& object, double set_duration_s, Json& unknown) {
    Pattern pattern;
    pattern.amplitude_g =
        number_field(object, "amplitude_g", pattern.amplitude_g, limits::kAmplitudeG);
    pattern.carriers = carriers_of(object, unknown);
    pattern.modulation = modulation_of(object, unknown);
    pattern.rhythm = rhythm_of(object, unknown);
    pattern.attack_s = number_field(object, "attack_s", pattern.attack_s, limits::kRampS);
    pattern.release_s = number_field(object, "release_s", pattern.release_s, limits::kRampS);
    pattern.duration_s = number_field(object, "duration_s", set_duration_s, limits::kDurationS);
    pattern.amplitude_curve =
        curve_of<AmplitudePoint>(object, "amplitude_curve", "value", limits::kCurveValue, unknown);
    pattern.frequency_curve = curve_of<FrequencyPoint>(object, "frequency_curve", "frequency_hz",
                                                       limits::kCarrierHz, unknown);
    pattern.transients = transients_of(object, unknown);
    pattern.accents = static_cast<Accents>(choice_field(object, "accents", 0, kAccents));
    // Numbers have been looked at one by one; what is left are times and their order.
    if (const auto fault = drawn_fault(pattern)) {
        refuse(*object.reading, object.place + "/" + fault->place, fault->expected, fault->got);
    }
    return pattern;
}

Json json_of(const Pattern& pattern, double set_duration_s) {
    Json fields = Json::object();
    const Pattern defaults;
    fields["amplitude_g"] = pattern.amplitude_g;
    fields["carriers"] = Json::array();
    for (const Carrier& carrier : pattern.carriers) {
        Json one = {{"frequency_hz", carrier.frequency_hz}, {"weight", carrier.weight}};
        if (carrier.phase_rad != 0.0) one["phase_rad"] = carrier.phase_rad;
        fields["carriers"].push_back(one);
    }
    if (pattern.modulation != defaults.modulation) {
        Json& modulation = fields["modulation"];
        modulation["kind"] = kModulationKinds[static_cast<std::size_t>(pattern.modulation.kind)];
        modulation["frequency_hz"] = pattern.modulation.frequency_hz;
        if (pattern.modulation.depth != 1.0) modulation["depth"] = pattern.modulation.depth;
    }
    if (pattern.rhythm != defaults.rhythm) {
        fields["rhythm"] = json_of(pattern.rhythm);
    }
    if (pattern.attack_s != 0.0) fields["attack_s"] = pattern.attack_s;
    if (pattern.release_s != 0.0) fields["release_s"] = pattern.release_s;
    if (pattern.duration_s != set_duration_s) fields["duration_s"] = pattern.duration_s;
    put_drawn(fields, pattern);
    return fields;
}

}  // namespace tact
