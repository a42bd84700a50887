#include "app/manual/open_manual.h"

#include <sys/wait.h>

#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "app/session/child_process.h"
#include "app/session/folders.h"
#include "app/session/program_version.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// In a process of its own: pictures are drawn as the window is, which one thread alone may do.
std::optional<ManualMade> made_manual(const ManualRequest& request, const std::stop_token& stop) {
    const auto folder = make_folder(request.page.parent_path());
    if (!folder) return ManualMade{request.page, folder.error().message};
    const auto process =
        started({request.program.string(), "manual", "--out", request.page.string()});
    if (!process) return ManualMade{request.page, process.error().message};
    const std::optional<int> status = ended(*process, stop);
    if (!status) return std::nullopt;
    if (*status == 0 && is_there(request.page)) return ManualMade{request.page, {}};
    return ManualMade{request.page, "\"tactspace manual --out " + request.page.string() +
                                        "\" in a terminal says why"};
}

// Not if the program was built again since.
bool is_current(const fs::path& page, const fs::path& program) {
    std::error_code none;
    const auto made = fs::last_write_time(page, none);
    if (none) return false;
    const auto built = fs::last_write_time(program, none);
    return !none && made >= built;
}

void forget_ended(ManualState& manual) {
    std::erase_if(manual.openers,
                  [](int process) { return waitpid(process, nullptr, WNOHANG) != 0; });
}

void show_in_browser(Ui& ui, ManualState& manual, const fs::path& page) {
    const auto process = started({"xdg-open", page.string()});
    if (!process) {
        return complain(ui, "No browser can be opened from here; the manual is " + page.string());
    }
    manual.openers.push_back(*process);
    say(ui, "The manual opens in the browser: " + page.string());
}

}  // namespace

fs::path installed_manual(const fs::path& program) {
    return program.parent_path().parent_path() / "share/doc/tactspace/manual.html";
}

fs::path kept_manual() {
    const std::string version(std::strrchr(kProgramVersion, ' ') + 1);
    const fs::path file = fs::path("tactspace") / ("manual-" + version + ".html");
    // Nothing changes the environment while the program runs.
    const char* cache = std::getenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
    if (cache != nullptr && cache[0] == '/') return cache / file;
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    if (home != nullptr && home[0] == '/') return fs::path(home) / ".cache" / file;
    return {};
}

void open_manual(Ui& ui, ManualState& manual) {
    const fs::path installed = installed_manual(manual.program);
    if (!manual.program.empty() && is_there(installed)) {
        return show_in_browser(ui, manual, installed);
    }
    const fs::path kept = kept_manual();
    if (manual.program.empty() || kept.empty()) {
        return complain(ui,
                        "There is no folder to make the manual in; \"tactspace manual --out "
                        "FILE.html\" in a terminal makes it.");
    }
    if (is_current(kept, manual.program)) return show_in_browser(ui, manual, kept);
    if (manual.job.busy()) return;
    manual.job.ask(
        {manual.program, kept},
        [](const ManualRequest& request, const std::stop_token& stop, std::atomic<float>&) {
            return made_manual(request, stop);
        },
        ui.wake, JobPolicy::finish);
    say(ui, "The manual is being made; it opens in a moment.");
}

void take_manual(Ui& ui, ManualState& manual) {
    if (!manual.openers.empty()) forget_ended(manual);
    const auto made = manual.job.latest();
    if (!made || made == manual.shown) return;
    manual.shown = made;
    if (!made->fault.empty()) return complain(ui, "The manual could not be made: " + made->fault);
    show_in_browser(ui, manual, made->page);
}

}  // namespace tact
