#include "model/evaluation/individuals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>

#include "model/common/decompositions.h"
#include "model/common/distributions.h"
#include "model/common/parallel.h"
#include "model/common/random.h"

namespace tact {

namespace {

// The means of participants, or the passes of the only one, as people of their own.
RatingStudy voices_of(const RatingStudy& study) {
    RatingStudy voices{study.labels, study.is_named, participant_means(study)};
    if (voices.judgements.size() > 1) return voices;
    voices.judgements = study.judgements;
    for (std::size_t k = 0; k < voices.judgements.size(); ++k) {
        voices.judgements[k].participant += ", pass " + std::to_string(k + 1);
    }
    return voices;
}

struct VoiceBounds {
    double with_others = 0.0;
    double with_all = 0.0;
};

std::vector<VoiceBounds> bounds_of(const RatingStudy& voices) {
    const std::vector<double> all = mean_ratings(voices).condensed;
    const std::vector<VoiceAgreement> others = agreement_with_others(voices);
    std::vector<VoiceBounds> bounds;
    for (std::size_t k = 0; k < others.size(); ++k) {
        bounds.push_back({others[k].rho, spearman(voices.judgements[k].condensed, all)});
    }
    return bounds;
}

bool is_complete(std::span<const double> values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// A column of a table that has a row a person.
Spread column_spread(const std::vector<PersonAgreement>& people,
                     std::vector<double> PersonAgreement::*column, std::size_t metric) {
    std::vector<double> values;
    for (const PersonAgreement& person : people) values.push_back((person.*column)[metric]);
    return spread_of(values);
}

// Empty where the ratings make no map, or are too few for one.
Eigen::MatrixXd map_of(const Dissimilarity& ratings, const EvaluationParams& params) {
    if (!is_complete(ratings.condensed)) return {};
    MdsParams mds = standard_mds_params(ratings.size, params.dimensions);
    mds.threads = 1;  // people are shared among the threads
    const PerceptualSpace space = nonmetric_mds(ratings, mds);
    return has_map(space) ? space.points : Eigen::MatrixXd();
}

}  // namespace

Spread spread_of(std::span<const double> values) {
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double value) { return !std::isnan(value); });
    std::ranges::sort(known);
    return {mean_known(known), quantile(known, 0.5), quantile(known, 0.25), quantile(known, 0.75),
            known.size()};
}

Ceilings ceilings(const RatingStudy& study, const Reliability& reliability) {
    Ceilings result{reliability.voices,
                    reliability.is_of_one_person,
                    reliability.spearman_brown,
                    reliability.ceiling_of_mean,
                    {},
                    {}};
    std::vector<double> others;
    std::vector<double> all;
    for (const VoiceBounds& one : bounds_of(voices_of(study))) {
        others.push_back(one.with_others);
        all.push_back(one.with_all);
    }
    result.with_others = spread_of(others);
    result.with_all = spread_of(all);
    return result;
}

Individuals individuals(const RatingStudy& study, const RatedSet& rated,
                        std::span<const Dissimilarity> metrics,
                        std::span<const Evaluation> evaluations, const EvaluationParams& params) {
    assert(metrics.size() == evaluations.size() && "an evaluation of each metric");
    const RatingStudy voices{study.labels, study.is_named, participant_means(study)};
    const std::vector<VoiceBounds> bounds = bounds_of(voices);
    Individuals result;
    result.people.resize(bounds.size());
    parallel_for(bounds.size(), params.threads, {}, [&](std::size_t p) {
        const Judgement& said = voices.judgements[p];
        PersonAgreement& person = result.people[p];
        person = {said.participant, bounds[p].with_others, bounds[p].with_all, {}, {}};
        const Eigen::MatrixXd own =
            map_of(among_rated({study.labels.size(), said.condensed}, rated), params);
        for (std::size_t m = 0; m < metrics.size(); ++m) {
            person.rho.push_back(spearman(metrics[m].condensed, said.condensed));
            const auto k = alienation(own, evaluations[m].map);
            person.k.push_back(k ? *k : kNoRating);
        }
    });
    for (std::size_t m = 0; m < metrics.size() && !bounds.empty(); ++m) {
        result.rho.push_back(column_spread(result.people, &PersonAgreement::rho, m));
        result.k.push_back(column_spread(result.people, &PersonAgreement::k, m));
    }
    return result;
}

namespace {

using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr int kMostRounds = 2000;
constexpr double kSettled = 1e-12;  // of a share explained, from round to round

// What is fitted: each one's scalar products by left diag(weights) right', where left becomes
// right.
struct Fit {
    Matrix left, right;  // n x k
    Matrix weights;      // people x k
    double explained = -1.0;
};

// -1/2 J D2 J with a sum of squares of 1; none where all pairs feel alike.
std::optional<Matrix> scalar_products(const Dissimilarity& dissimilarity) {
    const auto n = static_cast<Index>(dissimilarity.size);
    Matrix squares = Matrix::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
            const double d =
                i == j ? 0.0
                       : dissimilarity(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
            squares(i, j) = d * d;
        }
    }
    const Eigen::VectorXd means = squares.rowwise().mean();
    const double mean = means.mean();
    Matrix products(n, n);
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
            products(i, j) = -0.5 * (squares(i, j) - means(i) - means(j) + mean);
        }
    }
    const double size = products.norm();
    if (!(size > 0.0)) return std::nullopt;
    return products / size;
}

// left' S right, of its diagonal: how much of S stands in each dimension.
Eigen::VectorXd shares_in(const Matrix& products, const Fit& fit) {
    const Matrix seen = products * fit.right;
    Eigen::VectorXd shares(fit.left.cols());
    for (Index r = 0; r < shares.size(); ++r) shares(r) = fit.left.col(r).dot(seen.col(r));
    return shares;
}

// The dimensions against each other, as the fit of one person sees them.
Matrix overlap_of(const Fit& fit) {
    return (fit.left.transpose() * fit.left).cwiseProduct(fit.right.transpose() * fit.right);
}

// The least squares over all choices of which weights are 0: of five dimensions 31.
Eigen::VectorXd weights_not_below_zero(const Matrix& overlap, const Eigen::VectorXd& shares) {
    const Index k = shares.size();
    Eigen::VectorXd best = Eigen::VectorXd::Zero(k);
    double most = 0.0;
    for (unsigned chosen = 1; chosen < (1U << static_cast<unsigned>(k)); ++chosen) {
        std::vector<Index> at;
        for (Index r = 0; r < k; ++r) {
            if ((chosen >> static_cast<unsigned>(r)) & 1U) at.push_back(r);
        }
        const Eigen::VectorXd part = solved_symmetric(overlap(at, at), shares(at));
        if (!part.allFinite() || part.minCoeff() < 0.0) continue;
        const double gained = part.dot(shares(at));  // of the sum of squares, at the least squares
        if (gained <= most) continue;
        most = gained;
        best.setZero();
        best(at) = part;
    }
    return best;
}

void fit_weights(Fit& fit, const std::vector<Matrix>& people) {
    const Matrix overlap = overlap_of(fit);
    double explained = 0.0;
    for (std::size_t s = 0; s < people.size(); ++s) {
        const Eigen::VectorXd shares = shares_in(people[s], fit);
        const Eigen::VectorXd weights = weights_not_below_zero(overlap, shares);
        fit.weights.row(static_cast<Index>(s)) = weights.transpose();
        explained += weights.dot(2.0 * shares - overlap * weights);
    }
    fit.explained = explained / static_cast<double>(people.size());
}

void bring_to_length_one(Matrix& columns) {
    for (Index r = 0; r < columns.cols(); ++r) {
        const double length = columns.col(r).norm();
        if (length > 0.0) columns.col(r) /= length;
    }
}

// The best `side` for the other one and the weights; what nobody weighs stays.
void fit_side(Matrix& side, const Matrix& other, const Fit& fit,
              const std::vector<Matrix>& people) {
    Matrix seen = Matrix::Zero(side.rows(), side.cols());
    for (std::size_t s = 0; s < people.size(); ++s) {
        const Matrix products = people[s] * other;
        for (Index r = 0; r < side.cols(); ++r) {
            seen.col(r) += fit.weights(static_cast<Index>(s), r) * products.col(r);
        }
    }
    Matrix normal = (other.transpose() * other).cwiseProduct(fit.weights.transpose() * fit.weights);
    normal.diagonal().array() += 1e-12 * std::max(normal.trace(), 1e-300);
    Matrix inverse(normal.rows(), normal.cols());
    for (Index r = 0; r < normal.cols(); ++r) {
        inverse.col(r) = solved_symmetric(normal, Eigen::VectorXd::Unit(normal.rows(), r));
    }
    const Matrix fitted = seen * inverse;
    if (!fitted.allFinite()) return;
    side = fitted;
    bring_to_length_one(side);
}

// Both sides from their mean: what is fitted is symmetric, so that they come out alike but for
// sign.
void make_symmetric(Fit& fit, const std::vector<Matrix>& people) {
    for (Index r = 0; r < fit.left.cols(); ++r) {
        const double sign = fit.left.col(r).dot(fit.right.col(r)) < 0.0 ? -1.0 : 1.0;
        fit.left.col(r) += sign * fit.right.col(r);
    }
    bring_to_length_one(fit.left);
    fit.right = fit.left;
    fit_weights(fit, people);
}

Fit fit_from(Matrix start, const std::vector<Matrix>& people) {
    bring_to_length_one(start);
    Fit fit{start, start, Matrix::Zero(static_cast<Index>(people.size()), start.cols())};
    fit_weights(fit, people);
    for (int round = 0; round < kMostRounds; ++round) {
        const double before = fit.explained;
        fit_side(fit.left, fit.right, fit, people);
        fit_weights(fit, people);
        fit_side(fit.right, fit.left, fit, people);
        fit_weights(fit, people);
        if (fit.explained - before < kSettled) break;
    }
    make_symmetric(fit, people);
    return fit;
}

Matrix start_of_mean(const std::vector<Matrix>& people, Index k) {
    Matrix sum = people.front();
    for (std::size_t s = 1; s < people.size(); ++s) sum += people[s];
    return symmetric_eigen(sum).vectors.rightCols(k);
}

Matrix start_drawn(Index n, Index k, std::uint64_t stream) {
    RandomStream random{stream};
    Matrix start(n, k);
    for (Index i = 0; i < n; ++i) {
        for (Index r = 0; r < k; ++r) start(i, r) = next_normal(random);
    }
    return start.rowwise() - start.colwise().mean();
}

// Both sides of the fit are the same.
void order_dimensions(Fit& fit) {
    std::vector<Index> order;
    std::vector<double> sizes;
    for (Index r = 0; r < fit.left.cols(); ++r) {
        order.push_back(r);
        sizes.push_back(fit.weights.col(r).squaredNorm());
    }
    std::ranges::stable_sort(order, [&sizes](Index a, Index b) {
        return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
    });
    const Matrix weights = fit.weights(Eigen::all, order);
    Matrix group = fit.left(Eigen::all, order);
    for (Index r = 0; r < group.cols(); ++r) {
        Index farthest = 0;
        group.col(r).cwiseAbs().maxCoeff(&farthest);
        if (group(farthest, r) < 0.0) group.col(r) *= -1.0;
    }
    fit.weights = weights;
    fit.left = fit.right = group;
}

RatingStudy without_unrated(const RatingStudy& study) {
    const std::vector<std::string> unrated = unrated_patterns(study);
    if (unrated.empty()) return study;
    RatingStudy part = study;
    part.labels.clear();
    std::vector<std::size_t> rated;
    for (std::size_t k = 0; k < study.labels.size(); ++k) {
        if (std::ranges::find(unrated, study.labels[k]) != unrated.end()) continue;
        rated.push_back(k);
        part.labels.push_back(study.labels[k]);
    }
    for (Judgement& one : part.judgements) {
        one.condensed = among({study.labels.size(), std::move(one.condensed)}, rated).condensed;
    }
    return part;
}

std::vector<double> mean_weights(const std::vector<PersonWeights>& people) {
    std::vector<double> mean(people.front().weights.size(), 0.0);
    for (const PersonWeights& person : people) {
        for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += person.weights[r];
    }
    for (double& one : mean) one /= static_cast<double>(people.size());
    return mean;
}

}  // namespace

IndividualWeights individual_weights(const RatingStudy& study, int dimensions, int starts,
                                     std::uint64_t seed) {
    const RatingStudy rated = without_unrated(study);
    IndividualWeights result;
    result.labels = rated.labels;
    const auto n = static_cast<Index>(rated.labels.size());
    const Index k = std::clamp(dimensions, 1, kMostWeightedDimensions);
    std::vector<Matrix> people;
    for (const Judgement& one : participant_means(rated)) {
        const bool is_whole =
            std::ranges::all_of(one.condensed, [](double d) { return std::isfinite(d); });
        std::optional<Matrix> products;
        if (is_whole && n > 1) products = scalar_products({rated.labels.size(), one.condensed});
        if (!products) {
            result.left_out.push_back(one.participant);
            continue;
        }
        people.push_back(*std::move(products));
        result.people.push_back({one.participant, {}, 0.0});
    }
    if (people.size() < 2 || n < k + 2) {
        result.people.clear();
        return result;
    }
    Fit best = fit_from(start_of_mean(people, k), people);
    for (int start = 0; start < starts; ++start) {
        Fit fit = fit_from(start_drawn(n, k, random_bits(seed, static_cast<std::uint64_t>(start))),
                           people);
        if (fit.explained > best.explained + 1e-9) best = std::move(fit);
    }
    order_dimensions(best);
    const Matrix overlap = overlap_of(best);
    for (std::size_t s = 0; s < people.size(); ++s) {
        const Eigen::VectorXd weights = best.weights.row(static_cast<Index>(s)).transpose();
        result.people[s].weights.assign(weights.begin(), weights.end());
        result.people[s].explained =
            weights.dot(2.0 * shares_in(people[s], best) - overlap * weights);
    }
    result.mean = mean_weights(result.people);
    result.group = best.left;
    result.explained = best.explained;
    return result;
}

DimensionEnds ends_of(const IndividualWeights& weights, std::size_t dimension) {
    const Eigen::VectorXd places = weights.group.col(static_cast<Eigen::Index>(dimension));
    Eigen::Index low = 0;
    Eigen::Index high = 0;
    places.minCoeff(&low);
    places.maxCoeff(&high);
    return {weights.labels[static_cast<std::size_t>(low)],
            weights.labels[static_cast<std::size_t>(high)]};
}

int shown_weight_dimensions(std::size_t patterns) {
    return patterns < 3 ? 0 : static_cast<int>(std::min<std::size_t>(3, patterns - 2));
}

}  // namespace tact
