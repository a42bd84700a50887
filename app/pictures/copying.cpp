#include "app/pictures/pictures.h"

#include <imgui.h>
#include <signal.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/pictures/parts.h"
#include "model/io/set/set_file.h"

namespace tact {

namespace {

// What else lies on the clipboard of a desktop is not for us.
bool is_set_text(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != text.npos && text[begin] == '{' &&
           text.substr(begin, 400).find("\"tactspace\"") != text.npos;
}

}  // namespace

void copy_selected(Ui& ui, Workspace& work) {
    PatternSet copied;
    for (const std::size_t index : selected_indices(work)) {
        copied.vibrations.push_back(work.document.set.vibrations[index]);
    }
    work.clipboard_text = print_set(copied);
    work.clipboard = std::move(copied.vibrations);
    ImGui::SetClipboardText(work.clipboard_text.c_str());
    say(ui, work.clipboard.size() == 1 ? "Copied " + work.clipboard[0].name
                                       : "Copied " + patterns_text(work.clipboard.size()));
}

void paste(Ui& ui, Workspace& work) {
    const char* text = ImGui::GetClipboardText();
    std::vector<Vibration> pasted = work.clipboard;
    // From another window, or from an editor in which a set file is open.
    if (text != nullptr && text != work.clipboard_text && is_set_text(text)) {
        Expected<PatternSet> set = parse_set(text, "the clipboard", {});
        if (!set) return complain(ui, "Not pasted: " + set.error().message);
        pasted = std::move(set->vibrations);
    }
    if (pasted.empty()) {
        say(ui, "Nothing to paste: copy a pattern first, here or as the text of a set file");
        return;
    }
    const std::string what = pasted.size() == 1 ? pasted[0].name : patterns_text(pasted.size());
    insert_after_current(work, pasted);
    commit_step(ui, work, pasted.size() == 1 ? "Paste " + what : "Paste patterns");
    say(ui, "Pasted " + what);
}

Expected<Done> copy_to_clipboard(const Image& image) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    const bool wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
    const bool has_wayland = wayland && is_installed("wl-copy");
    if (!has_wayland && !is_installed("xclip")) {
        return Error{std::string("A picture goes to the clipboard by ") +
                     (wayland ? "wl-copy: install wl-clipboard" : "xclip: install xclip")};
    }
    const Expected<std::string> png = png_bytes(image);
    if (!png) return png.error();
    std::FILE* to = popen(has_wayland ? "exec wl-copy --type image/png"
                                      : "exec xclip -selection clipboard -t image/png -i",
                          "w");
    if (to == nullptr) return Error{"the clipboard's program could not be started"};
    const bool written = write_unharmed(to, png->data(), png->size());
    if (pclose(to) == 0 && written) return Done{};
    return Error{"the clipboard's program failed"};
}

bool is_installed(const std::string& program) {
    const char* folders = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    std::string left = folders == nullptr ? "" : folders;
    while (!left.empty()) {
        const std::size_t end = left.find(':');
        std::error_code none;
        if (std::filesystem::exists(std::filesystem::path(left.substr(0, end)) / program, none)) {
            return true;
        }
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return false;
}

bool write_unharmed(std::FILE* to, const void* bytes, std::size_t count) {
    sigset_t pipe;
    sigset_t before;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, &before);
    const bool good = std::fwrite(bytes, 1, count, to) == count && std::fflush(to) == 0;
    const timespec now{};
    if (!good) sigtimedwait(&pipe, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return good;
}

}  // namespace tact
