#include "app/screen/screen.h"

#include <algorithm>
#include <array>

#include "viz/drawing/imgui_versions.h"

namespace tact {
namespace {

// ImGui asserts that time advances; clicks of one time stamp still need an order.
constexpr double kLeastStepS = 1e-4;
constexpr double kFirstStepS = 1.0 / 60.0;

struct NamedKey {
    int code;
    ImGuiKey name;
};

// What ImGui is told of. Tab is the window's own: ImGui knows fields of text alone. What ImGui
// calls Space presses the focused button: that is Enter, since Space plays, everywhere.
constexpr std::array kNamedKeys =
    std::to_array<NamedKey>({{key::kLeft, ImGuiKey_LeftArrow},
                             {key::kRight, ImGuiKey_RightArrow},
                             {key::kUp, ImGuiKey_UpArrow},
                             {key::kDown, ImGuiKey_DownArrow},
                             {key::kPageUp, ImGuiKey_PageUp},
                             {key::kPageDown, ImGuiKey_PageDown},
                             {key::kHome, ImGuiKey_Home},
                             {key::kEnd, ImGuiKey_End},
                             {key::kInsert, ImGuiKey_Insert},
                             {key::kDelete, ImGuiKey_Delete},
                             {key::kBackspace, ImGuiKey_Backspace},
                             {key::kEnter, ImGuiKey_Space},
                             {key::kEnter, ImGuiKey_Enter},
                             {key::kEscape, ImGuiKey_Escape},
                             {key::kKeypadEnter, ImGuiKey_KeypadEnter},
                             {key::kF1, ImGuiKey_F1},
                             {key::kSpace, kSpaceBar},
                             {'A', ImGuiKey_A},
                             {'C', ImGuiKey_C},
                             {'T', ImGuiKey_T},
                             {'V', ImGuiKey_V},
                             {'X', ImGuiKey_X},
                             {'Y', ImGuiKey_Y},
                             {'Z', ImGuiKey_Z}});

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
    HeldKeys keys;
};

bool is_modifier(int code) { return code >= key::kLeftShift && code <= key::kRightSuper; }
bool has_state(int code) { return code >= 0 && static_cast<std::size_t>(code) < HeldKeys().size(); }

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

void set_held(InputQueue& queue, ImGuiIO& io, int code, bool down) {
    queue.held.set(static_cast<std::size_t>(code), down);
    for (const NamedKey& key : kNamedKeys) {
        if (key.code == code) add_key(io, key.name, down);
    }
}

// Whether the left or the right one is down.
bool is_held(const HeldKeys& held, int left, int right) {
    return held[static_cast<std::size_t>(left)] || held[static_cast<std::size_t>(right)];
}
bool has_ctrl(const HeldKeys& held) { return is_held(held, key::kLeftControl, key::kRightControl); }
bool has_shift(const HeldKeys& held) { return is_held(held, key::kLeftShift, key::kRightShift); }
bool has_alt(const HeldKeys& held) { return is_held(held, key::kLeftAlt, key::kRightAlt); }
bool has_super(const HeldKeys& held) { return is_held(held, key::kLeftSuper, key::kRightSuper); }

void set_modifiers(const HeldKeys& held, ImGuiIO& io) {
    add_modifiers(io, has_ctrl(held), has_shift(held), has_alt(held), has_super(held));
}

void note_press(InputQueue& queue, const KeyChange& change) {
    const auto is_same = [&](const KeyPress& press) { return press.code == change.code; };
    // On slow frames several repeats of a key fall together: they are one, or they would pile up.
    if (change.repeat && std::ranges::any_of(queue.pressed, is_same)) return;
    const HeldKeys& held = queue.held;
    queue.pressed.push_back({change.code, change.sign, change.repeat, has_ctrl(held),
                             has_shift(held), has_alt(held), has_super(held)});
}

void enter(InputQueue& queue, ImGuiIO& io, FrameShare& share, const KeyChange& change) {
    if (has_state(change.code) && !change.repeat) {
        set_held(queue, io, change.code, change.down);
        share.keys.set(static_cast<std::size_t>(change.code));
    }
    if (is_modifier(change.code)) {
        set_modifiers(queue.held, io);
        share.modifier = true;
    } else if (change.down) {
        note_press(queue, change);
        if (change.repeat) return;
        share.press = true;
        share.press_edits = change.sign == 0 || has_ctrl(queue.held) || has_alt(queue.held) ||
                            has_super(queue.held);
    }
}

void enter(InputQueue&, ImGuiIO& io, FrameShare& share, const Character& character) {
    io.AddInputCharacter(character.code);
    share.text = true;
}

// Whoever takes the focus away also gets the releases.
void enter(InputQueue& queue, ImGuiIO& io, FrameShare& share, const FocusChange& change) {
    io.AddFocusEvent(change.focused);
    share.focus = true;
    if (change.focused) return;
    for (int code = 0; has_state(code); ++code) {
        if (queue.held[static_cast<std::size_t>(code)]) set_held(queue, io, code, false);
    }
    std::ranges::fill(io.MouseDown, false);
    set_modifiers(queue.held, io);
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

bool is_anything_held(const InputQueue& queue, const ImGuiIO& io) {
    return queue.held.any() || std::ranges::count(io.MouseDown, true) > 0;
}

}  // namespace tact
