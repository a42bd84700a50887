#include "app/ui/ui.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "model/system/calendar.h"
#include "model/text/names.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::string lowered(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

// Natural order, case ignored.
bool comes_before(const FolderEntry& a, const FolderEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    const std::string x = lowered(a.name);
    const std::string y = lowered(b.name);
    return x == y ? a.name < b.name : naturally_before(x, y);
}

std::string changed_at(const fs::path& path) {
    std::error_code failure;
    const auto at = fs::last_write_time(path, failure);
    if (failure) return {};
    const auto of_system = std::chrono::file_clock::to_sys(at);
    const std::time_t seconds = std::chrono::system_clock::to_time_t(
        std::chrono::time_point_cast<std::chrono::system_clock::duration>(of_system));
    const std::optional<std::tm> here = local_parts(seconds);
    if (!here) return {};
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &*here)};
}

}  // namespace

bool has_extension(const std::string& name, const std::vector<std::string>& extensions) {
    return extensions.empty() || std::ranges::any_of(extensions, [&](const std::string& extension) {
               return lowered(name).ends_with(lowered(extension));
           });
}

fs::path home_folder() {
    // Nothing changes the environment while the program runs.
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    return home != nullptr && home[0] == '/' ? fs::path(home) : fs::path("/");
}

bool is_folder(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(path, none);
}

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& extensions) {
    FolderListing listing{folder, {}, {}};
    std::error_code failure;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
         at.increment(failure)) {
        FolderEntry entry{at->path().filename().string(), is_folder(at->path()), {}};
        if (entry.name.starts_with('.')) continue;
        if (entry.is_folder || has_extension(entry.name, extensions)) {
            entry.changed = changed_at(at->path());
            listing.entries.push_back(std::move(entry));
        }
    }
    if (failure) {
        listing.entries.clear();
        listing.fault = folder.string() + " cannot be read: " + failure.message() + ".";
    }
    std::ranges::sort(listing.entries, comes_before);
    return listing;
}

namespace {

namespace fs = std::filesystem;
using Chosen = std::optional<fs::path>;

bool is_there(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

// States the error in the name, which the person then types again.
Chosen refused(FileChooser& chooser, std::string remark) {
    chooser.remark = std::move(remark);
    chooser.focus_name = true;
    return std::nullopt;
}

Chosen no_folder(FileChooser& chooser, const fs::path& path) {
    return refused(chooser, "There is no folder " + path.parent_path().string() + ".");
}

fs::path typed_path(const FileChooser& chooser, const std::string& text) {
    if (text == "~" || text.starts_with("~/")) {
        return (home_folder() / text.substr(std::min<std::size_t>(2, text.size())))
            .lexically_normal();
    }
    return (chooser.listing.folder / text).lexically_normal();  // an absolute one replaces it
}

Chosen accept_to_open(FileChooser& chooser, const fs::path& path) {
    if (is_there(path)) return path;
    return refused(chooser, "There is no file " + path.string() + ".");
}

Chosen accept_to_save(FileChooser& chooser, fs::path path) {
    if (!has_extension(path.filename().string(), chooser.extensions)) {
        path += chooser.extensions.front();
    }
    if (!is_folder(path.parent_path())) return no_folder(chooser, path);
    if (!is_there(path)) return path;
    chooser.replacing = path;
    return std::nullopt;
}

// Asks before it replaces a file in the folder.
Chosen accept_to_save_into(FileChooser& chooser, const fs::path& folder) {
    for (const std::string& name : chooser.file_names) {
        if (!is_there(folder / name)) continue;
        chooser.replacing = folder / name;
        return std::nullopt;
    }
    return folder;
}

Chosen accept_new_folder(FileChooser& chooser, const fs::path& path) {
    if (is_there(path)) return refused(chooser, path.string() + " is a file.");
    return is_folder(path.parent_path()) ? Chosen(path) : no_folder(chooser, path);
}

}  // namespace

void go_to_folder(FileChooser& chooser, const fs::path& folder) {
    // "a/" and "a" are one folder; the root keeps its slash.
    fs::path there = folder.lexically_normal();
    if (!there.has_filename() && there.has_relative_path()) there = there.parent_path();
    chooser.listing = list_folder(there, chooser.extensions);
    chooser.cursor.reset();
    chooser.name = chooser.offered;
    chooser.remark.clear();
    chooser.focus_name = true;
}

Chosen accept_name(FileChooser& chooser) {
    chooser.remark.clear();
    if (chooser.name.empty() && chooser.use == ChooserUse::save_folder) {
        return accept_to_save_into(chooser, chooser.listing.folder);
    }
    if (chooser.name.empty()) return refused(chooser, lack_of_name(chooser));
    const fs::path path = typed_path(chooser, chooser.name);
    if (is_folder(path)) {
        go_to_folder(chooser, path);
        // A folder that was saved into before, not another one with the same name inside it.
        const bool again = path.filename() == chooser.offered;
        if (chooser.use == ChooserUse::save_folder && again) chooser.name.clear();
        return std::nullopt;
    }
    switch (chooser.use) {
        case ChooserUse::open:
            return accept_to_open(chooser, path);
        case ChooserUse::save:
            return accept_to_save(chooser, path);
        case ChooserUse::save_folder:
            return accept_new_folder(chooser, path);
    }
    return std::nullopt;
}

Chosen accept_folder(FileChooser& chooser) {
    if (!chooser.folders_too || !chooser.listing.fault.empty()) return std::nullopt;
    if (chooser.use == ChooserUse::save_folder) {
        return accept_to_save_into(chooser, chooser.listing.folder);
    }
    return chooser.listing.folder;
}

void make_folder(FileChooser& chooser) {
    const fs::path path = typed_path(chooser, chooser.name);
    std::error_code failure;
    const bool made = !chooser.name.empty() && fs::create_directory(path, failure);
    chooser.makes_folder = false;
    if (made) return go_to_folder(chooser, path);
    chooser.name = chooser.offered;
    chooser.remark = failure ? path.string() + " was not made: " + failure.message() + "."
                             : "No folder was made: there is one of this name.";
}

const char* lack_of_name(const FileChooser& chooser) {
    const bool takes_folder = chooser.use == ChooserUse::save_folder;
    return chooser.name.empty() && !takes_folder ? "Type a name, or pick one from the list." : "";
}

std::string lack_of_files(const FileChooser& chooser) {
    const bool is_any = std::ranges::any_of(chooser.listing.entries,
                                            [](const auto& entry) { return !entry.is_folder; });
    if (is_any) return {};
    if (chooser.extensions.empty()) return "No files here.";
    std::string kinds;
    for (const std::string& one : chooser.extensions) kinds += (kinds.empty() ? "" : ", ") + one;
    return "No " + kinds + " here.";
}

}  // namespace tact
