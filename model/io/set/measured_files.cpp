#include "model/io/set/measured_files.h"

#include "model/io/recordings/recording.h"
#include "model/io/recordings/wave_file.h"
#include "model/set/layers.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

bool holds(const fs::path& file, const Waveform& waveform) {
    const auto recording = read_recording(file, {1.0, 0});
    return recording && recording->waveform == waveform;
}

bool lies_in(const fs::path& folder, const std::string& path) {
    if (path.empty()) return true;
    return !folder.empty() && fs::path(path).parent_path() == folder;
}

}  // namespace

Expected<fs::path> store_waveform(const Waveform& waveform, const std::string& name,
                                  const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) return Error{folder.string() + ": cannot be made: " + fault.message()};
    const fs::path whole = fs::weakly_canonical(fs::absolute(folder, fault), fault);
    const std::string stem = file_stem(name);
    for (int number = 1;; ++number) {
        const std::string end = number == 1 ? "" : " " + std::to_string(number);
        const fs::path file = whole / (stem + end + ".wav");
        std::error_code none;
        if (fs::exists(file, none) || fs::exists(fs::path(file) += ".json", none)) {
            if (holds(file, waveform)) return file;
            continue;
        }
        const Expected<Done> written = write_wave_file(file, waveform);
        if (!written) return written.error();
        return file;
    }
}

Expected<Done> store_measurements(PatternSet& set, const fs::path& set_file,
                                  const fs::path& kept_in) {
    PatternSet stored = set;
    std::error_code none;
    const fs::path until_now = fs::weakly_canonical(kept_in, none);
    const fs::path folder = fs::absolute(set_file).parent_path() / "measured";
    remove_abandoned_files(folder);
    for (Vibration& vibration : stored.vibrations) {
        for (Measurement* measurement : recordings_in(vibration)) {
            if (!lies_in(until_now, measurement->path)) continue;
            const auto file = store_waveform(*measurement->waveform, vibration.name, folder);
            if (!file) return file.error();
            measurement->path = file->string();
            measurement->scale_g = 1.0;
        }
    }
    set = std::move(stored);
    return Done{};
}

}  // namespace tact
