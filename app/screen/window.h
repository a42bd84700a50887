// The one window of the program on the screen: GLFW, OpenGL and the loop that draws only on demand.
//
// A frame is drawn after input, after wake_window() and while the client says that something moves;
// otherwise the loop sleeps. ImGui's coordinates are the pixels of the framebuffer, so that text
// is sharp on every screen.
//
// Input     what the client wants drawn, as a set of functions called on this thread
// Output    a window until the client or its user closes it
// Left out  more than a second window, which only shows (side_window.h); gamepads, positions of
// input methods.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/screen/input_queue.h"
#include "model/common/expected.h"
#include "viz/picture/picture.h"

namespace tact {

struct WindowOptions {
    std::string title = "tactspace";
    int width = 1600;  // screen coordinates; kept within the monitor
    int height = 1000;
    bool maximised = false;
    bool visible = true;
};

// What a frame is drawn for.
struct FrameContext {
    double time_s = 0.0;  // since the window opened
    float content_scale = 1.0F;
    std::span<const KeyPress> pressed;
    int width = 0;  // screen coordinates, as in WindowOptions
    int height = 0;
    bool maximised = false;
    bool focused = true;       // keys come here
    bool side_closed = false;  // the person has closed the second window
};

// What is to be in a second window.
struct SideContent {
    std::string key;  // drawn again if this has changed
    std::string title;
    std::function<Image(int width, int height, float content_scale)> draw;
};

// What a frame asks of the window.
struct FrameRequest {
    bool animate = false;                                           // draw the next frame now
    double wake_after_s = std::numeric_limits<double>::infinity();  // or then, without input
    bool rebuild_fonts = false;                                     // before the next frame
    bool close = false;     // after this one, without asking
    std::string title;      // empty: it stays
    std::string reading{};  // for a screen reader, where it reads pages
    ImU32 background = IM_COL32_BLACK;
    bool full_screen = false;
    std::optional<SideContent> side{};  // none: no second window
};

struct WindowClient {
    // Between ImGui::NewFrame and ImGui::Render.
    std::function<FrameRequest(const FrameContext&)> frame;
    // Files dropped on the window.
    std::function<void(std::vector<std::filesystem::path>)> drop;
    // As soon as Esc goes down, on another thread where the screen is X11's
    // (app/screen/escape_watch.h) and between two frames; perhaps both. Its own frame follows.
    std::function<void()> escape;
    // The screen is gone, and the program ends as soon as this returns; on the thread that draws.
    std::function<std::string()> display_gone;
    // The user wants to close the window: may it? Without this, yes.
    std::function<bool()> close;
    // Fills the empty atlas of ImGui::GetIO(); also the place to set the style. Called before the
    // first frame, on another content scale, and on FrameRequest::rebuild_fonts.
    std::function<void(float content_scale)> build_fonts;
    // After the frame is on the screen.
    std::function<void()> after_frame;
    // The window is closed. Not in a browser, whose page goes without a word.
    std::function<void()> end;
};

// More screens than one are plugged in. While a window is open.
bool has_second_screen();

// A dialog of the browser's, whose files come as if dropped on the window; empty where the program
// sees the files of its computer itself.
std::function<void()> file_picker();

// Fingers are what the screen is used by: a phone that shows the page.
bool is_for_fingers();

// Some screen would show a window.
bool display_available();

// Opens the window, makes the ImGui context and returns when the window is closed; in a browser at
// once, while the page keeps the client. An Error says why it cannot open.
Expected<Done> run_window(const WindowOptions& options, const WindowClient& client);

// Has a frame drawn soon; from any thread, without a window too.
void wake_window();

}  // namespace tact
