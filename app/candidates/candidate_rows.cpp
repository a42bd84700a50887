#include "app/candidates/candidates.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "app/document/editing.h"
#include "app/rendering/rendering.h"
#include "model/io/tables/matrix_file.h"
#include "model/pattern/pattern_parameter.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

using RowsByName = std::unordered_map<std::string_view, std::size_t>;

DrawnNumbers drawn_numbers(const Pattern& pattern) {
    constexpr int kLooks = 200;
    const double step_s = pattern.duration_s / kLooks;
    double peak_g = 0.0;
    double strength = 0.0;  // g s
    double turns = 0.0;     // times Hz
    const auto add = [&](double g, double hz, double seconds) {
        peak_g = std::max(peak_g, g);
        strength += g * seconds;
        turns += g * seconds * hz;
    };
    for (int k = 0; k < kLooks; ++k) {
        const double t_s = (k + 0.5) * step_s;
        add(envelope_g(pattern, t_s), first_carrier_hz(pattern, t_s), step_s);
    }
    for (const auto& point : pattern.amplitude_curve) {
        peak_g = std::max(peak_g, envelope_g(pattern, point.time_s));
    }
    for (const Transient& one : pattern.transients) {
        add(one.amplitude_g, one.frequency_hz, one.duration_s);
    }
    DrawnNumbers numbers{pattern, peak_g, {}};
    if (strength > 0.0) numbers.mean_hz = turns / strength;
    return numbers;
}

// Taken from those of the rows before, where the pattern is still the same.
DrawnNumbers drawn_of(const std::string& name, const Pattern& pattern, DrawnByName& before) {
    const auto known = before.find(name);
    if (known != before.end() && known->second.of == pattern) return std::move(known->second);
    return drawn_numbers(pattern);
}

CandidateRow row_of(const Vibration& vibration, std::size_t place, DrawnByName& before,
                    DrawnByName& drawn) {
    CandidateRow row;
    row.place = place;
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    if (pattern == nullptr) {
        row.duration_s = own_duration_s(vibration);
        return row;
    }
    row.amplitude_g = value_of(*pattern, PatternParameter::amplitude);
    row.carrier_hz = value_of(*pattern, PatternParameter::carrier);
    for (std::size_t k = 1; k < pattern->carriers.size(); ++k) {
        if (pattern->carriers[k].weight > 0.0)
            row.further_hz.push_back(pattern->carriers[k].frequency_hz);
    }
    row.modulation_hz = value_of(*pattern, PatternParameter::modulation);
    row.rhythm = pattern->rhythm.text;
    row.duration_s = pattern->duration_s;
    if (!is_drawn(*pattern)) return row;
    const DrawnNumbers numbers = drawn_of(vibration.name, *pattern, before);
    row.peak_g = numbers.peak_g;
    row.mean_hz = numbers.mean_hz;
    row.ticks = pattern->transients.size();
    drawn.emplace(vibration.name, numbers);
    return row;
}

void add_nearest(CandidateRow& row, const LiveMap& map, const RowsByName& in_map,
                 const std::string& name) {
    const auto found = in_map.find(name);
    if (found == in_map.end() || found->second >= map.nearest.size()) return;
    const NearestNeighbour& nearest = map.nearest[found->second];
    if (!nearest.exists_for(found->second)) return;
    row.nearest_pm = nearest.dissimilarity;
    row.nearest_name = map.request.set->vibrations[nearest.place].name;
}

template <class Value>
bool is_before(const std::optional<Value>& a, const std::optional<Value>& b, bool descending) {
    if (!a || !b) return a.has_value() && !b.has_value();
    return descending ? *b < *a : *a < *b;
}

std::optional<double> sort_key(const CandidateRow& row, CandidateColumn by) {
    if (by == CandidateColumn::picked) return row.picked ? 1.0 : 0.0;
    return number_in(row, by);
}

void sort_rows(std::vector<CandidateRow>& rows, const Workspace& work,
               const CandidatesState& state) {
    const auto& all = work.document.set.vibrations;
    const bool down = state.descending;
    std::ranges::stable_sort(rows, [&](const CandidateRow& a, const CandidateRow& b) {
        if (state.by == CandidateColumn::picture)
            return down ? b.place < a.place : a.place < b.place;
        if (state.by == CandidateColumn::name) {
            return is_before(std::optional(all[a.place].name), std::optional(all[b.place].name),
                             down);
        }
        if (state.by == CandidateColumn::rhythm) return is_before(a.rhythm, b.rhythm, down);
        return is_before(sort_key(a, state.by), sort_key(b, state.by), down);
    });
}

}  // namespace

std::optional<double> number_in(const CandidateRow& row, CandidateColumn column) {
    switch (column) {
        case CandidateColumn::amplitude:
            return row.peak_g ? row.peak_g : row.amplitude_g;
        case CandidateColumn::carrier:
            return row.mean_hz ? row.mean_hz : row.carrier_hz;
        case CandidateColumn::modulation:
            return row.modulation_hz;
        case CandidateColumn::duration:
            return row.duration_s;
        case CandidateColumn::nearest:
            return row.nearest_pm;
        default:
            return std::nullopt;
    }
}

const std::vector<CandidateRow>& candidate_rows(const Workspace& work, const ShownMap& shown_map,
                                                CandidatesState& state) {
    const Selection& selection = work.selection;
    const auto& map = shown_map.transition.shown;
    const CandidatesAsked wanted{work.revision,    map,
                                 state.by,         state.descending,
                                 selection.search, is_narrowed_to_picked(selection),
                                 selection.picked};
    if (state.asked == wanted) return state.rows;
    state.asked = wanted;
    RowsByName in_map;
    for (std::size_t k = 0; map && k < map->request.set->vibrations.size(); ++k) {
        in_map.emplace(map->request.set->vibrations[k].name, k);
    }
    DrawnByName before = std::exchange(state.drawn, {});
    state.rows.clear();
    for (const std::size_t place : listed_indices(work)) {
        const Vibration& vibration = work.document.set.vibrations[place];
        CandidateRow row = row_of(vibration, place, before, state.drawn);
        if (map) add_nearest(row, *map, in_map, vibration.name);
        row.picked = selection.picked.contains(vibration.name);
        state.rows.push_back(std::move(row));
    }
    sort_rows(state.rows, work, state);
    return state.rows;
}

std::string candidates_csv(const PatternSet& set, const std::vector<CandidateRow>& rows) {
    const auto number = [](const std::optional<double>& value) {
        return value ? shortest_digits(*value) : std::string();
    };
    const auto carriers = [&number](const CandidateRow& row) {
        std::string text = number(row.carrier_hz);
        for (const double hz : row.further_hz) text += "+" + shortest_digits(hz);
        return text;
    };
    const auto line = [](const std::vector<std::string>& cells) { return csv_row(cells); };
    std::string csv =
        line({"name", "amplitude_g", "carriers_hz", "modulation_hz", "rhythm", "duration_s",
              "nearest", "nearest_pm", "picked", "mark", "peak_g", "mean_hz", "ticks"});
    const std::string mark = corner_text(mark_of(set));
    for (const CandidateRow& row : rows) {
        csv += line({set.vibrations[row.place].name, number(row.amplitude_g), carriers(row),
                     number(row.modulation_hz), row.rhythm.value_or(""), number(row.duration_s),
                     row.nearest_name, number(row.nearest_pm), row.picked ? "yes" : "no", mark,
                     number(row.peak_g), number(row.mean_hz),
                     row.peak_g ? std::to_string(row.ticks) : std::string()});
    }
    return csv;
}

void sort_by(CandidatesState& state, CandidateColumn column) {
    const bool largest_first =
        column == CandidateColumn::nearest || column == CandidateColumn::picked;
    state.descending = state.by == column ? !state.descending : largest_first;
    state.by = column;
}

}  // namespace tact
