#include "app/ui/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>
#include <utility>

#include "model/system/calendar.h"
#include "model/text/natural_order.h"

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

}  // namespace tact
