#include "app/report/preregistration_files.h"

#include <system_error>

#include "app/report/preregistration_page.h"
#include "app/session/folders.h"
#include "model/io/studies_out/preregistration_file.h"
#include "model/text/atomic_file.h"

namespace tact {

Expected<Done> write_preregistration(const std::filesystem::path& folder,
                                     const Preregistration& plan) {
    const std::filesystem::path file = folder / "preregistration.json";
    std::error_code none;
    if (std::filesystem::exists(file, none)) {
        return Error{file.string() +
                     ": expected a folder without a preregistration, which is written once"};
    }
    if (const auto made = make_folder(folder); !made) return made;
    if (const auto written = write_atomically(file, print_preregistration(plan)); !written) {
        return written;
    }
    return write_atomically(folder / "preregistration.html", preregistration_page(plan));
}

}  // namespace tact
