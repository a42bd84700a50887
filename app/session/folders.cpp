#include "app/session/folders.h"

#include <array>
#include <ctime>

#include "model/system/calendar.h"
#include "model/text/atomic_file.h"

namespace tact {

void keep_private(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;
    const auto tighten = [](const fs::path& path) {
        std::error_code none;
        fs::permissions(path, kOthers, fs::perm_options::remove, none);
    };
    tighten(folder);
    std::error_code fault;
    for (fs::recursive_directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        std::error_code none;
        if (!entry->is_symlink(none)) tighten(entry->path());
    }
}

std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending) {
    const std::time_t now = std::time(nullptr);
    const std::tm local = local_parts(now).value_or(std::tm{});
    std::array<char, 32> stamp{};
    std::strftime(stamp.data(), stamp.size(), "%Y%m%d-%H%M%S", &local);
    const std::string name = prefix + stamp.data();
    std::filesystem::path file = folder / (name + ending);
    for (int n = 2; is_there(file); ++n) {
        file = folder / (name + "-" + std::to_string(n) + ending);
    }
    return file;
}

}  // namespace tact
