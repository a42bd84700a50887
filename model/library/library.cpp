#include "model/library/library.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/set/layers.h"
#include "model/signal/spectrum.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Thousandths are finer than anything that can be seen or drawn.
double in_thousandths(double share) { return std::round(1e3 * share) / 1e3; }

StrengthShape shape_of(const std::vector<double>& samples_g) {
    StrengthShape shape{};
    const std::size_t count = samples_g.size();
    for (std::size_t part = 0; part < kShapeParts; ++part) {
        const std::size_t from = part * count / kShapeParts;
        const std::size_t to = (part + 1) * count / kShapeParts;
        double squares = 0.0;
        for (std::size_t k = from; k < to; ++k) squares += samples_g[k] * samples_g[k];
        if (to > from) shape[part] = std::sqrt(squares / static_cast<double>(to - from));
    }
    const double largest = std::ranges::max(shape);
    for (double& strength : shape) {
        strength = largest > 0.0 ? in_thousandths(strength / largest) : 0.0;
    }
    return shape;
}

std::optional<double> mean_hz_of(const Waveform& waveform) {
    if (waveform.samples_g.empty()) return std::nullopt;
    const Spectrum spectrum =
        amplitude_spectrum(without_mean(waveform.samples_g), waveform.rate_hz);
    double power = 0.0;
    double turns = 0.0;
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        const double square = spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
        power += square;
        turns += square * frequency_hz(spectrum, k);
    }
    if (!(power > 0.0)) return std::nullopt;
    return turns / power;
}

}  // namespace

LibraryEntry entry_of(const Vibration& vibration) {
    LibraryEntry entry;
    entry.name = vibration.name;
    entry.note = vibration.note;
    entry.effect = vibration.effect;
    if (const auto* measured = std::get_if<Measurement>(&vibration.source)) {
        entry.recording = true;
        entry.synthetic = measured->synthetic;
    }
    for (const Pattern* pattern : patterns_in(vibration)) {
        entry.ticks += pattern->transients.size();
    }
    const Waveform waveform = waveform_of(vibration);
    entry.duration_s = duration_s(waveform);
    entry.peak_g = peak_g(waveform);
    entry.mean_hz = mean_hz_of(waveform);
    entry.shape = shape_of(waveform.samples_g);
    return entry;
}

std::vector<std::string> reasons_left_out(const Library& library) {
    std::vector<std::string> reasons;
    for (const LibraryFile& file : library.files) {
        if (!file.left_out.empty()) reasons.push_back(file.left_out);
    }
    return reasons;
}

const LibraryFile& file_of(const Library& library, const LibraryEntry& entry) {
    return library.files[entry.file];
}

namespace {

std::string text_of(const Library& library, const LibraryEntry& entry) {
    const LibraryFile& file = file_of(library, entry);
    return lower_case(entry.name + '\n' + entry.note + '\n' + file.path + '\n' +
                      entry.effect.format + '\n' + file.licence);
}

}  // namespace

std::vector<std::size_t> found_by_words(const Library& library, std::string_view words) {
    std::vector<std::string> all;
    std::istringstream stream(lower_case(std::string(words)));
    for (std::string word; stream >> word;) all.push_back(word);
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < library.entries.size(); ++k) {
        const std::string text = text_of(library, library.entries[k]);
        if (std::ranges::all_of(all,
                                [&](const auto& word) { return text.find(word) != text.npos; }))
            found.push_back(k);
    }
    return found;
}

std::optional<StrengthShape> shape_through(const std::vector<double>& strengths) {
    if (strengths.size() < 2) return std::nullopt;
    const bool is_fine = std::ranges::all_of(
        strengths, [](double strength) { return std::isfinite(strength) && strength >= 0.0; });
    const double largest = std::ranges::max(strengths);
    if (!is_fine || !(largest > 0.0)) return std::nullopt;
    StrengthShape shape{};
    const auto last = static_cast<double>(strengths.size() - 1);
    for (std::size_t part = 0; part < kShapeParts; ++part) {
        const double at = (static_cast<double>(part) + 0.5) / kShapeParts * last;
        const auto before = static_cast<std::size_t>(at);
        const double share = at - std::floor(at);
        shape[part] = std::lerp(strengths[before], strengths[before + 1], share) / largest;
    }
    return shape;
}

double shape_difference(const StrengthShape& a, const StrengthShape& b) {
    double squares = 0.0;
    for (std::size_t k = 0; k < kShapeParts; ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(squares / kShapeParts);
}

}  // namespace tact
