#include "model/subset/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "model/common/portable.h"
#include "model/common/quantile.h"

namespace tact {

namespace {

constexpr std::array<double, 5> kSteps{1.0, 2.0, 4.0, 8.0, 16.0};
constexpr int kHalvings = 3;
// A change that only coarse envelopes take for enough is made larger this many times.
constexpr int kCorrections = 2;
constexpr double kCorrection = 1.15;
constexpr std::size_t kMostGiven = 6;

struct Nearest {
    double distance = 0.0;
    std::size_t place = 0;
};

Nearest nearest_to(const Dissimilarity& pm, std::size_t place,
                   std::span<const std::size_t> others) {
    Nearest nearest{0.0, place};
    for (const std::size_t k : others) {
        const bool is_first = nearest.place == place;
        if (k != place && (is_first || pm(place, k) < nearest.distance)) {
            nearest = {pm(place, k), k};
        }
    }
    return nearest;
}

// The set with one pattern changed, as the model sees it: one row is computed, all is ranked anew.
class Trial {
  public:
    Trial(const PatternSet& set, const PerceptualModelParams& params, std::size_t place,
          const SeparationOptions& options)
        : params_(params), place_(place), others_(options.from), felt_(options.felt) {
        const std::size_t longest = longest_samples(set);
        for (const Vibration& vibration : set.vibrations) {
            waveforms_.push_back(as_felt(waveform_of(vibration), longest));
        }
        if (others_.empty()) {
            others_.resize(waveforms_.size());
            std::iota(others_.begin(), others_.end(), std::size_t{0});
        }
        predict_.threads = options.threads;
        predict_.stop = options.stop;
    }

    // Beside what `previous` holds; none when stopped.
    std::optional<Nearest> operator()(const Pattern& pattern, const Prediction& previous) {
        const std::size_t length = waveforms_[place_].samples_g.size();
        Waveform changed = as_felt(render(pattern), length);
        std::swap(changed, waveforms_[place_]);
        predict_.previous = &previous;
        predict_.envelope_decimation = previous.envelope_decimation;
        const auto prediction = predict(waveforms_, params_, predict_);
        std::swap(changed, waveforms_[place_]);
        if (!prediction) return std::nullopt;
        return nearest_to(prediction->pm, place_, others_);
    }

    // The set as it is, with coarse envelopes: a hundredth of the work, for the search.
    std::optional<Prediction> coarse() {
        predict_.previous = nullptr;
        predict_.envelope_decimation = 10;
        return predict(waveforms_, params_, predict_);
    }

  private:
    Waveform as_felt(Waveform meant, std::size_t length) const {
        return padded(felt_ ? felt_(meant) : std::move(meant), length);
    }

    std::vector<Waveform> waveforms_;
    const PerceptualModelParams& params_;
    std::size_t place_;
    std::vector<std::size_t> others_;
    const std::function<Waveform(const Waveform&)>& felt_;
    PredictOptions predict_;
};

// One number in one direction.
struct Way {
    PatternParameter parameter;
    double from = 0.0;
    double sign = 1.0;
    double steps = 0.0;  // found

    double to() const { return stepped(parameter, from, sign * steps); }
};

std::vector<Way> ways_of(const Pattern& pattern) {
    std::vector<Way> ways;
    for (const PatternParameter parameter : kPatternParameters) {
        const auto value = value_of(pattern, parameter);
        if (!value) continue;
        for (const double sign : {1.0, -1.0}) {
            if (stepped(parameter, *value, sign) != *value)
                ways.push_back({parameter, *value, sign});
        }
    }
    return ways;
}

// Whether so large a change parts the pattern; none when stopped.
using Parts = std::function<std::optional<bool>(const Way&)>;

// The smallest change found that does: steps up until it does, then halves the last one.
std::optional<bool> narrow(Way& way, const Parts& parts) {
    double before = 0.0;
    double last = way.from;
    for (const double steps : kSteps) {
        way.steps = steps;
        if (way.to() == last) return false;  // at the end of its range
        last = way.to();
        const auto enough = parts(way);
        if (!enough) return std::nullopt;
        if (!*enough) {
            before = steps;
            continue;
        }
        double after = steps;
        for (int k = 0; k < kHalvings; ++k) {
            way.steps = 0.5 * (before + after);
            const auto half = parts(way);
            if (!half) return std::nullopt;
            (*half ? after : before) = way.steps;
        }
        way.steps = after;
        return true;
    }
    return false;
}

double with_three_digits(double value) {
    if (value == 0.0) return 0.0;
    // By whole powers of ten, so that 55.3 is the number that 55.3 is read as.
    const double digits = 2.0 - std::floor(portable::log10(std::abs(value)));
    const double whole = portable::pow(10.0, std::abs(digits));
    return digits >= 0.0 ? std::round(value * whole) / whole : std::round(value / whole) * whole;
}

}  // namespace

std::vector<ConfusablePair> confusable_pairs(const Dissimilarity& dissimilarity, double threshold,
                                             std::size_t most) {
    if (!std::isfinite(threshold)) return {};
    std::vector<ConfusablePair> pairs;
    std::size_t k = 0;
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        for (std::size_t j = i + 1; j < dissimilarity.size; ++j, ++k) {
            const double value = dissimilarity.condensed[k];
            if (value <= threshold) pairs.push_back({i, j, value});
        }
    }
    // Of half a million pairs a few hundred are wanted.
    const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(std::min(most, pairs.size()));
    std::ranges::partial_sort(pairs, end, {}, [](const ConfusablePair& pair) {
        return std::tuple(pair.dissimilarity, pair.a, pair.b);
    });
    pairs.erase(end, pairs.end());
    return pairs;
}

std::vector<double> sorted_values(const Dissimilarity& dissimilarity) {
    std::vector<double> values;
    for (const double value : dissimilarity.condensed) {
        if (std::isfinite(value)) values.push_back(value);
    }
    std::ranges::sort(values);
    return values;
}

double threshold_at(const Dissimilarity& dissimilarity, double share) {
    return quantile(sorted_values(dissimilarity), share);
}

Dissimilarity among(const Dissimilarity& dissimilarity, std::span<const std::size_t> objects) {
    Dissimilarity result{objects.size(), {}};
    for (std::size_t i = 0; i < objects.size(); ++i) {
        for (std::size_t j = i + 1; j < objects.size(); ++j) {
            result.condensed.push_back(dissimilarity(objects[i], objects[j]));
        }
    }
    return result;
}

std::optional<std::vector<Separation>> separations(const PatternSet& set,
                                                   const Prediction& prediction, std::size_t place,
                                                   double threshold,
                                                   const SeparationOptions& options) {
    const auto* pattern = std::get_if<Pattern>(&set.vibrations[place].source);
    if (pattern == nullptr) return std::nullopt;
    if (!std::isfinite(threshold)) return std::vector<Separation>{};
    Trial trial(set, prediction.params, place, options);
    const std::optional<Prediction> coarse = trial.coarse();
    if (!coarse) return std::nullopt;
    std::vector<Way> ways = ways_of(*pattern);
    double done = 0.0;
    const double all = static_cast<double>(ways.size() + 2 * kMostGiven);
    const auto tell = [&](double more) {
        done += more;
        if (options.progress) options.progress(std::min(1.0, done / all));
    };
    const Parts parts_coarsely = [&](const Way& way) -> std::optional<bool> {
        const auto nearest = trial(with_value(*pattern, way.parameter, way.to()), *coarse);
        if (!nearest) return std::nullopt;
        return nearest->distance > threshold;
    };
    std::vector<Way> found;
    for (Way& way : ways) {
        const auto narrowed = narrow(way, parts_coarsely);
        if (!narrowed) return std::nullopt;
        if (*narrowed) found.push_back(way);
        tell(1.0);
    }
    std::ranges::stable_sort(found, {}, &Way::steps);
    std::vector<Separation> result;
    for (Way& way : found) {
        if (result.size() == kMostGiven) break;
        for (int k = 0; k <= kCorrections; ++k, way.steps *= kCorrection) {
            const double to = with_three_digits(way.to());
            const auto nearest = trial(with_value(*pattern, way.parameter, to), prediction);
            if (!nearest) return std::nullopt;
            if (nearest->distance <= threshold) continue;
            result.push_back(
                {way.parameter, way.from, to, way.steps, nearest->distance, nearest->place});
            break;
        }
        tell(2.0);
    }
    std::ranges::stable_sort(result, {}, &Separation::steps);
    if (options.progress) options.progress(1.0);
    return result;
}

}  // namespace tact
