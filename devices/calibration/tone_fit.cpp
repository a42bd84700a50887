#include "devices/calibration/tone_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "model/common/decompositions.h"

namespace tact {

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
