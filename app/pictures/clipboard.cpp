#include "app/pictures/clipboard.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/pictures/programs.h"

namespace tact {

Expected<Done> copy_to_clipboard(const Image& image) {
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

}  // namespace tact
