#include "model/export/envelope_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "model/common/portable.h"
#include "model/io/effects_out/shares.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kStepS = 0.001;
constexpr std::size_t kSamplesAStep = 10;  // of the model's rate
constexpr double kToleranceDb = 0.1;
constexpr double kToleranceS = 0.001;
constexpr double kRounding = 1e-9;

// Values of each ms.
struct FeltCourse {
    std::vector<double> level_db;      // above threshold; 0: not felt
    std::vector<double> frequency_db;  // 20 log10 of Hz
};

double hz_of_strongest(const Pattern& pattern, double t_s) {
    if (pattern.carriers.empty()) return 0.0;
    const Carrier& strongest = *std::ranges::max_element(
        pattern.carriers, {}, [](const Carrier& carrier) { return std::abs(carrier.weight); });
    const double ratio = strongest.frequency_hz / pattern.carriers.front().frequency_hz;
    return ratio * first_carrier_hz(pattern, t_s);
}

Waveform carriers_of(Pattern pattern, double turned_rad) {
    pattern.transients.clear();
    for (Carrier& carrier : pattern.carriers) carrier.phase_rad += turned_rad;
    return render(pattern);
}

// As strong as a sine of this amplitude.
double strength_g(Transient one, double since_s) {
    const double of_shape = one.shape == TransientShape::square ? std::numbers::sqrt2 : 1.0;
    one.shape = TransientShape::square;  // its magnitude is its window
    return of_shape * std::abs(transient_g(one, since_s));
}

struct Strength {
    std::vector<double> squares_g2;  // of each sample: of carriers, then of all together
    std::vector<double> strongest_g;
    std::vector<double> frequency_hz;  // of the strongest, in each ms
};

void add_transient(Strength& all, const Transient& one) {
    const std::size_t samples = all.squares_g2.size();
    const double begin = std::max(0.0, one.time_s * kModelRateHz);
    const double end = (one.time_s + one.duration_s) * kModelRateHz + 1.0;
    for (auto n = static_cast<std::size_t>(begin); n < samples && static_cast<double>(n) < end;
         ++n) {
        const double g = strength_g(one, static_cast<double>(n) / kModelRateHz - one.time_s);
        all.squares_g2[n] += g * g;
        const std::size_t k = n / kSamplesAStep;
        if (!(g > all.strongest_g[k])) continue;
        all.strongest_g[k] = g;
        all.frequency_hz[k] = one.frequency_hz;
    }
}

Strength strength_of(const Pattern& pattern) {
    const Waveform sines = carriers_of(pattern, 0.0);
    const Waveform cosines = carriers_of(pattern, 0.5 * std::numbers::pi);
    Strength all;
    const std::size_t samples = sines.samples_g.size();
    const std::size_t steps = (samples + kSamplesAStep - 1) / kSamplesAStep;
    all.strongest_g.resize(steps);
    all.frequency_hz.resize(steps);
    for (std::size_t n = 0; n < samples; ++n) {
        all.squares_g2.push_back(sines.samples_g[n] * sines.samples_g[n] +
                                 cosines.samples_g[n] * cosines.samples_g[n]);
        double& strongest_g = all.strongest_g[n / kSamplesAStep];
        strongest_g = std::max(strongest_g, std::sqrt(all.squares_g2[n]));
    }
    for (std::size_t k = 0; k < steps; ++k) {
        all.frequency_hz[k] = hz_of_strongest(pattern, (static_cast<double>(k) + 0.5) * kStepS);
    }
    for (const Transient& one : pattern.transients) add_transient(all, one);
    return all;
}

// Silent from the pattern's end on.
FeltCourse course_of(const Pattern& pattern, std::size_t steps) {
    const Strength all = strength_of(pattern);
    FeltCourse course{std::vector<double>(steps), std::vector<double>(steps)};
    for (std::size_t k = 0; k < std::min(steps, all.frequency_hz.size()); ++k) {
        const std::size_t first = k * kSamplesAStep;
        const std::size_t last = std::min(first + kSamplesAStep, all.squares_g2.size());
        double sum = 0.0;
        for (std::size_t n = first; n < last; ++n) sum += all.squares_g2[n];
        const double g = std::sqrt(sum / static_cast<double>(last - first));
        const double hz = all.frequency_hz[k];
        course.level_db[k] = felt_level_db({g, hz});
        if (course.level_db[k] > 0.0) course.frequency_db[k] = 20.0 * portable::log10(hz);
    }
    return course;
}

// How far a value is from those of the other within 1 ms.
template <class Counts>
double off_db(double value, std::span<const double> others, std::size_t k, const Counts& counts) {
    double low = value;
    double high = value;
    bool any = false;
    for (std::size_t n = k > 0 ? k - 1 : 0; n < std::min(k + 2, others.size()); ++n) {
        if (!counts(n)) continue;
        low = any ? std::min(low, others[n]) : others[n];
        high = any ? std::max(high, others[n]) : others[n];
        any = true;
    }
    if (!any) return 0.0;
    return std::max({low - value, value - high, 0.0});
}

double error_at(const FeltCourse& one, const FeltCourse& other, std::size_t k) {
    const auto always = [](std::size_t) { return true; };
    const auto is_felt = [&](std::size_t n) { return other.level_db[n] > 0.0; };
    const double level_db = off_db(one.level_db[k], other.level_db, k, always);
    if (!(one.level_db[k] > 0.0)) return level_db;
    return std::max(level_db, off_db(one.frequency_db[k], other.frequency_db, k, is_felt));
}

// From one step to before another.
struct Steps {
    std::size_t first = 0;
    std::size_t end = 0;
};

std::size_t step_at(double t_s, std::size_t steps) {
    return std::min(static_cast<std::size_t>(std::max(0.0, std::floor(t_s / kStepS + kRounding))),
                    steps);
}

// Those that follow each other at once and weaker are the pieces of one that fades.
std::vector<Steps> accents_of(const Pattern& pattern, std::size_t steps) {
    std::vector<Transient> all = pattern.transients;
    std::ranges::stable_sort(all, {}, &Transient::time_s);
    std::vector<Steps> accents;
    double end_s = -1.0;
    double last_g = 0.0;
    for (const Transient& one : all) {
        const double own_end_s = one.time_s + one.duration_s;
        const Steps own{step_at(one.time_s, steps),
                        std::min(step_at(own_end_s + kStepS - 1e-6, steps), steps)};
        const bool fades = std::abs(one.time_s - end_s) < 1e-6 && one.amplitude_g <= last_g;
        end_s = own_end_s;
        last_g = one.amplitude_g;
        if (own.first >= own.end) continue;
        if (fades && !accents.empty()) {
            accents.back().end = own.end;
        } else {
            accents.push_back(own);
        }
    }
    return accents;
}

double loudest_db(const FeltCourse& course, Steps within) {
    double loudest = 0.0;
    for (std::size_t k = within.first; k < within.end; ++k) {
        loudest = std::max(loudest, course.level_db[k]);
    }
    return loudest;
}

// The faintest before and behind, up to the next ones: 0 dB before the beginning.
double beside_db(const FeltCourse& course, const std::vector<Steps>& accents, std::size_t n) {
    constexpr std::size_t kNear = 50;
    const Steps own = accents[n];
    const std::size_t least = n > 0 ? accents[n - 1].end : 0;
    const std::size_t most = n + 1 < accents.size() ? accents[n + 1].first : course.level_db.size();
    if (own.first == 0) return 0.0;
    double faintest = loudest_db(course, own);
    const std::size_t from = std::max(own.first > kNear ? own.first - kNear : 0, least);
    for (std::size_t k = from; k < own.first; ++k)
        faintest = std::min(faintest, course.level_db[k]);
    for (std::size_t k = own.end; k < std::min(own.end + kNear, most); ++k) {
        faintest = std::min(faintest, course.level_db[k]);
    }
    return faintest;
}

void count_accents(EnvelopeError& error, const std::vector<Steps>& accents, const FeltCourse& meant,
                   const FeltCourse& back) {
    constexpr double kStandsOutDb = 3.0;
    constexpr double kHalfDb = 6.1;
    constexpr std::size_t kMoved = 2;  // ms that it may be moved by
    const std::size_t steps = meant.level_db.size();
    for (std::size_t n = 0; n < accents.size(); ++n) {
        const Steps own = accents[n];
        const double level_db = loudest_db(meant, own);
        const double contrast_db = level_db - beside_db(meant, accents, n);
        if (contrast_db < kStandsOutDb) continue;
        ++error.accents;
        const Steps near{own.first - std::min(own.first, kMoved),
                         std::min(own.end + kMoved, steps)};
        const double left_db = loudest_db(back, near);
        const bool loud = left_db >= level_db - kHalfDb && left_db > 0.0;
        const bool stands_out = left_db - beside_db(back, accents, n) >= 0.5 * contrast_db;
        if (loud && stands_out) ++error.accents_left;
    }
}

}  // namespace

EnvelopeError envelope_error(const Pattern& meant, const Pattern& back) {
    EnvelopeError error;
    error.meant_s = meant.duration_s;
    error.lasts_s = back.duration_s;
    const double longest_s = std::max(meant.duration_s, back.duration_s);
    const auto steps = static_cast<std::size_t>(std::ceil(longest_s / kStepS - kRounding)) + 1;
    const FeltCourse asked = course_of(meant, steps);
    const FeltCourse got = course_of(back, steps);
    for (std::size_t k = 0; k < steps; ++k) {
        const double off = std::max(error_at(asked, got, k), error_at(got, asked, k));
        if (!(off > error.error_db)) continue;
        error.error_db = off;
        error.at_s = static_cast<double>(k) * kStepS;
    }
    const bool was_felt = std::ranges::max(asked.level_db) > 0.0;
    error.is_silenced = was_felt && !(std::ranges::max(got.level_db) > 0.0);
    count_accents(error, accents_of(meant, steps), asked, got);
    return error;
}

bool is_lossy(const EnvelopeError& error) {
    return error.error_db > kToleranceDb || error.accents_left < error.accents ||
           std::abs(error.lasts_s - error.meant_s) > kToleranceS + kRounding;
}

std::vector<std::string> words_of(const EnvelopeError& error) {
    std::vector<std::string> words;
    if (std::abs(error.lasts_s - error.meant_s) > kToleranceS + kRounding) {
        words.push_back("lasts " + significant_digits(1e3 * error.lasts_s, 5) + " ms in place of " +
                        significant_digits(1e3 * error.meant_s, 5) + " ms");
    }
    if (error.error_db > kToleranceDb) {
        words.push_back("at most " + significant_digits(error.error_db, 2) +
                        " dB off where it is felt, at " + significant_digits(error.at_s, 4) + " s");
    }
    if (error.accents_left < error.accents) {
        words.push_back(grouped_digits(error.accents_left) + " of " +
                        grouped_digits(error.accents) +
                        (error.accents == 1 ? " accent is left" : " accents are left"));
    }
    if (error.is_silenced) words.emplace_back(kSilenced);
    return words;
}

}  // namespace tact
