#include "model/io/recordings/recording.h"

#include <algorithm>
#include <cmath>

#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/signal/waveform.h"
#include "model/text/atomic_file.h"
#include "model/text/utf8.h"

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

RecordingKind recording_kind(const fs::path& path) {
    const std::string head = head_of_file(path);
    const std::string_view form = std::string_view(head).substr(0, 4);
    const bool is_wave = form == "RIFF" || form == "RIFX" || form == "RF64" || form == "BW64";
    if (is_wave && head.substr(std::min<std::size_t>(8, head.size()), 4) == "WAVE")
        return RecordingKind::wave;
    const std::string decoded = utf8_of_utf16(head).value_or(head);
    const std::string_view text = trimmed(without_bom(decoded));
    if (text.starts_with('{') || text.starts_with('<')) return RecordingKind::none;
    const std::string extension = extension_of(path);
    if (extension == ".txt") return RecordingKind::text;
    return extension == ".wav" ? RecordingKind::wave : RecordingKind::none;
}

bool is_recording(const fs::path& path) { return recording_kind(path) != RecordingKind::none; }

Expected<Recording> read_recording(const fs::path& path, const RecordingOptions& options) {
    switch (recording_kind(path)) {
        case RecordingKind::text:
            return read_text_recording(path, options.scale_g.value_or(1.0));
        case RecordingKind::wave:
            break;
        case RecordingKind::none:
            return Error{path.string() + ": expected a .txt or .wav file"};
    }
    auto recording = read_wave_file(path, options);
    if (recording && extension_of(path) != ".wav") {
        recording->remarks.emplace_back("is a WAV file by its content, whatever its ending");
    }
    return recording;
}

}  // namespace tact
