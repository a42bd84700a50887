#include "model/io/recordings/recording.h"

#include <algorithm>
#include <cmath>

#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/signal/waveform.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Expected<Recording> read_text_recording(const fs::path& path, double scale_g) {
    auto waveform = read_text_waveform(path);
    if (!waveform) return waveform.error();
    for (double& sample : waveform->samples_g) sample *= scale_g;
    if (!(peak_g(*waveform) <= kMaxSampleG)) {
        return Error{path.string() +
                     ": with the scale of the set, accelerations exceed 1,000,000 g"};
    }
    return Recording{*std::move(waveform), scale_g, {}};
}

}  // namespace

std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

bool is_recording(const fs::path& path) {
    const std::string extension = extension_of(path);
    return extension == ".txt" || extension == ".wav";
}

Expected<Recording> read_recording(const fs::path& path, const RecordingOptions& options) {
    const std::string extension = extension_of(path);
    if (extension == ".txt") return read_text_recording(path, options.scale_g.value_or(1.0));
    if (extension == ".wav") return read_wave_file(path, options);
    return Error{path.string() + ": expected a .txt or .wav file"};
}

}  // namespace tact
