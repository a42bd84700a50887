#include "model/subset/separation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "model/common/portable.h"
#include "model/subset/search_limit.h"

namespace tact {

namespace {

constexpr int kMostFeltSteps = 16;
// A change that only coarse envelopes take for enough is made a step larger this many times.
constexpr int kCorrections = 2;
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

// What a change comes to.
struct Outcome {
    Nearest nearest;
    bool parts = false;
};

// When the search ends: at the person's stop, or at the limit, where the trial under way ends, too.
class Ending {
  public:
    explicit Ending(const SeparationOptions& options)
        : limit_(limit_of(options.time_limit_s, options.stop)),
          with_person_(options.stop, [this] { both_.request_stop(); }) {}

    std::stop_token token() const { return both_.get_token(); }
    bool is_by_person() const { return limit_.stop.stop_requested(); }
    bool reached() {
        if (limit_.reached()) both_.request_stop();
        return both_.stop_requested();
    }
    // Enough is left to confirm what was found.
    bool may_search(double limit_s) {
        return !reached() && (!limit_.is_by_clock() || limit_.left_s() > 0.4 * limit_s);
    }

  private:
    SearchLimit limit_;
    std::stop_source both_;
    std::stop_callback<std::function<void()>> with_person_;
};

// The set with one pattern changed, as the model sees it: one row is computed, all is ranked again.
class Trial {
  public:
    Trial(const PatternSet& set, const PerceptualModelParams& params, std::size_t place,
          double threshold, const SeparationOptions& options, Ending& ending)
        : set_(set),
          params_(params),
          place_(place),
          threshold_(threshold),
          options_(options),
          others_(options.from) {
        predict_.samples = longest_samples(set);
        for (const Vibration& vibration : set.vibrations) {
            waveforms_.push_back(as_felt(waveform_of(vibration)));
            predict_.samples = std::max(predict_.samples, waveforms_.back().samples_g.size());
        }
        if (others_.empty()) {
            others_.resize(waveforms_.size());
            std::iota(others_.begin(), others_.end(), std::size_t{0});
        }
        predict_.threads = options.threads;
        predict_.stop = ending.token();
        predict_.progress = [&ending](double) { (void)ending.reached(); };
    }

    // Beside what `previous` holds; none when stopped.
    std::optional<Outcome> operator()(const Pattern& pattern, const Prediction& previous) {
        Waveform changed = as_felt(render(pattern));
        std::swap(changed, waveforms_[place_]);
        predict_.previous = &previous;
        predict_.envelope_decimation = previous.envelope_decimation;
        const auto prediction = predict(waveforms_, params_, predict_);
        std::swap(changed, waveforms_[place_]);
        if (!prediction) return std::nullopt;
        const Nearest nearest = nearest_to(prediction->pm, place_, others_);
        return Outcome{nearest, nearest.distance > threshold_in(prediction->pm) &&
                                    !(options_.by_a_step && is_within_a_step(pattern))};
    }

    // The set as it is, with coarse envelopes: a hundredth of the work, for the search.
    std::optional<Prediction> coarse() {
        predict_.previous = nullptr;
        predict_.envelope_decimation = 10;
        return predict(waveforms_, params_, predict_);
    }

  private:
    Waveform as_felt(Waveform meant) const {
        return options_.felt ? options_.felt(meant) : std::move(meant);
    }

    double threshold_in(const Dissimilarity& pm) const {
        if (!options_.share) return threshold_;
        const Dissimilarity counted = others_.size() == pm.size ? pm : among(pm, others_);
        return std::max(threshold_, threshold_at(counted, *options_.share));
    }

    bool is_within_a_step(const Pattern& pattern) const {
        return std::ranges::any_of(others_, [&](std::size_t k) {
            const auto* other = std::get_if<Pattern>(&set_.vibrations[k].source);
            return k != place_ && other != nullptr &&
                   within_a_step(set_.felt_steps, pattern, *other);
        });
    }

    const PatternSet& set_;
    std::vector<Waveform> waveforms_;
    const PerceptualModelParams& params_;
    std::size_t place_;
    double threshold_;
    const SeparationOptions& options_;
    std::vector<std::size_t> others_;
    PredictOptions predict_;
};

double with_three_digits(double value, double past) {
    if (value == 0.0) return 0.0;
    // By whole powers of ten, so that 55.3 is the number that 55.3 is read as.
    const double digits = 2.0 - std::floor(portable::log10(std::abs(value)));
    const double whole = portable::pow(10.0, std::abs(digits));
    return digits >= 0.0 ? (std::round(value * whole) + past) / whole
                         : (std::round(value / whole) + past) * whole;
}

// One number in one direction, by a number of felt steps.
struct Way {
    PatternParameter parameter;
    double from = 0.0;
    double sign = 1.0;
    int steps = 0;

    // To three digits, which are not nearer than the steps are.
    double to(const FeltSteps& felt) const {
        const double exact = stepped(felt, parameter, from, sign * steps);
        const Range& range = traits(parameter).range;
        if (exact == range.low || exact == range.high) return exact;
        double rounded = with_three_digits(exact, 0.0);
        if (sign * (rounded - exact) < 0.0) rounded = with_three_digits(exact, sign);
        return std::clamp(rounded, range.low, range.high);
    }

    double felt_steps(const FeltSteps& felt) const {
        return steps_between(felt, parameter, from, to(felt));
    }
};

std::vector<Way> ways_of(const Pattern& pattern, const FeltSteps& felt) {
    std::vector<Way> ways;
    for (const PatternParameter parameter : kPatternParameters) {
        const auto value = value_of(pattern, parameter);
        if (!value) continue;
        for (const double sign : {1.0, -1.0}) {
            const Way way{parameter, *value, sign, 1};
            if (sign * (way.to(felt) - *value) > 0.0 && way.felt_steps(felt) >= 1.0) {
                ways.push_back(way);
            }
        }
    }
    return ways;
}

// Whether so large a change parts the pattern; none when stopped.
using Parts = std::function<std::optional<bool>(const Way&)>;

// The fewest steps found that do: twice as many until they do, then halved between.
std::optional<bool> narrow(Way& way, const FeltSteps& felt, const Parts& parts) {
    int before = 0;
    double last = way.from;
    for (int steps = 1; steps <= kMostFeltSteps; steps *= 2) {
        way.steps = steps;
        if (way.to(felt) == last) return false;  // at the end of its range
        last = way.to(felt);
        const auto enough = parts(way);
        if (!enough) return std::nullopt;
        if (*enough) break;
        if (steps == kMostFeltSteps) return false;
        before = steps;
    }
    int after = way.steps;
    while (after - before > 1) {
        way.steps = (before + after) / 2;
        const auto enough = parts(way);
        if (!enough) return std::nullopt;
        (*enough ? after : before) = way.steps;
    }
    way.steps = after;
    return true;
}

// As many steps more as exact envelopes want; nothing in it where none is enough, none when
// stopped.
std::optional<std::vector<Separation>> confirmed(Way way, const Pattern& pattern,
                                                 const FeltSteps& felt,
                                                 const Prediction& prediction, Trial& trial) {
    for (int k = 0; k <= kCorrections; ++k, ++way.steps) {
        const double to = way.to(felt);
        const auto outcome = trial(with_value(pattern, way.parameter, to), prediction);
        if (!outcome) return std::nullopt;
        if (!outcome->parts) continue;
        return std::vector{Separation{way.parameter, way.from, to, way.felt_steps(felt),
                                      outcome->nearest.distance, outcome->nearest.place}};
    }
    return std::vector<Separation>{};
}

}  // namespace

std::optional<std::vector<Separation>> separations(const PatternSet& set,
                                                   const Prediction& prediction, std::size_t place,
                                                   double threshold,
                                                   const SeparationOptions& options) {
    const auto* pattern = std::get_if<Pattern>(&set.vibrations[place].source);
    if (pattern == nullptr) return std::nullopt;
    if (!std::isfinite(threshold)) return std::vector<Separation>{};
    const FeltSteps& felt = set.felt_steps;
    Ending ending(options);
    Trial trial(set, prediction.params, place, threshold, options, ending);
    // Nothing when the person stopped it.
    const auto at_limit =
        [&](std::vector<Separation> known) -> std::optional<std::vector<Separation>> {
        if (ending.is_by_person()) return std::nullopt;
        if (options.cut_off) options.cut_off();
        std::ranges::stable_sort(known, {}, &Separation::steps);
        return known;
    };
    const std::optional<Prediction> coarse = trial.coarse();
    if (!coarse) return at_limit({});
    std::vector<Way> ways = ways_of(*pattern, felt);
    double done = 0.0;
    const double all = static_cast<double>(ways.size() + 2 * kMostGiven);
    const auto tell = [&](double more) {
        done += more;
        if (options.progress) options.progress(std::min(1.0, done / all));
    };
    const Parts parts_coarsely = [&](const Way& way) -> std::optional<bool> {
        const auto outcome = trial(with_value(*pattern, way.parameter, way.to(felt)), *coarse);
        return outcome ? std::optional(outcome->parts) : std::nullopt;
    };
    std::vector<Way> found;
    bool is_whole = true;
    for (Way& way : ways) {
        is_whole = is_whole && ending.may_search(options.time_limit_s);
        if (!is_whole) break;
        const auto narrowed = narrow(way, felt, parts_coarsely);
        if (!narrowed) return at_limit({});
        if (*narrowed) found.push_back(way);
        tell(1.0);
    }
    std::ranges::stable_sort(found, {}, [&](const Way& way) { return way.felt_steps(felt); });
    std::vector<Separation> result;
    for (const Way& way : found) {
        if (result.size() == kMostGiven) break;
        const auto sure = confirmed(way, *pattern, felt, prediction, trial);
        if (!sure) return at_limit(std::move(result));
        result.insert(result.end(), sure->begin(), sure->end());
        tell(2.0);
    }
    if (options.progress) options.progress(1.0);
    if (!is_whole) return at_limit(std::move(result));
    std::ranges::stable_sort(result, {}, &Separation::steps);
    return result;
}

}  // namespace tact
