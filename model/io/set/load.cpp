#include "model/io/set/load.h"

#include <algorithm>
#include <unordered_map>

#include "model/io/recordings/recording.h"
#include "model/io/set/set_file.h"
#include "model/io/set/waveform_folder.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Expected<Loaded> load_recording(const fs::path& path) {
    std::vector<FileRemark> remarks;
    auto vibration = vibration_from(path, remarks);
    if (!vibration) return vibration.error();
    Loaded loaded;
    loaded.set.name = vibration->name;
    loaded.set.vibrations.push_back(*std::move(vibration));
    loaded.remarks = joined(remarks);
    return loaded;
}

Expected<Loaded> load_by_kind(const fs::path& path) {
    std::error_code none;
    if (fs::is_directory(path, none)) return read_waveform_folder(path);
    if (const auto size = readable_size(path); !size) return size.error();
    if (is_recording(path)) return load_recording(path);
    if (extension_of(path) == ".json") return read_set_file(path);
    return Error{path.string() +
                 ": expected a set (.tactspace.json), a folder of .txt or .wav files, or one such "
                 "file"};
}

template <class Value>
void append(std::vector<Value>& all, std::vector<Value>&& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

}  // namespace

Expected<Loaded> load_set(const fs::path& path) {
    return with_enough_memory(path.string(), [&path] { return load_by_kind(path); });
}

Expected<Loaded> load_sets(std::span<const fs::path> paths) {
    if (paths.empty()) return Error{"expected at least one set, got none"};
    auto all = load_set(paths.front());
    if (!all) return all;
    std::unordered_map<std::string, std::string> file_of;
    for (const Vibration& vibration : all->set.vibrations) {
        file_of.emplace(vibration.name, paths.front().string());
    }
    for (const fs::path& path : paths.subspan(1)) {
        auto more = load_set(path);
        if (!more) return more;
        for (const Vibration& vibration : more->set.vibrations) {
            const auto [other, is_new] = file_of.emplace(vibration.name, path.string());
            if (is_new) continue;
            return Error{path.string() + ": " + in_quotes(vibration.name) + " is a name in " +
                         other->second + " too, expected names that differ"};
        }
        if (more->set.model != all->set.model) {
            more->remarks.push_back(path.string() + ": model parameters of " +
                                    paths.front().string() + " used instead of its own");
        }
        append(all->set.vibrations, std::move(more->set.vibrations));
        append(all->set.ratings, std::move(more->set.ratings));
        append(all->remarks, std::move(more->remarks));
    }
    if (all->set.vibrations.size() > limits::kMaxPatterns) {
        return Error{"expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " patterns in all, got " + grouped_digits(all->set.vibrations.size())};
    }
    if (const auto fault = samples_fault(recorded_samples(all->set)); !fault.empty()) {
        return Error{fault};
    }
    return all;
}

}  // namespace tact
