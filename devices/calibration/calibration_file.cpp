#include "devices/calibration/calibration_file.h"

#include <nlohmann/json.hpp>

#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

constexpr Range kFrequencyHz{1.0, 5000.0};
constexpr Range kResponseG{1e-6, 1e4};
constexpr Range kShare{0.0, 1.0};
constexpr Range kFactor{0.0, 1e3};
constexpr std::size_t kMostPoints = 10'000;

ResponsePoint point_of(JsonObject object) {
    ResponsePoint point;
    for (const char* needed : {"frequency_hz", "g_per_full_scale"}) {
        if (field(object, needed) == nullptr) {
            refuse(*object.reading, place_of(object, needed), "a number", nullptr);
        }
    }
    point.frequency_hz = number_field(object, "frequency_hz", 1.0, kFrequencyHz);
    point.g_per_full_scale = number_field(object, "g_per_full_scale", 1.0, kResponseG);
    point.largest_drive = number_field(object, "largest_drive", point.largest_drive, kShare);
    if (point.largest_drive <= 0.0) {
        refuse(*object.reading, place_of(object, "largest_drive"), "a number above 0",
               point.largest_drive);
    }
    point.thd = number_field(object, "thd", point.thd, kFactor);
    point.nonlinearity = number_field(object, "nonlinearity", point.nonlinearity, kFactor);
    point.between = yes_no_field(object, "between", false);
    point.unknown = yes_no_field(object, "unknown", false);
    (void)unknown_fields(object);
    return point;
}

std::vector<ResponsePoint> points_of(JsonObject& object) {
    JsonReading& reading = *object.reading;
    std::vector<ResponsePoint> points;
    const std::string place = place_of(object, "points");
    const auto elements = array_field(object, "points", 1, kMostPoints);
    if (elements.empty()) refuse(reading, place, "the measured points", nullptr);
    for (const Json* element : elements) {
        const std::string at = place + "/" + std::to_string(points.size());
        points.push_back(point_of(object_at(reading, *element, at)));
        const std::size_t last = points.size() - 1;
        if (last == 0 || points[last].frequency_hz > points[last - 1].frequency_hz) continue;
        refuse(reading, at + "/frequency_hz", "a higher frequency than the point before",
               points[last].frequency_hz);
    }
    return points;
}

}  // namespace

Expected<Calibration> parse_calibration(std::string_view text, const std::string& file) {
    const Expected<Json> json = parse_json(text, file);
    if (!json) return json.error();
    JsonReading reading{file, {}, UnknownKeys::refused};
    JsonObject object = object_at(reading, *json, "");
    if (field(object, "tactspace_calibration") == nullptr) {
        return Error{file + ": expected a calibration, with \"tactspace_calibration\": 1"};
    }
    (void)whole_field(object, "tactspace_calibration", 1, {1.0, 1.0});
    Calibration calibration;
    calibration.device = name_field(object, "device", "");
    calibration.channel = whole_field(object, "channel", 1, {1.0, 256.0});
    calibration.actuator = name_field(object, "actuator", "");
    calibration.mounting = name_field(object, "mounting", "");
    calibration.gain_note = name_field(object, "gain_note", "");
    calibration.sensor = name_field(object, "sensor", "");
    calibration.date = name_field(object, "date", "");
    calibration.load_mass_g = number_field(object, "load_mass_g", 0.0, {0.0, 1e5});
    calibration.excursion_limit_mm = number_field(object, "excursion_limit_mm", 0.0, {0.0, 100.0});
    calibration.rms_limit = number_field(object, "rms_limit", 0.0, kShare);
    calibration.points = points_of(object);
    (void)unknown_fields(object);
    if (!reading.fault.empty()) return Error{reading.fault};
    return calibration;
}

Expected<Calibration> read_calibration(const std::filesystem::path& path) {
    const Expected<std::string> text = read_text_file(path);
    if (!text) return text.error();
    return parse_calibration(*text, path.string());
}

std::string print_calibration(const Calibration& calibration) {
    Json json{{"tactspace_calibration", 1},
              {"device", calibration.device},
              {"channel", calibration.channel},
              {"actuator", calibration.actuator},
              {"mounting", calibration.mounting},
              {"gain_note", calibration.gain_note},
              {"sensor", calibration.sensor},
              {"date", calibration.date},
              {"load_mass_g", calibration.load_mass_g},
              {"excursion_limit_mm", calibration.excursion_limit_mm},
              {"rms_limit", calibration.rms_limit},
              {"points", Json::array()}};
    for (const ResponsePoint& point : calibration.points) {
        json["points"].push_back({{"frequency_hz", point.frequency_hz},
                                  {"g_per_full_scale", point.g_per_full_scale},
                                  {"largest_drive", point.largest_drive},
                                  {"thd", point.thd},
                                  {"nonlinearity", point.nonlinearity}});
        if (point.between) json["points"].back()["between"] = true;
        if (point.unknown) json["points"].back()["unknown"] = true;
    }
    return text_of_json(json, 2) + "\n";
}

Expected<Done> write_calibration(const std::filesystem::path& path,
                                 const Calibration& calibration) {
    return write_atomically(path, print_calibration(calibration));
}

}  // namespace tact
