#include "model/subset/subset_stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/common/random.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/perceptual_model/perceptual_model.h"

namespace tact {

namespace {

constexpr std::size_t kCoarse = 10;  // envelopes at 1 kHz: OC's order hardly changes

bool toss(RandomStream& random) { return next_even(random) < 0.0; }

double near(RandomStream& random, double value, double reach) {
    return std::max(0.0, value + reach * next_even(random));
}

void toss_choices(RandomStream& random, PerceptualModelParams& params) {
    NeuralCodingParams& coding = params.coding;
    coding.components = toss(random) ? Components::all : Components::peaks;
    coding.subthreshold = toss(random) ? Subthreshold::ignored : Subthreshold::subtracted;
    coding.split = toss(random) ? WindowSplit::halves : WindowSplit::first;
    coding.share = toss(random) ? FireSharing::total : FireSharing::own;
    coding.band_pass_order_per_edge = 4 + static_cast<int>(next_index(random, 3));
    coding.low_pass_order = 8 + static_cast<int>(next_index(random, 5));
    coding.inhibitory.centre = near(random, coding.inhibitory.centre, 1.0);
    params.envelope.alignment =
        toss(random) ? EnvelopeAlignment::causal : EnvelopeAlignment::centred;
}

// Envelopes are the dearest part, and few draws differ in them: one prediction of each kind is kept
// for the next draw to take its pairs from.
class Predictions {
  public:
    Predictions(const PatternSet& set, const StabilityParams& params)
        : waveforms_(model_waveforms(set)) {
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

// Sums of points that are turned to a map.
class Cloud {
  public:
    explicit Cloud(const Eigen::MatrixXd& points)
        : points_(points),
          sum_(Eigen::MatrixXd::Zero(points.rows(), points.cols())),
          products_(static_cast<std::size_t>(points.rows()), Eigen::Matrix3d::Zero()) {}

    void add(const Eigen::MatrixXd& map) {
        const Eigen::MatrixXd away = procrustes(map, points_).aligned - points_;
        sum_ += away;
        ++count_;
        for (Eigen::Index i = 0; i < away.rows(); ++i) {
            const Eigen::Vector3d d = in_space(away, i);
            products_[static_cast<std::size_t>(i)] += d * d.transpose();
        }
    }

    std::vector<Eigen::Matrix3d> covariance() const {
        std::vector<Eigen::Matrix3d> result = products_;
        if (count_ < 2) return std::vector<Eigen::Matrix3d>(result.size(), Eigen::Matrix3d::Zero());
        const auto count = static_cast<double>(count_);
        for (Eigen::Index i = 0; i < sum_.rows(); ++i) {
            const Eigen::Vector3d mean = in_space(sum_, i) / count;
            Eigen::Matrix3d& c = result[static_cast<std::size_t>(i)];
            c = (c - count * mean * mean.transpose()) / (count - 1.0);
        }
        return result;
    }

  private:
    static Eigen::Vector3d in_space(const Eigen::MatrixXd& points, Eigen::Index i) {
        Eigen::Vector3d p = Eigen::Vector3d::Zero();
        for (Eigen::Index k = 0; k < std::min<Eigen::Index>(points.cols(), 3); ++k) {
            p(k) = points(i, k);
        }
        return p;
    }

    const Eigen::MatrixXd& points_;
    Eigen::MatrixXd sum_;
    std::vector<Eigen::Matrix3d> products_;
    std::size_t count_ = 0;
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
    RandomStream random{random_bits(stability.seed, draw)};
    PerceptualModelParams drawn = params;
    for (Curve& threshold : drawn.coding.tables.threshold) {
        const double decades = stability.threshold_db / 20.0 * next_even(random);
        for (double& value : threshold.value) value += decades;
    }
    for (double& weight : drawn.channel_weight)
        weight = near(random, weight, stability.weight_step);
    drawn.nc_weight = near(random, params.nc_weight, stability.weight_step);
    drawn.oc_weight = near(random, params.oc_weight, stability.weight_step);
    if (stability.toss_choices) toss_choices(random, drawn);
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
    Cloud cloud(points);
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
    Stability result{params.draws, subset, {}, 0.0, 0.0, cloud.covariance()};
    for (const std::size_t count : picked) {
        result.share_picked.push_back(static_cast<double>(count) / draws);
    }
    result.share_same = static_cast<double>(same) / draws;
    result.share_weakest = static_cast<double>(weakest) / draws;
    return result;
}

}  // namespace tact
