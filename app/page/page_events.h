// What a page tells of its canvas: keys, mouse and fingers on their way into the queue, text on its
// clipboard, files dropped.
//
// Input     events of the browser, between two frames
// Output    what GLFW would have told: codes of its keys, pixels of the canvas
// Left out  input methods; what a browser keeps for itself (Ctrl+W, Ctrl+T, Ctrl+N); fingers from
// the
//           third on
// Source    UI Events and Touch Events of the W3C; emscripten/html5.h
#pragma once

#include <string>

#include "app/screen/screen.h"

namespace tact {

struct PageEvents {
    WindowClient client;  // told at once of what is more than input
    InputQueue input;
    std::string clipboard;  // as of the last copy here or the last paste
    bool fonts_outdated = true;
    bool focused = true;
    unsigned buttons_held = 0;  // one bit each
    bool is_pinching = false;
    float pinch_px = 0.0F;  // between two fingers, as of their last move
};

// From now on, until the page is gone; `events` stays where it is.
void listen_to_page(PageEvents& events);

// Seconds since the page was opened.
double page_time_s();

// Pixels of the screen for each of the page's own.
float page_scale();

// Puts a text on the browser's clipboard; a browser may want a click or a key before it.
void copy_in_page(const std::string& text);

}  // namespace tact
