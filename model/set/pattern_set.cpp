#include "model/set/pattern_set.h"

#include <algorithm>

#include "model/common/parallel.h"
#include "model/set/layers.h"
#include "model/signal/resample.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

bool Measurement::operator==(const Measurement& other) const {
    return path == other.path && scale_g == other.scale_g && measures == other.measures &&
           measures_version == other.measures_version && synthetic == other.synthetic &&
           (waveform == other.waveform || *waveform == *other.waveform);
}

Waveform waveform_of(const Vibration& vibration) { return waveform_of(vibration, kModelRateHz); }

Waveform waveform_of(const Vibration& vibration, double rate_hz) {
    if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
        return render(*pattern, rate_hz);
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        return render(*layered, rate_hz);
    }
    return resampled(*std::get<Measurement>(vibration.source).waveform, rate_hz);
}

std::vector<Waveform> model_waveforms(const PatternSet& set) {
    const std::size_t longest = longest_samples(set);
    std::vector<Waveform> waveforms = own_waveforms(set, 1);
    for (Waveform& one : waveforms) one = padded(std::move(one), longest);
    return waveforms;
}

std::vector<Waveform> own_waveforms(const PatternSet& set, int threads) {
    std::vector<Waveform> waveforms(set.vibrations.size());
    parallel_for(waveforms.size(), threads, {},
                 [&](std::size_t k) { waveforms[k] = waveform_of(set.vibrations[k]); });
    return waveforms;
}

namespace {

std::size_t samples_of(const Vibration& vibration) {
    if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
        return sample_count(pattern->duration_s, kModelRateHz);
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        return sample_count(duration_s(*layered), kModelRateHz);
    }
    return std::get<Measurement>(vibration.source).waveform->samples_g.size();
}

}  // namespace

std::size_t longest_samples(const PatternSet& set) {
    std::size_t longest = 0;
    for (const Vibration& vibration : set.vibrations) {
        longest = std::max(longest, samples_of(vibration));
    }
    return longest;
}

double own_duration_s(const Vibration& vibration) {
    return static_cast<double>(samples_of(vibration)) / kModelRateHz;
}

double longest_s(const PatternSet& set) {
    return static_cast<double>(longest_samples(set)) / kModelRateHz;
}

std::vector<std::string> names_of(const PatternSet& set) {
    std::vector<std::string> names;
    for (const Vibration& vibration : set.vibrations) names.push_back(vibration.name);
    return names;
}

std::map<std::string, std::size_t> actuators_of(const PatternSet& set) {
    std::map<std::string, std::size_t> count;
    for (const Vibration& one : set.vibrations) {
        if (!one.effect.actuator.empty()) ++count[one.effect.actuator];
    }
    return count;
}

std::optional<std::size_t> place_named(const PatternSet& set, const std::string& name) {
    const auto found = std::ranges::find(set.vibrations, name, &Vibration::name);
    if (found == set.vibrations.end()) return std::nullopt;
    return static_cast<std::size_t>(found - set.vibrations.begin());
}

std::string unused_name(const PatternSet& set, const std::string& wanted) {
    const auto taken = [&set](const std::string& name) {
        return std::ranges::any_of(set.vibrations,
                                   [&name](const Vibration& v) { return v.name == name; });
    };
    if (!taken(wanted)) return wanted;
    // A copy of "tick 2" is "tick 3": its number continues.
    std::string stem = wanted;
    int number = 2;
    const std::size_t space = wanted.find_last_of(' ');
    const std::string end = space == std::string::npos ? "" : wanted.substr(space + 1);
    const bool is_number = !end.empty() && end.size() < 4 && end[0] != '0' &&
                           end.find_first_not_of("0123456789") == std::string::npos;
    if (is_number && taken(wanted.substr(0, space))) {
        stem = wanted.substr(0, space);
        number = std::stoi(end) + 1;
    }
    std::string name;
    do {
        const std::string behind = " " + std::to_string(number++);
        name = std::string(whole_characters(stem, kMaxNameBytes - behind.size())) + behind;
    } while (taken(name));
    return name;
}

Expected<std::size_t> place_of(const PatternSet& set, const std::string& name) {
    if (set.vibrations.empty()) return Error{"the set is empty, expected at least one pattern"};
    if (const auto place = place_named(set, name)) return *place;
    std::string known;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        constexpr std::size_t kNamed = 12;
        if (k < kNamed) known += (k == 0 ? "" : ", ") + set.vibrations[k].name;
        if (k == kNamed) known += ", ...";
    }
    return Error{"there is no pattern \"" + name + "\", expected one of " + known};
}

Expected<std::size_t> pattern_place_of(const PatternSet& set, const std::string& name) {
    const Expected<std::size_t> place = place_of(set, name);
    if (!place || std::holds_alternative<Pattern>(set.vibrations[*place].source)) return place;
    const bool has_layers = std::holds_alternative<LayeredPattern>(set.vibrations[*place].source);
    return Error{"expected a pattern made of parameters, got " +
                 std::string(has_layers ? "the layers of" : "the recording") + " \"" + name + "\""};
}

const Pattern* pattern_named(const PatternSet& set, const std::string& name) {
    const auto place = place_named(set, name);
    return place ? std::get_if<Pattern>(&set.vibrations[*place].source) : nullptr;
}

}  // namespace tact
