// MPEG's haptic interchange format (HJIF, ISO/IEC 23090-31).
//
// Source    the standard's reference software (BSD-3-Clause) and files that it wrote: positions in
//           ticks of 1/timescale s, amplitudes as shares, Hz as they are, phases in radians;
//           amplitude and frequency are interpolated apart from each other, between the keyframes
//           that have them. Gain and mixing coefficient of a channel multiply.
// Output    an effect a channel; vectorial waves of one envelope become carriers (sketch.h), up to
//           four groups of them that sound at once layers, as the phases are given
// Tolerated older files ("version": "1"): negative amplitudes, keyframes without frequency; of
//           MPEG's tools positions before 0 that lost their sign, "Other" as a perception.
// Left out  wavelet bands, composites and perceptions that are not vibration, each with a remark.
//           A curve band is the course of the vibration itself: traced (model/pattern/traced.h).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "model/io/formats/hjif/hjif.h"
#include "model/pattern/traced.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr Range kTicks{0.0, 1e12};
constexpr Range kTimescale{1.0, 1e6};
constexpr Range kHjifAmplitude{-1e3, 1e3};
constexpr Range kHjifHz{0.0, 1e6};
constexpr Range kHjifGain{0.0, 1e3};
constexpr std::size_t kMostHjifObjects = 100'000;
constexpr double kMostTracedS = 120.0;  // of all curves of a file

struct HjifReading {
    const EffectFile& file;
    double ticks_per_s = 1000.0;
    double traced_s = 0.0;
    std::size_t points = 0;                 // that references make, of the channel that is read
    std::map<double, const Json*> library;  // of the perception that is read, by id
    std::vector<std::string> remarks;
    bool is_other = false;  // the perception that is being read calls itself so
    Effects effects;
    UnusedNames names;
};

struct Band {
    std::string type;
    double middle_hz;  // of its limits
    double gain_g;
    Sketch& sketch;
};

// The keyframes of a basis effect, in the file's time.
struct Keyframes {
    AmplitudeCurve amplitude;
    FrequencyCurve frequency;
    double end_s = 0.0;
};

// How many of the first keyframes stand before 0: their positions, of 16 bits, are written without
// a sign by a tool of the standard's own, such as 65534 before 0.
std::size_t frames_before_zero(JsonObject& effect, HjifReading& hjif) {
    constexpr double kLeast = 32'768.0;
    constexpr double kMost = 65'535.0;
    const Json* frames = field(effect, "keyframes");
    if (frames == nullptr || !frames->is_array()) return 0;
    for (std::size_t k = 0; k < frames->size(); ++k) {
        const Json& frame = (*frames)[k];
        const auto at = frame.is_object() ? frame.find("relative_position") : frame.end();
        const bool is_number = frame.is_object() && at != frame.end() && at->is_number();
        const double ticks = is_number ? at->get<double>() : 0.0;
        if (ticks > kMost) return 0;
        if (ticks >= kLeast) continue;
        if (k > 0) {
            remark_once(hjif.remarks,
                        "positions such as 65534 before 0 are taken as -2, and so as 0");
        }
        return k;
    }
    return 0;  // late, all of them
}

double next_ticks(JsonObject& frame, std::size_t& before_zero) {
    const double written = number_field(frame, "relative_position", 0.0, kTicks);
    if (before_zero == 0) return written;
    --before_zero;
    return 0.0;
}

Keyframes keyframes_of(JsonObject& effect, double start_s, HjifReading& hjif) {
    Keyframes frames;
    frames.end_s = start_s;
    std::size_t before_zero = frames_before_zero(effect, hjif);
    Json unknown;
    read_objects(effect, "keyframes", 0, kMostVoicePoints, unknown, [&](JsonObject& one, Json&) {
        const double ticks = next_ticks(one, before_zero);
        const double time_s = start_s + ticks / hjif.ticks_per_s;
        if (time_s < frames.end_s) {
            refuse(*one.reading, place_of(one, "relative_position"),
                   "a position not before the last keyframe's", ticks);
        }
        frames.end_s = time_s;
        if (field(one, "amplitude_modulation") != nullptr) {
            const double share = number_field(one, "amplitude_modulation", 0.0, kHjifAmplitude);
            if (share < 0.0) remark_once(hjif.remarks, "negative amplitudes are taken as positive");
            frames.amplitude.push_back({time_s, std::abs(share)});
        }
        if (field(one, "frequency_modulation") != nullptr) {
            frames.frequency.push_back(
                {time_s, number_field(one, "frequency_modulation", 0.0, kHjifHz)});
        }
    });
    return frames;
}

// The first harmonic of a wave of amplitude 1.
double fundamental(const std::string& signal) {
    if (signal == "Square") return 4.0 / std::numbers::pi;
    if (signal == "Triangle") return 8.0 / (std::numbers::pi * std::numbers::pi);
    return signal == "Sine" ? 1.0 : 2.0 / std::numbers::pi;
}

void add_transients(JsonObject& effect, double start_s, Band& band, HjifReading& hjif) {
    std::size_t before_zero = frames_before_zero(effect, hjif);
    Json unknown;
    read_objects(effect, "keyframes", 0, kMostVoicePoints, unknown, [&](JsonObject& one, Json&) {
        const double ticks = next_ticks(one, before_zero);
        const double share = number_field(one, "amplitude_modulation", 1.0, kHjifAmplitude);
        if (field(one, "frequency_modulation") == nullptr) {
            remark_once(hjif.remarks, "transients without frequency get the middle of their band");
        }
        const double hz = number_field(one, "frequency_modulation", band.middle_hz, kHjifHz);
        const double in_range = std::clamp(hz, limits::kCarrierHz.low, limits::kCarrierHz.high);
        if (in_range != hz) remark_once(hjif.remarks, "frequencies are moved into 0.1 to 1,000 Hz");
        band.sketch.transients.push_back(held_burst(start_s + ticks / hjif.ticks_per_s,
                                                    std::abs(share) * band.gain_g, in_range,
                                                    burst_duration_s(hjif.file.map, 0.5)));
    });
}

void add_wave(JsonObject& effect, double start_s, Band& band, HjifReading& hjif) {
    Keyframes frames = keyframes_of(effect, start_s, hjif);
    constexpr std::array<const char*, 5> kSignals{"Sine", "Square", "Triangle", "SawToothUp",
                                                  "SawToothDown"};
    const std::string signal = kSignals[choice_field(effect, "base_signal", 0, kSignals)];
    if (signal != "Sine") {
        remark_once(hjif.remarks, signal + " waves are taken as the sine that they begin with");
    }
    if (frames.amplitude.empty()) frames.amplitude.push_back({start_s, 1.0});
    if (frames.frequency.empty()) {
        remark_once(hjif.remarks, "keyframes without frequency get the middle of their band");
        frames.frequency.push_back({start_s, band.middle_hz});
    }
    for (AmplitudePoint& point : frames.amplitude) point.value *= band.gain_g * fundamental(signal);
    const double phase = number_field(effect, "phase", 0.0, limits::kPhaseRad);
    band.sketch.voices.push_back(
        {start_s, frames.end_s, std::move(frames.amplitude), std::move(frames.frequency), phase});
}

// Straight lines between keyframes of a curve, as a vibration of one frequency at a time.
void add_curve(JsonObject& effect, double start_s, Band& band, HjifReading& hjif) {
    const Keyframes frames = keyframes_of(effect, start_s, hjif);
    const double length_s = frames.end_s - start_s;
    if (frames.amplitude.size() < 2 || !(length_s > 0.0)) return;
    hjif.traced_s += length_s;
    if (hjif.traced_s > kMostTracedS) {
        return refuse_plainly(*effect.reading, effect.place,
                              "expected at most 120 s of curves in a file, got more");
    }
    remark_once(hjif.remarks, "curve bands are traced: one frequency at a time");
    Waveform course{kModelRateHz, {}};
    course.samples_g.resize(sample_count(length_s, kModelRateHz));
    for (std::size_t n = 0; n < course.samples_g.size(); ++n) {
        const double t_s = start_s + static_cast<double>(n) / kModelRateHz;
        course.samples_g[n] = band.gain_g * sides_at(frames.amplitude, t_s).behind;
    }
    Pattern pattern = traced(course).pattern;
    Voice voice{start_s, frames.end_s, pattern.amplitude_curve, pattern.frequency_curve, 0.0};
    if (voice.amplitude.empty()) voice.amplitude.push_back({0.0, 1.0});
    if (voice.frequency.empty()) {
        voice.frequency.push_back({0.0, pattern.carriers.front().frequency_hz});
    }
    for (AmplitudePoint& point : voice.amplitude) {
        point = {start_s + point.time_s, point.value * pattern.amplitude_g};
    }
    for (FrequencyPoint& point : voice.frequency) point.time_s += start_s;
    band.sketch.voices.push_back(std::move(voice));
}

// What is wrong with having the keyframes of an effect once more, or empty. It is asked before they
// are read: a thousand bytes of references may name a million of them.
std::string pay_for(const Json& effect, const Band& band, HjifReading& hjif) {
    const auto frames = effect.find("keyframes");
    const bool is_list = frames != effect.end() && frames->is_array();
    const std::size_t count = is_list ? frames->size() : 0;
    if (std::string fault = size_fault(band.sketch, hjif.points += 2 * count); !fault.empty()) {
        return fault;
    }
    return pay_points(hjif.file, count);
}

void read_effect(JsonObject& effect, Band& band, HjifReading& hjif) {
    const double start_s = number_field(effect, "position", 0.0, kTicks) / hjif.ticks_per_s;
    const std::string type = text_field(effect, "effect_type", "Basis");
    JsonObject basis = effect;
    if (type == "Reference") {
        const double id = needed_number_of(effect, "id", kAnyNumber);
        const auto found = hjif.library.find(id);
        if (found == hjif.library.end()) {
            return refuse(*effect.reading, place_of(effect, "id"),
                          "the id of an effect in the library", id);
        }
        if (const std::string fault = pay_for(*found->second, band, hjif); !fault.empty()) {
            return refuse_plainly(*effect.reading, effect.place, fault);
        }
        basis = object_at(*effect.reading, *found->second, effect.place);
    } else if (type == "Composite" || type == "Timeline") {
        return remark_once(hjif.remarks, "composite effects are left out");
    } else if (type != "Basis") {
        return refuse(*effect.reading, place_of(effect, "effect_type"),
                      "\"Basis\", \"Reference\" or \"Composite\"", type);
    }
    if (band.type == "Transient") return add_transients(basis, start_s, band, hjif);
    if (band.type == "VectorialWave") return add_wave(basis, start_s, band, hjif);
    add_curve(basis, start_s, band, hjif);
}

void read_band(JsonObject& object, double gain_g, Sketch& sketch, HjifReading& hjif) {
    constexpr std::array<const char*, 6> kBands{"Transient", "Curve",       "VectorialWave",
                                                "Wave",      "WaveletWave", "Wavelet"};
    std::string type = kBands[choice_field(object, "band_type", 2, kBands)];
    if (type == "WaveletWave" || type == "Wavelet") {
        return remark_once(hjif.remarks, "wavelet bands are left out");
    }
    if (type == "Wave") type = "VectorialWave";
    const double low = number_field(object, "lower_frequency_limit", 65.0, kHjifHz);
    const double high = number_field(object, "upper_frequency_limit", 300.0, kHjifHz);
    Band band{type, 0.5 * (low + high), gain_g, sketch};
    Json unknown;
    read_objects(object, "effects", 0, kMostVoices, unknown,
                 [&](JsonObject& effect, Json&) { read_effect(effect, band, hjif); });
}

// Voices of one course, or of one band.
using Bed = std::vector<Voice>;

// The voices of a channel by what they can be layers of; `ends` of each band's.
std::vector<Bed> beds_of(const std::vector<Voice>& voices, const std::vector<std::size_t>& ends) {
    std::vector<Bed> beds;
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        const auto at = [&](std::size_t k) {
            return voices.begin() + static_cast<std::ptrdiff_t>(k);
        };
        Bed band(at(begin), at(end));
        begin = end;
        std::erase_if(band, [](const Voice& one) {
            return !(one.start_s < one.end_s) || !(peak_value(one.amplitude) > 0.0);
        });
        if (band.empty()) continue;
        const auto alike = std::ranges::find_if(beds, [&](const Bed& bed) {
            Bed both = bed;
            both.push_back(band.front());
            return band.size() == 1 && are_carriers(both);
        });
        if (alike == beds.end()) {
            beds.push_back(std::move(band));
        } else {
            alike->push_back(band.front());
        }
    }
    return beds;
}

bool sound_at_once(const std::vector<Bed>& beds) {
    const auto meet = [](const Bed& a, const Bed& b) {
        return std::ranges::any_of(a, [&b](const Voice& one) {
            return std::ranges::any_of(b, [&one](const Voice& other) {
                return one.start_s < other.end_s && other.start_s < one.end_s;
            });
        });
    };
    for (std::size_t k = 1; k < beds.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j) {
            if (meet(beds[j], beds[k])) return true;
        }
    }
    return false;
}

// The layers of the channel, as long as the whole; the first has the transients.
Expected<std::vector<Pattern>> layers_of(const Sketch& channel, const std::vector<Bed>& beds,
                                         double duration_s, std::vector<std::string>& remarks) {
    std::vector<Pattern> layers;
    for (const Bed& bed : beds) {
        Sketch one{bed, {}, duration_s, channel.unit_g};
        if (layers.empty()) one.transients = channel.transients;
        std::vector<std::string> own;
        auto pattern = pattern_of(one, own);
        if (!pattern) return pattern.error();
        for (const std::string& remark : own) remark_once(remarks, remark);
        layers.push_back(*std::move(pattern));
    }
    return layers;
}

// Layers in the place of a pattern that vibrations of one time are merged into.
Expected<Done> add_layers(Effect& effect, const Sketch& sketch,
                          const std::vector<std::size_t>& ends, const HjifReading& hjif) {
    constexpr std::size_t kMostLayers = 4;
    constexpr std::size_t kMostBands = 64;  // whose courses are compared with each other
    if (ends.size() > kMostBands) return Done{};
    const std::vector<Bed> beds = beds_of(sketch.voices, ends);
    if (beds.size() < 2 || beds.size() > kMostLayers || !sound_at_once(beds)) return Done{};
    std::vector<std::string> remarks = hjif.remarks;
    auto layers = layers_of(sketch, beds, effect.pattern.duration_s, remarks);
    if (!layers) return Error{hjif.file.path + ": " + layers.error().message};
    remark_once(remarks, std::to_string(beds.size()) + " courses at once are layers");
    effect.layers = *std::move(layers);
    effect.remarks = std::move(remarks);
    return Done{};
}

Expected<Done> read_channel(JsonObject& channel, const std::string& name, HjifReading& hjif) {
    hjif.remarks.clear();
    if (hjif.is_other) remark_once(hjif.remarks, "\"Other\" is taken as a vibration");
    hjif.points = 0;
    Sketch sketch;
    const double gain_g = hjif.file.map.full_scale_g *
                          number_field(channel, "gain", 1.0, kHjifGain) *
                          number_field(channel, "mixing_coefficient", 1.0, kHjifGain);
    sketch.unit_g = gain_g > 0.0 ? gain_g : hjif.file.map.full_scale_g;
    Json unknown;
    std::vector<std::size_t> ends;  // of the voices of each band
    read_objects(channel, "bands", 0, 1000, unknown, [&](JsonObject& band, Json&) {
        read_band(band, gain_g, sketch, hjif);
        ends.push_back(sketch.voices.size());
    });
    if (!channel.reading->fault.empty()) return Error{channel.reading->fault};
    if (sketch.voices.empty() && sketch.transients.empty()) return Done{};
    if (!pay(hjif.file.budget.names, 1)) return Error{hjif.file.path + ": expected fewer channels"};
    auto effect = finished(hjif.file, hjif.names.unused(name), sketch, hjif.remarks);
    if (!effect) return effect.error();
    if (const auto added = add_layers(*effect, sketch, ends, hjif); !added) return added;
    hjif.effects.push_back(*std::move(effect));
    return Done{};
}

void read_library(JsonObject& perception, HjifReading& hjif) {
    hjif.library.clear();
    for (const Json* effect : array_field(perception, "effect_library", 0, kMostHjifObjects)) {
        const auto id = effect->is_object() ? effect->find("id") : effect->end();
        if (!effect->is_object() || id == effect->end() || !id->is_number()) continue;
        hjif.library.emplace(id->get<double>(), effect);
    }
}

Expected<Done> read_perception(JsonObject& perception, HjifReading& hjif) {
    const std::string modality = text_field(perception, "perception_modality", "Vibrotactile");
    // What MPEG's own tools write over vibrations.
    hjif.is_other = modality == "Other";
    if (modality != "Vibrotactile" && modality != "Vibration" && !hjif.is_other) {
        remark_once(hjif.remarks, in_quotes(modality) + " is left out: not a vibration");
        return Done{};
    }
    read_library(perception, hjif);
    const auto channels = array_field(perception, "channels", 0, kMostHjifObjects);
    for (std::size_t k = 0; k < channels.size(); ++k) {
        JsonObject channel = object_at(*perception.reading, *channels[k],
                                       place_of(perception, "channels") + "/" + std::to_string(k));
        const auto read = read_channel(channel, hjif.file.stem, hjif);
        if (!read) return read;
    }
    if (!perception.reading->fault.empty()) return Error{perception.reading->fault};
    return Done{};
}

}  // namespace

Likeness hjif_likeness(const Json& document, std::string_view) {
    return document.contains("perceptions") ? Likeness::certain : Likeness::none;
}

Expected<Effects> read_hjif(const Json& document, const EffectFile& file) {
    JsonReading reading = reading_of(file);
    JsonObject object = object_at(reading, document, "");
    HjifReading hjif{file, 1000.0, 0.0, 0, {}, {}, false, {}, {}};
    hjif.ticks_per_s = number_field(object, "timescale", 1000.0, kTimescale);
    const std::string version = text_field(object, "version", "");
    const auto perceptions = array_field(object, "perceptions", 0, kMostHjifObjects);
    for (std::size_t k = 0; k < perceptions.size(); ++k) {
        JsonObject perception =
            object_at(reading, *perceptions[k], "/perceptions/" + std::to_string(k));
        const auto read = read_perception(perception, hjif);
        if (!read) return read.error();
    }
    if (!reading.fault.empty()) return Error{reading.fault};
    if (hjif.effects.empty()) {
        return Error{file.path + ": /perceptions: expected at least one vibration, got none" +
                     (hjif.remarks.empty() ? "" : " (" + hjif.remarks.front() + ")")};
    }
    if (version != "2023" && version != "2023-1" && version != "2025") {
        for (Effect& effect : hjif.effects) {
            effect.remarks.push_back("version " + in_quotes(version) + " read as 2023");
        }
    }
    return std::move(hjif.effects);
}

}  // namespace tact
