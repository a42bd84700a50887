// Pictures of single views without a window, as the command line makes them.
#pragma once

#include <string>
#include <vector>

#include "model/dissimilarity.h"
#include "model/mds.h"
#include "model/pattern_set.h"
#include "viz/picture.h"

namespace tact {

struct PictureSize {
    int width = 1000;
    int height = 900;
    float scale = 1.0F;
    bool dark = true;
};

Image matrix_picture(const std::vector<std::string>& labels, const Dissimilarity& matrix,
                     const std::string& metric, const PictureSize& size);

Image space_picture(const PatternSet& set, const Dissimilarity& pm, const PerceptualSpace& space,
                    const PictureSize& size);

Image wave_picture(const Vibration& vibration, const PictureSize& size);

Image spectrum_picture(const Vibration& vibration, const NeuralCodingParams& params,
                       const PictureSize& size);

// The whole window as it would open on the set, its map computed.
Image window_picture(const PatternSet& set, int threads, const PictureSize& size);

}  // namespace tact
