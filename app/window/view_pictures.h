// Pictures of the window or of one of its panes: as it would open on a set, or as it is.
//
// Exact     same input, same bytes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/export/export_state.h"
#include "app/physiology/stages.h"
#include "app/pictures/pictures.h"
#include "app/window/app.h"
#include "devices/calibration/rendering.h"
#include "viz/picture/picture.h"

namespace tact {

// A program that stands still while pictures of it are drawn.
struct StillView {
    App app;
    std::vector<WindowScroll> scrolled{};  // its panes
};

// What a fresh view is to show of its set; places in set.vibrations.
struct ViewChoice {
    PictureView view = PictureView::window;
    std::size_t pattern = 0;
    std::optional<std::size_t> pinned{};      // for comparison
    std::optional<Stage> stage{};             // large
    bool tilted = false;                      // the receptors
    bool textbook = false;                    // measured facts over the stages
    int threads = 0;                          // 0: all cores
    int dimensions = 3;                       // of the map
    std::optional<RenderedBy> rendered_by{};  // results of what a device plays
};

// The program as it would open on the set, with what the view shows computed.
std::shared_ptr<StillView> opened_view(const PatternSet& set, const ViewChoice& choice);

// The program as it is in the current ImGui context, but still: without jobs, files, hints and what
// the mouse does.
std::shared_ptr<StillView> still_view(const App& app);

// Draws a program from one of the two above, with its playhead at the time.
Picture view_picture(StillView& still, PictureView view, double at_s, const PictureSize& size);

}  // namespace tact
