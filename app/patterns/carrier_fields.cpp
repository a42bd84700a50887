#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/document/editing.h"
#include "app/patterns/parts.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// The nearest frequency with a whole number of cycles, so that no energy leaks between bins.
double snapped_hz(double frequency_hz, double duration_s) {
    return snapped_to(frequency_hz, 1.0 / duration_s);
}

void share_equally(Pattern& pattern) {
    for (Carrier& carrier : pattern.carriers) {
        carrier.weight = 1.0 / static_cast<double>(pattern.carriers.size());
    }
}

bool leaks(const Pattern& pattern) {
    if (!pattern.frequency_curve.empty())
        return false;  // a sweep has no whole number of cycles
                       // anyway
    for (const Carrier& carrier : pattern.carriers) {
        const double cycles = carrier.frequency_hz * pattern.duration_s;
        if (std::abs(cycles - std::round(cycles)) > 1e-6) return true;
    }
    return false;
}

void draw_leak_warning(Ui& ui, Workspace& work, const Pattern& pattern) {
    if (!leaks(pattern) || !pattern.rhythm.text.empty()) return;
    constexpr const char* kNotWhole = "not a whole number of cycles:";
    const std::string label =
        "snap to steps of " + significant_digits(1.0 / pattern.duration_s, 4) + " Hz";
    const float gap = ui.theme.gap_px;
    const float snap = ImGui::CalcTextSize(label.c_str()).x;
    const float both = ImGui::CalcTextSize(kNotWhole).x + gap + snap;
    if (!flow_on(both, 2.0F * gap)) draw_label(ui, "", both);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(ui.theme.warning));
    ImGui::TextUnformatted(kNotWhole);
    ImGui::PopStyleColor();
    draw_tooltip(ui,
                 "A carrier does not fit a whole number of cycles into the pattern. Its spectrum "
                 "leaks into neighbouring bins, and the model counts each of them: rates come out "
                 "too high. Frequencies that are multiples of 1 / duration do not leak.");
    flow_on(snap, gap);
    if (link(ui, {.id = "link:snap", .label = label})) {
        edit_patterns(work, [](Pattern& p) {
            for (Carrier& carrier : p.carriers) {
                carrier.frequency_hz = snapped_hz(carrier.frequency_hz, p.duration_s);
            }
        });
        commit_step(ui, work, "Snap " + of_selection(work, "carriers"));
    }
}

void draw_carrier(Ui& ui, Workspace& work, const Pattern& pattern, std::size_t k) {
    ImGui::PushID(static_cast<int>(k));
    const std::string label = "Carrier " + std::to_string(k + 1);
    const std::string id = "carrier_" + std::to_string(k + 1) + "_hz";
    const double bin_hz = 1.0 / pattern.duration_s;
    Field field = field_of(numbers::kCarrier, id.c_str());
    field.label = label.c_str();
    field.step = std::max(1.0, bin_hz);
    field.snap = bin_hz;
    field.enabled = k != 0 || pattern.frequency_curve.empty();
    if (!field.enabled) {
        field.help =
            "Drawn: the frequency curve above is this carrier's; the others keep their ratio to "
            "it.";
    }
    edit_number(ui, work, numbers::kCarrier, field, "carrier", [k](auto& p) {
        return k < p.carriers.size() ? &p.carriers[k].frequency_hz : nullptr;
    });
    ImGui::PopID();
}

// Frequency of the second of two carriers.
std::optional<double> mix_of(const Pattern& pattern) {
    const auto& carriers = pattern.carriers;
    if (carriers.size() != 2) return std::nullopt;
    const double sum = carriers[0].weight + carriers[1].weight;
    return sum != 0.0 ? carriers[1].weight / sum : 0.5;
}

// Share of the second of two carriers; three or more have a weight each.
void draw_mix(Ui& ui, Workspace& work, const Pattern& pattern) {
    const auto& carriers = pattern.carriers;
    if (carriers.size() == 2) {
        edit_number(ui, work,
                    {.id = "mix",
                     .label = "Mix",
                     .format = "%.3g",
                     .slider = {0.0, 1.0},
                     .typed = {0.0, 1.0},
                     .step = 0.05,
                     .snap = 0.01,
                     .help = "Share of carrier 2; carrier 1 has the rest."},
                    "mix", mix_of, [](Pattern& p, double value) {
                        if (p.carriers.size() != 2) return;
                        p.carriers[0].weight = 1.0 - value;
                        p.carriers[1].weight = value;
                    });
        return;
    }
    if (carriers.size() < 2) return;
    for (std::size_t k = 0; k < carriers.size(); ++k) {
        const std::string label = "Weight " + std::to_string(k + 1);
        const std::string id = "weight_" + std::to_string(k + 1);
        Field field = field_of(numbers::kWeight, id.c_str());
        field.label = label.c_str();
        edit_number(ui, work, numbers::kWeight, field, "weight", [k](auto& p) {
            return k < p.carriers.size() ? &p.carriers[k].weight : nullptr;
        });
    }
}

void add_carrier(Ui& ui, Workspace& work) {
    edit_patterns(work, [](Pattern& p) {
        const std::size_t before = p.carriers.size();
        push_carrier(p);
        if (p.carriers.size() == before) return;
        double& fresh_hz = p.carriers.back().frequency_hz;
        fresh_hz = snapped_hz(fresh_hz, p.duration_s);
    });
    commit_step(ui, work, "Add " + of_selection(work, "carrier"));
}

void remove_carrier(Ui& ui, Workspace& work) {
    edit_patterns(work, [](Pattern& p) {
        if (p.carriers.size() < 2) return;
        p.carriers.pop_back();
        share_equally(p);
    });
    commit_step(ui, work, "Remove " + of_selection(work, "carrier"));
}

void draw_carrier_links(Ui& ui, Workspace& work, const Pattern& pattern) {
    constexpr const char* kAdd = "Add carrier";
    draw_label(ui, "", ImGui::CalcTextSize(kAdd).x);
    const bool can_add = pattern.carriers.size() < limits::kMaxCarriers;
    if (can_add) {
        if (field_link(ui, work, "link:add carrier", kAdd,
                       "One more tone, at three times the last one's frequency")) {
            add_carrier(ui, work);
        }
    }
    if (pattern.carriers.size() > 1) {
        if (can_add) flow_on(ImGui::CalcTextSize("Remove").x, 2.0F * ui.theme.gap_px);
        if (field_link(ui, work, "link:remove carrier", "Remove", "The last carrier goes"))
            remove_carrier(ui, work);
    }
    draw_leak_warning(ui, work, pattern);
}

}  // namespace

bool field_link(Ui& ui, const Workspace& work, const char* id, const std::string& label,
                const char* tip) {
    const bool is_locked = current_vibration(work)->locked;
    return link(ui, {.id = id,
                     .label = label,
                     .tip = tip,
                     .why_not = is_locked ? "The pattern is locked. Unlock it to change it." : ""});
}

double snapped_to(double value, double snap) {
    return snap > 0.0 ? std::max(snap, multiple_of(snap, std::round(value / snap))) : value;
}

void push_carrier(Pattern& pattern) {
    constexpr double kHighestHz = 500.0;
    if (pattern.carriers.size() >= limits::kMaxCarriers) return;
    Carrier fresh = pattern.carriers.back();
    fresh.frequency_hz = std::min(3.0 * fresh.frequency_hz, kHighestHz);
    pattern.carriers.push_back(fresh);
    share_equally(pattern);
}

void draw_carrier_fields(Ui& ui, Workspace& work, const Pattern& pattern) {
    for (std::size_t k = 0; k < pattern.carriers.size(); ++k) draw_carrier(ui, work, pattern, k);
    draw_mix(ui, work, pattern);
    draw_carrier_links(ui, work, pattern);
}

}  // namespace tact
