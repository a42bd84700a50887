#include "model/library/library_folder.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "model/common/parallel.h"
#include "model/io/folders/folder_files.h"
#include "model/io/formats/read_effects.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/set_file.h"
#include "model/io/set/waveform_folder.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostIndexBytes = std::size_t{1} << 28;
constexpr std::size_t kLicenceCharacters = 80;

FileStamp stamp_of(const fs::path& path) {
    std::error_code none;
    FileStamp stamp;
    stamp.bytes = fs::file_size(path, none);
    if (none) return {};
    const auto changed = fs::last_write_time(path, none).time_since_epoch();
    stamp.modified_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(changed).count();
    return stamp;
}

// "LICENSE", "COPYING.LESSER", "licence-mit.txt"; no effect that is called so.
bool is_licence(const fs::path& path) {
    const std::string name = lower_case(path.filename().string());
    for (const std::string_view word : {"license", "licence", "copying"}) {
        if (!name.starts_with(word)) continue;
        const bool is_whole = name.size() == word.size();
        if (!is_whole && name[word.size()] != '.' && name[word.size()] != '-') continue;
        const std::string ending = extension_of(path);
        return ending != ".wav" && ending != ".json" && ending != ".xml" && !is_effect_name(name);
    }
    return false;
}

// The first line of a licence's text, which is its name in all that are usual.
std::string licence_in(const fs::path& path) {
    const std::string head = valid_utf8(head_of_file(path));
    for (std::string_view rest = head; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        if (!line.empty()) return shortened(line, kLicenceCharacters);
        rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    }
    return {};
}

// By folder; several in one say nothing of any file.
using Licences = std::map<fs::path, std::string>;

Licences licences_among(const std::vector<fs::path>& files) {
    std::map<fs::path, std::vector<fs::path>> by_folder;
    for (const fs::path& file : files) {
        if (is_licence(file)) by_folder[file.parent_path()].push_back(file);
    }
    Licences licences;
    for (const auto& [folder, all] : by_folder) {
        licences.emplace(folder, all.size() == 1 ? licence_in(all.front()) : "");
    }
    return licences;
}

std::string licence_of(const Licences& licences, const fs::path& file, const fs::path& top) {
    for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
        const auto found = licences.find(folder);
        if (found != licences.end()) return found->second;
        if (folder == top || folder == folder.parent_path()) return {};
    }
}

bool is_before(const NamedFiles& a, const NamedFiles& b) {
    const std::string folder_a = a.path.parent_path().string();
    const std::string folder_b = b.path.parent_path().string();
    if (folder_a != folder_b) return naturally_before(folder_a, folder_b);
    return naturally_before(a.path.filename().string(), b.path.filename().string());
}

bool is_sidecar(const fs::path& path) {
    return extension_of(path) == ".json" && extension_of(path.stem()) == ".wav";
}

std::vector<NamedFiles> files_to_look_at(std::vector<fs::path> files) {
    std::erase_if(files, [](const fs::path& path) { return is_licence(path); });
    std::ranges::sort(files);
    const std::set<fs::path> all(files.begin(), files.end());
    std::erase_if(files, is_sidecar);
    std::vector<NamedFiles> named = with_pairs(files);
    for (NamedFiles& one : named) {
        const fs::path sidecar = sidecar_of(one.path);
        if (one.second.empty() && all.contains(sidecar)) one.second = sidecar;
    }
    std::ranges::sort(named, is_before);
    return named;
}

// What one file comes to.
struct Looked {
    LibraryFile file;
    std::vector<LibraryEntry> entries;
};

struct Found {
    std::vector<Vibration> vibrations;
    std::string fault;  // why some or all are missing
};

void add_to(Found& found, Expected<std::vector<Vibration>> read) {
    if (!read) {
        if (found.fault.empty()) found.fault = valid_utf8(read.error().message);
        return;
    }
    std::ranges::move(*read, std::back_inserter(found.vibrations));
}

Found found_in(const fs::path& path, const fs::path& beside, std::stop_token stop = {}) {
    Found found;
    std::vector<FileRemark> remarks;
    if (is_set_name(path)) {
        auto set = read_set_file(path);
        if (!set) return {{}, valid_utf8(set.error().message)};
        return {std::move(set->set.vibrations), {}};
    }
    if (beside.empty() || is_sidecar(beside)) {
        add_to(found, vibrations_in(path, {.stop = stop}, remarks));
        return found;
    }
    auto pair = vibrations_in(path, {.stop = stop}, remarks, beside);
    if (pair) return {*std::move(pair), {}};
    // One of the two is bad, and the other is read as if it were alone.
    add_to(found, vibrations_in(path, {.stop = stop}, remarks));
    add_to(found, vibrations_in(beside, {.stop = stop}, remarks));
    return found;
}

// Those alone that are as they were.
using KnownFiles = std::map<std::string, Looked>;

KnownFiles known_files(Library library) {
    KnownFiles known;
    for (const LibraryFile& file : library.files) known[file.path].file = file;
    for (LibraryEntry& entry : library.entries) {
        known[library.files[entry.file].path].entries.push_back(std::move(entry));
    }
    return known;
}

std::string within(const fs::path& file, const fs::path& folder) {
    return file.empty() ? "" : file.lexically_relative(folder).generic_string();
}

LibraryFile file_now(const NamedFiles& files, const fs::path& folder, const Licences& licences) {
    LibraryFile file;
    file.path = within(files.path, folder);
    file.beside = within(files.second, folder);
    file.stamp = stamp_of(files.path);
    if (!files.second.empty()) file.beside_stamp = stamp_of(files.second);
    file.licence = licence_of(licences, files.path, folder);
    return file;
}

bool is_as_it_was(const LibraryFile& now, const LibraryFile& was) {
    return now.path == was.path && now.beside == was.beside && now.stamp == was.stamp &&
           now.beside_stamp == was.beside_stamp && now.stamp != FileStamp{};
}

void look_into(Looked& looked, const NamedFiles& files, std::stop_token stop) {
    Found found = found_in(files.path, files.second, stop);
    looked.file.left_out = std::move(found.fault);
    for (const Vibration& vibration : found.vibrations) {
        LibraryEntry entry = entry_of(vibration);
        entry.place = looked.entries.size();
        looked.entries.push_back(std::move(entry));
    }
}

// What was kept of the folder, with its text; a damaged index counts as none, with a remark.
struct KeptIndex {
    Library library;
    std::string text;
};

KeptIndex kept_index(const fs::path& folder, std::vector<std::string>& remarks) {
    const fs::path path = folder / kLibraryFile;
    std::error_code none;
    if (!fs::exists(path, none)) return {};
    const auto text = read_text_file(path, kMostIndexBytes);
    auto library = text ? parse_library(*text, folder) : Expected<Library>(text.error());
    if (library) return {*std::move(library), *text};
    remarks.push_back(library.error().message + ": all files were read again");
    return {};
}

// What is as it was keeps its entries; gives the places of all others.
std::vector<std::size_t> take_known(std::vector<Looked>& all, KnownFiles known) {
    std::vector<std::size_t> fresh;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto was = known.find(all[k].file.path);
        if (was == known.end() || !is_as_it_was(all[k].file, was->second.file)) {
            fresh.push_back(k);
            continue;
        }
        all[k].file.left_out = was->second.file.left_out;
        all[k].entries = std::move(was->second.entries);
    }
    return fresh;
}

// False when stopped.
bool look_into_all(std::vector<Looked>& all, const std::vector<NamedFiles>& files,
                   const std::vector<std::size_t>& fresh, const LibraryOptions& options) {
    std::mutex counting;
    std::size_t done = 0;
    parallel_for(fresh.size(), options.threads, options.stop, [&](std::size_t k) {
        look_into(all[fresh[k]], files[fresh[k]], options.stop);
        const std::lock_guard lock(counting);
        ++done;
        if (options.progress) {
            options.progress(static_cast<double>(done) / static_cast<double>(fresh.size()));
        }
    });
    return !options.stop.stop_requested();
}

void keep(Library& library, const std::string& text_before) {
    const std::string text = print_library(library);
    if (text == text_before) return;
    const auto written = write_atomically(library.folder / kLibraryFile, text);
    if (!written) {
        library.remarks.push_back(written.error().message +
                                  ": this library will be read again each time");
    }
}

}  // namespace

Expected<Library> open_library(const fs::path& folder, const LibraryOptions& options) {
    std::error_code fault;
    if (!fs::is_directory(folder, fault)) {
        return Error{folder.string() + ": expected a folder"};
    }
    auto found = files_below(folder, options.stop);
    if (!found) return found.error();
    if (found->files.size() > kMostLibraryFiles) {
        return Error{folder.string() + ": expected at most " + grouped_digits(kMostLibraryFiles) +
                     " files, got " + grouped_digits(found->files.size())};
    }
    Library library;
    library.folder = folder;
    library.remarks = std::move(found->left_out);
    KeptIndex before;
    if (!options.read_all) before = kept_index(folder, library.remarks);
    const Licences licences = licences_among(found->files);
    const std::vector<NamedFiles> files = files_to_look_at(std::move(found->files));
    std::vector<Looked> all;
    for (const NamedFiles& one : files) all.push_back({file_now(one, folder, licences), {}});
    const auto fresh = take_known(all, known_files(std::move(before.library)));
    if (!look_into_all(all, files, fresh, options)) return Error{kReadingCancelled};
    library.files_read = fresh.size();
    for (Looked& one : all) {
        for (LibraryEntry& entry : one.entries) {
            entry.file = library.files.size();
            library.entries.push_back(std::move(entry));
        }
        library.files.push_back(std::move(one.file));
    }
    if (options.keep) keep(library, before.text);
    return library;
}

Expected<Vibration> vibration_of(const Library& library, const LibraryEntry& entry) {
    const LibraryFile& file = file_of(library, entry);
    const fs::path path = library.folder / file.path;
    const fs::path beside = file.beside.empty() ? fs::path() : library.folder / file.beside;
    Found found = found_in(path, beside);
    auto& all = found.vibrations;
    if (entry.place < all.size() && all[entry.place].name == entry.name)
        return std::move(all[entry.place]);
    if (all.empty() && !found.fault.empty()) return Error{found.fault};
    return Error{path.string() + ": expected " + in_quotes(entry.name) +
                 " in it, as when the library was opened"};
}

}  // namespace tact
