// Recordings as WAV files.
//
// A sidecar, `<file>.json`, says what its full scale is and which channel counts (from 1):
//     {"scale_g": 2.0, "channel": 1, "of": "0123456789abcdef"}
// Where "of" is there and not the fingerprint of the file, a remark says so.
//
// Source    libsndfile; RIFF, RIFX and RF64 with any encoding that it knows
// Input     any rate of 100 Hz to 10 MHz, any number of channels
// Output    10 kHz, in g; errors as "FILE: .."
// Valid     1 frame to 60 s; at most kMaxWaveBytes, and kMaxDecodedSamples of the channels that are
//           read; a file shorter than its header says is refused. The whole file is decoded once,
//           however many channels it has.
// Left out  calibration, cue points, writing of more than one channel.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/recordings/recording.h"
#include "model/signal/waveform.h"

namespace tact {

// A WAV file and its sidecar, in memory.
struct WaveText {
    std::string bytes;
    std::string sidecar;  // empty: none
};

// The options decide the scale, then the sidecar; default: 1 g with a remark. So for the channel.
Expected<Recording> read_wave_file(const std::filesystem::path& path,
                                   const RecordingOptions& options = {});

// The same of texts; `name` for messages.
Expected<Recording> parse_wave(WaveText text, const std::string& name,
                               const RecordingOptions& options = {});

inline constexpr std::size_t kMaxWaveBytes = std::size_t{1} << 28;

// Channels as they are in the file: at its rate, 1 being full scale.
struct WaveChannels {
    double rate_hz = kModelRateHz;
    std::vector<std::vector<double>> channels;
    std::optional<double> scale_g;  // that the sidecar says
    std::string remark;             // on that, or empty
};

// What reads the channels decides by their number: a sentence without its end stop that says why
// not, or empty. `only`: one channel, from 1; 0: all.
using ChannelFault = std::function<std::string(std::size_t channels)>;
Expected<WaveChannels> read_wave_channels(const std::filesystem::path& path, std::size_t only = 0,
                                          const ChannelFault& fault_of = {});

enum class WaveEncoding { float32, int16, int24 };

struct WaveOptions {
    WaveEncoding encoding = WaveEncoding::float32;
    double scale_g = 1.0;  // g at full scale; other than 1, a sidecar says so
};

// One channel at the waveform's own rate, a whole number of Hz. With whole-number encodings a peak
// beyond full scale is an Error, as it would be cut off; so is what could not be read again: a peak
// above 1,000,000 g, or NaN.
Expected<Done> write_wave_file(const std::filesystem::path& path, const Waveform& waveform,
                               const WaveOptions& options = {});

// The same, with a sidecar in any case, as texts; `name` for messages.
Expected<WaveText> wave_text(const Waveform& waveform, const WaveOptions& options,
                             const std::string& name);

// Whether a WAV file is as long as its header says. libsndfile reads a truncated one without a
// word.
//
// Source    RIFF (Microsoft & IBM 1991), RF64 (EBU Tech 3306), BW64 (ITU-R BS.2088), sizes as sox
// leaves them

// Empty if all of the data chunk is there; otherwise the end of a sentence ("has 10 of the 400
// bytes of samples that its header promises"). Sizes that a stream's writer left open are accepted.
std::string wave_size_fault(std::istream& stream, std::uint64_t file_bytes);

}  // namespace tact
