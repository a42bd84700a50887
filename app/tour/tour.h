// A guided tour through the model: it drives the real program on a real pattern, stage by stage,
// and ends with two patterns compared.
//
// Input     any set with a pattern in it; the document is never changed
// Output    a card with the step's text; what the step is about is outlined
#pragma once

#include <cstddef>
#include <span>

#include "viz/drawing/geometry.h"

namespace tact {

struct App;

struct TourStep {
    const char* title;
    const char* text;
    void (*enter)(App&);  // brings the program to where the step happens
};

std::span<const TourStep> tour_steps();

// From the first step, or from where it was left.
void start_tour(App& app);
void go_to_step(App& app, std::size_t step);

// The view is again what it was before; a tour that was not at its end can be taken up again.
void leave_tour(App& app);

// The card, above everything else in the window.
void draw_tour(App& app, const Rect& window);

}  // namespace tact
