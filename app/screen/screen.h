// The window of the system: GLFW, input, Esc.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <bitset>
#include <cfloat>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/common/expected.h"
#include "viz/picture/frame_damage.h"
#include "viz/picture/picture.h"

namespace tact {

// Mouse and keyboard events on their way to ImGui, whose widgets look at their state once a frame:
// a click or a key shorter than a slow frame would be lost.
//
// Each frame takes events from the front of the queue as long as ImGui could still tell what came
// first: not a press with its own release, not a move with a button, one key press at a time. The
// rest waits for the next frame, nothing is dropped and nothing changes places. ImGui's clock
// follows the time stamps, so that two clicks are a double click by when they were made.
//
// Input     events from the window's callbacks or from a test; key codes are GLFW's
// Output    ImGuiIO, filled for one frame
// Left out  gamepads, touch, more than five mouse buttons. Time stamps are those of the polling.

// GLFW's codes of the keys that make no text; for the others the code is the capital letter or
// the ASCII sign.
namespace key {
inline constexpr int kUnknown = -1;
inline constexpr int kSpace = 32;
inline constexpr int kEscape = 256;
inline constexpr int kEnter = 257;
inline constexpr int kTab = 258;
inline constexpr int kBackspace = 259;
inline constexpr int kInsert = 260;
inline constexpr int kDelete = 261;
inline constexpr int kRight = 262;
inline constexpr int kLeft = 263;
inline constexpr int kDown = 264;
inline constexpr int kUp = 265;
inline constexpr int kPageUp = 266;
inline constexpr int kPageDown = 267;
inline constexpr int kHome = 268;
inline constexpr int kEnd = 269;
inline constexpr int kF1 = 290;  // kF1 + 11: F12
inline constexpr int kKeypadEnter = 335;
inline constexpr int kLeftShift = 340;
inline constexpr int kLeftControl = 341;
inline constexpr int kLeftAlt = 342;
inline constexpr int kLeftSuper = 343;
inline constexpr int kRightShift = 344;
inline constexpr int kRightControl = 345;
inline constexpr int kRightAlt = 346;
inline constexpr int kRightSuper = 347;
inline constexpr int kLast = 348;
}  // namespace key

struct MouseMove {
    float x_px = 0.0F;
    float y_px = 0.0F;
};
inline constexpr MouseMove kMouseGone{-FLT_MAX, -FLT_MAX};  // outside the window

struct MouseButton {
    int button = 0;  // 0 left, 1 right, 2 middle
    bool down = false;
};

struct MouseWheel {
    float x = 0.0F;  // notches
    float y = 0.0F;
};

struct KeyChange {
    int code = key::kUnknown;  // by what is written on the key, not where it sits
    bool down = false;
    bool repeat = false;  // of a key held down
    char32_t sign = 0;    // what the key writes without modifiers, in lower case; 0: nothing
};

struct Character {
    char32_t code = 0;
};

struct FocusChange {
    bool focused = false;
};

struct InputEvent {
    double time_s = 0.0;
    std::variant<MouseMove, MouseButton, MouseWheel, KeyChange, Character, FocusChange> what;
};

// A key that went down, or repeated, in this frame: what shortcuts look at.
struct KeyPress {
    int code = key::kUnknown;
    char32_t sign = 0;
    bool repeat = false;
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool super = false;
};

// The Enter of the keypad is one, too.
inline bool was_pressed(std::span<const KeyPress> pressed, int code) {
    return std::ranges::any_of(pressed, [code](const KeyPress& p) {
        return p.code == code || (code == key::kEnter && p.code == key::kKeypadEnter);
    });
}

using HeldKeys = std::bitset<key::kLast + 1>;  // by code

struct InputQueue {
    std::deque<InputEvent> waiting;
    HeldKeys held;                  // as of the current frame
    std::vector<KeyPress> pressed;  // of the current frame
    double clock_s = -1.0;          // ImGui's clock; below zero before the first frame
};

// Puts an event at the end.
void push(InputQueue& queue, const InputEvent& event);

// Events still wait: draw another frame now.
bool pending(const InputQueue& queue);

// Before ImGui::NewFrame: fills `io`, its DeltaTime included, with the next frame's share.
void apply(InputQueue& queue, ImGuiIO& io, double now_s);

// Some key or button is down as far as ImGui knows: it may repeat.
bool is_anything_held(const InputQueue& queue, const ImGuiIO& io);

// The picture of the last frame, kept on the graphics side: the next one paints only what changed.
//
// Left out  anything but OpenGL 3. All calls need the window's context to be current.

struct KeptFrame {
    unsigned framebuffer = 0;
    unsigned texture = 0;
    FramePrint print;  // of what is in it; of no size: nothing is
};

// Paints what differs and puts the whole on the screen's back buffer, width x height pixels.
void paint(KeptFrame& kept, ImDrawData& frame, int width, int height, ImU32 background);

// The next frame is painted again: what pictures are made of has changed.
void forget(KeptFrame& kept);

void destroy(KeptFrame& kept);

// The one window of the program on the screen: GLFW, OpenGL and the loop that draws only on demand.
//
// A frame is drawn after input, after wake_window() and while the client says that something moves;
// otherwise the loop sleeps. ImGui's coordinates are the pixels of the framebuffer, so that text
// is sharp on every screen.
//
// Input     what the client wants drawn, as a set of functions called on this thread
// Output    a window until the client or its user closes it
// Left out  more than a second window, which only shows; gamepads, positions of
// input methods.

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
    // (app/screen/parts.h) and between two frames; perhaps both. Its own frame follows.
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
