#include "model/io/folders/folder_files.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "model/io/folders/zip_file.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr const char* kStopped = "reading was cancelled";
constexpr std::size_t kHeadBytes = 4096;

std::string too_many(const fs::path& folder) {
    return folder.string() + ": expected at most " + grouped_digits(kMostEntries) +
           " files and folders in all";
}

std::string too_deep(const fs::path& folder) {
    return folder.string() + ": expected at most " + std::to_string(kMostDepth) +
           " folders within each other";
}

struct Listing {
    FolderFiles found;
    std::stop_token stop;
    std::size_t entries = 0;
};

// What is there, but hidden; the error of the system, if any.
std::vector<fs::path> entries_of(const fs::path& folder, std::error_code& fault) {
    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        if (!entry->path().filename().string().starts_with('.')) entries.push_back(entry->path());
        if (entries.size() > kMostEntries) break;
    }
    return entries;
}

// A folder inside of the one that is read.
bool is_followed(Listing& listing, const fs::path& folder, bool beside_set, int depth) {
    if (beside_set && folder.filename() == "measured") return false;
    std::error_code none;
    const bool is_link = fs::is_symlink(folder, none);
    std::vector<std::string>& left_out = listing.found.left_out;
    if (is_link) left_out.push_back(folder.string() + ": a link to a folder is not followed");
    if (!is_link && depth == kMostDepth) left_out.push_back(too_deep(folder));
    return !is_link && depth < kMostDepth;
}

// What ends the listing, or empty; a folder inside that cannot be read ends nothing.
std::string list_into(Listing& listing, const fs::path& folder, int depth) {
    if (listing.stop.stop_requested()) return kStopped;
    std::error_code fault;
    const std::vector<fs::path> entries = entries_of(folder, fault);
    if (fault) {
        const std::string sentence = folder.string() + ": cannot be read: " + fault.message();
        if (depth == 0) return sentence;
        listing.found.left_out.push_back(sentence);
    }
    listing.entries += entries.size();
    if (listing.entries > kMostEntries) return too_many(folder);
    const bool has_set = std::ranges::any_of(entries, is_set_name);
    for (const fs::path& path : entries) {
        std::error_code none;
        if (!fs::is_directory(path, none)) {
            listing.found.files.push_back(path);
        } else if (is_followed(listing, path, has_set, depth)) {
            std::string end = list_into(listing, path, depth + 1);
            if (!end.empty()) return end;
        }
    }
    return {};
}

// The files of a zip file by their paths.
using ZipPaths = std::map<fs::path, ZipEntry>;

FileAccess access_within(ZipFile zip, ZipPaths paths) {
    const auto whole =
        std::make_shared<const std::pair<ZipFile, ZipPaths>>(std::move(zip), std::move(paths));
    const auto entry_of = [whole](const fs::path& path) -> const ZipEntry* {
        const auto found = whole->second.find(path);
        return found == whole->second.end() ? nullptr : &found->second;
    };
    FileAccess access;
    access.zip = whole->first.path;
    access.head = [whole, entry_of](const fs::path& path) {
        const ZipEntry* entry = entry_of(path);
        return entry == nullptr ? "" : unpacked_head(whole->first, *entry, kHeadBytes);
    };
    access.size = [entry_of](const fs::path& path) {
        const ZipEntry* entry = entry_of(path);
        return entry == nullptr ? std::size_t{0} : static_cast<std::size_t>(entry->bytes);
    };
    access.is_there = [entry_of](const fs::path& path) { return entry_of(path) != nullptr; };
    access.bytes = [whole, entry_of](const fs::path& path,
                                     std::size_t most_bytes) -> Expected<std::string> {
        const ZipEntry* entry = entry_of(path);
        if (entry == nullptr) return Error{path.string() + ": does not exist"};
        return unpacked(whole->first, *entry, most_bytes);
    };
    return access;
}

// What nobody asked for: hidden, of a Mac's own, or of a set that lies beside.
bool is_passed_over(const fs::path& within, const std::set<fs::path>& of_sets) {
    fs::path folder;
    for (const fs::path& part : within) {
        const std::string name = part.string();
        const bool is_hidden = name.starts_with('.') && name != ".." && name != ".";
        if (is_hidden || name == "__MACOSX") return true;
        if (name == "measured" && of_sets.contains(folder) && folder / part != within) return true;
        folder /= part;
    }
    return false;
}

// The readable files of a zip file, by their paths; the rest is left out.
ZipPaths paths_in(const ZipFile& zip, std::vector<std::string>& left_out) {
    std::set<fs::path> of_sets;
    for (const ZipEntry& entry : zip.entries) {
        if (is_set_name(entry.name)) of_sets.insert(fs::path(entry.name).parent_path());
    }
    ZipPaths paths;
    for (const ZipEntry& entry : zip.entries) {
        if (entry.name.ends_with('/') && entry.fault.empty()) continue;
        const fs::path within = fs::path(entry.name).lexically_normal();
        if (is_passed_over(within, of_sets)) continue;
        if (!entry.fault.empty()) {
            left_out.push_back(zip.path.string() + ": " + in_quotes(entry.name) + ": " +
                               entry.fault);
        } else if (std::distance(within.begin(), within.end()) > kMostDepth + 1) {
            left_out.push_back(too_deep(zip.path / within.parent_path()));
        } else {
            paths.emplace(zip.path / within, entry);
        }
    }
    return paths;
}

Expected<FolderFiles> files_in_zip(const fs::path& path) {
    auto zip = open_zip_file(path);
    if (!zip) return zip.error();
    FolderFiles found;
    ZipPaths paths = paths_in(*zip, found.left_out);
    for (const auto& [file, entry] : paths) found.files.push_back(file);
    found.access = access_within(*std::move(zip), std::move(paths));
    return found;
}

}  // namespace

FileAccess files_on_disk() {
    FileAccess access;
    access.head = [](const fs::path& path) { return head_of_file(path, kHeadBytes); };
    access.size = [](const fs::path& path) {
        std::error_code none;
        const auto size = fs::file_size(path, none);
        return none ? std::size_t{0} : static_cast<std::size_t>(size);
    };
    access.is_there = [](const fs::path& path) {
        std::error_code none;
        return fs::exists(path, none);
    };
    access.bytes = [](const fs::path& path, std::size_t most_bytes) {
        return read_text_file(path, most_bytes);
    };
    return access;
}

FileAccess access_to(const fs::path& file) {
    for (fs::path above = file.parent_path(); above.has_relative_path();
         above = above.parent_path()) {
        std::error_code none;
        if (fs::is_directory(above, none)) break;
        if (!is_zip_file(above)) continue;
        auto files = files_in_zip(above);
        if (files) return std::move(files->access);
    }
    return files_on_disk();
}

bool is_set_name(const fs::path& path) {
    return path.filename().string().ends_with(".tactspace.json");
}

Expected<FolderFiles> files_below(const fs::path& folder_or_zip, const std::stop_token& stop) {
    if (is_zip_file(folder_or_zip)) return files_in_zip(folder_or_zip);
    Listing listing{{{}, {}, files_on_disk()}, stop};
    if (std::string end = list_into(listing, folder_or_zip, 0); !end.empty()) {
        return Error{std::move(end)};
    }
    return std::move(listing.found);
}

bool is_there(const std::filesystem::path& path) {
    std::error_code none;
    return std::filesystem::exists(path, none);
}

Expected<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    const bool is_new = !is_there(folder);
    std::filesystem::create_directories(folder, fault);
    constexpr unsigned kAll = 0777;
    const unsigned mode = mode_of_new(folder, kAll);
    if (is_new && !fault && mode != kAll) {
        std::filesystem::permissions(folder, static_cast<std::filesystem::perms>(mode), fault);
    }
    if (!fault && std::filesystem::is_directory(folder, fault)) return Done{};
    return Error{folder.string() + ": cannot be made a folder" +
                 (fault ? ": " + fault.message() : "; there is a file of this name")};
}

}  // namespace tact
