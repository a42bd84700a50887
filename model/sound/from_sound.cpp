#include "model/sound/from_sound.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "assets/assets.h"
#include "model/common/portable.h"
#include "model/export/ranks_among.h"
#include "model/io/recordings/sound_file.h"
#include "model/io/set/set_file.h"
#include "model/pattern/traced.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/signal/spectrum.h"
#include "model/signal/waveform.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kYardstick = "sets/pm_2023_twelve.tactspace.json";
constexpr double kNothingG = 1e-4;  // the peak of what nobody feels

std::string name_from(const std::filesystem::path& path) {
    const std::string stem = valid_utf8(path.stem().string());
    return stem.empty() ? "sound" : stem;
}

std::string note_of(const std::string& file, const FromSound& result,
                    const FromSoundOptions& options) {
    std::string note = "From the sound " + file + ", for " + options.actuator.name + ", " +
                       significant_digits(result.full_scale_g, 4) + " g at full scale";
    for (const std::string& remark : result.remarks) note += "; " + remark;
    return note + ".";
}

}  // namespace

Expected<FromSound> from_sound(const std::filesystem::path& path, const FromSoundOptions& options) {
    auto sound = read_sound_file(path);
    if (!sound) return sound.error();
    FromSound result;
    result.full_scale_g =
        options.full_scale_g.value_or(sound->scale_g.value_or(options.actuator.full_scale_g));
    SoundOptions how;
    how.band_hz = options.actuator.frequency_hz;
    how.full_scale_g = result.full_scale_g;
    how.accents = options.accents;
    result.made = pattern_of_sound(sound->waveform, how);
    if (!(peak_g(result.made.felt) > kNothingG * result.full_scale_g * peak_g(sound->waveform))) {
        return Error{path.string() + ": nothing of it lies in the " +
                     significant_digits(how.band_hz.low, 4) + " to " +
                     significant_digits(how.band_hz.high, 4) + " Hz of " + options.actuator.name};
    }
    // At the file's own rate; the curves were made at 10 kHz.
    result.made.pattern = with_duration(std::move(result.made.pattern), sound->duration_s);
    result.remarks = std::move(sound->remarks);
    for (std::string& words : words_of(result.made, how)) {
        result.remarks.push_back(std::move(words));
    }
    if (!options.without_pm && !options.stop.stop_requested()) {
        const auto yardstick = parse_set(asset(kYardstick), kYardstick, {});
        if (!yardstick) return yardstick.error();
        result.moved = sound_moved(result.made.felt, result.made.pattern, *yardstick,
                                   {options.threads, options.stop, options.progress});
        if (result.moved) result.remarks.push_back(words_on(*result.moved));
    }
    if (options.stop.stop_requested()) return Error{path.string() + ": was stopped"};
    result.vibration.name = name_from(path);
    result.vibration.source = result.made.pattern;
    result.vibration.note = note_of(valid_utf8(path.filename().string()), result, options);
    return result;
}

namespace {

constexpr double kBesideOctaves = 1.0 / 6.0;
constexpr double kFadeOctaves = 0.5;
constexpr double kSectionS = 1.0;

Range widened(Range band_hz) {
    const double ratio = portable::pow(2.0, kBesideOctaves);
    return {band_hz.low / ratio, band_hz.high * ratio};
}

double energy_of(const Waveform& waveform) {
    double sum = 0.0;
    for (const double sample : waveform.samples_g) sum += sample * sample;
    return sum;
}

// What the actuator cannot do is asked of it at the edge of its band.
void keep_within(Pattern& pattern, Range band_hz) {
    const auto within = [&](double& hz) { hz = std::clamp(hz, band_hz.low, band_hz.high); };
    within(pattern.carriers.front().frequency_hz);
    for (FrequencyPoint& point : pattern.frequency_curve) within(point.frequency_hz);
    for (Transient& transient : pattern.transients) within(transient.frequency_hz);
    const auto is_steady = [&](const FrequencyPoint& point) {
        return point.frequency_hz == pattern.carriers.front().frequency_hz;
    };
    if (std::ranges::all_of(pattern.frequency_curve, is_steady)) pattern.frequency_curve.clear();
}

std::string hz_text(Range band_hz) {
    return significant_digits(band_hz.low, 4) + " to " + significant_digits(band_hz.high, 4) +
           " Hz";
}

}  // namespace

Waveform felt_in_band(const Waveform& sound, Range band_hz) {
    const Range flat_hz = widened(band_hz);
    const auto gain = [flat_hz](double hz) {
        if (!(hz > 0.0)) return 0.0;
        const double off = hz < flat_hz.low    ? portable::log2(flat_hz.low / hz)
                           : hz > flat_hz.high ? portable::log2(hz / flat_hz.high)
                                               : 0.0;
        return off >= kFadeOctaves ? 0.0 : fade_gain(kFadeOctaves - off, kFadeOctaves);
    };
    return {sound.rate_hz, zero_phase_filtered(sound.samples_g, sound.rate_hz, gain)};
}

SoundPattern pattern_of_sound(const Waveform& sound, const SoundOptions& options) {
    SoundPattern made;
    const Waveform scaled = with_gain(sound, options.full_scale_g);
    made.felt = felt_in_band(scaled, options.band_hz);
    const double all = energy_of(scaled);
    if (all > 0.0) made.outside_share = std::clamp(1.0 - energy_of(made.felt) / all, 0.0, 1.0);
    TraceParams params;
    params.most_points = std::max<std::size_t>(options.points_per_s, 2);
    params.section_s = kSectionS;
    params.band_hz = widened(options.band_hz);
    params.transients = options.accents;
    TracedPattern traced_sound = traced(made.felt, params);
    made.pattern = std::move(traced_sound.pattern);
    made.amplitude_error_g = traced_sound.amplitude_error_g;
    made.frequency_error_hz = traced_sound.frequency_error_hz;
    made.frequency_is_a_guess = traced_sound.frequency_is_a_guess;
    made.other_share = traced_sound.other_share;
    keep_within(made.pattern, options.band_hz);
    const double peak = peak_g(made.felt);
    if (peak > limits::kAmplitudeG.high) made.over_g = peak;
    return made;
}

std::vector<std::string> words_of(const SoundPattern& made, const SoundOptions& options) {
    constexpr double kMuch = 0.05;
    std::vector<std::string> words;
    const Pattern& pattern = made.pattern;
    const std::size_t points = pattern.amplitude_curve.size() + pattern.frequency_curve.size();
    words.push_back(significant_digits(pattern.duration_s, 4) + " s, " +
                    counted(points, "point of a curve", "points of curves") + " and " +
                    counted(pattern.transients.size(), "accent", "accents"));
    if (made.frequency_is_a_guess) {
        words.push_back("too short to measure its frequency: " +
                        significant_digits(pattern.carriers[0].frequency_hz, 3) +
                        " Hz are a guess");
    }
    if (made.other_share > kMuch) {
        words.push_back(percent(made.other_share) +
                        " of what can be felt has other frequencies than the strongest one, or is "
                        "noise: its strength is kept, its roughness is not");
    }
    if (made.outside_share > kMuch) {
        words.push_back(percent(made.outside_share) + " of the sound's energy lies outside of " +
                        hz_text(options.band_hz) + " and is not felt");
    }
    if (made.over_g > 0.0) {
        words.push_back("its peak of " + significant_digits(made.over_g, 3) +
                        " g is beyond the 50 g that a pattern may have");
    }
    return words;
}

namespace {

constexpr double kSame = 1e-4;  // of the yardstick's largest NC or OC

std::vector<double> section_of(const std::vector<double>& x, std::size_t first, std::size_t count) {
    std::vector<double> section(count, 0.0);
    for (std::size_t n = first; n < std::min(first + count, x.size()); ++n) {
        section[n - first] = x[n];
    }
    return section;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double pm_among(const Prediction& yardstick, double nc, double oc) {
    const auto is_same = [](double value, const Dissimilarity& among) {
        return value <= kSame * std::ranges::max(among.condensed);
    };
    if (is_same(nc, yardstick.nc) && is_same(oc, yardstick.oc)) return 0.0;
    return pm_of(ranks_among(std::vector{nc}, yardstick.nc.condensed).front(),
                 ranks_among(std::vector{oc}, yardstick.oc.condensed).front(),
                 yardstick.params.nc_weight, yardstick.params.oc_weight);
}

}  // namespace

std::optional<SoundMoved> sound_moved(const Waveform& felt, const Pattern& pattern,
                                      const PatternSet& yardstick,
                                      const SoundMovedOptions& options) {
    assert(yardstick.vibrations.size() >= 3);
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    const auto known = predict(own_waveforms(yardstick, options.threads), yardstick.model, how);
    if (!known) return std::nullopt;
    const Waveform rendered = render(pattern);
    const std::size_t count = longest_samples(yardstick);
    const std::size_t samples = std::max(felt.samples_g.size(), rendered.samples_g.size());
    SoundMoved moved{yardstick.name, longest_s(yardstick), {}, 0.0, 0.0};
    for (std::size_t first = 0; first < samples; first += count) {
        const std::vector<Waveform> both{
            {kModelRateHz, section_of(felt.samples_g, first, count)},
            {kModelRateHz, section_of(rendered.samples_g, first, count)}};
        const auto codes = pattern_codes(both, yardstick.model, how);
        if (options.stop.stop_requested() || codes.size() != 2) return std::nullopt;
        moved.pm.push_back(pm_among(*known, nc_matrix(codes, yardstick.model, how).condensed[0],
                                    oc_matrix(codes, yardstick.model, how).condensed[0]));
        if (options.stop.stop_requested()) return std::nullopt;
        if (options.progress) {
            options.progress(
                std::min(1.0, static_cast<double>(first + count) / static_cast<double>(samples)));
        }
    }
    moved.closest_pm = std::ranges::min(known->pm.condensed);
    moved.farthest_pm = std::ranges::max(known->pm.condensed);
    return moved;
}

std::string words_on(const SoundMoved& moved) {
    if (moved.pm.empty()) return {};
    const auto most = std::ranges::max_element(moved.pm);
    std::string words = "PM from the sound " + significant_digits(mean_of(moved.pm), 3);
    if (moved.pm.size() > 1) {
        const double from_s = moved.section_s * static_cast<double>(most - moved.pm.begin());
        words += " on the whole, at most " + significant_digits(*most, 3) + " (" +
                 significant_digits(from_s, 3) + " to " +
                 significant_digits(from_s + moved.section_s, 3) + " s)";
    }
    return words + "; the pairs of " + moved.yardstick + " have " +
           significant_digits(moved.closest_pm, 3) + " to " +
           significant_digits(moved.farthest_pm, 3);
}

}  // namespace tact
