#include "app/ui/chooser_answer.h"

#include <algorithm>
#include <system_error>

namespace tact {
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
