#include "model/subset/subset_stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "model/common/random.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

namespace {

constexpr std::size_t kCoarse = 10;  // envelopes at 1 kHz: OC's order hardly changes

constexpr int kOrderReach = 2;  // of filters, either way

template <class Choice>
void turn(RandomStream& random, double share, Choice one, Choice other, Choice& value) {
    if (0.5 * (next_even(random) + 1.0) < share) value = value == one ? other : one;
}

double near(RandomStream& random, double value, double reach) {
    return std::max(0.0, value + reach * next_even(random));
}

int near(RandomStream& random, int order, int reach) {
    const auto steps = static_cast<std::size_t>(2 * reach + 1);
    const int moved = order - reach + static_cast<int>(next_index(random, steps));
    return std::clamp(moved, static_cast<int>(limits::kFilterOrder.low),
                      static_cast<int>(limits::kFilterOrder.high));
}

void turn_choices(RandomStream& random, double share, PerceptualModelParams& params) {
    NeuralCodingParams& coding = params.coding;
    turn(random, share, Components::all, Components::peaks, coding.components);
    turn(random, share, Subthreshold::ignored, Subthreshold::subtracted, coding.subthreshold);
    turn(random, share, WindowSplit::halves, WindowSplit::first, coding.split);
    turn(random, share, FireSharing::total, FireSharing::own, coding.share);
    turn(random, share, EnvelopeAlignment::causal, EnvelopeAlignment::centred,
         params.envelope.alignment);
    // A bandpass has its order at either edge: half the reach.
    coding.band_pass_order_per_edge =
        near(random, coding.band_pass_order_per_edge, kOrderReach / 2);
    coding.low_pass_order = near(random, coding.low_pass_order, kOrderReach);
    coding.inhibitory.centre = near(random, coding.inhibitory.centre, 1.0);
}

// Envelopes are the dearest part, and few draws differ in them: one prediction of each kind is kept
// for the next draw to take its pairs from.
class Predictions {
  public:
    Predictions(const PatternSet& set, const StabilityParams& params)
        : waveforms_(own_waveforms(set, params.threads)) {
        options_.threads = params.threads;
        options_.stop = params.stop;
        options_.envelope_decimation = kCoarse;
    }

    const Prediction* of(const PerceptualModelParams& params) {
        std::optional<Prediction>& last =
            last_[params.envelope.alignment == EnvelopeAlignment::causal ? 0 : 1];
        options_.previous = last ? &*last : nullptr;
        std::optional<Prediction> next = predict(waveforms_, params, options_);
        if (!next) return nullptr;
        last = std::move(next);
        return &*last;
    }

  private:
    std::vector<Waveform> waveforms_;
    PredictOptions options_;
    std::array<std::optional<Prediction>, 2> last_;
};

// Where maps put their points beside where the first one has them, to which they are turned. The
// first draw is the model itself: its map, of coarse envelopes as theirs, is what they differ from.
class Cloud {
  public:
    Cloud(const Eigen::MatrixXd& points, std::size_t draws)
        : points_(points),
          moves_(static_cast<std::size_t>(points.rows()),
                 Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(draws))) {}

    void add(const Eigen::MatrixXd& map) {
        if (count_ == 0) first_ = procrustes(map, points_).aligned;
        const Eigen::MatrixXd away = procrustes(map, first_).aligned - first_;
        const Eigen::Index axes = std::min<Eigen::Index>(away.cols(), 3);
        for (Eigen::Index i = 0; i < away.rows(); ++i) {
            moves_[static_cast<std::size_t>(i)].col(count_).head(axes) =
                away.row(i).head(axes).transpose();
        }
        ++count_;
    }

    // Draws without a map have none.
    std::vector<Eigen::Matrix3Xd> moves() && {
        for (Eigen::Matrix3Xd& one : moves_) one.conservativeResize(3, count_);
        return std::move(moves_);
    }

  private:
    const Eigen::MatrixXd& points_;
    Eigen::MatrixXd first_;
    std::vector<Eigen::Matrix3Xd> moves_;
    Eigen::Index count_ = 0;
};

// From the set's own map: another start would find another map of the same matrix.
PerceptualSpace near_map(const Dissimilarity& pm, const Eigen::MatrixXd& points,
                         std::stop_token stop) {
    MdsParams params;
    params.dimensions = static_cast<int>(points.cols());
    params.tolerance = 1e-6;
    params.max_steps = 300;
    params.threads = 1;
    return smacof(pm, points, params, stop);
}

}  // namespace

PerceptualModelParams drawn_params(const PerceptualModelParams& params,
                                   const StabilityParams& stability, std::size_t draw) {
    PerceptualModelParams drawn = params;
    if (draw == 0) return drawn;
    RandomStream random{random_bits(stability.seed, draw)};
    for (Curve& threshold : drawn.coding.tables.threshold) {
        const double decades = stability.threshold_db / 20.0 * next_even(random);
        for (double& value : threshold.value) value += decades;
    }
    for (double& weight : drawn.channel_weight)
        weight = near(random, weight, stability.weight_step);
    drawn.nc_weight = near(random, params.nc_weight, stability.weight_step);
    drawn.oc_weight = near(random, params.oc_weight, stability.weight_step);
    if (stability.turned_share > 0.0) turn_choices(random, stability.turned_share, drawn);
    return drawn;
}

std::vector<std::size_t> ever_picked(const Stability& stability) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < stability.share_picked.size(); ++k) {
        const bool is_member = std::ranges::binary_search(stability.subset.members, k);
        if (is_member || stability.share_picked[k] > 0.0) order.push_back(k);
    }
    std::ranges::stable_sort(order, std::greater<>{},
                             [&](std::size_t k) { return stability.share_picked[k]; });
    return order;
}

std::optional<Stability> subset_stability(const PatternSet& set, const SubsetProblem& problem,
                                          const Subset& subset, const Eigen::MatrixXd& points,
                                          const StabilityParams& params) {
    const std::size_t n = set.vibrations.size();
    Predictions predictions(set, params);
    Cloud cloud(points, params.draws);
    std::vector<std::size_t> picked(n, 0);
    std::size_t same = 0;
    std::size_t weakest = 0;
    SubsetOptions options;
    options.time_limit_s = params.time_limit_s;
    options.threads = params.threads;
    options.stop = params.stop;
    for (std::size_t draw = 0; draw < params.draws; ++draw) {
        const Prediction* prediction = predictions.of(drawn_params(set.model, params, draw));
        if (prediction == nullptr) return std::nullopt;
        const auto answer = most_distinct_subset(prediction->pm, problem, options);
        if (!answer || params.stop.stop_requested()) return std::nullopt;
        for (const std::size_t member : answer->best.members) ++picked[member];
        same += answer->best.members == subset.members ? 1U : 0U;
        weakest += subset_of(prediction->pm, subset.members).weakest == subset.weakest ? 1U : 0U;
        const PerceptualSpace map = near_map(prediction->pm, points, params.stop);
        if (map.points.rows() == points.rows()) cloud.add(map.points);
        if (params.progress) {
            params.progress(static_cast<double>(draw + 1) / static_cast<double>(params.draws));
        }
    }
    const double draws = std::max(1.0, static_cast<double>(params.draws));
    Stability result{params.draws, subset, {}, 0.0, 0.0, std::move(cloud).moves()};
    for (const std::size_t count : picked) {
        result.share_picked.push_back(static_cast<double>(count) / draws);
    }
    result.share_same = static_cast<double>(same) / draws;
    result.share_weakest = static_cast<double>(weakest) / draws;
    return result;
}

}  // namespace tact
