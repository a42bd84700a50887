#include "model/io/effects/actuator_file.h"

#include <array>
#include <nlohmann/json.hpp>

#include "model/io/effects/relaxed_json.h"
#include "model/pattern/pattern.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::size_t kMostActuatorBytes = 1'000'000;
constexpr Range kGain{0.0, 1.0};
constexpr Range kFullScaleG{0.001, 50.0};
constexpr Range kSensationDb{1.0, 100.0};
constexpr std::array<const char*, 2> kFrequencyLaws{"linear", "logarithmic"};
constexpr std::array<const char*, 2> kIntensityLaws{"linear", "squared"};
constexpr std::array<const char*, 4> kBurstShapes{"saw", "sine", "square", "triangle"};

void refuse_falling(JsonObject& object, const std::string& place, Range range) {
    std::string& fault = object.reading->fault;
    if (range.low <= range.high || !fault.empty()) return;
    fault = object.reading->file + ": " + place + ": expected at least the lowest frequency, " +
            shortest_digits(range.low) + " Hz, got " + shortest_digits(range.high);
}

BurstShape shape_of(JsonObject& object, BurstShape fallback) {
    return static_cast<BurstShape>(
        choice_field(object, "shape", static_cast<std::size_t>(fallback), kBurstShapes));
}

Burst acf_burst(JsonObject& emphasis, std::string_view key) {
    JsonObject fields = object_field(emphasis, key);
    constexpr Range kDurationMs{limits::kTransientS.low * 1e3, limits::kTransientS.high * 1e3};
    Burst burst;
    burst.frequency_hz =
        number_field(fields, "output_frequency", burst.frequency_hz, limits::kCarrierHz);
    burst.duration_s =
        number_field(fields, "duration_ms", burst.duration_s * 1e3, kDurationMs) / 1e3;
    burst.shape = shape_of(fields, BurstShape::saw);  // the default of its owner
    return burst;
}

ActuatorMap acf_map(JsonObject& object) {
    ActuatorMap map;
    JsonObject metadata = object_field(object, "metadata");
    map.name = name_field(metadata, "device", object.reading->file);
    map.source = "From " + object.reading->file +
                 ". 1 g at full scale is assumed: such files do not have it.";
    JsonObject continuous = object_field(object, "continuous");
    map.continuous_gain = number_field(continuous, "gain", 1.0, kGain);
    map.ducking = number_field(continuous, "emphasis_ducking", 1.0, kGain);
    map.frequency_hz.low =
        number_field(continuous, "frequency_min", map.frequency_hz.low, limits::kCarrierHz);
    map.frequency_hz.high =
        number_field(continuous, "frequency_max", map.frequency_hz.high, limits::kCarrierHz);
    refuse_falling(object, "/continuous/frequency_max", map.frequency_hz);
    JsonObject emphasis = object_field(object, "emphasis");
    map.transient_gain = number_field(emphasis, "gain", 1.0, kGain);
    map.fade_out = number_field(emphasis, "fade_out_percent", 0.0, {0.0, 100.0}) / 100.0;
    map.burst_at_0 = acf_burst(emphasis, "frequency_min");
    map.burst_at_1 = acf_burst(emphasis, "frequency_max");
    return map;
}

Burst own_burst(JsonObject& object, std::string_view key) {
    JsonObject fields = object_field(object, key);
    Burst burst;
    burst.frequency_hz =
        number_field(fields, "frequency_hz", burst.frequency_hz, limits::kCarrierHz);
    burst.duration_s = number_field(fields, "duration_s", burst.duration_s, limits::kTransientS);
    burst.shape = shape_of(fields, burst.shape);
    return burst;
}

ActuatorMap own_map(JsonObject& object) {
    ActuatorMap map;
    map.name = name_field(object, "actuator", "");
    map.source = text_field(object, "source", "From " + object.reading->file + ".");
    const auto ends = array_field(object, "frequency_hz", 2, 2);
    if (ends.size() == 2) {
        const std::string place = place_of(object, "frequency_hz");
        map.frequency_hz = {number_at(*object.reading, *ends[0], place + "/0", limits::kCarrierHz),
                            number_at(*object.reading, *ends[1], place + "/1", limits::kCarrierHz)};
        refuse_falling(object, place + "/1", map.frequency_hz);
    }
    map.frequency_law =
        static_cast<FrequencyLaw>(choice_field(object, "frequency_law", 0, kFrequencyLaws));
    map.intensity_law =
        static_cast<IntensityLaw>(choice_field(object, "intensity_law", 0, kIntensityLaws));
    map.full_scale_g = number_field(object, "full_scale_g", map.full_scale_g, kFullScaleG);
    map.continuous_gain = number_field(object, "continuous_gain", 1.0, kGain);
    map.transient_gain = number_field(object, "transient_gain", 1.0, kGain);
    map.burst_at_0 = own_burst(object, "burst_at_0");
    map.burst_at_1 = own_burst(object, "burst_at_1");
    map.fade_out = number_field(object, "fade_out", 0.0, kGain);
    map.ducking = number_field(object, "ducking", 1.0, kGain);
    map.sensation_db = number_field(object, "sensation_db", map.sensation_db, kSensationDb);
    return map;
}

Json json_of(const Burst& burst) {
    return {{"frequency_hz", burst.frequency_hz},
            {"duration_s", burst.duration_s},
            {"shape", kBurstShapes[static_cast<std::size_t>(burst.shape)]}};
}

}  // namespace

Expected<ActuatorMap> parse_actuator(std::string_view text, const std::string& file) {
    const auto document = parse_json(strict_json(without_bom(text)), file);
    if (!document) return document.error();
    JsonReading reading{file, {}};
    JsonObject object = object_at(reading, *document, "");
    if (!reading.fault.empty()) return Error{reading.fault};
    const bool is_own = document->contains("actuator");
    const bool is_acf = document->contains("continuous") && document->contains("emphasis");
    if (!is_own && !is_acf) {
        return Error{file +
                     ": expected an actuator map, with the key \"actuator\", or with "
                     "\"continuous\" and \"emphasis\" as in an .acf"};
    }
    ActuatorMap map = is_own ? own_map(object) : acf_map(object);
    if (!reading.fault.empty()) return Error{reading.fault};
    return map;
}

Expected<ActuatorMap> read_actuator_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path, kMostActuatorBytes);
    if (!text) return text.error();
    return parse_actuator(*text, path.string());
}

std::string print_actuator(const ActuatorMap& map) {
    const Json fields = {
        {"actuator", map.name},
        {"source", map.source},
        {"frequency_hz", {map.frequency_hz.low, map.frequency_hz.high}},
        {"frequency_law", kFrequencyLaws[static_cast<std::size_t>(map.frequency_law)]},
        {"intensity_law", kIntensityLaws[static_cast<std::size_t>(map.intensity_law)]},
        {"full_scale_g", map.full_scale_g},
        {"continuous_gain", map.continuous_gain},
        {"transient_gain", map.transient_gain},
        {"burst_at_0", json_of(map.burst_at_0)},
        {"burst_at_1", json_of(map.burst_at_1)},
        {"fade_out", map.fade_out},
        {"ducking", map.ducking},
        {"sensation_db", map.sensation_db}};
    return text_of_json(fields, 2) + "\n";
}

}  // namespace tact
