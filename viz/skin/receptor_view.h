// The receptors of one type in a fingertip, to scale: where they sit, how strongly each is driven,
// and which fire now.
//
// Source    Lim & Park 2023, section 4.1 (rates, hot zone, radius) and Figure 6 (the tilted view).
// Input     the grid of one type, its activation, how recently each receptor fired
// Output    the receptor under the mouse and the receptor clicked
// Valid     any number of receptors; each costs a few quads
// Left out  easing (the caller moves `tilted` and lets flashes fade), what a read-out says (the
//           caller draws it at `hovered_at`), the edge of the finger as a limit (the model has
//           none): receptors beyond it are grey.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "model/physiology/activation.h"
#include "model/physiology/receptor_grid.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"
#include "viz/skin/fingertip.h"

namespace tact {

// What colour and, in the tilted view, height stand for.
enum class ReceptorQuantity {
    rate,      // impulses/s: as fired where that is known, else the mean rate of Eq. 2
    amplitude  // of the propagated wave, as a share of the probe's
};

struct ReceptorScene {
    Receptor receptor = Receptor::meissner;
    const ReceptorGrid* grid = nullptr;  // null: not computed yet
    Activation activation{};
    bool silent = false;  // next to no energy in the channel's band: none of them fires
    // From the probe to the map's edges, the same in maps to compare; no width: as its height.
    double half_extent_mm = 10.5;
    double half_width_mm = 0.0;
    ReceptorQuantity quantity = ReceptorQuantity::rate;
    double largest_hz = 0.0;  // the rate of the strongest colour; 0: the centre's
    // How often the receptor under the probe fires in the whole signal, as a raster shows it. The
    // model may share impulses out so that this is several times what Eq. 2's rate would give.
    std::optional<int> centre_spikes{};
    bool only_leaks = false;     // what fires answers to what its filter leaks
    double times_a_cycle = 0.0;  // that the centre fires, where that is said; 0: it is not
    bool legend = true;          // of the colours, in the caption; false: one stands for all maps
    double duration_s = 1.0;     // of the signal
    std::span<const float> flash{};  // by receptor: 1 fires now, fading to 0; empty: none does
    float tilted = 0.0F;             // 0: seen from above; 1: from the side, values as heights
    std::optional<std::size_t> selected{};
    std::optional<std::size_t> pointed{};  // pointed at elsewhere
    bool stale = false;
};

struct ReceptorAction {
    std::optional<std::size_t> hovered{};
    ImVec2 hovered_at{0, 0};  // the middle of its mark, for a read-out
    std::optional<std::size_t> clicked{};
    bool clicked_empty = false;
};

ReceptorAction draw_receptors(const char* id, const Theme& theme, const Rect& area,
                              const ReceptorScene& scene);

// The half extent, and the half width, at which the fingertip and the reach of all four types are
// in view.
double common_extent_mm(const PerReceptor<Activation>& activation);
double common_width_mm(const PerReceptor<Activation>& activation);

// Where the parts go. Pure, for tests.
struct ReceptorLayout {
    Rect map;
    Rect caption;         // beneath the map or right of it; empty where there is no room
    bool beside = false;  // it is right of it
    SkinView skin;
};

ReceptorLayout receptor_layout(const Theme& theme, const Rect& area, const ReceptorScene& scene);

// Impulses/s of the receptor under the probe: as fired, or by Eq. 2 if that is not known.
double centre_hz(const ReceptorScene& scene);

// 0..1: what a receptor's colour and height show.
double shown_value(const ReceptorScene& scene, double distance_mm);

}  // namespace tact
