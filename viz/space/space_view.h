// The perceptual space: patterns as points, far apart where people would tell them apart.
//
// Input     a 2-D or 3-D map with names and looks; the camera, which the mouse changes
// Output    the point under the mouse and what was clicked
// Valid     any n; names of at most kMostNames points are looked at. At most kMostLinks links,
//           evenly chosen, and the foremost kMostSpreads ellipses are drawn.
// Left out  easing between maps (the caller moves the points).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viz/drawing/theme.h"
#include "viz/space/space_camera.h"

namespace tact {

inline constexpr std::size_t kMostNames = 200;
inline constexpr std::size_t kMostLinks = 4000;   // lines; more would be a blot, and too slow
inline constexpr std::size_t kMostSpreads = 500;  // ellipses

struct SpaceLink {
    std::size_t a = 0;
    std::size_t b = 0;
};

// Places of patterns that there are not: k columns, as the points have.
struct SpaceMaybes {
    const Eigen::MatrixXd* proposals = nullptr;     // could be taken; rings, or null
    std::span<const std::string> proposal_names{};  // a name each
    std::optional<std::size_t> lit{};               // pointed at elsewhere
    const Eigen::MatrixXd* track = nullptr;         // in order, along a number; or null
    std::span<const std::string> track_words{};     // what the number is there
    const Eigen::MatrixXd* cloud = nullptr;         // can be reached; or null
    std::optional<Eigen::RowVectorXd> wanted{};     // where a point was put ...
    std::optional<Eigen::RowVectorXd> reached{};    // ... and the nearest that it can be
};

struct SpaceScene {
    std::span<const std::string> labels{};              // n
    std::span<const PatternLook> looks{};               // n
    const Eigen::MatrixXd* points = nullptr;            // n x 2 or n x 3; never null
    const Eigen::MatrixXd* ghosts = nullptr;            // where the points were before, or null
    double ghost_opacity = 0.0;                         // 1: just left, 0: gone
    bool arrows = false;                                // from the ghosts to the points, with heads
    std::span<const std::vector<std::size_t>> paths{};  // points to join, along a parameter
    std::span<const std::size_t> chosen{};              // a subset, ringed; others step back
    std::span<const std::size_t> faint{};               // filtered out: they step back farther
    std::span<const SpaceLink> links{};                 // pairs that are too close
    // Where each point might be as well, a column a draw, from the point; or empty.
    std::span<const Eigen::Matrix3Xd> spread{};
    std::optional<std::size_t> selected{};
    std::span<const std::size_t> selected_too{};                      // beside it
    std::optional<std::size_t> pointed{};                             // pointed at elsewhere
    std::function<double(std::size_t, std::size_t)> dissimilarity{};  // may be empty
    std::string_view quantity{};                                      // what it is: "PM"
    double length_of_one = 0.0;     // of one of it, in the map; 0: no scale is drawn
    std::string_view point_hint{};  // what a press on a point does, said where the mouse is on one
    SpaceMaybes maybes{};
    bool moves = false;        // a drag of a point moves it, without Alt
    bool takes_place = false;  // the left button says where, and turns and selects nothing
    bool stale = false;
};

struct SpaceAction {
    std::optional<std::size_t> hovered{};
    std::optional<std::size_t> pressed{};  // the left button is down on it
    std::optional<std::size_t> clicked{};  // on release, without a drag
    std::optional<std::size_t> double_clicked{};
    std::optional<std::size_t> right_clicked{};  // on release, without a drag
    // Ctrl+drag from the first to the second, let go there.
    std::optional<SpaceLink> drawn_between{};
    std::optional<std::vector<std::size_t>> enclosed{};  // by a box or a lasso, let go
    std::optional<std::size_t> proposal{};               // under the mouse
    std::optional<std::size_t> proposal_pressed{};       // the left button is down on it
    std::optional<std::size_t> proposal_clicked{};
    std::optional<std::size_t> on_track{};  // the nearest place of the track under the mouse
    // Alt+drag of a point, or any where the scene moves them: which, and where to, in the plane of
    // the screen through it.
    std::optional<std::size_t> moved{};
    std::optional<Eigen::RowVectorXd> moved_to{};
    bool move_ended = false;  // let go there
    // The left button is down there, of a scene that takes a place: in the plane of the screen
    // through the map's middle.
    std::optional<Eigen::RowVectorXd> placed_at{};
    bool with_ctrl = false;      // it is held
    bool clicked_empty = false;  // a click beside all points
    bool camera_changed = false;
};

// Ellipses hold half of where a point might be, by a normal distribution.
//
// Left drag on empty space orbits (pans in 2-D), with Shift draws a box, with Ctrl and Shift a
// lasso; Ctrl+drag from a point draws a line to another; middle or right drag pans, the wheel zooms
// at the mouse, a click on the name of an axis looks along it, a double click on empty space resets
// the camera. A locked camera does not move.
SpaceAction draw_space(const char* id, const Theme& theme, const Rect& pane,
                       const SpaceScene& scene, SpaceCamera& camera);

}  // namespace tact
