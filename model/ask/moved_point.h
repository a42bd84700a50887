// Where a point of a map would go if its vibration were another: by what the preview of a map goes
// by, without making the map.
//
// Output    a place in the frame of the given map: the others are let move as they would, and all
// is
//           turned back onto where they were
// Left out  other minima: the map is not begun anew, as an exact one is
// Exact     same input, same place, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/perceptual_model/perceptual_model.h"
#include "model/signal/waveform.h"

namespace tact {

struct MapAsItIs {
    std::vector<Waveform> waveforms;  // as they are felt, of one length
    PerceptualModelParams model;
    Eigen::MatrixXd points;  // n x k, as they are shown
};

class MovedPoint {
  public:
    // None when stopped. `row` is the point that moves.
    static std::optional<MovedPoint> of(MapAsItIs map, std::size_t row, int threads,
                                        std::stop_token stop);

    // Of a waveform that is padded to the others' length.
    struct Place {
        Eigen::RowVectorXd at;
        Dissimilarity pm;  // of the set with the change, by coarse envelopes
    };
    // From any thread.
    std::optional<Place> operator()(const Waveform& changed, std::stop_token stop,
                                    int threads = 0) const;

    const Eigen::MatrixXd& points() const { return map_.points; }
    const Dissimilarity& pm() const { return coarse_->pm; }
    std::size_t length() const { return map_.waveforms.front().samples_g.size(); }

  private:
    MovedPoint(MapAsItIs map, std::size_t row) : map_(std::move(map)), row_(row) {}
    std::optional<Place> raw(const Waveform& changed, std::stop_token stop, int threads) const;

    MapAsItIs map_;
    std::size_t row_;
    std::shared_ptr<const Prediction> coarse_;
    Eigen::RowVectorXd shift_;  // from where it is by coarse envelopes to where it is shown
};

}  // namespace tact
