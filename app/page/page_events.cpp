#include <emscripten.h>
#include <emscripten/html5.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "app/page/page_events.h"
#include "devices/device/halt.h"

// In page.js.
extern "C" {
void page_copy(const char* text);
void page_listen();  // to what html5.h has no function for: pasted texts and dropped files
}

namespace tact {

namespace {

constexpr const char* kCanvas = "#canvas";

// ImGui's numbers of the mouse's buttons.
constexpr int kLeft = 0;
constexpr int kMiddle = 2;

struct NamedCode {
    std::string_view name;  // of the key's place, as the browser has it
    int code;
};

constexpr std::array kNamedCodes = std::to_array<NamedCode>({
    {"Escape", key::kEscape},
    {"Enter", key::kEnter},
    {"NumpadEnter", key::kKeypadEnter},
    {"Tab", key::kTab},
    {"Backspace", key::kBackspace},
    {"Insert", key::kInsert},
    {"Delete", key::kDelete},
    {"ArrowRight", key::kRight},
    {"ArrowLeft", key::kLeft},
    {"ArrowDown", key::kDown},
    {"ArrowUp", key::kUp},
    {"PageUp", key::kPageUp},
    {"PageDown", key::kPageDown},
    {"Home", key::kHome},
    {"End", key::kEnd},
    {"Space", key::kSpace},
    {"ShiftLeft", key::kLeftShift},
    {"ControlLeft", key::kLeftControl},
    {"AltLeft", key::kLeftAlt},
    {"MetaLeft", key::kLeftSuper},
    {"ShiftRight", key::kRightShift},
    {"ControlRight", key::kRightControl},
    {"AltRight", key::kRightAlt},
    {"MetaRight", key::kRightSuper},
    {"Minus", '-'},
    {"Equal", '='},
    {"BracketLeft", '['},
    {"BracketRight", ']'},
    {"Semicolon", ';'},
    {"Quote", '\''},
    {"Backquote", '`'},
    {"Backslash", '\\'},
    {"Comma", ','},
    {"Period", '.'},
    {"Slash", '/'},
    {"NumpadAdd", '+'},
    {"NumpadSubtract", '-'},
    {"NumpadMultiply", '*'},
    {"NumpadDivide", '/'},
    {"NumpadDecimal", '.'},
});

// The code of a key by its place: what it writes on an American keyboard.
int code_of_place(std::string_view place) {
    const bool is_letter = place.size() == 4 && place.starts_with("Key");
    const bool is_digit = place.size() == 6 && place.starts_with("Digit");
    const bool is_keypad = place.size() == 7 && place.starts_with("Numpad");
    if (is_letter || is_digit || is_keypad) return place.back();
    if (place.size() >= 2 && place.size() <= 3 && place[0] == 'F') {
        int number = 0;
        for (const char digit : place.substr(1)) number = 10 * number + (digit - '0');
        return key::kF1 + number - 1;
    }
    for (const NamedCode& named : kNamedCodes) {
        if (named.name == place) return named.code;
    }
    return key::kUnknown;
}

char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// What the key writes without modifiers: the browser says what it writes with them.
char32_t sign_of(const EmscriptenKeyboardEvent& event, int place) {
    const bool is_ascii = event.key[0] > ' ' && event.key[0] < 127 && event.key[1] == '\0';
    const bool is_written = place == key::kSpace || (place > ' ' && place < 127);
    const char written = is_ascii ? lower_letter(event.key[0]) : '\0';
    const bool is_letter = written >= 'a' && written <= 'z';
    const bool is_digit = place >= '0' && place <= '9';
    if (is_letter || (written != '\0' && !event.shiftKey && !is_digit)) {
        return static_cast<char32_t>(written);
    }
    return is_written ? static_cast<char32_t>(lower_letter(static_cast<char>(place))) : 0;
}

KeyChange change_of(const EmscriptenKeyboardEvent& event, bool down) {
    KeyChange change;
    const int place = code_of_place(event.code);
    change.sign = sign_of(event, place);
    change.down = down;
    change.repeat = down && event.repeat;
    const bool writes = change.sign != 0 && (place == key::kUnknown || place < key::kEscape);
    change.code = !writes                                      ? place
                  : change.sign >= U'a' && change.sign <= U'z' ? static_cast<int>(change.sign - 32)
                                                               : static_cast<int>(change.sign);
    return change;
}

// The one character that a key writes; 0: it writes none, as "Enter".
char32_t character_of(const char* key) {
    const auto first = static_cast<unsigned char>(key[0]);
    const std::size_t bytes = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (std::strlen(key) != bytes) return 0;
    if (bytes == 1) return first;
    char32_t code = first & (0x7FU >> bytes);
    for (std::size_t k = 1; k < bytes; ++k) {
        code = (code << 6U) | (static_cast<unsigned char>(key[k]) & 0x3FU);
    }
    return code;
}

void push_now(PageEvents& events, const decltype(InputEvent::what)& what) {
    push(events.input, {page_time_s(), what});
}

PageEvents& events_in(void* user) { return *static_cast<PageEvents*>(user); }

bool is_paste(const EmscriptenKeyboardEvent& event) {
    return (event.ctrlKey || event.metaKey) && std::string_view(event.code) == "KeyV";
}

EM_BOOL on_key_down(int, const EmscriptenKeyboardEvent* event, void* user) {
    PageEvents& events = events_in(user);
    // The text comes with an event of its own, which the key then follows.
    if (is_paste(*event)) return EM_FALSE;
    const KeyChange change = change_of(*event, true);
    push_now(events, change);
    if (change.code == key::kEscape && !event->repeat && events.client.escape) {
        events.client.escape();
    }
    const bool commands = event->ctrlKey || event->metaKey;
    const char32_t character = commands ? 0 : character_of(event->key);
    if (character != 0) push_now(events, Character{character});
    return EM_TRUE;
}

EM_BOOL on_key_up(int, const EmscriptenKeyboardEvent* event, void* user) {
    push_now(events_in(user), change_of(*event, false));
    return EM_TRUE;
}

MouseMove place_of(double x, double y) {
    return {static_cast<float>(x) * page_scale(), static_cast<float>(y) * page_scale()};
}

EM_BOOL on_mouse(int kind, const EmscriptenMouseEvent* event, void* user) {
    PageEvents& events = events_in(user);
    // A press elsewhere on the page is not for the canvas; a drag continues outside.
    push_now(events, place_of(event->targetX, event->targetY));
    if (kind == EMSCRIPTEN_EVENT_MOUSEMOVE) return EM_TRUE;
    constexpr std::array kButtons{0, 2, 1};  // the browser's second is the wheel
    if (event->button >= kButtons.size()) return EM_FALSE;
    const int button = kButtons[event->button];
    const unsigned bit = 1U << static_cast<unsigned>(button);
    const bool down = kind == EMSCRIPTEN_EVENT_MOUSEDOWN;
    if (!down && (events.buttons_held & bit) == 0) return EM_FALSE;
    events.buttons_held = down ? events.buttons_held | bit : events.buttons_held & ~bit;
    push_now(events, MouseButton{button, down});
    return EM_FALSE;  // the browser gives the page the keys by it
}

EM_BOOL on_leave(int, const EmscriptenMouseEvent*, void* user) {
    PageEvents& events = events_in(user);
    if (events.buttons_held == 0) push_now(events, kMouseGone);
    return EM_TRUE;
}

EM_BOOL on_wheel(int, const EmscriptenWheelEvent* event, void* user) {
    // A notch is three lines, or what browsers scroll by for it.
    constexpr double kNotchPx = 100.0;
    constexpr double kNotchLines = 3.0;
    const double notch = event->deltaMode == DOM_DELTA_PIXEL ? kNotchPx : kNotchLines;
    push_now(events_in(user), MouseWheel{static_cast<float>(-event->deltaX / notch),
                                         static_cast<float>(-event->deltaY / notch)});
    return EM_TRUE;
}

float apart_px(const EmscriptenTouchPoint& a, const EmscriptenTouchPoint& b) {
    return static_cast<float>(std::hypot(a.targetX - b.targetX, a.targetY - b.targetY));
}

void press(PageEvents& events, int button, bool down) {
    const unsigned bit = 1U << static_cast<unsigned>(button);
    if (((events.buttons_held & bit) != 0) == down) return;
    events.buttons_held = down ? events.buttons_held | bit : events.buttons_held & ~bit;
    push_now(events, MouseButton{button, down});
}

// Two fingers do what the middle button does, which moves what is shown, and zoom as the wheel
// does: a notch for each tenth that they part.
void pinch(PageEvents& events, const EmscriptenTouchEvent& event) {
    constexpr float kNotch = 1.1F;
    const EmscriptenTouchPoint& a = event.touches[0];
    const EmscriptenTouchPoint& b = event.touches[1];
    const float now_px = apart_px(a, b);
    press(events, kLeft, false);
    push_now(events, place_of(0.5 * static_cast<double>(a.targetX + b.targetX),
                              0.5 * static_cast<double>(a.targetY + b.targetY)));
    press(events, kMiddle, true);
    if (events.is_pinching && now_px > 0.0F && events.pinch_px > 0.0F) {
        const float notches = std::log(now_px / events.pinch_px) / std::log(kNotch);
        push_now(events, MouseWheel{0.0F, notches});
    }
    events.is_pinching = true;
    events.pinch_px = now_px;
}

EM_BOOL on_touch(int kind, const EmscriptenTouchEvent* event, void* user) {
    PageEvents& events = events_in(user);
    const bool ends = kind == EMSCRIPTEN_EVENT_TOUCHEND || kind == EMSCRIPTEN_EVENT_TOUCHCANCEL;
    if (!ends && event->numTouches >= 2) {
        pinch(events, *event);
        return EM_TRUE;
    }
    if (ends) {
        if (event->numTouches <= 1) events.is_pinching = false;
        press(events, kLeft, false);
        press(events, kMiddle, false);
        return EM_TRUE;
    }
    if (events.is_pinching) return EM_TRUE;  // the last finger of two draws nothing
    push_now(events, place_of(event->touches[0].targetX, event->touches[0].targetY));
    if (kind == EMSCRIPTEN_EVENT_TOUCHSTART) press(events, kLeft, true);
    return EM_TRUE;
}

EM_BOOL on_focus(int kind, const EmscriptenFocusEvent*, void* user) {
    PageEvents& events = events_in(user);
    events.focused = kind == EMSCRIPTEN_EVENT_FOCUS;
    push_now(events, FocusChange{events.focused});
    return EM_TRUE;
}

PageEvents* listening = nullptr;  // for what JavaScript calls by name

}  // namespace

extern "C" EMSCRIPTEN_KEEPALIVE void page_pasted(const char* text) {
    listening->clipboard = text;
    for (const bool down : {true, false}) {
        push_now(*listening, KeyChange{'V', down, false, U'v'});
    }
}

extern "C" EMSCRIPTEN_KEEPALIVE void page_dropped(const char* names) {
    std::vector<std::filesystem::path> files;
    for (std::string_view left = names; !left.empty();) {
        const std::size_t end = std::min(left.find('\n'), left.size());
        files.emplace_back(left.substr(0, end));
        left.remove_prefix(std::min(end + 1, left.size()));
    }
    if (listening->client.drop && !files.empty()) listening->client.drop(std::move(files));
    wake_window();
}

// Nobody sees what is felt, and no frame comes to follow it.
extern "C" EMSCRIPTEN_KEEPALIVE void page_hidden() { rest_all(); }

void listen_to_page(PageEvents& events) {
    listening = &events;
    const char* const page = EMSCRIPTEN_EVENT_TARGET_WINDOW;
    emscripten_set_keydown_callback(page, &events, EM_TRUE, on_key_down);
    emscripten_set_keyup_callback(page, &events, EM_TRUE, on_key_up);
    emscripten_set_mousedown_callback(kCanvas, &events, EM_TRUE, on_mouse);
    emscripten_set_mouseup_callback(page, &events, EM_TRUE, on_mouse);
    emscripten_set_mousemove_callback(page, &events, EM_TRUE, on_mouse);
    emscripten_set_mouseleave_callback(kCanvas, &events, EM_TRUE, on_leave);
    emscripten_set_wheel_callback(kCanvas, &events, EM_TRUE, on_wheel);
    emscripten_set_touchstart_callback(kCanvas, &events, EM_TRUE, on_touch);
    emscripten_set_touchmove_callback(kCanvas, &events, EM_TRUE, on_touch);
    emscripten_set_touchend_callback(kCanvas, &events, EM_TRUE, on_touch);
    emscripten_set_touchcancel_callback(kCanvas, &events, EM_TRUE, on_touch);
    emscripten_set_focus_callback(page, &events, EM_TRUE, on_focus);
    emscripten_set_blur_callback(page, &events, EM_TRUE, on_focus);
    page_listen();
}

double page_time_s() { return emscripten_get_now() / 1000.0; }

float page_scale() { return static_cast<float>(emscripten_get_device_pixel_ratio()); }

void copy_in_page(const std::string& text) { page_copy(text.c_str()); }

}  // namespace tact
