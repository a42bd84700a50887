// Parts that the files of this room share.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/screen/screen.h"

struct GLFWwindow;
struct wl_display;

namespace tact {

// The X server is gone: actuators come to rest, what is to be kept is kept, one sentence is said,
// the program ends with 1.
//
// Xlib ends the program by itself, with whichever thread found out; destructors that then run
// beside the other thread crash it. The program's own thread, which is inside Xlib and so changes
// nothing, does the keeping; any other waits for it.
//
// A Wayland compositor that is gone is noticed by GLFW, which asks every window to close.

// Arms this for the rest of the run. The drawing thread calls it, and calls `keep` once when the
// screen is lost; it answers with what could not be kept, empty: all is. An empty `keep` saves
// nothing.
void end_with_display(std::function<std::string()> keep);

// Ends so if a Wayland compositor is gone; otherwise does nothing. For whoever is asked to close.
void end_if_compositor_is_gone();

// Notices Esc in a window the moment it goes down, while the program's own thread may still be
// drawing.
//
// On X11 a connection of its own to the screen asks for the keys of that window as well: any number
// of clients may. On Wayland it is a keyboard of its own: watch_wayland_escape(). GLFW hears of
// them, too, when it is asked the next time.

class EscapeWatch {
  public:
    // `pressed` is called on another thread, until this is destroyed. Without it nothing is
    // watched.
    EscapeWatch(GLFWwindow* window, std::function<void()> pressed);

  private:
    std::jthread thread_;
};

// The window over the whole of the screen it is on, and back to where it was.
//
// Left out  several screens as one.

struct FullScreen {
    bool is_on = false;
    int x = 0;  // where the window goes back to
    int y = 0;
    int width = 0;
    int height = 0;
};

// Does nothing where it is so already, or where there is no screen to fill.
void set_full_screen(GLFWwindow& window, FullScreen& state, bool wanted);

// What a key is called: by the sign that it writes in the layout of the keyboard.

// The ASCII sign a key writes, in lower case; 0: none. The row of digits counts as digits in every
// layout, and one without Latin letters keeps the letters' places of the US one. Codes are GLFW's.
char32_t sign_of(int code, int scancode);

// Keys that write are named by what they write, in capitals; keypad and the others keep their code.
int code_of(int code, char32_t sign);

// What the system tells of a window: keys and mouse on their way into the queue, files dropped, the
// wish to close, changes of its state.
//
// Input     GLFW's callbacks, on the thread that lets it deliver events
// Left out  whatever is read and not told: sizes, focus at the start of a frame.

struct WindowEvents {
    const WindowClient* client = nullptr;  // told at once of what is more than input
    InputQueue input;
    std::array<int, key::kLast + 1> code_of_key{};  // what a held key meant when it went down
    unsigned buttons_held = 0;                      // one bit each
    bool fonts_outdated = true;                     // they are of another scale, or of none
    bool maximised = false;
    bool side_damaged = false;  // the screen has lost what was in the second window
};

// From now on, until the window is destroyed; `events` stays where it is, and is the window's user
// pointer.
void listen(GLFWwindow& window, WindowEvents& events);

// Keys of the second window count as pressed in the first.
void listen_to_keys(GLFWwindow& side, WindowEvents& events);

struct WindowSize {
    int width = 0;
    int height = 0;
};

WindowSize window_size(GLFWwindow* glfw);       // screen coordinates
WindowSize framebuffer_size(GLFWwindow* glfw);  // pixels

// A second window beside the program's: a picture that is shown where those who look at the first
// one do not see it.
//
// Input     what is to be in it, as a picture to be drawn for its size; keys pressed in it are the
//           program's
// Output    on another screen, where there is one: over the whole of it; else, and on Wayland, a
//           window of its own
// Left out  the mouse

struct SideWindow {
    GLFWwindow* glfw = nullptr;  // null: no window
    std::string shown;           // the key of what is in it
    WindowSize size;             // of what is in it, pixels
    bool failed = false;         // the system gave none: it is not asked again
};

// After a frame of the program's window, whose context is current again afterwards. True, once,
// when the person has closed it.
bool show_side(SideWindow& side, GLFWwindow& main, WindowEvents& events,
               const std::optional<SideContent>& content);

void close_side(SideWindow& side, GLFWwindow& main);

// Whether windows are shown by a Wayland compositor. Nobody is told there where a window is, and
// one that is covered is asked for no frame.

// GLFW's connection to it. Null: windows are X11's, or GLFW is not in use.
wl_display* wayland_display();

// Esc in the windows of a Wayland client, noticed on a thread of its own.
//
// Keys go to every keyboard that a client asked its seat for: a second one, with a queue of its
// own, hears of them while the first one's queue, GLFW's, waits for the drawing thread.

// Until the stop, of which `woken` can be read, or until the compositor is gone. Where Esc is the
// key that most keyboards have it on: other layouts are GLFW's to read.
void watch_wayland_escape(const std::stop_token& stop, wl_display* display, int woken,
                          const std::function<void()>& pressed);

}  // namespace tact
