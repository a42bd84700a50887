// Pictures of single views without a window: PNG or SVG.
//
// Exact     same input, same bytes.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/set/pattern_set.h"
#include "viz/picture/picture.h"
#include "viz/space/space_view.h"

namespace tact {

enum class PictureFormat { png, svg };

struct PictureSize {
    int width = 1000;
    int height = 900;
    float scale = 1.0F;
    bool dark = true;
    PictureFormat format = PictureFormat::png;
    bool titled = true;     // above what is drawn: what it is
    std::string svg_ids{};  // as PictureOptions has them
};

struct Svg {
    std::string text;
};

using Picture = std::variant<Image, Svg>;  // by the format asked for

// What `draw` draws, in the format asked for.
Picture drawn(const PictureSize& size, const PictureOptions& options,
              const std::function<void(const Theme&)>& draw);

Picture matrix_picture(const std::vector<std::string>& labels, const Dissimilarity& matrix,
                       const std::string& quantity, const PictureSize& size,
                       const std::string& mark = {});

// What a space is drawn with besides its points.
struct SpaceMarks {
    std::span<const std::size_t> chosen{};              // a subset, ringed
    std::span<const SpaceLink> links{};                 // pairs that are too close
    std::span<const std::vector<std::size_t>> paths{};  // patterns to join, along a parameter
    const Eigen::MatrixXd* before = nullptr;  // where the points were, n x k: arrows from there
    std::string quantity = "PM";              // what the matrix is
    std::string source{};                     // where it is from; empty: predicted by that
    std::string mark{};                       // what has to be said of it; empty: nothing
};

Picture space_picture(const PatternSet& set, const Dissimilarity& pm, const PerceptualSpace& space,
                      const PictureSize& size, const SpaceMarks& marks = {});

// Several maps of one set beside each other, one legend for all of them.
struct MapPanel {
    const Dissimilarity* apart = nullptr;  // never null, nor is the other
    const PerceptualSpace* space = nullptr;
    SpaceMarks marks{};
};
Picture space_panels_picture(const PatternSet& set, std::span<const MapPanel> panels,
                             const std::string& title, const std::string& detail,
                             const PictureSize& size);
std::size_t panel_columns(std::size_t panels);  // that they stand in

Picture wave_picture(const Vibration& vibration, const PictureSize& size);

Picture spectrum_picture(const Vibration& vibration, const NeuralCodingParams& params,
                         const PictureSize& size);

// A failed write leaves an existing file as it was.
Expected<Done> write_picture(const std::filesystem::path& path, const Picture& picture);

}  // namespace tact
