#include "app/screen/input_queue.h"

#include <algorithm>
#include <bitset>
#include <type_traits>

namespace tact {
namespace {

// ImGui asserts that time goes on; clicks of one time stamp still need an order.
constexpr double kLeastStepS = 1e-4;
constexpr double kFirstStepS = 1.0 / 60.0;
constexpr std::size_t kKeyCount = std::extent_v<decltype(ImGuiIO::KeysDown)>;

// What the frame being filled already holds.
struct FrameShare {
    bool move = false;
    bool button = false;
    bool wheel = false;
    bool press = false;
    bool press_edits = false;  // the key may do something to a text field besides writing
    bool text = false;
    bool modifier = false;
    bool focus = false;
    std::bitset<kKeyCount> keys;
};

bool is_modifier(int code) { return code >= key::kLeftShift && code <= key::kRightSuper; }
bool has_state(int code) { return code >= 0 && static_cast<std::size_t>(code) < kKeyCount; }

// Whether an event may join the frame. ImGui takes moves first, then the wheel, then text, then
// keys; so what would go backwards in that order, or repeat a kind that has one place, must wait.

bool joins(const FrameShare& share, const MouseMove&) {
    return !share.button && !share.wheel && !share.press && !share.text;
}

// A slider ignores the move of the frame in which it is released, and overlapping widgets need a
// frame to learn which of them is under the mouse.
bool joins(const FrameShare& share, const MouseButton&) {
    return joins(share, MouseMove{}) && !share.move;
}

bool joins(const FrameShare& share, const MouseWheel&) {
    return !share.button && !share.press && !share.text;
}

bool joins(const FrameShare& share, const KeyChange& change) {
    if (change.repeat) return true;  // no change of state; ImGui repeats by itself
    if (has_state(change.code) && share.keys[static_cast<std::size_t>(change.code)]) return false;
    if (!change.down && !is_modifier(change.code)) return true;
    const bool is_after_input = share.button || share.wheel || share.press || share.text;
    return !is_after_input;
}

bool joins(const FrameShare& share, const Character&) {
    return !share.button && !share.press_edits;
}

bool joins(const FrameShare& share, const FocusChange&) {
    return joins(share, MouseButton{}) && !share.modifier && share.keys.none();
}

void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const MouseMove& move) {
    io.MousePos = {move.x_px, move.y_px};
    share.move = true;
}

void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const MouseButton& change) {
    if (change.button < 0 || change.button >= ImGuiMouseButton_COUNT) return;
    io.MouseDown[change.button] = change.down;
    share.button = true;
}

void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const MouseWheel& wheel) {
    io.MouseWheelH += wheel.x;
    io.MouseWheel += wheel.y;
    share.wheel = true;
}

void set_modifiers(ImGuiIO& io) {
    io.KeyShift = io.KeysDown[key::kLeftShift] || io.KeysDown[key::kRightShift];
    io.KeyCtrl = io.KeysDown[key::kLeftControl] || io.KeysDown[key::kRightControl];
    io.KeyAlt = io.KeysDown[key::kLeftAlt] || io.KeysDown[key::kRightAlt];
    io.KeySuper = io.KeysDown[key::kLeftSuper] || io.KeysDown[key::kRightSuper];
}

void note_press(InputQueue& queue, const ImGuiIO& io, const KeyChange& change) {
    const auto is_same = [&](const KeyPress& press) { return press.code == change.code; };
    // On slow frames several repeats of a key fall together: they are one, or they would pile up.
    if (change.repeat && std::ranges::any_of(queue.pressed, is_same)) return;
    queue.pressed.push_back(
        {change.code, change.sign, change.repeat, io.KeyCtrl, io.KeyShift, io.KeyAlt, io.KeySuper});
}

void enter(InputQueue& queue, ImGuiIO& io, FrameShare& share, const KeyChange& change) {
    if (has_state(change.code) && !change.repeat) {
        io.KeysDown[change.code] = change.down;
        share.keys.set(static_cast<std::size_t>(change.code));
    }
    if (is_modifier(change.code)) {
        set_modifiers(io);
        share.modifier = true;
    } else if (change.down) {
        note_press(queue, io, change);
        if (change.repeat) return;
        share.press = true;
        share.press_edits = change.sign == 0 || io.KeyCtrl || io.KeyAlt || io.KeySuper;
    }
}

void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const Character& character) {
    io.AddInputCharacter(character.code);
    share.text = true;
}

// Whoever takes the focus away also gets the releases.
void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const FocusChange& change) {
    io.AddFocusEvent(change.focused);
    share.focus = true;
    if (change.focused) return;
    std::ranges::fill(io.KeysDown, false);
    std::ranges::fill(io.MouseDown, false);
    set_modifiers(io);
}

void advance_clock(InputQueue& queue, ImGuiIO& io, double time_s) {
    const bool is_first = queue.clock_s < 0.0;
    const double step_s = is_first ? kFirstStepS : std::max(time_s - queue.clock_s, kLeastStepS);
    queue.clock_s = is_first ? std::max(time_s, 0.0) : queue.clock_s + step_s;
    io.DeltaTime = static_cast<float>(step_s);
}

}  // namespace

void push(InputQueue& queue, const InputEvent& event) { queue.waiting.push_back(event); }

bool pending(const InputQueue& queue) { return !queue.waiting.empty(); }

void apply(InputQueue& queue, ImGuiIO& io, double now_s) {
    queue.pressed.clear();
    FrameShare share;
    double last_s = now_s;
    const auto take = [&](const auto& event) {
        const bool fits = !share.focus && joins(share, event);
        if (fits) enter(queue, io, share, event);
        return fits;
    };
    while (pending(queue) && std::visit(take, queue.waiting.front().what)) {
        last_s = queue.waiting.front().time_s;
        queue.waiting.pop_front();
    }
    // Behind with the events, ImGui's clock is behind too, and always right about clicks.
    advance_clock(queue, io, pending(queue) ? last_s : now_s);
}

bool is_anything_held(const ImGuiIO& io) {
    return std::ranges::count(io.KeysDown, true) + std::ranges::count(io.MouseDown, true) > 0;
}

void set_key_map(ImGuiIO& io) {
    // Tab is the window's own: ImGui knows fields of text alone.
    io.KeyMap[ImGuiKey_LeftArrow] = key::kLeft;
    io.KeyMap[ImGuiKey_RightArrow] = key::kRight;
    io.KeyMap[ImGuiKey_UpArrow] = key::kUp;
    io.KeyMap[ImGuiKey_DownArrow] = key::kDown;
    io.KeyMap[ImGuiKey_PageUp] = key::kPageUp;
    io.KeyMap[ImGuiKey_PageDown] = key::kPageDown;
    io.KeyMap[ImGuiKey_Home] = key::kHome;
    io.KeyMap[ImGuiKey_End] = key::kEnd;
    io.KeyMap[ImGuiKey_Insert] = key::kInsert;
    io.KeyMap[ImGuiKey_Delete] = key::kDelete;
    io.KeyMap[ImGuiKey_Backspace] = key::kBackspace;
    io.KeyMap[ImGuiKey_Space] = key::kEnter;  // what ImGui calls Space presses the focused button
    io.KeyMap[ImGuiKey_Enter] = key::kEnter;
    io.KeyMap[ImGuiKey_Escape] = key::kEscape;
    io.KeyMap[ImGuiKey_KeyPadEnter] = key::kKeypadEnter;
    io.KeyMap[ImGuiKey_A] = 'A';
    io.KeyMap[ImGuiKey_C] = 'C';
    io.KeyMap[ImGuiKey_V] = 'V';
    io.KeyMap[ImGuiKey_X] = 'X';
    io.KeyMap[ImGuiKey_Y] = 'Y';
    io.KeyMap[ImGuiKey_Z] = 'Z';
}

}  // namespace tact
