// Names beside points, so that none covers another name or another point.
//
// Greedy by priority over eight places around each point. Not the most names possible (that is
// NP-hard, and simulated annealing would make names jump while the map turns), but the important
// ones always come first.
//
// A name beside a point is nearer to that than to any other one; one that stands off has a line to
// its point, which crosses no name. Long names are rather shortened than set above or below.
//
// Source    candidate places: Imhof 1975; greedy point-feature labelling: Christensen, Marks &
//           Shieber 1995.
// Left out  drawing those lines: leader() says where.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "viz/drawing/geometry.h"
#include "viz/space/space_camera.h"

namespace tact {

struct LabelRequest {
    std::size_t disc = 0;  // the point it names
    ImVec2 size{0, 0};
    float least_px = 0.0F;  // it may be shortened to this width; 0: not at all
};

struct LabelField {
    std::span<const Disc> discs{};     // every point, whether named or not
    std::span<const Rect> occupied{};  // other things that no name may cover
    Rect pane;                         // names stay inside
    float gap_px = 3.0F;               // between a point and its name
    // Where none of the eight is free: as far off, then two and three times; 0: only beside it.
    float far_px = 0.0F;
    ImVec2 apart_px{0, 0};  // between two names: across, and one above the other
};

// From the edge of a point to a name that stands off it; none where it stands beside it.
struct Leader {
    ImVec2 from{0, 0};
    ImVec2 to{0, 0};
};
std::optional<Leader> leader(const Disc& disc, const Rect& name, float gap_px);

// For each request, most important first: where its name goes, or nothing if it fits nowhere; less
// wide than asked for where it is to be shortened. Cost is bounded: places that are looked at times
// the points near them.
std::vector<std::optional<Rect>> place_labels(std::span<const LabelRequest> requests,
                                              const LabelField& field);

}  // namespace tact
