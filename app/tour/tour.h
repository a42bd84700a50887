// A guided tour through the model: it drives the real program on a real pattern, stage by stage,
// and ends with two patterns compared.
//
// Input     any set with a pattern in it; the document is never changed
// Output    a card with the step's text; what the step is about is outlined
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/physiology/physiology_state.h"
#include "app/physiology/stages.h"
#include "app/timeline/playhead.h"
#include "app/timeline/timeline.h"
#include "app/tour/tour_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// Where a step happens.
struct TourScene {
    std::optional<Stage> stage{};  // large; none: all of them
    double speed = 0.0;            // of the playhead; 0: it stands still
    TimeRange range{};             // of no length: the whole pattern
    bool begins = false;           // on the pattern that shows most, with room for the stages
    bool compares = false;         // with the pattern that is farthest away
};

struct TourStep {
    const char* title;
    const char* text;
    TourScene scene{};
};

std::span<const TourStep> tour_steps();

// From the first step, or from where it was left.
void start_tour(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                const ShownMap& shown_map, Physiology& physiology, TourState& tour);
void go_to_step(Workspace& work, Layout& layout, Timeline& timeline, const ShownMap& shown_map,
                Physiology& physiology, TourState& tour, std::size_t step);

// The view is again what it was before; a tour that was not at its end can be taken up again.
void leave_tour(Workspace& work, Layout& layout, Timeline& timeline, Physiology& physiology,
                TourState& tour);

// The card, above everything else in the window.
void draw_tour(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
               const ShownMap& shown_map, Physiology& physiology, TourState& tour,
               const Rect& window);

}  // namespace tact
