// Drops files onto a window of X11, as a file manager does: XDND, version 5.
// drop_files WINDOW FILE...: exit code 0 once the window has taken them.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

#include "tests/support/patience.h"

namespace {

struct Drag {
    Display* display = nullptr;
    Window source = 0;
    Window target = 0;
    std::string uris;

    Atom atom(const char* name) const { return XInternAtom(display, name, False); }

    void tell(const char* what, const std::array<long, 4>& words) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display;
        event.xclient.window = target;
        event.xclient.message_type = atom(what);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(source);
        for (std::size_t k = 0; k < words.size(); ++k) event.xclient.data.l[k + 1] = words[k];
        XSendEvent(display, target, False, NoEventMask, &event);
        XFlush(display);
    }

    // The files, to the window that asks for them.
    void answer(const XSelectionRequestEvent& request) const {
        const auto* bytes = reinterpret_cast<const unsigned char*>(uris.data());
        XChangeProperty(display, request.requestor, request.property, request.target, 8,
                        PropModeReplace, bytes, static_cast<int>(uris.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.display = display;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display, request.requestor, False, NoEventMask, &event);
        XFlush(display);
    }

    // Until the window says so; what it asks for meanwhile it gets.
    bool hears(const char* what) const {
        const auto until = tact::end_of_patience();
        while (std::chrono::steady_clock::now() < until) {
            if (XPending(display) == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                continue;
            }
            XEvent event;
            XNextEvent(display, &event);
            if (event.type == SelectionRequest) answer(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(what)) {
                return event.xclient.data.l[1] != 0;  // GLFW says how many bytes it took
            }
        }
        return false;
    }
};

std::string uri_of(const std::string& path) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string uri = "file://";
    for (const char c : path) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '_' ||
                              c == '-';
        const auto byte = static_cast<unsigned char>(c);
        if (is_plain) {
            uri += c;
        } else {
            uri += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
        }
    }
    return uri + "\r\n";
}

int fault(const char* words) {
    std::cerr << "drop_files: " << words << "\n";
    return 1;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) return 2;
    Drag drag;
    drag.display = XOpenDisplay(nullptr);
    if (drag.display == nullptr) return fault("there is no display");
    drag.target = std::strtoul(words[1], nullptr, 0);
    for (int k = 2; k < count; ++k) drag.uris += uri_of(words[k]);
    drag.source =
        XCreateSimpleWindow(drag.display, DefaultRootWindow(drag.display), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(drag.display, drag.atom("XdndSelection"), drag.source, CurrentTime);
    constexpr long kVersion = 5L << 24;
    constexpr long kPlace = 200L << 16 | 200L;
    drag.tell("XdndEnter", {kVersion, static_cast<long>(drag.atom("text/uri-list")), 0, 0});
    drag.tell("XdndPosition",
              {0, kPlace, CurrentTime, static_cast<long>(drag.atom("XdndActionCopy"))});
    if (!drag.hears("XdndStatus")) return fault("the window takes no files");
    drag.tell("XdndDrop", {0, CurrentTime, 0, 0});
    return drag.hears("XdndFinished") ? 0 : fault("the window did not take these");
}
