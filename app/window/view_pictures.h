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

// A copy of the program that does not change while pictures of it are drawn.
struct ViewSnapshot {
    App app;
    std::vector<WindowScroll> scrolled{};  // scroll positions of its panes
};

// Content of a fresh view; places in set.vibrations.
struct ViewChoice {
    PictureView view = PictureView::window;
    std::size_t pattern = 0;
    std::optional<std::size_t> pinned{};      // for comparison
    std::optional<Stage> stage{};             // shown large
    bool tilted = false;                      // the receptors' maps
    bool textbook = false;                    // measured facts over the stages
    int threads = 0;                          // 0: all cores
    int dimensions = 3;                       // of the map
    std::optional<RenderedBy> rendered_by{};  // results for the patterns as a device plays them
};

// The program as it would open on the set, with all results that the view shows.
std::shared_ptr<ViewSnapshot> opened_view(const PatternSet& set, const ViewChoice& choice);

// A copy of the program in the current ImGui context, without jobs, files, hints and effects of the
// mouse.
std::shared_ptr<ViewSnapshot> snapshot_of(const App& app);

// Draws one of the two above, with its playhead at the time.
Picture view_picture(ViewSnapshot& still, PictureView view, double at_s, const PictureSize& size);

}  // namespace tact
