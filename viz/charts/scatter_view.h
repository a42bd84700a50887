// Two numbers of every pair as points, with a monotone fit if there is one: predictions against
// ratings, or a Shepard diagram.
//
// Source    Shepard 1962; the fit is Kruskal's, drawn as the steps it is.
// Input     x and y of every pair, NaN: not drawn; disparities in the same order
// Output    the pair under the mouse and the clicked pair
// Valid     any number; above kMostScatterPoints an even choice of them is drawn, with a remark.
//           The fit is drawn from all of them, as first and last point of each pixel column.
// Left out  zooming, several series.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/units.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

inline constexpr std::size_t kMostScatterPoints = 5000;

struct FitPoint {
    double x = 0.0;
    double fitted = 0.0;

    bool operator==(const FitPoint&) const = default;
};

// Results that need a pass over all pairs: 10,000 patterns have 5e7, too many for one frame.
// A caller with many pairs keeps this beside its fit.
struct ScatterSummary {
    std::optional<Range> x{};     // nullopt: no finite value
    std::optional<Range> y{};     // range of the values and the fit
    std::vector<FitPoint> fit{};  // ordered by x, then by the fit: all, or the ends of fine slices
};

ScatterSummary summary_of(std::span<const double> x, std::span<const double> y,
                          std::span<const double> fitted);

struct ScatterScene {
    std::span<const double> x{};
    std::span<const double> y{};
    std::span<const double> fitted{};         // monotone in x; empty: no fit
    const ScatterSummary* summary = nullptr;  // summary of these; null: computed in each frame
    std::string_view x_title{};               // below the axis
    std::string_view y_title{};               // above the axis
    std::string_view corner{};                // in the lower right corner
    std::optional<std::size_t> selected{};
    std::function<std::vector<std::string>(std::size_t)> readout{};  // lines on a pair
    bool stale = false;
};

struct ScatterAction {
    std::optional<std::size_t> hovered{};
    std::optional<std::size_t> clicked{};
};

ScatterAction draw_scatter(const char* id, const Theme& theme, const Rect& area,
                           const ScatterScene& scene);

// The place of a point on the screen: for tests of the drawing.
ImVec2 scatter_point(const Theme& theme, const Rect& area, const ScatterScene& scene,
                     std::size_t index);

// The corners of the fit's steps on the screen, at most four per pixel column: also for tests.
std::vector<ImVec2> scatter_fit_line(const Theme& theme, const Rect& area,
                                     const ScatterScene& scene);

}  // namespace tact
