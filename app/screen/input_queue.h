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
#pragma once

#include <imgui.h>

#include <algorithm>
#include <bitset>
#include <cfloat>
#include <deque>
#include <span>
#include <variant>
#include <vector>

namespace tact {

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

}  // namespace tact
