// Recordings as WAV files.
//
// A sidecar, `<file>.json`, says what its full scale is and which channel counts (from 1):
//     {"scale_g": 2.0, "channel": 1}
//
// Source    libsndfile; RIFF, RIFX and RF64 with any encoding that it knows
// Input     any rate of 100 Hz to 10 MHz, any number of channels
// Output    10 kHz, in g; errors as "FILE: .."
// Valid     1 frame to 60 s; a file shorter than its header says is refused
// Left out  calibration, cue points, writing of more than one channel.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "model/common/expected.h"
#include "model/io/recordings/recording.h"
#include "model/signal/waveform.h"

namespace tact {

// The scale is that of the options, else of the sidecar, else 1 g with a remark; so is the channel.
Expected<Recording> read_wave_file(const std::filesystem::path& path,
                                   const RecordingOptions& options = {});

// All channels as they are in the file: at its rate, 1 being full scale.
struct WaveChannels {
    double rate_hz = kModelRateHz;
    std::vector<std::vector<double>> channels;
    std::optional<double> scale_g;  // that the sidecar says
};
Expected<WaveChannels> read_wave_channels(const std::filesystem::path& path);

enum class WaveEncoding { float32, int16, int24 };

struct WaveOptions {
    WaveEncoding encoding = WaveEncoding::float32;
    double scale_g = 1.0;  // g at full scale; other than 1, a sidecar says so
};

// One channel at the waveform's own rate, a whole number of Hz. With whole-number encodings a peak
// beyond full scale is an Error, as it would be cut off.
Expected<Done> write_wave_file(const std::filesystem::path& path, const Waveform& waveform,
                               const WaveOptions& options = {});

}  // namespace tact
