#include "app/folders.h"

namespace tact {

Expected<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (!fault && std::filesystem::is_directory(folder, fault)) return Done{};
    return Error{folder.string() + ": cannot be made a folder" +
                 (fault ? ": " + fault.message() : "; there is a file of this name")};
}

}  // namespace tact
