// The receptors of one type in a fingertip, to scale: their places, how strongly each is driven,
// and which of them fire now.
//
// Source    Lim & Park 2023, section 4.1 (rates, hot zone, radius) and Figure 6 (the tilted view).
// Input     the grid of one type, its activation, how recently each receptor fired
// Output    the receptor under the mouse and the clicked receptor
// Valid     any number of receptors; each costs a few quads
// Left out  easing (the caller moves `tilted` and lets flashes fade), the text of the read-out (the
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

// The quantity shown by colour and, in the tilted view, by height.
enum class ReceptorQuantity {
    rate,      // impulses/s: counted if known, otherwise the mean rate of Eq. 2
    amplitude  // amplitude of the propagated wave, relative to the probe's
};

struct ReceptorScene {
    Receptor receptor = Receptor::meissner;
    const ReceptorGrid* grid = nullptr;  // null: not computed yet
    Activation activation{};
    bool silent = false;  // nearly no energy in the channel's band: none of them fires
    // From the probe to the map's edges, the same in all compared maps; width 0: as the height.
    double half_extent_mm = 10.5;
    double half_width_mm = 0.0;
    ReceptorQuantity quantity = ReceptorQuantity::rate;
    double largest_hz = 0.0;  // the rate of the strongest colour; 0: the centre's
    // Spikes of the receptor under the probe in the whole signal, as counted in a raster. The model
    // may share impulses out so that this is several times the rate of Eq. 2.
    std::optional<int> centre_spikes{};
    bool only_leaks = false;     // spikes only follow the filter's leak
    double times_a_cycle = 0.0;  // impulses of the centre per cycle, if the caption tells them; 0:
                                 // it does not
    bool legend = true;          // colour scale in the caption; false: all maps share one
    double duration_s = 1.0;     // length of the signal
    std::span<const float> flash{};  // by receptor: 1 fires now, fading to 0; empty: none fires
    float tilted = 0.0F;             // 0: seen from above; 1: from the side, values as heights
    std::optional<std::size_t> selected{};
    std::optional<std::size_t> pointed{};  // under the mouse elsewhere
    bool stale = false;
};

struct ReceptorAction {
    std::optional<std::size_t> hovered{};
    ImVec2 hovered_at{0, 0};  // the centre of its mark, for a read-out
    std::optional<std::size_t> clicked{};
    bool clicked_empty = false;
};

ReceptorAction draw_receptors(const char* id, const Theme& theme, const Rect& area,
                              const ReceptorScene& scene);

// The half extent, and the half width, that show the fingertip and the reach of all four types.
double common_extent_mm(const PerReceptor<Activation>& activation);
double common_width_mm(const PerReceptor<Activation>& activation);

// Places of the parts. Pure, for tests.
struct ReceptorLayout {
    Rect map;
    Rect caption;         // beneath the map or right of it; empty if there is no room
    bool beside = false;  // the caption is right of the map
    SkinView skin;
};

ReceptorLayout receptor_layout(const Theme& theme, const Rect& area, const ReceptorScene& scene);

// Impulses/s of the receptor under the probe: counted, or by Eq. 2 if the count is not known.
double centre_hz(const ReceptorScene& scene);

// The value behind a receptor's colour and height, 0..1.
double shown_value(const ReceptorScene& scene, double distance_mm);

}  // namespace tact
