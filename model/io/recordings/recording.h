// A recorded vibration from a file, whichever kind of file it is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/signal/waveform.h"

namespace tact {

struct Recording {
    Waveform waveform;  // at the model's rate, in g
    double scale_g = 1.0;
    std::vector<std::string> remarks;  // "resampled from 11,025 Hz to 10,000 Hz", without the file
};

struct RecordingOptions {
    std::optional<double> scale_g;       // g at full scale; in text files: g of 1
    std::optional<std::size_t> channel;  // from 0; of WAV files
};

// Samples of all channels or columns that are read. With them in three copies on the way to 10 kHz
// a reader stays below 1 GB. A minute of one channel at 500 kHz.
inline constexpr std::size_t kMaxDecodedSamples = 30'000'000;

// Whether read_recording reads files of this name: .txt and .wav, in any case.
enum class RecordingKind { none, text, wave };

// By what the file begins with, and by its ending where that tells nothing or nothing is there.
RecordingKind recording_kind(const std::filesystem::path& path);
RecordingKind recording_kind(const std::filesystem::path& path, std::string_view head);

Expected<Recording> read_recording(const std::filesystem::path& path,
                                   const RecordingOptions& options = {});

// The same of bytes that are no file of their own; `sidecar` is that of a WAV file, or empty.
Expected<Recording> parse_recording(const std::filesystem::path& path, std::string bytes,
                                    std::string sidecar, const RecordingOptions& options = {});

// The file beside a WAV file that says what its full scale is.
std::filesystem::path sidecar_of(const std::filesystem::path& path);

// The extension in lower case, with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace tact
