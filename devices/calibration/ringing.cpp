#include "devices/calibration/ringing.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "model/common/decompositions.h"

namespace tact {

namespace {

constexpr double kSharp = 1.7;  // times as strong as a third of an octave beside it
constexpr double kMostOffDb = 0.3;
constexpr double kBesides = 1.25;  // a third of an octave, but for rounding
constexpr double kAround = 1.43;   // half an octave, likewise
constexpr double kRunUpS = 0.5;    // of the signal before the first tone
constexpr int kMostSteps = 12;
constexpr std::size_t kFewest = 5;
constexpr double kDbPerLog = 20.0 / std::numbers::ln10;

using Three = Eigen::Vector3d;  // logarithms of f0, Q and g

double shape(double f0_hz, double q, double f_hz) {
    const double u = (f0_hz / f_hz) * (f0_hz / f_hz);
    return 1.0 / std::sqrt((1.0 - u) * (1.0 - u) + u / (q * q));
}

// A cubic through four samples.
double half_a_sample_ago(const std::vector<double>& drive, std::size_t n) {
    const auto at = [&](std::size_t place) { return place < drive.size() ? drive[place] : 0.0; };
    if (n < 2) return 0.0;
    return (9.0 * (at(n - 1) + at(n)) - at(n - 2) - at(n + 1)) / 16.0;
}

// The acceleration of the mass on its spring. Each sample is held until the next one, which is as
// if all of them came half a sample later.
void ring(const Three& log_of, const std::vector<double>& drive, std::size_t begin, std::size_t end,
          double rate_hz, std::vector<double>& moved) {
    const double w = 2.0 * std::numbers::pi * std::exp(log_of(0));
    const double a = 0.5 * w / std::exp(log_of(1));
    const double turn = std::sqrt(w * w - a * a);
    const double fall = std::exp(-a / rate_hz);
    const double c = fall * std::cos(turn / rate_hz);
    const double s = fall * std::sin(turn / rate_hz) / turn;
    const double g = std::exp(log_of(2));
    double x = 0.0;
    double v = 0.0;
    for (std::size_t n = begin; n < end; ++n) {
        moved[n] = g * (half_a_sample_ago(drive, n) - 2.0 * a * v - w * w * x);
        const double place = drive[n] / (w * w);
        const double from = x - place;
        x = (c + a * s) * from + s * v + place;
        v = -w * w * s * from + (c - a * s) * v;
    }
}

// Points first .. last of a table, and the tones that they were measured by.
struct Peak {
    const CalibrationPlan& plan;
    std::vector<CalibrationTone> tones;
    std::vector<double> logs;   // of the strengths measured
    std::vector<double> moved;  // room for the signal
};

// Logarithms of the strengths that would be measured.
Eigen::VectorXd measured_of(Peak& peak, const Three& log_of) {
    const double rate_hz = peak.plan.drive.rate_hz;
    std::size_t begin = peak.moved.size();
    std::size_t end = 0;
    for (const CalibrationTone& tone : peak.tones) {
        begin = std::min(begin, tone.begin);
        end = std::max(end, tone.end);
    }
    begin -= std::min(begin, static_cast<std::size_t>(kRunUpS * rate_hz));
    ring(log_of, peak.plan.drive.samples, begin, std::min(end, peak.moved.size()), rate_hz,
         peak.moved);
    Eigen::VectorXd logs(std::ssize(peak.tones));
    for (std::size_t k = 0; k < peak.tones.size(); ++k) {
        const ToneFit fit = fit_of(peak.plan, peak.tones[k], peak.moved, 0);
        logs(static_cast<Eigen::Index>(k)) =
            std::log(std::max(fit.amplitude_g, 1e-12) / peak.tones[k].level);
    }
    return logs;
}

Eigen::VectorXd missing(Peak& peak, const Three& log_of) {
    const auto count = std::ssize(peak.logs);
    return Eigen::Map<const Eigen::VectorXd>(peak.logs.data(), count) - measured_of(peak, log_of);
}

Three best_of_grid(const Peak& peak) {
    Three best = Three::Zero();
    double least = std::numeric_limits<double>::infinity();
    const double low_hz = peak.tones.front().frequency_hz;
    const double high_hz = peak.tones.back().frequency_hz;
    for (int place = 0; place <= 100; ++place) {
        const double f0_hz = low_hz * std::pow(high_hz / low_hz, place / 100.0);
        for (const double q : {3.0, 6.0, 12.0, 25.0, 50.0}) {
            double sum = 0.0;
            double squares = 0.0;
            for (std::size_t k = 0; k < peak.tones.size(); ++k) {
                const double off =
                    peak.logs[k] - std::log(shape(f0_hz, q, peak.tones[k].frequency_hz));
                sum += off;
                squares += off * off;
            }
            const auto count = static_cast<double>(peak.tones.size());
            if (squares - sum * sum / count >= least) continue;
            least = squares - sum * sum / count;
            best = {std::log(f0_hz), std::log(q), sum / count};
        }
    }
    return best;
}

// One step towards the least squares; false: no step is better.
bool step(Peak& peak, Three& log_of, Eigen::VectorXd& off) {
    constexpr double kSmall = 1e-4;
    Eigen::MatrixXd slope(off.size(), 3);
    for (int p = 0; p < 3; ++p) {
        Three beside = log_of;
        beside(p) += kSmall;
        slope.col(p) = (off - missing(peak, beside)) / kSmall;
    }
    const Eigen::MatrixXd normal = slope.transpose() * slope;
    const Eigen::VectorXd right = slope.transpose() * off;
    Three change = solved_symmetric(normal, right);
    const Three most(0.02, 0.5, 0.5);
    change = change.cwiseMax(-most).cwiseMin(most);
    for (double share = 1.0; share > 0.05; share /= 2.0) {
        Three next = log_of + share * change;
        next(1) = std::clamp(next(1), std::log(0.6), std::log(1000.0));
        const Eigen::VectorXd left = missing(peak, next);
        if (!(left.squaredNorm() < off.squaredNorm())) continue;
        log_of = next;
        off = left;
        return true;
    }
    return false;
}

std::optional<Resonance> fitted(Peak& peak, std::span<ResponsePoint> points) {
    Three log_of = best_of_grid(peak);
    Eigen::VectorXd off = missing(peak, log_of);
    for (int k = 0; k < kMostSteps && off.cwiseAbs().maxCoeff() * kDbPerLog > 0.01; ++k) {
        if (!step(peak, log_of, off)) break;
    }
    Resonance found{std::exp(log_of(0)),        std::exp(log_of(1)),
                    std::exp(log_of(2)),        points.front().frequency_hz,
                    points.back().frequency_hz, off.cwiseAbs().maxCoeff() * kDbPerLog};
    if (!(found.off_db <= kMostOffDb)) return std::nullopt;
    for (std::size_t k = 0; k < points.size(); ++k) {
        // What noise has added to a point stays.
        const double left = off(static_cast<Eigen::Index>(k));
        const double whole_g = strength_g(found, points[k].frequency_hz) * std::exp(left);
        const double by_db = kDbPerLog * std::log(whole_g / points[k].g_per_full_scale);
        found.corrected_db = std::max(found.corrected_db, std::abs(by_db));
        points[k].g_per_full_scale = whole_g;
    }
    return found;
}

// Stronger than both sides by far.
bool is_sharp(const std::vector<ResponsePoint>& points, std::size_t k) {
    const double g = points[k].g_per_full_scale;
    bool below = false;
    bool above = false;
    for (const ResponsePoint& other : points) {
        const double ratio = other.frequency_hz / points[k].frequency_hz;
        if (ratio > 1.0 / kAround && ratio < kAround && other.g_per_full_scale > g) return false;
        const bool is_weak = g > kSharp * other.g_per_full_scale;
        below = below || (ratio <= 1.0 / kBesides && ratio > 1.0 / kAround && is_weak);
        above = above || (ratio >= kBesides && ratio < kAround && is_weak);
    }
    return below && above;
}

}  // namespace

double strength_g(const Resonance& resonance, double f_hz) {
    return resonance.g * shape(resonance.f0_hz, resonance.q, f_hz);
}

std::vector<double> rung_g(const CalibrationPlan& plan, const std::vector<CalibrationTone>& tones,
                           const Resonance& resonance) {
    if (tones.empty()) return {};
    Peak peak{plan, tones, {}, std::vector<double>(plan.drive.samples.size(), 0.0)};
    const Eigen::VectorXd logs = measured_of(
        peak, {std::log(resonance.f0_hz), std::log(resonance.q), std::log(resonance.g)});
    std::vector<double> strengths;
    for (const double log : logs) strengths.push_back(std::exp(log));
    return strengths;
}

std::vector<Resonance> sharp_resonances(const CalibrationPlan& plan,
                                        const std::vector<CalibrationTone>& tones,
                                        std::vector<ResponsePoint>& points) {
    std::vector<Resonance> found;
    std::size_t free_from = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!is_sharp(points, k)) continue;
        std::size_t first = k;
        std::size_t end = k + 1;
        const double f_hz = points[k].frequency_hz;
        while (first > free_from && points[first - 1].frequency_hz > f_hz / kAround) --first;
        while (end < points.size() && points[end].frequency_hz < f_hz * kAround) ++end;
        if (end - first < kFewest) continue;
        Peak peak{plan, {}, {}, std::vector<double>(plan.drive.samples.size(), 0.0)};
        for (std::size_t n = first; n < end; ++n) {
            peak.tones.push_back(tones[n]);
            peak.logs.push_back(std::log(points[n].g_per_full_scale));
        }
        const auto one = fitted(peak, std::span(points).subspan(first, end - first));
        if (!one) continue;
        found.push_back(*one);
        free_from = end;
    }
    return found;
}

namespace {

constexpr int kHarmonics = 5;

// The model of calibration_run.h. `samples` and `phase` of one length.
ToneFit fitted(std::span<const double> samples, std::span<const double> phase) {
    constexpr int kColumns = 2 * kHarmonics + 1;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(kColumns, kColumns);
    Eigen::Vector<double, kColumns> right = Eigen::Vector<double, kColumns>::Zero();
    Eigen::Vector<double, kColumns> row;
    const auto fill = [&row](double p) {
        row(0) = 1.0;
        for (int h = 1; h <= kHarmonics; ++h) {
            row(2 * h - 1) = std::cos(h * p);
            row(2 * h) = std::sin(h * p);
        }
    };
    for (std::size_t n = 0; n < samples.size(); ++n) {
        fill(phase[n]);
        normal.noalias() += row * row.transpose();
        right += samples[n] * row;
    }
    const Eigen::Vector<double, kColumns> solved = solved_symmetric(normal, right);
    double rest = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        fill(phase[n]);
        const double left = samples[n] - row.dot(solved);
        rest += left * left / static_cast<double>(samples.size());
    }
    const double fundamental = solved.segment<2>(1).squaredNorm();
    const double harmonics = solved.tail<2 * kHarmonics - 2>().squaredNorm();
    if (!(fundamental > 0.0)) return {0.0, 0.0, -300.0, 1e15};
    const double snr = fundamental / 2.0 / std::max(rest, 1e-30);
    const double half = static_cast<double>(samples.size()) / 2.0;
    return {std::sqrt(fundamental), std::sqrt(harmonics / fundamental), 10.0 * std::log10(snr),
            1.0 / std::sqrt(snr * half)};
}

}  // namespace

ToneFit fit_of(const CalibrationPlan& plan, const CalibrationTone& tone,
               std::span<const double> samples, std::size_t start) {
    const std::size_t end = std::min(start + tone.end, samples.size());
    const std::size_t begin = std::min(start + tone.begin, end);
    return fitted(samples.subspan(begin, end - begin),
                  std::span(plan.phase_rad).subspan(tone.begin, end - begin));
}

}  // namespace tact
