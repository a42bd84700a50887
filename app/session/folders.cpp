#include "app/session/folders.h"

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

}  // namespace tact
