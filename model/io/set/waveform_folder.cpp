#include "model/io/set/waveform_folder.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "model/io/formats/ahap/ahap_pair.h"
#include "model/io/formats/read_effects.h"
#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/set/layers.h"
#include "model/text/enough_memory.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

using Kinds = std::vector<RecordingKind>;

bool is_sidecar(const fs::path& path) {
    return extension_of(path) == ".json" && extension_of(path.stem()) == ".wav";
}

// What is asked for of a folder, and what is found in it and below it.
struct Listing {
    Kinds kinds;
    bool effects = false;
    const LoadOptions& options;
    FileAccess access{};
    std::vector<fs::path> files{};  // recordings, and what may be effects
    std::set<fs::path> recordings{};
    std::size_t others = 0;  // neither, nor sidecars of recordings, nor hidden
    std::vector<std::string> sets{};
    std::vector<std::string> left_out{};
};

// Any name will do. What has an effect's name and is no effect is told.
bool may_hold_effects(const FileAccess& access, const fs::path& path, const std::string& head) {
    return is_effect_name(path.string()) || !head_of_effects(head, access.size(path)).empty();
}

// What is wrong with a file that holds none, as the end of a sentence; or empty.
std::string no_effects_fault(const fs::path& path, const std::string& head) {
    const std::string stranger = known_stranger(path, head);
    if (!stranger.empty()) return stranger;
    return is_effect_name(path.string()) ? "expected an effect, got none" : "";
}

void sort_out(Listing& listing, const fs::path& path) {
    const std::string head = listing.access.head(path);
    // What is in it is not looked for: it may hold another without end.
    if (head.starts_with("PK\x03\x04")) {
        listing.left_out.push_back(path.string() +
                                   ": is a zip file, which is read where it is opened by itself");
        return;
    }
    const bool wanted = std::ranges::count(listing.kinds, recording_kind(path, head)) > 0;
    if (wanted) listing.recordings.insert(path);
    if (is_set_name(path)) {
        listing.sets.push_back(path.string());
    } else if (wanted || (listing.effects && !is_sidecar(path) &&
                          may_hold_effects(listing.access, path, head))) {
        listing.files.push_back(path);
    } else if (!is_sidecar(path)) {
        ++listing.others;
    }
}

// A folder's own files come before those of the folders in it.
bool is_before(const fs::path& a, const fs::path& b) {
    const std::string folder_a = a.parent_path().string();
    const std::string folder_b = b.parent_path().string();
    if (folder_a != folder_b) return naturally_before(folder_a, folder_b);
    const std::string stem_a = a.stem().string();
    const std::string stem_b = b.stem().string();
    return stem_a == stem_b ? a < b : naturally_before(stem_a, stem_b);
}

std::string kinds_text(const Kinds& kinds) {
    std::string text;
    for (const RecordingKind kind : kinds) {
        text += (text.empty() ? "" : " or ") +
                std::string(kind == RecordingKind::text ? ".txt" : ".wav");
    }
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
    Loaded loaded;
    std::vector<FileRemark> remarks;
    UnusedNames taken;            // of all
    std::set<std::string> stems;  // of recordings, that have been given
    std::size_t samples = 0;
    std::size_t others = 0;
};

// What is wrong with one vibration more, or empty.
std::string room_fault(const Gathered& all, std::size_t samples) {
    if (all.loaded.set.vibrations.size() >= limits::kMaxPatterns) {
        return "expected at most " + grouped_digits(limits::kMaxPatterns) + " vibrations in all";
    }
    return samples_fault(all.samples + samples);
}

std::string name_beside(Gathered& all, const std::string& name, const fs::path& file) {
    if (!all.taken.taken.contains(name)) return all.taken.unused(name);
    return all.taken.unused(name + valid_utf8(file.extension().string()));
}

// Recordings come first to their names, which were kept free for them.
void name_recording(Gathered& all, Vibration& vibration, const fs::path& file) {
    if (all.stems.insert(vibration.name).second) return;
    vibration.name = name_beside(all, vibration.name, file);
    all.remarks.push_back(
        {file.string(), "is called " + in_quotes(vibration.name) + ", as its name is taken"});
}

// What is wrong with the file as one sentence, or empty.
std::string gather_recording(Gathered& all, const fs::path& file, const FileAccess& access) {
    auto vibration = with_enough_memory(file.string(),
                                        [&] { return vibration_from(file, all.remarks, access); });
    if (!vibration) return vibration.error().message;
    const std::size_t samples = recorded_samples(*vibration);
    if (const auto fault = room_fault(all, samples); !fault.empty()) {
        return file.string() + ": " + fault;
    }
    all.samples += samples;
    name_recording(all, *vibration, file);
    all.loaded.set.vibrations.push_back(*std::move(vibration));
    ++all.loaded.files;
    return {};
}

std::string gather_effects(Gathered& all, const fs::path& file, const fs::path& second,
                           const Listing& listing) {
    const FileAccess& access = listing.access;
    auto effects = effects_from(file, listing.options, all.remarks, second, access);
    if (!effects) return effects.error().message;
    if (effects->empty()) {
        const std::string fault = no_effects_fault(file, access.head(file));
        if (!fault.empty()) return file.string() + ": " + fault;
        ++all.others;
        return {};
    }
    for (Vibration& effect : *effects) {
        if (const auto fault = room_fault(all, 0); !fault.empty()) {
            return file.string() + ": " + fault;
        }
        effect.name = name_beside(all, effect.name, file);
        all.loaded.set.vibrations.push_back(std::move(effect));
    }
    all.loaded.files += second.empty() ? 1 : 2;
    return {};
}

// Two files of a pair of which one is bad: the other is read as if it were alone.
void gather_one(Gathered& all, const NamedFiles& files, const Listing& listing) {
    std::vector<std::string>& left_out = all.loaded.left_out;
    if (listing.recordings.contains(files.path)) {
        const std::string fault = gather_recording(all, files.path, listing.access);
        if (!fault.empty()) left_out.push_back(fault);
        return;
    }
    const std::string fault = gather_effects(all, files.path, files.second, listing);
    if (fault.empty()) return;
    if (files.second.empty()) {
        left_out.push_back(fault);
        return;
    }
    for (const fs::path& one : {files.path, files.second}) {
        const std::string alone = gather_effects(all, one, {}, listing);
        if (!alone.empty()) left_out.push_back(alone);
    }
}

// False: the reading was cancelled.
bool gather_all(Gathered& all, const Listing& listing) {
    const std::vector<NamedFiles> files = with_pairs(listing.files);
    for (std::size_t k = 0; k < files.size(); ++k) {
        gather_one(all, files[k], listing);
        if (listing.options.stop.stop_requested()) return false;
        if (listing.options.progress) {
            listing.options.progress(static_cast<double>(k + 1) /
                                     static_cast<double>(files.size()));
        }
    }
    return true;
}

// Why a folder gave nothing.
Error nothing_read(const Listing& listing, const std::vector<std::string>& left_out,
                   const std::string& name) {
    if (left_out.empty()) {
        return Error{name + ": expected at least one " + kinds_text(listing.kinds) +
                     (listing.effects ? " or effect" : "") + " file in this " +
                     (listing.access.zip.empty() ? "folder" : "zip file") + ", got none"};
    }
    const std::size_t more = left_out.size() - 1;
    return Error{left_out.front() +
                 (more == 0 ? "" : "; and " + grouped_digits(more) + " more were not read")};
}

void remark_on_folder(Gathered& all, const Listing& listing, const std::string& name) {
    std::vector<std::string>& remarks = all.loaded.remarks;
    for (const std::string& set : listing.sets) {
        all.remarks.push_back({set, "is a set of its own and was left alone"});
    }
    remarks = joined(all.remarks);
    if (const auto remark = lengths_remark(all.loaded.set); !remark.empty()) {
        remarks.push_back(name + ": " + remark);
    }
    if (all.others > 0) {
        remarks.push_back(name + ": " + grouped_digits(all.others) +
                          (all.others == 1 ? " other file" : " other files") + " ignored");
    }
}

Expected<Loaded> read_folder(const fs::path& folder, const Kinds& kinds, bool effects,
                             const LoadOptions& options) {
    const std::string name = folder.string();
    auto found = files_below(folder, options.stop);
    if (!found) return found.error();
    Listing listing{kinds, effects, options, found->access};
    listing.left_out = std::move(found->left_out);
    for (const fs::path& file : found->files) {
        if (options.stop.stop_requested()) return Error{kReadingCancelled};
        sort_out(listing, file);
    }
    if (listing.files.size() > limits::kMaxPatterns) {
        return Error{name + ": expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " files, got " + grouped_digits(listing.files.size())};
    }
    std::ranges::sort(listing.files, is_before);
    Gathered all;
    all.loaded.files = 0;
    all.others = listing.others;
    all.loaded.left_out = listing.left_out;
    std::error_code none;
    const fs::path whole = fs::weakly_canonical(folder, none);
    all.loaded.set.name =
        valid_utf8((listing.access.zip.empty() ? whole.filename() : whole.stem()).string());
    for (const fs::path& file : listing.files) {
        if (listing.recordings.contains(file))
            all.taken.taken.insert(valid_utf8(file.stem().string()));
    }
    if (!gather_all(all, listing)) return Error{kReadingCancelled};
    if (all.loaded.set.vibrations.empty()) return nothing_read(listing, all.loaded.left_out, name);
    remark_on_folder(all, listing, name);
    return std::move(all.loaded);
}

Expected<EffectsRead> read_effects_file(const fs::path& path, const LoadOptions& options,
                                        const FileAccess& access) {
    const auto text = access.bytes(path, kMostEffectBytes);
    if (!text) return text.error();
    Budget budget;
    budget.stop = options.stop;
    return read_effects(*text, path.string(), options.actuator, budget);
}

// Notes where it has them, and layers.
VibrationSource source_of(const Effect& effect) {
    const auto found = [](const Pattern& one) { return with_found_notes(one).value_or(one); };
    if (effect.layers.empty()) return found(effect.pattern);
    std::vector<Pattern> layers;
    for (const Pattern& layer : effect.layers) layers.push_back(found(layer));
    return layers_of(std::move(layers));
}

// `files`: what the note calls it.
void add_effects(std::vector<Vibration>& vibrations, const EffectsRead& read, const fs::path& path,
                 const std::string& files, std::vector<FileRemark>& remarks) {
    for (const Effect& effect : read.effects) {
        Vibration vibration;
        vibration.name = effect.name;
        vibration.source = source_of(effect);
        vibration.note = origin_of(read, effect, files);
        vibration.effect = {read.format->key, read.map.name};
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

Expected<Loaded> read_waveform_folder(const fs::path& folder, const LoadOptions& options) {
    return read_folder(folder, {RecordingKind::text, RecordingKind::wave}, true, options);
}

Expected<Loaded> read_text_folder(const fs::path& folder) {
    return read_folder(folder, {RecordingKind::text}, false, {});
}

Expected<Recording> recording_in(const FileAccess& access, const fs::path& path,
                                 const RecordingOptions& options) {
    if (access.zip.empty()) return read_recording(path, options);
    const bool is_text = recording_kind(path, access.head(path)) == RecordingKind::text;
    auto bytes = access.bytes(path, is_text ? kMaxTextWaveformBytes : kMaxWaveBytes);
    if (!bytes) return bytes.error();
    const fs::path sidecar = sidecar_of(path);
    if (is_text || !access.is_there(sidecar)) {
        return parse_recording(path, *std::move(bytes), {}, options);
    }
    auto said = access.bytes(sidecar, kMostEffectBytes);
    if (!said) return said.error();
    // Nothing in it is a fault of its own: JSON has at least a word.
    return parse_recording(path, *std::move(bytes), said->empty() ? " " : *std::move(said),
                           options);
}

Expected<Vibration> vibration_from(const fs::path& path, std::vector<FileRemark>& remarks,
                                   const FileAccess& access) {
    auto recording = recording_in(access, path);
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

Expected<std::vector<Vibration>> vibrations_in(const fs::path& path, const LoadOptions& options,
                                               std::vector<FileRemark>& remarks,
                                               const fs::path& second) {
    const FileAccess access = files_on_disk();
    const std::string head = access.head(path);
    std::vector<Vibration> vibrations;
    if (recording_kind(path, head) != RecordingKind::none) {
        auto one = with_enough_memory(path.string(),
                                      [&] { return vibration_from(path, remarks, access); });
        if (!one) return one.error();
        vibrations.push_back(*std::move(one));
        return vibrations;
    }
    if (!may_hold_effects(access, path, head)) return vibrations;
    auto effects = effects_from(path, options, remarks, second, access);
    if (!effects || !effects->empty()) return effects;
    if (const auto fault = no_effects_fault(path, head); !fault.empty())
        return Error{path.string() + ": " + fault};
    return vibrations;
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

Expected<std::vector<Vibration>> effects_from(const fs::path& path, const LoadOptions& options,
                                              std::vector<FileRemark>& remarks,
                                              const fs::path& second, const FileAccess& access) {
    const auto read = read_effects_file(path, options, access);
    if (!read) return read.error();
    std::vector<Vibration> vibrations;
    const std::string file = valid_utf8(path.filename().string());
    if (second.empty()) {
        add_effects(vibrations, *read, path, file, remarks);
        return vibrations;
    }
    const auto other = read_effects_file(second, options, access);
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
