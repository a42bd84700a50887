#include "model/subset/concave_bound.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "model/common/decompositions.h"

namespace tact {

namespace {

constexpr std::size_t kStepsPerBound = 8;
// A bound that stays above the floor by a gap is tight enough within this share of the gap.
constexpr double kTightEnough = 0.05;

std::size_t count_of(const Relaxation& relaxation) { return relaxation.objects.size(); }

const double* column(const Eigen::MatrixXd& distances, std::size_t object) {
    return distances.data() + static_cast<Eigen::Index>(object) * distances.rows();
}

void renew_slopes(Relaxation& relaxation, const Eigen::MatrixXd& distances) {
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        const double* to = column(distances, relaxation.objects[u]);
        double slope = relaxation.linear[u] + relaxation.shift * (0.5 - relaxation.share[u]);
        for (std::size_t v = 0; v < count_of(relaxation); ++v) {
            slope += to[relaxation.objects[v]] * relaxation.share[v];
        }
        relaxation.slope[u] = slope;
    }
}

void add_share(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t place,
               double share) {
    if (share == 0.0) return;
    const double* to = column(distances, relaxation.objects[place]);
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        relaxation.slope[u] += share * to[relaxation.objects[u]];
    }
    relaxation.slope[place] -= share * relaxation.shift;
    relaxation.share[place] = std::clamp(relaxation.share[place] + share, 0.0, 1.0);
}

// Where more share would raise the sum most, and where less would lower it least.
struct Ends {
    std::size_t rise = 0;
    std::size_t fall = 0;
};

Ends steepest(const Relaxation& relaxation) {
    Ends ends;
    double most = -std::numeric_limits<double>::infinity();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        if (relaxation.share[u] < 1.0 && relaxation.slope[u] > most) {
            most = relaxation.slope[u];
            ends.rise = u;
        }
        if (relaxation.share[u] > 0.0 && relaxation.slope[u] < least) {
            least = relaxation.slope[u];
            ends.fall = u;
        }
    }
    return ends;
}

// Shares that sum to r, after objects came and went.
void fill_up(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t r) {
    constexpr double kNothing = 1e-12;
    const auto wanted = static_cast<double>(r);
    double sum = std::accumulate(relaxation.share.begin(), relaxation.share.end(), 0.0);
    while (std::abs(sum - wanted) > kNothing) {
        const Ends ends = steepest(relaxation);
        const std::size_t place = sum < wanted ? ends.rise : ends.fall;
        const double room = sum < wanted ? 1.0 - relaxation.share[place] : relaxation.share[place];
        const double step = std::min(room, std::abs(sum - wanted));
        if (step <= 0.0) return;
        add_share(relaxation, distances, place, sum < wanted ? step : -step);
        sum += sum < wanted ? step : -step;
    }
}

// Moves share from one object to another, as far as that raises the sum. False: nowhere.
bool exchange(Relaxation& relaxation, const Eigen::MatrixXd& distances) {
    const auto [rise, fall] = steepest(relaxation);
    const double gain = relaxation.slope[rise] - relaxation.slope[fall];
    if (gain <= 0.0 || rise == fall) return false;
    const double* to_rise = column(distances, relaxation.objects[rise]);
    const double* to_fall = column(distances, relaxation.objects[fall]);
    const double bend = 2.0 * (relaxation.shift + to_rise[relaxation.objects[fall]]);
    double step = std::min(1.0 - relaxation.share[rise], relaxation.share[fall]);
    if (bend > 0.0) step = std::min(step, gain / bend);
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        const std::size_t object = relaxation.objects[u];
        relaxation.slope[u] += step * (to_rise[object] - to_fall[object]);
    }
    relaxation.slope[rise] -= step * relaxation.shift;
    relaxation.slope[fall] += step * relaxation.shift;
    relaxation.share[rise] = std::min(1.0, relaxation.share[rise] + step);
    relaxation.share[fall] = std::max(0.0, relaxation.share[fall] - step);
    return true;
}

TangentBound bound_now(const Relaxation& relaxation, std::size_t r, std::vector<double>& slopes) {
    slopes = relaxation.slope;
    const auto last = slopes.begin() + static_cast<std::ptrdiff_t>(r) - 1;
    std::nth_element(slopes.begin(), last, slopes.end(), std::greater<>{});
    TangentBound result;
    result.last_slope = *last;
    result.next_slope = last + 1 == slopes.end() ? -std::numeric_limits<double>::infinity()
                                                 : *std::max_element(last + 1, slopes.end());
    double rise = 0.0;
    double sum = 0.0;
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        const double x = relaxation.share[u];
        rise += x * relaxation.slope[u];
        sum += 0.5 * x * (relaxation.slope[u] + relaxation.linear[u] + 0.5 * relaxation.shift);
    }
    result.value = relaxation.chosen_sum + sum;
    result.bound = result.value - rise + std::accumulate(slopes.begin(), last + 1, 0.0);
    return result;
}

void remove(Relaxation& relaxation, std::size_t place) {
    for (std::vector<double>* values : {&relaxation.linear, &relaxation.share, &relaxation.slope}) {
        (*values)[place] = values->back();
        values->pop_back();
    }
    relaxation.objects[place] = relaxation.objects.back();
    relaxation.objects.pop_back();
}

}  // namespace

double concave_shift(const Eigen::MatrixXd& distances, std::span<const std::size_t> objects) {
    const auto m = static_cast<Eigen::Index>(objects.size());
    if (m < 2) return 0.0;
    Eigen::MatrixXd among(m, m);
    for (Eigen::Index j = 0; j < m; ++j) {
        const double* to = column(distances, objects[static_cast<std::size_t>(j)]);
        for (Eigen::Index i = 0; i < m; ++i) among(i, j) = to[objects[static_cast<std::size_t>(i)]];
    }
    // P D P without the constant direction: pushed below all others, which its size bounds.
    const Eigen::VectorXd means = among.rowwise().mean();
    among.colwise() -= means;
    among.rowwise() -= means.transpose();
    among.array() += means.mean();
    const double size = among.cwiseAbs().rowwise().sum().maxCoeff();
    among.array() -= 2.0 * size / static_cast<double>(m);
    constexpr double kRounding = 1e-11;
    return symmetric_eigenvalues(among)(m - 1) + kRounding * size;
}

double shift_seconds(std::size_t objects) {
    constexpr double kTried = 200.0;
    static const double of_few_s = [] {
        constexpr auto few = static_cast<Eigen::Index>(kTried);
        Eigen::MatrixXd symmetric(few, few);
        for (Eigen::Index i = 0; i < few; ++i) {
            for (Eigen::Index j = 0; j < few; ++j) {
                symmetric(i, j) = static_cast<double>((i + j) * (i * j + 7) % 101);
            }
        }
        const auto begin = std::chrono::steady_clock::now();
        [[maybe_unused]] const Eigen::VectorXd values = symmetric_eigenvalues(symmetric);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }();
    const double times = static_cast<double>(objects) / kTried;
    return of_few_s * times * times * times;
}

Relaxation relaxed(const Eigen::MatrixXd& distances, std::span<const std::size_t> chosen,
                   std::span<const std::size_t> objects) {
    Relaxation result;
    result.objects.assign(objects.begin(), objects.end());
    const std::size_t m = objects.size();
    result.linear.assign(m, 0.0);
    result.share.assign(m, 0.0);
    result.slope.assign(m, 0.0);
    for (std::size_t a = 0; a < chosen.size(); ++a) {
        const double* to = column(distances, chosen[a]);
        for (std::size_t b = 0; b < a; ++b) result.chosen_sum += to[chosen[b]];
        for (std::size_t u = 0; u < m; ++u) result.linear[u] += to[objects[u]];
    }
    renew_shift(result, distances);
    return result;
}

void renew_shift(Relaxation& relaxation, const Eigen::MatrixXd& distances) {
    relaxation.shift = concave_shift(distances, relaxation.objects);
    relaxation.shift_of = count_of(relaxation);
    renew_slopes(relaxation, distances);
}

void choose(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t place) {
    add_share(relaxation, distances, place, -relaxation.share[place]);
    relaxation.chosen_sum += relaxation.linear[place];
    const double* to = column(distances, relaxation.objects[place]);
    remove(relaxation, place);
    for (std::size_t u = 0; u < count_of(relaxation); ++u) {
        relaxation.linear[u] += to[relaxation.objects[u]];
        relaxation.slope[u] += to[relaxation.objects[u]];
    }
}

void leave_out(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t place) {
    add_share(relaxation, distances, place, -relaxation.share[place]);
    remove(relaxation, place);
}

TangentBound tighten(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t r,
                     double floor) {
    assert(r >= 1 && r <= count_of(relaxation) && "nothing to choose");
    fill_up(relaxation, distances, r);
    std::vector<double> slopes;
    const std::size_t most_steps = 20 + 4 * count_of(relaxation);
    for (std::size_t step = 0;; step += kStepsPerBound) {
        const TangentBound now = bound_now(relaxation, r, slopes);
        const double gap = now.bound - now.value;
        const bool is_tight = gap <= slack_of(now.bound) ||
                              (now.value > floor && gap < kTightEnough * (now.value - floor));
        if (now.bound < floor || is_tight || step >= most_steps) return now;
        for (std::size_t k = 0; k < kStepsPerBound; ++k) {
            if (!exchange(relaxation, distances)) return bound_now(relaxation, r, slopes);
        }
    }
}

double slack_of(double bound) {
    constexpr double kRounding = 1e-10;
    return kRounding * std::abs(bound) + 0.5;
}

}  // namespace tact
