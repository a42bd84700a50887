// The index of a library as JSON.

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "model/library/library_folder.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

// Raised whenever a reader gives other numbers or words: all files are read again then.
constexpr int kIndexVersion = 1;
constexpr const char* kFormat = "tactspace library";

constexpr Range kWhole{0.0, 9e15};
constexpr std::size_t kMostInFile = 1'000'000;

// As text: JSON's numbers are doubles in many programs, and nanoseconds need more digits.
Json json_of(const FileStamp& stamp) {
    return {std::to_string(stamp.bytes), std::to_string(stamp.modified_ns)};
}

FileStamp stamp_in(JsonObject& object, std::string_view key) {
    const auto parts = array_field(object, key, 0, 2);
    if (parts.size() != 2 || !parts[0]->is_string() || !parts[1]->is_string()) return {};
    FileStamp stamp;
    const auto& bytes = parts[0]->get_ref<const std::string&>();
    const auto& time = parts[1]->get_ref<const std::string&>();
    std::from_chars(bytes.data(), bytes.data() + bytes.size(), stamp.bytes);
    std::from_chars(time.data(), time.data() + time.size(), stamp.modified_ns);
    return stamp;
}

Json json_of(const LibraryEntry& entry) {
    Json json = {{"name", entry.name},
                 {"note", entry.note},
                 {"duration_s", entry.duration_s},
                 {"peak_g", entry.peak_g}};
    if (!entry.effect.format.empty()) {
        json["format"] = entry.effect.format;
        json["actuator"] = entry.effect.actuator;
    }
    if (entry.recording) json["recording"] = true;
    if (entry.synthetic) json["synthetic"] = true;
    if (entry.mean_hz) json["mean_hz"] = *entry.mean_hz;
    if (entry.ticks > 0) json["ticks"] = entry.ticks;
    json["shape"] = entry.shape;
    return json;
}

LibraryEntry entry_in(JsonObject& object) {
    LibraryEntry entry;
    entry.name = text_field(object, "name", "");
    entry.note = text_field(object, "note", "");
    entry.effect.format = text_field(object, "format", "");
    entry.effect.actuator = text_field(object, "actuator", "");
    entry.recording = yes_no_field(object, "recording", false);
    entry.synthetic = yes_no_field(object, "synthetic", false);
    entry.duration_s = number_field(object, "duration_s", 0.0, {0.0, 1e6});
    entry.peak_g = number_field(object, "peak_g", 0.0, {0.0, kMaxSampleG});
    if (field(object, "mean_hz") != nullptr)
        entry.mean_hz = number_field(object, "mean_hz", 0.0, {0.0, kModelRateHz});
    entry.ticks = static_cast<std::size_t>(number_field(object, "ticks", 0.0, kWhole));
    const auto shape = array_field(object, "shape", kShapeParts, kShapeParts);
    for (std::size_t k = 0; k < shape.size(); ++k) {
        entry.shape[k] =
            number_at(*object.reading, *shape[k], place_of(object, "shape"), {0.0, 1.0});
    }
    return entry;
}

Json json_of(const LibraryFile& file) {
    Json json = {{"path", file.path}, {"stamp", json_of(file.stamp)}};
    if (!file.beside.empty()) {
        json["beside"] = file.beside;
        json["beside_stamp"] = json_of(file.beside_stamp);
    }
    if (!file.licence.empty()) json["licence"] = file.licence;
    if (!file.left_out.empty()) json["left_out"] = file.left_out;
    return json;
}

LibraryFile file_in(JsonObject& object) {
    LibraryFile file;
    file.path = text_field(object, "path", "");
    file.beside = text_field(object, "beside", "");
    file.stamp = stamp_in(object, "stamp");
    file.beside_stamp = stamp_in(object, "beside_stamp");
    file.licence = text_field(object, "licence", "");
    file.left_out = text_field(object, "left_out", "");
    return file;
}

}  // namespace

std::string print_library(const Library& library) {
    Json files = Json::array();
    for (const LibraryFile& file : library.files) {
        files.push_back(json_of(file));
        files.back()["entries"] = Json::array();
    }
    for (const LibraryEntry& entry : library.entries) {
        files[entry.file]["entries"].push_back(json_of(entry));
    }
    const Json whole = {{"format", kFormat}, {"version", kIndexVersion}, {"files", files}};
    // A line for each file, so that two indexes can be compared line by line.
    std::string text = text_of_json(whole);
    for (std::size_t at = 0; (at = text.find(",{\"path\"", at)) != text.npos; at += 2) {
        text.insert(at + 1, "\n");
    }
    return text + "\n";
}

Expected<Library> parse_library(std::string_view text, const std::filesystem::path& folder) {
    const auto document = parse_json(text, (folder / kLibraryFile).string());
    if (!document) return document.error();
    JsonReading reading{(folder / kLibraryFile).string(), {}};
    JsonObject whole = object_at(reading, *document, "");
    const int version = whole_field(whole, "version", 0, {0.0, 1e6});
    if (text_field(whole, "format", "") != kFormat || version != kIndexVersion) {
        return Error{reading.file + ": expected an index of version " +
                     std::to_string(kIndexVersion)};
    }
    Library library;
    library.folder = folder;
    Json unknown;
    read_objects(whole, "files", 0, kMostLibraryFiles, unknown, [&](JsonObject& one, Json&) {
        library.files.push_back(file_in(one));
        Json within;
        std::size_t place = 0;
        read_objects(one, "entries", 0, kMostInFile, within, [&](JsonObject& entry, Json&) {
            LibraryEntry read = entry_in(entry);
            read.file = library.files.size() - 1;
            read.place = place++;
            library.entries.push_back(std::move(read));
        });
    });
    if (!reading.fault.empty()) return Error{reading.fault};
    return library;
}

}  // namespace tact
