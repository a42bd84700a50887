#include "model/io/effects/actuator_file.h"

#include "model/io/effects/relaxed_json.h"
#include "model/text/atomic_file.h"
#include "model/text/described_json.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::size_t kMostActuatorBytes = 1'000'000;

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
    map.continuous_gain = number_field(continuous, "gain", 1.0, numbers::kContinuousGain.range);
    map.ducking = number_field(continuous, "emphasis_ducking", 1.0, numbers::kDucking.range);
    map.frequency_hz.low =
        number_field(continuous, "frequency_min", map.frequency_hz.low, limits::kCarrierHz);
    map.frequency_hz.high =
        number_field(continuous, "frequency_max", map.frequency_hz.high, limits::kCarrierHz);
    refuse_falling(object, "/continuous/frequency_max", map.frequency_hz);
    JsonObject emphasis = object_field(object, "emphasis");
    map.transient_gain = number_field(emphasis, "gain", 1.0, numbers::kContinuousGain.range);
    map.fade_out = number_field(emphasis, "fade_out_percent", 0.0, {0.0, 100.0}) / 100.0;
    map.burst_at_0 = acf_burst(emphasis, "frequency_min");
    map.burst_at_1 = acf_burst(emphasis, "frequency_max");
    return map;
}

ActuatorMap own_map(JsonObject& object) {
    ActuatorMap map;
    map.source = "From " + object.reading->file + ".";
    Json unknown = Json::object();
    take_fields(object, map, unknown);
    refuse_falling(object, "/frequency_hz/1", map.frequency_hz);
    return map;
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
    Json fields = Json::object();
    put_fields<ActuatorMap>(fields, map, nullptr);
    return text_of_json(fields, 2) + "\n";
}

}  // namespace tact
