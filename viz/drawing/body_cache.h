// The columns of waves that are drawn again and again, found once.
//
// A plot that moves in nothing but its playhead has the columns of the frame before. They are known
// by the samples in view and by the view, whoever owns the samples: a stale wave is never drawn.
//
// Exact     as wave_body().
// Left out  an upper bound in bytes: what was not drawn in this frame or the one before goes, once
//           there is more than a window shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "viz/drawing/wave_body.h"

namespace tact {

struct BodyCache {
    struct Kept {
        std::shared_ptr<const WaveBody> body;
        int frame = 0;  // that drew them last
    };
    std::unordered_map<std::uint64_t, Kept> kept;  // by the fingerprint of all that they depend on
};

// As wave_body() of the same; `frame` counts those drawn so far.
std::shared_ptr<const WaveBody> kept_body(BodyCache& cache, int frame,
                                          std::span<const double> samples, double first,
                                          double last, std::size_t columns, const BodyScale& scale);

}  // namespace tact
