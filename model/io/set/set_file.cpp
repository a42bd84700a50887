#include "model/io/set/set_file.h"

#include <nlohmann/json.hpp>

#include <span>

#include "model/common/fingerprint.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/set_json.h"
#include "model/io/set/waveform_folder.h"
#include "model/set/layers.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::string text_of(const Json& document) { return text_of_json(document, 2) + "\n"; }

// Where a file of the set lies. The folder's links are followed, so that ".." in a relative path
// means the same to us as to the system; the file's own link stays.
fs::path resolved(const fs::path& folder, const std::string& path) {
    std::error_code none;
    const fs::path whole = fs::absolute(folder / path, none);
    return fs::weakly_canonical(whole.parent_path(), none) / whole.filename();
}

// Whether a file, with all links followed, lies in a folder or below it.
bool lies_below(const fs::path& folder, const fs::path& file) {
    std::error_code none;
    const fs::path base = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, none);
    const fs::path way = fs::weakly_canonical(file, none).lexically_relative(base);
    return !way.empty() && *way.begin() != "..";
}

// What may be told of an unreadable recording: no content of a file outside of the set's folder.
std::string told(const Error& error, const fs::path& file, const fs::path& folder) {
    if (lies_below(folder, file)) return error.message;
    if (const auto size = readable_size(file); !size) return size.error().message;
    return file.string() + ": is no recording that can be read. It lies outside of the set's " +
           "folder, so its content is not shown; opened by itself it says more";
}

// Whether a file lies in the zip file that is open already.
bool is_reached_by(const FileAccess& access, const fs::path& file) {
    if (access.zip.empty()) return false;
    const fs::path way = file.lexically_relative(access.zip);
    return !way.empty() && *way.begin() != "..";
}

// Reads the waveform of a recording that a document names; what is wrong, or empty. `access`: to
// the one before.
std::string load_recording(Measurement& measurement, const std::string& name,
                           const fs::path& folder, FileAccess& access,
                           std::vector<std::string>& remarks) {
    const fs::path path = resolved(folder, measurement.path);
    RecordingOptions options;
    if (measurement.scale_g > 0.0) options.scale_g = measurement.scale_g;
    if (!is_reached_by(access, path)) access = access_to(path);
    Expected<Recording> recording = recording_in(access, path, options);
    if (!recording) return told(recording.error(), path, folder);
    for (const std::string& remark : recording->remarks) {
        remarks.push_back(in_quotes(name) + ": " + remark);
    }
    measurement.path = path.string();
    measurement.scale_g = recording->scale_g;
    measurement.waveform = std::make_shared<const Waveform>(std::move(recording->waveform));
    return {};
}

std::string load_recordings(Vibration& vibration, const fs::path& folder, FileAccess& access,
                            std::vector<std::string>& remarks) {
    for (Measurement* measurement : recordings_in(vibration)) {
        std::string fault = load_recording(*measurement, vibration.name, folder, access, remarks);
        if (!fault.empty()) return fault;
    }
    return {};
}

std::string recording_place(const std::string& file, std::size_t k, const Vibration& vibration) {
    const bool has_layers = std::holds_alternative<LayeredPattern>(vibration.source);
    return file + ": /patterns/" + std::to_string(k) + (has_layers ? "/layers" : "/waveform") +
           " of " + in_quotes(vibration.name);
}

Expected<Loaded> loaded_from(std::string_view text, const std::string& name,
                             const fs::path& folder) {
    auto document = parse_json(text, name);
    if (!document) return document.error();
    JsonReading reading{name, {}, UnknownKeys::kept};
    Loaded loaded;
    loaded.set = set_of(reading, *document, loaded.remarks);
    if (!reading.fault.empty()) return Error{reading.fault};
    std::size_t samples = 0;
    FileAccess access = files_on_disk();
    for (std::size_t k = 0; k < loaded.set.vibrations.size(); ++k) {
        Vibration& vibration = loaded.set.vibrations[k];
        std::string fault = load_recordings(vibration, folder, access, loaded.remarks);
        samples += recorded_samples(vibration);
        if (fault.empty()) fault = samples_fault(samples);
        const auto* layered = std::get_if<LayeredPattern>(&vibration.source);
        if (fault.empty() && layered != nullptr) fault = fault_of(*layered);
        if (!fault.empty()) return Error{recording_place(name, k, vibration) + ": " + fault};
    }
    for (const auto& [actuator, count] : actuators_of(loaded.set)) {
        loaded.remarks.push_back(name + ": " + grouped_digits(count) +
                                 (count == 1 ? " pattern was" : " patterns were") +
                                 " read by actuator map " + in_quotes(actuator));
    }
    return loaded;
}

}  // namespace

Expected<Loaded> read_set_file(const fs::path& path) {
    return with_enough_memory(path.string(), [&]() -> Expected<Loaded> {
        const auto text = read_text_file(path);
        if (!text) return text.error();
        auto loaded = loaded_from(*text, path.string(), path.parent_path());
        if (loaded) loaded->mark = fingerprint(*text);
        return loaded;
    });
}

Expected<PatternSet> parse_set(std::string_view text, const std::string& name_for_messages,
                               const fs::path& folder) {
    return with_enough_memory(name_for_messages, [&]() -> Expected<PatternSet> {
        auto loaded = loaded_from(text, name_for_messages, folder);
        if (!loaded) return loaded.error();
        return std::move(loaded->set);
    });
}

std::string print_set(const PatternSet& set) { return text_of(json_of(set, {})); }

std::string print_set(const PatternSet& set, const fs::path& folder) {
    return text_of(json_of(set, folder));
}

Expected<Done> write_set_file(const fs::path& path, const PatternSet& set) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string name = path.string();
    const std::string text = print_set(set, folder);
    const auto document = parse_json(text, name);
    if (!document) return document.error();
    JsonReading reading{name, {}, UnknownKeys::kept};
    std::vector<std::string> remarks;
    set_of(reading, *document, remarks);
    if (!reading.fault.empty()) return Error{reading.fault};
    if (const auto fault = samples_fault(recorded_samples(set)); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    for (const Vibration& vibration : set.vibrations) {
        const auto* layered = std::get_if<LayeredPattern>(&vibration.source);
        const std::string layers_fault = layered == nullptr ? "" : fault_of(*layered);
        if (layers_fault.empty()) continue;
        return Error{name + ": " + in_quotes(vibration.name) + ": " + layers_fault};
    }
    remove_abandoned_files(folder);
    return write_atomically(path, text);
}

namespace {

std::uint64_t mixed_text(std::uint64_t so_far, const PatternSet& set) {
    const std::string text = print_set(set);
    return mixed(so_far, std::span<const char>(text));
}

// Without what changes nothing that is felt: how steps are counted, and letters that no note has.
Pattern as_felt(Pattern pattern) {
    Rhythm& rhythm = pattern.rhythm;
    rhythm.meter = {};
    std::erase_if(rhythm.kinds, [&rhythm](const auto& kind) {
        return rhythm.text.find(kind.first) == std::string::npos;
    });
    return pattern;
}

}  // namespace

std::uint64_t vibrations_fingerprint(const PatternSet& set) {
    std::uint64_t number = 0;
    PatternSet bare;
    for (const Vibration& vibration : set.vibrations) {
        Vibration& kept = bare.vibrations.emplace_back();
        if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
            kept.source = as_felt(*pattern);
        } else {
            const Waveform waveform = waveform_of(vibration);
            number = mixed(number, std::uint64_t{bare.vibrations.size()});
            number = mixed(number, std::span<const double>(waveform.samples_g));
        }
    }
    return mixed_text(number, bare);
}

std::uint64_t model_fingerprint(const PatternSet& set) {
    PatternSet bare;
    bare.model = set.model;
    return mixed_text(0, bare);
}

}  // namespace tact
