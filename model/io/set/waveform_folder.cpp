#include "model/io/set/waveform_folder.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "model/io/effects/ahap_pair.h"
#include "model/io/effects/read_effects.h"
#include "model/text/atomic_file.h"
#include "model/text/natural_order.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

using Kinds = std::initializer_list<std::string_view>;

struct Listing {
    std::vector<fs::path> files;  // in natural order of their stems: recordings, and what may be
                                  // effects where those are asked for
    std::size_t others = 0;       // neither, nor sidecars of recordings, nor hidden
};

bool is_sidecar(const fs::path& path) {
    return extension_of(path) == ".json" && extension_of(path.stem()) == ".wav";
}

bool is_of(const fs::path& path, Kinds kinds) {
    return std::ranges::count(kinds, extension_of(path)) > 0;
}

// Whether to look inside: any name will do, but a set of ours is no effect.
bool may_hold_effects(const fs::path& path) {
    const bool is_set = path.filename().string().ends_with(".tactspace.json");
    return !is_set && !head_of_effects(path).empty();
}

Expected<Listing> listed(const fs::path& folder, Kinds kinds, bool effects) {
    Listing listing;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path& path = entry->path();
        std::error_code none;
        if (path.filename().string().starts_with('.')) continue;
        const bool wanted = !entry->is_directory(none) && is_of(path, kinds);
        if (wanted || (effects && !is_sidecar(path) && may_hold_effects(path))) {
            listing.files.push_back(path);
        } else if (!is_sidecar(path)) {
            ++listing.others;
        }
    }
    if (fault) return Error{folder.string() + ": cannot be read: " + fault.message()};
    std::ranges::sort(listing.files, [](const fs::path& a, const fs::path& b) {
        const std::string stem_a = a.stem().string();
        const std::string stem_b = b.stem().string();
        return stem_a == stem_b ? a < b : naturally_before(stem_a, stem_b);
    });
    return listing;
}

std::string kinds_text(Kinds kinds) {
    std::string text;
    for (const std::string_view kind : kinds)
        text += (text.empty() ? "" : " or ") + std::string(kind);
    return text;
}

// A remark on waveforms of several lengths, or empty.
std::string lengths_remark(const PatternSet& set) {
    std::size_t shortest = std::numeric_limits<std::size_t>::max();
    std::size_t longest = 0;
    for (const Vibration& vibration : set.vibrations) {
        if (std::holds_alternative<Pattern>(vibration.source)) continue;
        const std::size_t samples = recorded_samples(vibration);
        shortest = std::min(shortest, samples);
        longest = std::max(longest, samples);
    }
    if (shortest >= longest) return {};
    return "lengths of " + grouped_digits(shortest) + " to " + grouped_digits(longest) +
           " samples, the shorter ones are padded with zeros";
}

// What comes of the files of a folder, one by one.
struct Gathered {
    PatternSet set;
    std::vector<FileRemark> remarks;
    std::vector<fs::path> recordings;
    std::vector<std::string> names;  // of the recordings
    UnusedNames taken;               // of all
    std::size_t samples = 0;
    std::size_t others = 0;
};

Expected<Done> gather_recording(Gathered& all, const fs::path& file) {
    auto vibration = vibration_from(file, all.remarks);
    if (!vibration) return vibration.error();
    all.samples += recorded_samples(*vibration);
    if (const auto fault = samples_fault(all.samples); !fault.empty()) {
        return Error{file.string() + ": " + fault};
    }
    all.recordings.push_back(file);
    all.names.push_back(vibration->name);
    all.set.vibrations.push_back(*std::move(vibration));
    return Done{};
}

// A file that only its content could have made one of ours is left aside where it is faulty.
Expected<Done> gather_effects(Gathered& all, const fs::path& file, const fs::path& second,
                              const std::optional<ActuatorMap>& actuator) {
    auto effects = effects_from(file, actuator, all.remarks, second);
    if (!effects) {
        if (is_effect_name(file.string())) return effects.error();
        all.remarks.push_back({effects.error().message, "ignored"});
        return Done{};
    }
    if (effects->empty()) ++all.others;
    for (Vibration& effect : *effects) {
        const bool is_taken = all.taken.taken.contains(effect.name);
        if (is_taken) effect.name += valid_utf8(file.extension().string());
        effect.name = all.taken.unused(effect.name);
        all.set.vibrations.push_back(std::move(effect));
    }
    return Done{};
}

Expected<Loaded> read_folder(const fs::path& folder, Kinds kinds, bool effects,
                             const std::optional<ActuatorMap>& actuator) {
    const std::string name = folder.string();
    const auto listing = listed(folder, kinds, effects);
    if (!listing) return listing.error();
    if (listing->files.size() > limits::kMaxPatterns) {
        return Error{name + ": expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " files, got " + grouped_digits(listing->files.size())};
    }
    Gathered all;
    all.others = listing->others;
    std::error_code none;
    all.set.name = valid_utf8(fs::weakly_canonical(folder, none).filename().string());
    // Recordings come first to their names: two that are equal are refused below.
    for (const fs::path& file : listing->files) {
        if (is_of(file, kinds)) all.taken.taken.insert(valid_utf8(file.stem().string()));
    }
    for (const auto& [file, second] : with_pairs(listing->files)) {
        const auto read = is_of(file, kinds) ? gather_recording(all, file)
                                             : gather_effects(all, file, second, actuator);
        if (!read) return read.error();
    }
    if (all.set.vibrations.empty()) {
        return Error{name + ": expected at least one " + kinds_text(kinds) +
                     (effects ? " or effect" : "") + " file in this folder, got none"};
    }
    if (const auto equal = first_equal(all.names)) {
        return Error{name + ": " + all.recordings[equal->first].filename().string() + " and " +
                     all.recordings[equal->second].filename().string() + " both give the name " +
                     in_quotes(all.names[equal->second]) + ", expected names that differ"};
    }
    if (all.set.vibrations.size() > limits::kMaxPatterns) {
        return Error{name + ": expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " vibrations, got " + grouped_digits(all.set.vibrations.size())};
    }
    Loaded loaded{std::move(all.set), joined(all.remarks)};
    if (const auto remark = lengths_remark(loaded.set); !remark.empty()) {
        loaded.remarks.push_back(name + ": " + remark);
    }
    if (all.others > 0) {
        loaded.remarks.push_back(name + ": " + grouped_digits(all.others) +
                                 (all.others == 1 ? " other file" : " other files") + " ignored");
    }
    return loaded;
}

Expected<EffectsRead> read_effects_file(const fs::path& path,
                                        const std::optional<ActuatorMap>& actuator) {
    const auto text = read_text_file(path, kMostEffectBytes);
    if (!text) return text.error();
    return read_effects(*text, path.string(), actuator);
}

// `files`: what the note calls it.
void add_effects(std::vector<Vibration>& vibrations, const EffectsRead& read, const fs::path& path,
                 const std::string& files, std::vector<FileRemark>& remarks) {
    for (const Effect& effect : read.effects) {
        Vibration vibration;
        vibration.name = effect.name;
        vibration.source = effect.pattern;
        vibration.note = origin_of(read, effect, files);
        vibration.effect = {traits(read.format).key, read.map.name};
        vibrations.push_back(std::move(vibration));
        for (const std::string& remark : effect.remarks) {
            const FileRemark one{path.string(), remark};
            if (std::ranges::find(remarks, one) == remarks.end()) remarks.push_back(one);
        }
    }
    if (read.effects.empty()) return;
    remarks.push_back(
        {path.string(), "actuator map " + read.map.name + " (" + read.map.source + ")"});
}

}  // namespace

Expected<Loaded> read_waveform_folder(const fs::path& folder,
                                      const std::optional<ActuatorMap>& actuator) {
    return read_folder(folder, {".txt", ".wav"}, true, actuator);
}

Expected<Loaded> read_text_folder(const fs::path& folder) {
    return read_folder(folder, {".txt"}, false, {});
}

Expected<Vibration> vibration_from(const fs::path& path, std::vector<FileRemark>& remarks) {
    auto recording = read_recording(path);
    if (!recording) return recording.error();
    for (const std::string& remark : recording->remarks) {
        remarks.push_back({path.string(), remark});
    }
    Vibration vibration;
    vibration.name = valid_utf8(path.stem().string());
    std::error_code none;
    Measurement measurement;
    measurement.path =
        (fs::weakly_canonical(fs::absolute(path, none).parent_path(), none) / path.filename())
            .string();
    measurement.scale_g = recording->scale_g;
    measurement.waveform = std::make_shared<const Waveform>(std::move(recording->waveform));
    vibration.source = std::move(measurement);
    return vibration;
}

std::vector<NamedFiles> with_pairs(std::span<const fs::path> files) {
    std::map<fs::path, std::size_t> place;  // a folder may have thousands
    for (std::size_t k = 0; k < files.size(); ++k) place.emplace(files[k], k);
    std::vector<fs::path> second_of(files.size());
    std::vector<bool> is_second(files.size());
    for (std::size_t k = 0; k < files.size(); ++k) {
        const auto second = second_of_pair(files[k].string());
        const auto found = second ? place.find(*second) : place.end();
        if (found == place.end()) continue;
        second_of[k] = files[found->second];
        is_second[found->second] = true;
    }
    std::vector<NamedFiles> all;
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (!is_second[k]) all.push_back({files[k], std::move(second_of[k])});
    }
    return all;
}

Expected<std::vector<Vibration>> effects_from(const fs::path& path,
                                              const std::optional<ActuatorMap>& actuator,
                                              std::vector<FileRemark>& remarks,
                                              const fs::path& second) {
    const auto read = read_effects_file(path, actuator);
    if (!read) return read.error();
    std::vector<Vibration> vibrations;
    const std::string file = valid_utf8(path.filename().string());
    if (second.empty()) {
        add_effects(vibrations, *read, path, file, remarks);
        return vibrations;
    }
    const auto other = read_effects_file(second, actuator);
    if (!other) return other.error();
    const std::string other_file = valid_utf8(second.filename().string());
    if (const auto pair = joined_pair(*read, *other)) {
        add_effects(vibrations, *pair, path, file + " and " + other_file, remarks);
        remarks.push_back({path.string(), "one pattern with " + other_file});
        return vibrations;
    }
    add_effects(vibrations, *read, path, file, remarks);
    add_effects(vibrations, *other, second, other_file, remarks);
    return vibrations;
}

std::vector<std::string> joined(const std::vector<FileRemark>& remarks) {
    std::map<std::string, std::size_t> count;
    for (const FileRemark& remark : remarks) ++count[remark.text];
    std::vector<std::string> result;
    for (const FileRemark& remark : remarks) {
        const std::size_t files = std::exchange(count[remark.text], 0);
        if (files == 0) continue;
        const std::string others = files == 1 ? "" : " and " + grouped_digits(files - 1) + " more";
        result.push_back(remark.file + others + ": " + remark.text);
    }
    return result;
}

}  // namespace tact
