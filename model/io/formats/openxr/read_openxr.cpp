// The C initialiser of a parametric vibration, as write_openxr.cpp writes it, read back.

#include <cmath>
#include <optional>

#include "model/io/formats/openxr/openxr.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// "    {1000, 0.5f, 0.25f}," as its numbers; empty of any other line.
std::vector<double> row_of(std::string_view line) {
    std::vector<double> row;
    line = trimmed(line);
    if (!line.starts_with('{') || !line.ends_with("},")) return row;
    line = line.substr(1, line.size() - 3);
    while (!line.empty()) {
        const std::size_t comma = std::min(line.find(','), line.size());
        std::string_view number = trimmed(line.substr(0, comma));
        if (number.ends_with('f')) number.remove_suffix(1);
        const auto value = finite_number_in(number);
        if (!value) return {};
        row.push_back(*value);
        line.remove_prefix(std::min(comma + 1, line.size()));
    }
    return row;
}

// Rows of the arrays, in the order of the arrays: amplitude, frequency, transients.
std::vector<std::vector<std::vector<double>>> arrays_of(std::string_view text) {
    std::vector<std::vector<std::vector<double>>> arrays;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with("[] = {")) arrays.emplace_back();
        const std::vector<double> row = row_of(line);
        if (!row.empty() && !arrays.empty()) arrays.back().push_back(row);
    }
    return arrays;
}

std::optional<AmplitudeCurve> curve_of(const std::vector<std::vector<double>>& rows) {
    AmplitudeCurve curve;
    for (const std::vector<double>& row : rows) {
        if (row.size() != 2) return std::nullopt;
        curve.push_back({1e-9 * row[0], row[1]});
    }
    return curve;
}

constexpr double kMergedWithinS = 0.001;

}  // namespace

Expected<Effect> openxr_back(const WrittenEffect& written, const EffectFile& file) {
    EffectFile linear = file;
    linear.map.frequency_law = FrequencyLaw::linear;
    const auto arrays = arrays_of(written.text);
    const Error broken{file.path + ": expected arrays of amplitude and frequency points"};
    if (arrays.size() < 2) return broken;
    const auto amplitude = curve_of(arrays[0]);
    const auto frequency = curve_of(arrays[1]);
    if (!amplitude || amplitude->size() < 2 || !frequency || frequency->empty()) return broken;
    Sketch sketch;
    sketch.unit_g = continuous_g(linear.map, 1.0);
    sketch.duration_s = amplitude->back().time_s;
    sketch.voices.push_back({0.0, sketch.duration_s, acceleration_curve(linear.map, *amplitude),
                             frequency_curve(linear.map, *frequency), 0.0});
    std::optional<double> last_s;
    for (std::size_t k = 0; arrays.size() > 2 && k < arrays[2].size(); ++k) {
        const std::vector<double>& row = arrays[2][k];
        if (row.size() != 3) return broken;
        const double time_s = 1e-9 * row[0];
        const bool merged = last_s && time_s - *last_s < kMergedWithinS;
        last_s = time_s;
        if (merged) continue;
        add_bursts(sketch.transients, transients_on(linear.map, time_s, row[1], row[2]));
    }
    return finished(linear, file.stem, sketch, {});
}

}  // namespace tact
