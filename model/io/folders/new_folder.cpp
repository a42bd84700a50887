#include "model/io/folders/new_folder.h"

#include <string>
#include <system_error>

#include "model/text/atomic_file.h"

namespace tact {

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
