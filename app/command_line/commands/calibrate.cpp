// tactspace calibrate: the signal that an actuator is measured with, and the table that a recording
// of it gives.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "devices/calibration/calibration_file.h"
#include "devices/calibration/calibration_run.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/wave_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::string table_of(const CalibrationResult& result) {
    std::vector<TextRow> rows{
        {"Hz", "g per full scale", "up to", "distortion", "nonlinearity", ""}};
    for (const ResponsePoint& point : result.points) {
        rows.push_back(
            {fixed_digits(point.frequency_hz, 1), significant_digits(point.g_per_full_scale, 3),
             fixed_digits(point.largest_drive, 2), fixed_digits(100.0 * point.thd, 1) + " %",
             fixed_digits(100.0 * point.nonlinearity, 1) + " %",
             point.unknown   ? "not known"
             : point.between ? "worked out"
                             : "measured"});
    }
    return aligned(rows);
}

std::string json_of(const CalibrationResult& result) {
    nlohmann::json json{{"begins_s", result.begins_s},
                        {"remarks", result.remarks},
                        {"points", nlohmann::json::array()},
                        {"tones", nlohmann::json::array()}};
    for (const ResponsePoint& point : result.points) {
        json["points"].push_back({{"frequency_hz", point.frequency_hz},
                                  {"g_per_full_scale", point.g_per_full_scale},
                                  {"largest_drive", point.largest_drive},
                                  {"thd", point.thd},
                                  {"nonlinearity", point.nonlinearity},
                                  {"between", point.between},
                                  {"unknown", point.unknown}});
    }
    for (const MeasuredTone& one : result.tones) {
        json["tones"].push_back({{"frequency_hz", one.tone.frequency_hz},
                                 {"level", one.tone.level},
                                 {"amplitude_g", one.amplitude_g},
                                 {"thd", one.thd},
                                 {"snr_db", one.snr_db},
                                 {"standard_error", one.standard_error},
                                 {"accepted", one.accepted}});
    }
    return text_of_json(json) + "\n";
}

Expected<Done> write_signal(const CalibrateCommand& command, const CalibrationPlan& plan) {
    const Waveform signal{plan.drive.rate_hz, plan.drive.samples};
    if (auto written = write_wave_file(command.signal, signal); !written) return written;
    std::cerr << "tactspace: wrote " << command.signal.string() << ", "
              << fixed_digits(duration_s(signal), 1)
              << " s: play it with --full-scale 1 --level 1 --no-protection while the sensor "
                 "records, then give the "
                 "recording to --recording with the same options\n";
    return Done{};
}

}  // namespace

Expected<Done> run(const CalibrateCommand& command) {
    CalibrationParams params;
    params.is_sweep = command.sweep;
    params.low_hz = command.low_hz;
    params.high_hz = command.high_hz;
    if (params.high_hz < params.low_hz) {
        return Error{"--high: expected " + significant_digits(params.low_hz, 3) +
                     " Hz or more, as --low is"};
    }
    if (!command.signal.empty()) return write_signal(command, calibration_plan(params));

    const Expected<Recording> recording = read_acceleration_file(command.recording, command.how);
    if (!recording) return recording.error();
    for (const std::string& remark : recording->remarks) {
        std::cerr << "tactspace: " << command.recording.string() << ": " << remark << "\n";
    }
    const Expected<CalibrationResult> result = calibration_from(params, recording->waveform);
    if (!result) return Error{command.recording.string() + ": " + result.error().message};
    Calibration calibration = command.about;
    calibration.points = result->points;
    if (!command.out.empty()) {
        if (auto written = write_calibration(command.out, calibration); !written) return written;
    }
    for (const std::string& remark : result->remarks) {
        std::cerr << "tactspace: " << remark << "\n";
    }
    std::cout << (command.json ? json_of(*result) : table_of(*result));
    return Done{};
}

}  // namespace tact
