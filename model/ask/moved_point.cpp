#include "model/ask/moved_point.h"

#include <utility>

#include "model/map/mds.h"
#include "model/map/procrustes.h"

namespace tact {

namespace {

constexpr std::size_t kCoarseEnvelopes = 10;
constexpr Eigen::Index kMany = 100;

MdsParams following(Eigen::Index objects, Eigen::Index dimensions) {
    MdsParams params;
    params.dimensions = static_cast<int>(dimensions);
    params.random_starts = 0;
    // Where there are many, what is near enough: a step takes a millisecond then.
    params.tolerance = objects > kMany ? 1e-7 : 1e-10;
    params.max_steps = objects > kMany ? 100 : 3000;
    params.threads = 1;
    return params;
}

}  // namespace

std::optional<MovedPoint> MovedPoint::of(MapAsItIs map, std::size_t row, int threads,
                                         std::stop_token stop) {
    MovedPoint result(std::move(map), row);
    if (!result.map_.base) {
        PredictOptions options;
        options.envelope_decimation = kCoarseEnvelopes;
        options.threads = threads;
        options.stop = stop;
        auto coarse = predict(result.map_.waveforms, result.map_.model, options);
        if (!coarse) return std::nullopt;
        result.map_.base = std::make_shared<const Prediction>(*std::move(coarse));
    }
    const auto unchanged = result.raw(result.map_.waveforms[row], stop, threads, false);
    if (!unchanged) return std::nullopt;
    result.shift_ = result.map_.points.row(static_cast<Eigen::Index>(row)) - unchanged->at;
    return result;
}

std::optional<MovedPoint::Place> MovedPoint::raw(const Waveform& changed, std::stop_token stop,
                                                 int threads, bool from_all_starts) const {
    std::vector<Waveform> waveforms = map_.waveforms;
    waveforms[row_] = changed;
    PredictOptions options;
    options.envelope_decimation = map_.base->envelope_decimation;
    options.previous = map_.base.get();
    options.samples = map_.base->codes.front()->samples;  // also where the longest is changed
    options.threads = threads;
    options.stop = stop;
    auto prediction = predict(waveforms, map_.model, options);
    if (!prediction) return std::nullopt;
    MdsParams params = following(map_.points.rows(), map_.points.cols());
    if (from_all_starts) {
        params = standard_mds_params(prediction->pm.size, static_cast<int>(map_.points.cols()));
        params.threads = threads;
    }
    const PerceptualSpace space = from_all_starts
                                      ? nonmetric_mds(prediction->pm, params, stop)
                                      : smacof(prediction->pm, map_.points, params, stop);
    if (stop.stop_requested()) return std::nullopt;
    const ProcrustesFit fit = procrustes(space.points, map_.points, false);
    return Place{fit.aligned.row(static_cast<Eigen::Index>(row_)), std::move(prediction->pm)};
}

std::optional<MovedPoint::Place> MovedPoint::operator()(const Waveform& changed,
                                                        std::stop_token stop, int threads) const {
    auto place = raw(changed, std::move(stop), threads, false);
    if (place) place->at += shift_;
    return place;
}

std::optional<MovedPoint::Place> MovedPoint::mapped_again(const Waveform& changed,
                                                          std::stop_token stop, int threads) const {
    return raw(changed, std::move(stop), threads, true);
}

}  // namespace tact
