// Where a point of a map would go if its vibration were another, without making the map: one row is
// predicted, and the map continues from its present state.
//
// An exact prediction gives the point's place in the map made afterwards, unless another minimum is
// lower then; coarse envelopes give a preview, off by some percent of the map.
//
// Output    a place in the frame of the given map: the others may move as they would, and all of it
//           is turned back onto where they were
// Left out  other minima, except in mapped_again()
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
    std::vector<Waveform> waveforms;  // as they are felt
    PerceptualModelParams model;
    Eigen::MatrixXd points;  // n x k, as they are shown
    // Prediction of these waveforms: its envelopes make places exact, or previews. Null: makes one.
    std::shared_ptr<const Prediction> base{};
};

class MovedPoint {
  public:
    // None when stopped. `row` is the point that moves.
    static std::optional<MovedPoint> of(MapAsItIs map, std::size_t row, int threads,
                                        std::stop_token stop);

    // The place of a waveform.
    struct Place {
        Eigen::RowVectorXd at;
        Dissimilarity pm;  // of the set with the change
    };
    // From any thread.
    std::optional<Place> operator()(const Waveform& changed, std::stop_token stop,
                                    int threads = 0) const;

    // The same with the map made again from all its starts, as an exact one is: the point's final
    // place, other minima included, for a hundred times the work.
    std::optional<Place> mapped_again(const Waveform& changed, std::stop_token stop,
                                      int threads = 0) const;

    const Eigen::MatrixXd& points() const { return map_.points; }
    const Dissimilarity& pm() const { return map_.base->pm; }

  private:
    MovedPoint(MapAsItIs map, std::size_t row) : map_(std::move(map)), row_(row) {}
    std::optional<Place> raw(const Waveform& changed, std::stop_token stop, int threads,
                             bool from_all_starts) const;

    MapAsItIs map_;
    std::size_t row_;
    Eigen::RowVectorXd shift_;  // from where it goes unchanged to where it is shown
};

}  // namespace tact
