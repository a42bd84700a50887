// What an accelerometer recorded, as one vibration: tables and WAV files of one or three axes.
//
// Source    DFT321 for three axes (model/signal/simulated_measurement.h)
// Input     .csv and .txt tables (model/io/recordings/acceleration_table.h), .wav of one or three
//           channels
// Output    10 kHz, in g, without the constant offset; what was done to it as remarks. Errors as
//           "FILE: .." or "FILE:LINE: .."
// Valid     a rate of 100 Hz to 10 MHz, 60 s, kMaxDecodedSamples; tables of at most kMaxTableBytes,
//           WAV files of at most kMaxWaveBytes. Times that stray from even ones by 1 % of a step
//           and more are evened out by straight lines between samples
//           Where nothing names a unit, values that cannot be g are refused, and times that would
//           make a recording in either of two units. Silence is refused
// Left out  filters of the sensor, gaps in the recording, its temperature.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "model/common/expected.h"
#include "model/common/units.h"
#include "model/io/recordings/acceleration_table.h"
#include "model/io/recordings/recording.h"

namespace tact {

// What is given and not used is refused: it was given for a reason.
struct AccelerationOptions {
    std::optional<AccelerationUnit> unit;  // default: the file's, or g with a remark
    double sensitivity_v_per_g = 0.0;      // of volts, which need it; 0: not known ...
    double offset_v = 0.0;                 // ... which stand for 0 g
    std::size_t axis = 0;                  // from 1; 0: the only one, or three as one
    std::optional<double> rate_hz;         // instead of a time column; of tables
    std::optional<double> full_scale;      // of WAV files, in the unit; none: the sidecar's, or 1
    AccelerationTableOptions table;        // of tables
};

namespace limits {
inline constexpr Range kSensitivityVPerG{1e-6, 1e6};
inline constexpr Range kOffsetV{-1e6, 1e6};
}  // namespace limits

// Options of one of several files: those that only files of another kind can use are left out.
AccelerationOptions options_among(const std::filesystem::path& file,
                                  std::span<const std::filesystem::path> all,
                                  AccelerationOptions options);

Expected<Recording> read_acceleration_file(const std::filesystem::path& path,
                                           const AccelerationOptions& options = {});

// Samples in runs of three and more at the largest or least value that the signal jumps into, as
// one does that meets the limit of its sensor; a slow peak of few digits does not.
std::size_t samples_at_rail(const std::vector<double>& samples);

}  // namespace tact
