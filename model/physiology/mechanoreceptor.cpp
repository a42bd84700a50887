#include "model/physiology/mechanoreceptor.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>

#include "assets/assets.h"
#include "model/common/portable.h"
#include "model/physiology/log_curve.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Lim & Park 2023, section 4.1 and Table 1.
constexpr std::array<ReceptorTraits, kReceptorCount> kTraits{{
    {"Meissner", "FA1", "NP I", 3.0, 100.0, 1.4, true},
    {"Pacinian", "FA2", "P", 10.0, 500.0, 0.2, true},
    {"Merkel", "SA1", "NP III", 0.0, 5.0, 0.7, false},
    {"Ruffini", "SA2", "NP II", 15.0, 400.0, 0.1, false},
}};

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

// Adds one line of a table to the curve of its receptor; returns the error, or an empty text.
std::string add_knot(const std::vector<std::string>& header, const std::string& line,
                     const TableTraits& table, PerReceptor<Curve>& curves) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != header.size()) {
        return "expected " + std::to_string(header.size()) + " columns";
    }
    const auto cell = [&](std::string_view column) -> const std::string& {
        const auto place = std::ranges::find(header, column) - header.begin();
        return cells[static_cast<std::size_t>(place)];
    };
    const auto receptor = std::ranges::find_if(
        kTraits, [&](const ReceptorTraits& t) { return cell("receptor") == t.afferent; });
    if (receptor == kTraits.end()) return "expected a receptor of FA1, FA2, SA1, SA2";
    Curve& curve = curves[static_cast<std::size_t>(receptor - kTraits.begin())];
    const auto frequency_hz = finite_number_in(cell("frequency_hz"));
    const double above_hz = curve.frequency_hz.empty() ? 0.0 : curve.frequency_hz.back();
    if (!frequency_hz || *frequency_hz <= above_hz) return "expected frequencies that ascend";
    const std::string& written = cell(table.column);
    const auto value = finite_number_in(written);
    if (!value) return std::string("expected a number as ") + table.column;
    if (!table.values.contains(*value)) {
        return std::string("expected ") + table.expected + ", got " + written;
    }
    curve.frequency_hz.push_back(*frequency_hz);
    curve.value.push_back(*value);
    return {};
}

Expected<PerReceptor<Curve>> parse_curves(const std::string& csv, const TableTraits& table) {
    PerReceptor<Curve> curves;
    std::vector<std::string> header;
    std::istringstream lines(csv);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || line.front() == '#') continue;
        std::string fault;
        if (header.empty()) {
            header = cells_of(line);
            for (const std::string_view column :
                 {std::string_view("receptor"), std::string_view("frequency_hz"),
                  std::string_view(table.column)}) {
                if (std::ranges::find(header, column) == header.end()) {
                    fault = "expected a column " + std::string(column);
                }
            }
        } else {
            fault = add_knot(header, line, table, curves);
        }
        if (!fault.empty()) {
            return Error{table.name + (", line " + std::to_string(number) + ": ") + fault};
        }
    }
    for (const Receptor receptor : kReceptors) {
        if (curves[index_of(receptor)].frequency_hz.empty()) {
            return Error{table.name + std::string(": expected at least one line for ") +
                         traits(receptor).afferent};
        }
    }
    return curves;
}

// `log10_hz` returns the logarithm of a knot.
template <class Log10Hz>
double between_knots(const Curve& curve, const LogFrequency& frequency, const Log10Hz& log10_hz) {
    const auto& knots = curve.frequency_hz;
    const auto above = std::ranges::upper_bound(knots, frequency.frequency_hz);
    if (above == knots.begin()) return curve.value.front();
    if (above == knots.end()) return curve.value.back();
    const auto k = static_cast<std::size_t>(above - knots.begin());
    const double position =
        (frequency.log10_hz - log10_hz(k - 1)) / (log10_hz(k) - log10_hz(k - 1));
    return curve.value[k - 1] + position * (curve.value[k] - curve.value[k - 1]);
}

}  // namespace

const ReceptorTraits& traits(Receptor receptor) { return kTraits[index_of(receptor)]; }

double grid_interval_mm(Receptor receptor) {
    return 1.0 / std::sqrt(traits(receptor).density_per_mm2);
}

double at(const Curve& curve, double frequency_hz) {
    const auto log10_hz = [&](std::size_t k) { return portable::log10(curve.frequency_hz[k]); };
    return between_knots(curve, {frequency_hz, portable::log10(frequency_hz)}, log10_hz);
}

LogCurve log_curve(const Curve& curve) {
    LogCurve result{curve, {}};
    for (const double knot_hz : curve.frequency_hz) {
        result.log10_hz.push_back(portable::log10(knot_hz));
    }
    return result;
}

LogFrequency log_frequency(double frequency_hz) {
    return {frequency_hz, portable::log10(frequency_hz)};
}

double at(const LogCurve& curve, const LogFrequency& frequency) {
    return between_knots(curve.curve, frequency, [&](std::size_t k) { return curve.log10_hz[k]; });
}

const PhysiologyTables& default_tables() {
    static const PhysiologyTables tables = [] {
        auto parsed = parse_tables(std::string(asset("physiology/firing_rate_slopes.csv")),
                                   std::string(asset("physiology/absolute_thresholds.csv")));
        assert(parsed && "the compiled-in physiology tables do not parse");
        return *parsed;
    }();
    return tables;
}

const PerReceptor<Curve>& aosp_thresholds() {
    static const PerReceptor<Curve> curves = [] {
        auto parsed =
            parse_thresholds(std::string(asset("physiology/absolute_thresholds_aosp.csv")));
        assert(parsed && "the compiled-in second thresholds do not parse");
        return *parsed;
    }();
    return curves;
}

Expected<PerReceptor<Curve>> parse_slopes(const std::string& csv) {
    return parse_curves(csv, kSlopeTable);
}

Expected<PerReceptor<Curve>> parse_thresholds(const std::string& csv) {
    return parse_curves(csv, kThresholdTable);
}

Expected<PhysiologyTables> parse_tables(const std::string& slopes_csv,
                                        const std::string& thresholds_csv) {
    auto slope = parse_slopes(slopes_csv);
    if (!slope) return slope.error();
    auto threshold = parse_thresholds(thresholds_csv);
    if (!threshold) return threshold.error();
    return PhysiologyTables{*slope, *threshold};
}

}  // namespace tact
