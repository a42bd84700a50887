// One number of several patterns at a time.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/patterns/parts.h"
#include "model/text/numbers.h"
#include "model/text/typed_number.h"

namespace tact {

namespace {

struct Followed {
    std::vector<double> values;  // the edited patterns, in the order of the list
    std::size_t leader = 0;      // the current pattern's place among them
};

Followed followed(const Workspace& work, const ReadNumber& read) {
    Followed all;
    for (const std::size_t index : selected_indices(work)) {
        const Pattern* pattern = editable_layer(work, index);
        const auto value = pattern == nullptr ? std::nullopt : read(*pattern);
        if (!value) continue;
        if (index == work.selection.current) all.leader = all.values.size();
        all.values.push_back(*value);
    }
    return all;
}

// A pattern with default numbers and this many carriers.
Pattern normal_pattern(const Workspace& work, std::size_t carriers) {
    Pattern normal;
    normal.duration_s = work.document.set.duration_s;
    while (normal.carriers.size() < carriers) push_carrier(normal);
    return normal;
}

// Values of all as the leader goes to `to`. `before`: the values at the gesture's beginning.
std::vector<double> targets(const Followed& all, std::vector<double> before, const Field& field,
                            const NumberEdit& edit, double to) {
    if (before.size() != all.values.size()) before = all.values;
    const bool by_ratio = std::ranges::all_of(before, [](double value) { return value > 0.0; });
    std::vector<double> to_each = all.values;
    for (std::size_t k = 0; k < to_each.size(); ++k) {
        double& value = to_each[k];
        switch (edit.along) {
            case Along::same:
                value = to;
                break;
            case Along::factor:
                value *= edit.factor;
                break;
            case Along::ratio:
                value = by_ratio ? snapped_to(before[k] * (to / before[all.leader]), field.snap)
                                 : before[k] + (to - before[all.leader]);
                break;
            case Along::step:
                value += to - all.values[all.leader];
                break;
            case Along::back:
                value = before[k];
                break;
        }
    }
    to_each[all.leader] = to;
    return to_each;
}

// Writes all values; returns the number of patterns that did not reach theirs, because it is out of
// range.
std::size_t write_all(Workspace& work, const std::vector<double>& to_each, const ReadNumber& read,
                      const WriteNumber& write) {
    std::size_t k = 0;
    edit_patterns(work, [&](Pattern& pattern) {
        if (read(pattern) && k < to_each.size()) write(pattern, to_each[k++]);
    });
    const std::vector<double> reached = followed(work, read).values;
    std::size_t clamped = 0;
    for (k = 0; k < std::min(reached.size(), to_each.size()); ++k) {
        constexpr double kSame = 1e-9;
        clamped += std::abs(reached[k] - to_each[k]) > kSame * std::max(1.0, std::abs(to_each[k]));
    }
    return clamped;
}

// Patterns over the slider's range, once the mouse rests on it.
void note_rested(const Ui& ui, Workspace& work, const Field& field, const Pattern& shown,
                 const WriteNumber& write) {
    constexpr double kRestS = 0.15;
    constexpr int kPlaces = 13;
    const bool rests = ui.time_s - ui.hover_since_s >= kRestS;
    const bool alone = work.selection.others.empty() && current_layers(work) == nullptr;
    if (!rests || ImGui::GetIO().MouseDown[0] || !alone) return;
    RestedNumber rested{
        work.document.set.vibrations[work.selection.current].name, field.id, {}, {}};
    const auto [low, high] = field.slider;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k < kPlaces; ++k) {
        const double share = static_cast<double>(k) / (kPlaces - 1);
        const double exact =
            field.logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
        // Snaps as the slider itself does: down to 0.
        const double whole =
            field.snap > 0.0 ? multiple_of(field.snap, std::round(exact / field.snap)) : exact;
        const double value = std::clamp(whole, low, high);
        if (value == last) continue;
        last = value;
        Pattern changed = shown;
        write(changed, value);
        rested.patterns.push_back(clamped(std::move(changed)));
        rested.words.push_back(shown_number(field.format, value));
    }
    work.selection.rested = std::move(rested);
}

// "0 to 10000 ms": what can be typed.
std::string typed_words(const Field& field) {
    const std::string unit(unit_in(field.format));
    return significant_digits(field.typed.low, 6) + " to " +
           significant_digits(field.typed.high, 6) + (unit.empty() ? "" : " " + unit);
}

// Its help, and what can be typed where the slider has less.
std::string help_with_reach(const Field& field) {
    const std::string help = field.help == nullptr ? "" : field.help;
    if (!field.enabled || field.slider == field.typed) return help;
    return help + (help.empty() ? "" : " ") + "Typed values reach from " + typed_words(field) + ".";
}

void tell_clamped(Ui& ui, const Field& field, std::size_t clamped, std::size_t count) {
    if (clamped == 0 || count < 2) return;
    complain(ui, std::string(field.label) + ": " + std::to_string(clamped) + " of " +
                     std::to_string(count) + " patterns stopped at the end of the range, " +
                     typed_words(field));
}

}  // namespace

void edit_number(Ui& ui, Workspace& work, Field field, const std::string& what,
                 const ReadNumber& read, const WriteNumber& write) {
    const Pattern* pattern = shown_pattern(work);
    if (pattern == nullptr) return;
    const Pattern shown = *pattern;
    const auto value = read(shown);
    if (!value) return;
    const Followed all = followed(work, read);
    if (!all.values.empty()) {
        const auto [least, most] = std::ranges::minmax(all.values);
        if (least != most) field.mixed = Range{least, most};
    }
    field.normal = read(normal_pattern(work, shown.carriers.size()));
    const std::string help = help_with_reach(field);
    if (!help.empty()) field.help = help.c_str();
    double edited = *value;
    const FieldEdit edit = draw_field(ui, field, edited);
    if (edit.begun) {
        ui.field.before = all.values;
        ui.field.clamped = 0;
    }
    if (edit.changed && !all.values.empty() && (edited != *value || all.values.size() > 1)) {
        ui.field.clamped =
            write_all(work, targets(all, ui.field.before, field, edit, edited), read, write);
    }
    if (edit.over_bar && !edit.changed) note_rested(ui, work, field, shown, write);
    if (!edit.finished) return;
    commit_step(ui, work, "Change " + of_selection(work, what));
    tell_clamped(ui, field, std::exchange(ui.field.clamped, 0), all.values.size());
}

}  // namespace tact
