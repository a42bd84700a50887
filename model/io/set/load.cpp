#include "model/io/set/load.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "model/io/folders/zip_file.h"
#include "model/io/formats/ahap/ahap_pair.h"
#include "model/io/formats/read_effects.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/set_file.h"
#include "model/io/set/waveform_folder.h"
#include "model/set/layers.h"
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

// The file of a pair that nobody asked for.
void remark_on_second(const fs::path& path, std::vector<FileRemark>& remarks) {
    const auto second = second_of_pair(path.string());
    std::error_code none;
    if (!second || !fs::exists(*second, none)) return;
    remarks.push_back({path.string(), "its transients in " +
                                          valid_utf8(fs::path(*second).filename().string()) +
                                          " are not read: both files, or their folder, are one "
                                          "pattern"});
}

Expected<Loaded> load_effects(const fs::path& path, const fs::path& second,
                              const LoadOptions& options) {
    std::vector<FileRemark> remarks;
    auto effects = effects_from(path, options, remarks, second);
    if (!effects) return effects.error();
    if (second.empty()) remark_on_second(path, remarks);
    Loaded loaded;
    const bool is_pair = !second.empty() && effects->size() == 1;
    loaded.set.name = is_pair ? effects->front().name : effect_stem(path);
    loaded.set.vibrations = *std::move(effects);
    loaded.effects = true;
    loaded.remarks = joined(remarks);
    return loaded;
}

using FileOfName = std::unordered_map<std::string, std::string>;

// buzz, buzz.haptic, buzz.haptic 2 ..: the first that is free.
std::string unused_beside(const FileOfName& file_of, std::string name, const fs::path& path) {
    if (!file_of.contains(name)) return name;
    name += valid_utf8(path.extension().string());
    std::string numbered = name;
    for (int k = 2; file_of.contains(numbered); ++k) numbered = name + " " + std::to_string(k);
    return numbered;
}

// A set of ours says so in its first keys, or has its patterns there: it may be large, and is not
// read twice. `head`: that of head_of_effects.
bool may_be_effect_file(const fs::path& path, std::string_view head) {
    if (head.empty()) return false;
    const auto has = [head](const char* key) { return head.find(key) != head.npos; };
    return is_effect_name(path.string()) || !(has("\"tactspace\"") || has("\"patterns\""));
}

Expected<Loaded> load_by_kind(const fs::path& path, const fs::path& second,
                              const LoadOptions& options) {
    std::error_code none;
    if (fs::is_directory(path, none)) return read_waveform_folder(path, options);
    const auto size = readable_size(path);
    if (!size) return size.error();
    if (is_zip_file(path)) return read_waveform_folder(path, options);
    std::string begin = head_of_file(path);
    if (recording_kind(path, begin) != RecordingKind::none) return load_recording(path);
    const std::string head = head_of_effects(std::move(begin), *size);
    const bool is_set = head.find("\"tactspace\"") != std::string::npos;
    if (is_effect_name(path.string()) || may_be_effect_file(path, head)) {
        auto effects = load_effects(path, second, options);
        if (!effects || !effects->set.vibrations.empty()) return effects;
    }
    const std::string stranger = is_set ? std::string() : known_stranger(path, head);
    if (!stranger.empty()) return Error{path.string() + ": " + stranger};
    if (is_set || extension_of(path) == ".json") return read_set_file(path);
    return Error{path.string() +
                 ": expected a set (.tactspace.json), a folder or zip file of .txt, .wav or "
                 "effect files, or one such file"};
}

Expected<Loaded> load_with(const fs::path& path, const fs::path& second,
                           const LoadOptions& options) {
    return with_enough_memory(path.string(), [&] { return load_by_kind(path, second, options); });
}

template <class Value>
void append(std::vector<Value>& all, std::vector<Value>&& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

}  // namespace

Expected<Loaded> load_set(const fs::path& path, const LoadOptions& options) {
    return load_with(path, {}, options);
}

Expected<Loaded> load_set(const fs::path& path, const std::optional<ActuatorMap>& actuator) {
    return load_set(path, LoadOptions{actuator});
}

bool holds_effects(const fs::path& path) {
    if (is_effect_name(path.string())) return true;
    if (!may_be_effect_file(path, head_of_effects(path))) return false;
    const auto text = read_text_file(path, kMostEffectBytes);
    if (!text) return false;
    const auto read = read_effects(*text, path.string());
    return read && read->format != nullptr;
}

namespace {

// What is read so far, and which file each name is of.
struct Merging {
    Loaded all;
    std::string first;  // whose name, duration and model are kept; empty: nothing was read
    FileOfName file_of;
};

bool is_set_file(const fs::path& path, const Loaded& loaded) {
    return extension_of(path) == ".json" && !loaded.effects;
}

// A name of both that may not change, as the end of a sentence; or empty. Frees the others.
std::string settle_names(const Merging& merging, Loaded& more, const fs::path& path, bool partly) {
    const bool may_change = more.effects || (partly && !is_set_file(path, more));
    FileOfName known = merging.file_of;
    for (Vibration& vibration : more.set.vibrations) {
        if (may_change) vibration.name = unused_beside(known, vibration.name, path);
        const auto [other, is_new] = known.emplace(vibration.name, path.string());
        if (is_new) continue;
        return in_quotes(vibration.name) + " is a name in " + other->second +
               " too, expected names that differ";
    }
    return {};
}

// What is wrong with the two together, as the end of a sentence; or empty.
std::string merge(Merging& merging, Loaded&& more, const fs::path& path, bool partly) {
    Loaded& all = merging.all;
    if (std::string fault = settle_names(merging, more, path, partly); !fault.empty()) return fault;
    for (const Vibration& vibration : more.set.vibrations) {
        merging.file_of.emplace(vibration.name, path.string());
    }
    if (merging.first.empty()) {
        merging.first = path.string();
        more.left_out.insert(more.left_out.begin(), all.left_out.begin(), all.left_out.end());
        all = std::move(more);
        return {};
    }
    if (more.set.model != all.set.model) {
        more.remarks.push_back(path.string() + ": model parameters of " + merging.first +
                               " used instead of its own");
    }
    all.files += more.files;
    append(all.set.vibrations, std::move(more.set.vibrations));
    append(all.set.ratings, std::move(more.set.ratings));
    append(all.set.told_apart, std::move(more.set.told_apart));
    append(all.remarks, std::move(more.remarks));
    append(all.left_out, std::move(more.left_out));
    return {};
}

// Options for one file among several: its share of the whole.
LoadOptions part_of(const LoadOptions& options, std::size_t k, std::size_t count) {
    LoadOptions part = options;
    if (!options.progress) return part;
    part.progress = [&options, k, count](double share) {
        options.progress((static_cast<double>(k) + share) / static_cast<double>(count));
    };
    return part;
}

}  // namespace

Expected<Loaded> load_sets(std::span<const fs::path> paths, const LoadOptions& options) {
    if (paths.empty()) return Error{"expected at least one set, got none"};
    const std::vector<NamedFiles> files = with_pairs(paths);
    Merging merging;
    for (std::size_t k = 0; k < files.size(); ++k) {
        const auto& [path, second] = files[k];
        auto more = load_with(path, second, part_of(options, k, files.size()));
        if (options.stop.stop_requested()) return Error{kReadingCancelled};
        std::string fault = more ? std::string() : more.error().message;
        if (more) {
            fault = merge(merging, *std::move(more), path, options.partly);
            if (!fault.empty()) fault = path.string() + ": " + fault;
        }
        if (fault.empty()) continue;
        if (!options.partly) return Error{fault};
        merging.all.left_out.push_back(std::move(fault));
    }
    Loaded& all = merging.all;
    if (merging.first.empty()) {
        const std::size_t others = all.left_out.size() - 1;
        return Error{
            all.left_out.front() +
            (others == 0 ? "" : "; and " + grouped_digits(others) + " more were not read")};
    }
    if (all.set.vibrations.size() > limits::kMaxPatterns) {
        return Error{"expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " patterns in all, got " + grouped_digits(all.set.vibrations.size())};
    }
    if (const auto fault = samples_fault(recorded_samples(all.set)); !fault.empty()) {
        return Error{fault};
    }
    return std::move(all);
}

Expected<Loaded> load_sets(std::span<const fs::path> paths,
                           const std::optional<ActuatorMap>& actuator) {
    return load_sets(paths, LoadOptions{actuator});
}

std::size_t recorded_samples(const Vibration& vibration) {
    std::size_t samples = 0;
    for (const Measurement* one : recordings_in(vibration)) {
        if (one->waveform != nullptr) samples += one->waveform->samples_g.size();
    }
    return samples;
}

std::size_t recorded_samples(const PatternSet& set) {
    std::size_t samples = 0;
    for (const Vibration& vibration : set.vibrations) samples += recorded_samples(vibration);
    return samples;
}

std::string samples_fault(std::size_t samples) {
    if (samples <= kMaxSetSamples) return {};
    return "expected at most " + grouped_digits(kMaxSetSamples) +
           " samples in all recordings, got more";
}

std::string counts_text(const Loaded& loaded) {
    if (loaded.left_out.empty()) return {};
    return grouped_digits(loaded.files) + (loaded.files == 1 ? " file" : " files") + " read, " +
           grouped_digits(loaded.left_out.size()) + " not";
}

}  // namespace tact
