// Every parameter of the selected patterns: drag, type or nudge.

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/editing.h"
#include "app/panels/panels.h"
#include "app/widgets.h"
#include "viz/marks.h"

namespace tact {

namespace {

// One gesture on one number: written to all selected patterns, a step when it ends.
void edit_number(App& app, const Field& field, double value, const std::string& what,
                 const std::function<void(Pattern&, double)>& write) {
    double edited = value;
    const FieldEdit edit = draw_field(app, field, edited);
    if (edit.changed && edited != value) {
        edit_patterns(app, [&](Pattern& pattern) { write(pattern, edited); });
    }
    if (edit.finished) commit_step(app, "Change " + of_selection(app, what));
}

// The nearest frequency with a whole number of cycles: no energy leaks between bins.
double snapped_hz(double frequency_hz, double duration_s) {
    const double bin_hz = 1.0 / duration_s;
    return std::max(bin_hz, std::round(frequency_hz / bin_hz) * bin_hz);
}

bool leaks(const Pattern& pattern) {
    for (const Carrier& carrier : pattern.carriers) {
        const double cycles = carrier.frequency_hz * pattern.duration_s;
        if (std::abs(cycles - std::round(cycles)) > 1e-6) return true;
    }
    return false;
}

void draw_leak_warning(App& app, const Pattern& pattern) {
    if (!leaks(pattern) || !pattern.rhythm.text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(app.theme.warning));
    ImGui::TextUnformatted("leaks");
    ImGui::PopStyleColor();
    draw_tooltip(app,
                 "A carrier does not fit a whole number of cycles into the pattern. Its spectrum "
                 "leaks into neighbouring bins, and the model counts each of them: rates come out "
                 "too high. Frequencies that are multiples of 1 / duration do not leak.");
    ImGui::SameLine(0.0F, app.theme.gap_px);
    char label[64];
    std::snprintf(label, sizeof label, "Snap to %g Hz steps", 1.0 / pattern.duration_s);
    if (link(app, "snap", label)) {
        edit_patterns(app, [](Pattern& p) {
            for (Carrier& carrier : p.carriers) {
                carrier.frequency_hz = snapped_hz(carrier.frequency_hz, p.duration_s);
            }
        });
        commit_step(app, "Snap " + of_selection(app, "carriers"));
    }
}

void draw_carrier(App& app, const Pattern& pattern, std::size_t k) {
    const Carrier& carrier = pattern.carriers[k];
    ImGui::PushID(static_cast<int>(k));
    const std::string label = "Carrier " + std::to_string(k + 1);
    const std::string id = "carrier_" + std::to_string(k + 1) + "_hz";
    const double bin_hz = 1.0 / pattern.duration_s;
    edit_number(app,
                {id.c_str(),
                 label.c_str(),
                 "%.5g Hz",
                 {10.0, 500.0},
                 limits::kCarrierHz,
                 std::max(1.0, bin_hz),
                 bin_hz,
                 true,
                 "Frequency of the sine, in steps that do not leak. Typed values are exact and "
                 "reach from 0.1 to 1000 Hz."},
                carrier.frequency_hz, "carrier", [k](Pattern& p, double value) {
                    if (k < p.carriers.size()) p.carriers[k].frequency_hz = value;
                });
    ImGui::PopID();
}

// Share of the second of two carriers; with more, each has its own weight.
void draw_mix(App& app, const Pattern& pattern) {
    const auto& carriers = pattern.carriers;
    if (carriers.size() == 2) {
        const double sum = carriers[0].weight + carriers[1].weight;
        const double share = sum != 0.0 ? carriers[1].weight / sum : 0.5;
        edit_number(app,
                    {"mix",
                     "Mix",
                     "%.3g of 2",
                     {0.0, 1.0},
                     {0.0, 1.0},
                     0.05,
                     0.01,
                     false,
                     "Share of carrier 2; carrier 1 has the rest."},
                    share, "mix", [](Pattern& p, double value) {
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
        edit_number(
            app,
            {id.c_str(), label.c_str(), "%.3g", {0.0, 1.0}, limits::kCarrierWeight, 0.05, 0.01},
            carriers[k].weight, "weight", [k](Pattern& p, double value) {
                if (k < p.carriers.size()) p.carriers[k].weight = value;
            });
    }
}

void add_carrier(App& app) {
    edit_patterns(app, [](Pattern& p) {
        if (p.carriers.size() >= limits::kMaxCarriers) return;
        Carrier fresh = p.carriers.back();
        fresh.frequency_hz = snapped_hz(std::min(3.0 * fresh.frequency_hz, 500.0), p.duration_s);
        p.carriers.push_back(fresh);
        // Equal shares, so that the pattern does not get stronger by it.
        for (Carrier& carrier : p.carriers) {
            carrier.weight = 1.0 / static_cast<double>(p.carriers.size());
        }
    });
    commit_step(app, "Add " + of_selection(app, "carrier"));
}

void remove_carrier(App& app) {
    edit_patterns(app, [](Pattern& p) {
        if (p.carriers.size() < 2) return;
        p.carriers.pop_back();
        for (Carrier& carrier : p.carriers) {
            carrier.weight = 1.0 / static_cast<double>(p.carriers.size());
        }
    });
    commit_step(app, "Remove " + of_selection(app, "carrier"));
}

void draw_carrier_links(App& app, const Pattern& pattern) {
    ImGui::Dummy({0.0F, 0.0F});
    ImGui::SameLine(label_width(app) + ImGui::GetStyle().WindowPadding.x);
    if (pattern.carriers.size() < limits::kMaxCarriers) {
        if (link(app, "add carrier", "Add carrier")) add_carrier(app);
        note_item(app.rects, "link:add carrier");
        ImGui::SameLine(0.0F, 2.0F * app.theme.gap_px);
    }
    if (pattern.carriers.size() > 1) {
        if (link(app, "remove carrier", "Remove")) remove_carrier(app);
        note_item(app.rects, "link:remove carrier");
        ImGui::SameLine(0.0F, 2.0F * app.theme.gap_px);
    }
    draw_leak_warning(app, pattern);
    ImGui::NewLine();
}

void draw_modulation(App& app, const Pattern& pattern) {
    const Modulation& modulation = pattern.modulation;
    edit_number(app,
                {"modulation_hz",
                 "Modulation",
                 "%.4g Hz",
                 {0.0, 100.0},
                 limits::kModulationHz,
                 1.0,
                 1.0 / pattern.duration_s,
                 false,
                 "Frequency of the amplitude modulation; 0 is none."},
                modulation.frequency_hz, "modulation",
                [](Pattern& p, double value) { p.modulation.frequency_hz = value; });
    const bool am = modulation.kind == ModulationKind::am;
    edit_number(app,
                {"depth", "Depth", "%.3g", limits::kDepth, limits::kDepth, 0.05, 0.01, false,
                 am ? "m of 1 + m sin(2 pi f t)."
                    : "Only for the kind 1 + m sin: the product with a sine has no depth.",
                 am},
                modulation.depth, "depth",
                [](Pattern& p, double value) { p.modulation.depth = value; });
    draw_label(app, "Kind");
    const auto choose = [&](const char* label, ModulationKind kind) {
        if (ImGui::RadioButton(label, modulation.kind == kind) && modulation.kind != kind) {
            edit_patterns(app, [kind](Pattern& p) { p.modulation.kind = kind; });
            commit_step(app, "Change " + of_selection(app, "modulation kind"));
        }
        note_item(app.rects, std::string("radio:") + label);
    };
    choose("product", ModulationKind::product);
    draw_tooltip(app, "sin(2 pi f t): Eq. 7 of the paper; the envelope has twice the frequency.");
    ImGui::SameLine(0.0F, 2.0F * app.theme.gap_px);
    choose("1 + m sin", ModulationKind::am);
}

// One rhythm step: a click turns rest into note, note into hold (where it can), hold into rest.
std::string stepped(std::string text, std::size_t step) {
    const bool can_hold = step > 0 && text[step - 1] != '-';
    if (text[step] == '-') {
        text[step] = 'x';
    } else if (text[step] == 'x' && can_hold) {
        text[step] = '=';
    } else {
        text[step] = '-';
        // A hold needs a note before it.
        for (std::size_t k = step + 1; k < text.size() && text[k] == '='; ++k) text[k] = '-';
    }
    return text;
}

void set_rhythm(App& app, const std::string& text) {
    edit_patterns(app, [&text](Pattern& p) { p.rhythm.text = text; });
    commit_step(app, "Change " + of_selection(app, "rhythm"));
}

void draw_rhythm_grid(App& app, const Rhythm& rhythm) {
    const Theme& theme = app.theme;
    const std::size_t steps = rhythm.text.size();
    const float width = ImGui::GetContentRegionAvail().x;
    const float cell = std::min(20.0F * theme.scale, width / static_cast<float>(steps));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k < steps; ++k) {
        const char mark = rhythm.text[k];
        const ImVec2 min{corner.x + static_cast<float>(k) * cell, corner.y};
        const float gap = 1.5F * theme.scale;
        // A held step joins the one before it.
        const float left = mark == '=' ? min.x - gap : min.x + gap;
        ImGui::SetCursorScreenPos(min);
        ImGui::PushID(static_cast<int>(k));
        const bool pressed = ImGui::InvisibleButton("step", {cell, cell});
        note_item(app.rects, "step:" + std::to_string(k), std::string(1, mark));
        ImU32 colour = mark == '-' ? theme.field : theme.accent;
        if (ImGui::IsItemHovered()) colour = mark == '-' ? theme.hover : theme.text;
        list.AddRectFilled({left, min.y + gap}, {min.x + cell - gap, min.y + cell - gap}, colour,
                           2.0F * theme.scale);
        ImGui::PopID();
        if (pressed) set_rhythm(app, stepped(rhythm.text, k));
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + cell});
    ImGui::Dummy({width, 2.0F * theme.scale});
}

void draw_rhythm(App& app, const Pattern& pattern) {
    EditorState& state = app.editor;
    draw_label(app, "Rhythm");
    if (!state.rhythm_typing) state.rhythm_text = pattern.rhythm.text;
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##rhythm", "one note throughout; x=-x note, hold, rest",
                             &state.rhythm_text);
    note_item(app.rects, "rhythm", pattern.rhythm.text);
    state.rhythm_typing = ImGui::IsItemActive();
    const std::string fault = rhythm_fault(state.rhythm_text);
    if (state.rhythm_typing && fault.empty() && state.rhythm_text != pattern.rhythm.text) {
        edit_patterns(app, [&state](Pattern& p) { p.rhythm.text = state.rhythm_text; });
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        if (fault.empty()) {
            commit_step(app, "Change " + of_selection(app, "rhythm"));
        } else {
            complain(app, "Rhythm: " + fault + "; the pattern keeps " +
                              (pattern.rhythm.text.empty() ? "one note throughout"
                                                           : "\"" + pattern.rhythm.text + "\""));
        }
    }
    if (state.rhythm_typing && !fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(app.theme.error));
        ImGui::TextUnformatted(fault.c_str());
        ImGui::PopStyleColor();
    }
    if (pattern.rhythm.text.empty()) {
        ImGui::Dummy({0.0F, 0.0F});
        ImGui::SameLine(label_width(app) + ImGui::GetStyle().WindowPadding.x);
        if (link(app, "make grid", "Make a rhythm")) set_rhythm(app, "x=--x=--");
        note_item(app.rects, "link:make a rhythm");
        return;
    }
    draw_rhythm_grid(app, pattern.rhythm);
    edit_number(app,
                {"unit_ms",
                 "Step",
                 "%.4g ms",
                 {5.0, 500.0},
                 {1.0, 10'000.0},
                 5.0,
                 1.0,
                 true,
                 "Length of one x, = or -. The text repeats to fill the duration."},
                1000.0 * pattern.rhythm.unit_s, "rhythm step",
                [](Pattern& p, double value) { p.rhythm.unit_s = value / 1000.0; });
}

void draw_times(App& app, const Pattern& pattern) {
    edit_number(app,
                {"attack_ms",
                 "Attack",
                 "%.4g ms",
                 {0.0, 500.0},
                 {0.0, 10'000.0},
                 5.0,
                 1.0,
                 false,
                 "Linear rise at the beginning of every note."},
                1000.0 * pattern.attack_s, "attack",
                [](Pattern& p, double value) { p.attack_s = value / 1000.0; });
    edit_number(app,
                {"release_ms",
                 "Release",
                 "%.4g ms",
                 {0.0, 500.0},
                 {0.0, 10'000.0},
                 5.0,
                 1.0,
                 false,
                 "Linear fall at the end of every note."},
                1000.0 * pattern.release_s, "release",
                [](Pattern& p, double value) { p.release_s = value / 1000.0; });
    edit_number(app,
                {"duration_s",
                 "Duration",
                 "%.4g s",
                 {0.05, 10.0},
                 limits::kDurationS,
                 0.05,
                 0.05,
                 true,
                 "The model was validated at 1 s. Shorter patterns of a set are padded with "
                 "silence to its longest. Typed values reach 60 s."},
                pattern.duration_s, "duration",
                [](Pattern& p, double value) { p.duration_s = value; });
}

void draw_measurement(App& app, const Measurement& measurement) {
    dim_text(app, "Measured waveform");
    ImGui::TextWrapped("%s", measurement.path.c_str());
    char text[128];
    std::snprintf(text, sizeof text, "%.4g s, peak %.3g g, %.4g g at full scale",
                  duration_s(*measurement.waveform), peak_g(*measurement.waveform),
                  measurement.scale_g);
    dim_text(app, text);
    if (!measurement.measures.empty()) {
        ImGui::TextWrapped("Measures %s", measurement.measures.c_str());
    }
}

bool is_saved(const PatternSet& saved, const Vibration& vibration) {
    return std::ranges::any_of(saved.vibrations, [&vibration](const Vibration& v) {
        return v.name == vibration.name && v.source == vibration.source;
    });
}

void draw_note(App& app, const Vibration& vibration) {
    if (vibration.note.empty()) return;
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(app.theme.dim_text));
    ImGui::PushFont(app.theme.fonts.small);
    // A note describes what was opened; it does not follow edits.
    const bool edited = app.unsaved && !is_saved(app.document.saved, vibration);
    ImGui::TextWrapped("%s%s", edited ? "Note, from before the edit: " : "",
                       vibration.note.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

}  // namespace

void draw_editor_panel(App& app) {
    const Vibration* vibration = current_vibration(app);
    if (vibration == nullptr) {
        draw_empty(*ImGui::GetWindowDrawList(), app.theme, rest_of_pane(), "Nothing to edit",
                   "Select a pattern above, or press New.");
        return;
    }
    draw_hint(app, "editor",
              "Drag a slider and watch the point move on the right. Type a number for an exact "
              "value; arrow keys nudge.");
    if (!ImGui::BeginChild("fields")) {
        ImGui::EndChild();
        return;
    }
    const Vibration shown = *vibration;  // edits below replace the document's own
    ImGui::BeginDisabled(shown.locked);
    if (const auto* pattern = std::get_if<Pattern>(&shown.source)) {
        edit_number(app,
                    {"amplitude_g",
                     "Amplitude",
                     "%.3g g",
                     {0.0, 4.0},
                     limits::kAmplitudeG,
                     0.05,
                     0.01,
                     false,
                     "Peak acceleration of the sum of carriers. Typed values reach 50 g."},
                    pattern->amplitude_g, "amplitude",
                    [](Pattern& p, double value) { p.amplitude_g = value; });
        for (std::size_t k = 0; k < pattern->carriers.size(); ++k) draw_carrier(app, *pattern, k);
        draw_mix(app, *pattern);
        draw_carrier_links(app, *pattern);
        draw_modulation(app, *pattern);
        draw_rhythm(app, *pattern);
        draw_times(app, *pattern);
    } else {
        draw_measurement(app, std::get<Measurement>(shown.source));
    }
    ImGui::EndDisabled();
    draw_note(app, shown);
    ImGui::EndChild();
}

}  // namespace tact
