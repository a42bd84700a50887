#include "model/io/recordings/recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/signal/waveform.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Expected<Recording> scaled(Expected<Waveform> waveform, const fs::path& path, double scale_g) {
    if (!waveform) return waveform.error();
    for (double& sample : waveform->samples_g) sample *= scale_g;
    if (!(peak_g(*waveform) <= kMaxSampleG)) {
        return Error{path.string() +
                     ": with the scale of the set, accelerations exceed 1,000,000 g"};
    }
    return Recording{*std::move(waveform), scale_g, {}};
}

Expected<Recording> told_by_content(Expected<Recording> recording, const fs::path& path) {
    if (recording && extension_of(path) != ".wav") {
        recording->remarks.emplace_back("is a WAV file by its content, whatever its ending");
    }
    return recording;
}

Error unknown_kind(const fs::path& path) {
    return Error{path.string() + ": expected a .txt or .wav file"};
}

}  // namespace

fs::path sidecar_of(const fs::path& path) { return fs::path(path) += ".json"; }

std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

RecordingKind recording_kind(const fs::path& path) {
    return recording_kind(path, head_of_file(path));
}

RecordingKind recording_kind(const fs::path& path, std::string_view head) {
    const std::string_view form = head.substr(0, 4);
    const bool is_wave = form == "RIFF" || form == "RIFX" || form == "RF64" || form == "BW64";
    if (is_wave && head.substr(std::min<std::size_t>(8, head.size()), 4) == "WAVE")
        return RecordingKind::wave;
    const std::string decoded = utf8_of_utf16(head).value_or(std::string(head));
    const std::string_view text = trimmed(without_bom(decoded));
    if (text.starts_with('{') || text.starts_with('<')) return RecordingKind::none;
    const std::string extension = extension_of(path);
    if (extension == ".txt") return RecordingKind::text;
    return extension == ".wav" ? RecordingKind::wave : RecordingKind::none;
}

Expected<Recording> read_recording(const fs::path& path, const RecordingOptions& options) {
    switch (recording_kind(path)) {
        case RecordingKind::text:
            return scaled(read_text_waveform(path), path, options.scale_g.value_or(1.0));
        case RecordingKind::wave:
            return told_by_content(read_wave_file(path, options), path);
        case RecordingKind::none:
            break;
    }
    return unknown_kind(path);
}

Expected<Recording> parse_recording(const fs::path& path, std::string bytes, std::string sidecar,
                                    const RecordingOptions& options) {
    switch (recording_kind(path, bytes)) {
        case RecordingKind::text:
            return scaled(parse_text_waveform(bytes, path.string()), path,
                          options.scale_g.value_or(1.0));
        case RecordingKind::wave:
            return told_by_content(
                parse_wave({std::move(bytes), std::move(sidecar)}, path.string(), options), path);
        case RecordingKind::none:
            break;
    }
    return unknown_kind(path);
}

}  // namespace tact
