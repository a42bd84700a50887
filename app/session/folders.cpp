#include "app/session/folders.h"

#include <array>
#include <ctime>

namespace tact {

bool is_there(const std::filesystem::path& path) {
    std::error_code none;
    return std::filesystem::exists(path, none);
}

Expected<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (!fault && std::filesystem::is_directory(folder, fault)) return Done{};
    return Error{folder.string() + ": cannot be made a folder" +
                 (fault ? ": " + fault.message() : "; there is a file of this name")};
}

std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending) {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
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
