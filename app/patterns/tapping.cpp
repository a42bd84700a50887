#include "app/patterns/patterns.h"

#include <algorithm>
#include <string>

#include "app/document/editing.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr std::size_t kMostTaps = 256;

// A press begins a note, a release ends it.
void follow_taps(const Ui& ui, TappingState& tapping, bool button_held) {
    const double now_s = ImGui::GetTime();
    const bool keys = ImGui::IsKeyDown(ImGuiKey_T) || ImGui::IsKeyDown(kSpaceBar);
    if (!keys) tapping.has_opened = false;
    const bool key_held = keys && !tapping.has_opened && !is_number_typed(ui);
    const bool held = key_held || button_held;
    if (held && !tapping.down_s && tapping.taps.size() < kMostTaps) tapping.down_s = now_s;
    if (held || !tapping.down_s) return;
    tapping.taps.push_back({*tapping.down_s, now_s - *tapping.down_s});
    tapping.down_s.reset();
}

void draw_pad(Ui& ui, TappingState& tapping) {
    const Theme& theme = ui.theme;
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 64.0F * theme.scale};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("tap", size);
    const bool held = ImGui::IsItemActive();
    note_item(ui.rects, "tap", std::to_string(tapping.taps.size()));
    follow_taps(ui, tapping, held);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool down = tapping.down_s.has_value();
    list.AddRectFilled(corner, corner + size, down ? theme.accent : theme.field,
                       4.0F * theme.scale);
    const char* words = "Press Space, T, or here: each press is a note, as long as you hold it";
    const ImVec2 room = text_size(theme.fonts.regular, words);
    draw_text(list, theme.fonts.regular, corner + (size - room) * 0.5F,
              down ? theme.pane : theme.text, shortened(theme.fonts.regular, words, size.x));
}

// Taps, over the steps made of them.
void draw_taps(const Ui& ui, const TappingState& tapping, const TappedRhythm& tapped,
               double least_s) {
    const Theme& theme = ui.theme;
    const float row = 14.0F * theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, 2.0F * row + theme.gap_px});
    if (tapping.taps.empty()) return;
    const Rhythm& rhythm = tapped.rhythm;
    const double text_s = static_cast<double>(rhythm.text.size()) * rhythm.unit_s;
    const Tap& last = tapping.taps.back();
    const double first_s = tapping.taps.front().onset_s;
    const double whole_s = std::max({text_s, least_s, last.onset_s + last.length_s - first_s});
    const auto x = [&](double t_s) { return corner.x + static_cast<float>(t_s / whole_s) * width; };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const Tap& tap : tapping.taps) {
        const float left = x(tap.onset_s - first_s);
        const float right = x(tap.onset_s + tap.length_s - first_s);
        list.AddRectFilled({left, corner.y},
                           {std::max(right, left + theme.trace_px), corner.y + row}, theme.dim_text,
                           2.0F * theme.scale);
    }
    const float top = corner.y + row + 0.5F * theme.gap_px;
    draw_rhythm_cells(theme, {{corner.x, top}, {x(text_s), top + row}}, rhythm.text);
}

void draw_words(Ui& ui, const TappingState& tapping, const TappedRhythm& tapped, double least_s) {
    if (tapping.taps.empty()) {
        dim_text(ui, "Nothing was tapped yet.");
        return;
    }
    std::string words = rhythm_summary(tapped.rhythm.text) + "; taps are " +
                        with_decimals(1000.0 * tapped.rms_error_s, 0) + " ms off the grid (rms)";
    if (tapped.left_out > 0) {
        words += "; " + std::to_string(tapped.left_out) +
                 " left out: two in one step, or behind step " + grouped_digits(kMaxRhythmSteps);
    }
    if (tapped.length_s > least_s) {
        const double length_s = std::min(tapped.length_s, limits::kDurationS.high);
        words += ". The pattern becomes " + significant_digits(length_s, 4) + " s long";
    }
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "tapped", .text = words + ".", .value = tapped.rhythm.text});
    ImGui::PopTextWrapPos();
}

void draw_step_field(Ui& ui, TappingState& tapping) {
    constexpr Range kMs{20.0, 2000.0};
    const double estimated_s = estimated_step_s(tapping.taps);
    double step_ms = 1000.0 * tapping.step_s.value_or(estimated_s);
    const FieldEdit edit = draw_field(ui,
                                      {.id = "tap_step_ms",
                                       .label = "Step",
                                       .format = "%.4g ms",
                                       .slider = kMs,
                                       .typed = kMs,
                                       .step = 5.0,
                                       .snap = 1.0,
                                       .logarithmic = true,
                                       .help = "Length of one step, estimated from the taps until "
                                               "it is changed here."},
                                      step_ms);
    if (edit.changed) tapping.step_s = step_ms / 1000.0;
    draw_label(ui, "", ImGui::CalcTextSize("Start over").x);
    if (link(ui, {.id = "link:start over", .label = "Start over"})) tapping = {};
    if (!tapping.step_s) return;
    flow_on(ImGui::CalcTextSize("Estimate the step").x, 2.0F * ui.theme.gap_px);
    if (link(ui, {.id = "link:estimate step", .label = "Estimate the step"}))
        tapping.step_s.reset();
}

void take(Ui& ui, Workspace& work, const TappedRhythm& tapped) {
    edit_patterns(work, [&tapped](Pattern& pattern) {
        pattern.rhythm = tapped.rhythm;
        if (tapped.length_s > pattern.duration_s) {
            pattern = with_duration(pattern, std::min(tapped.length_s, limits::kDurationS.high));
        }
    });
    commit_step(ui, work, "Tap " + of_selection(work, "rhythm"));
}

}  // namespace

void open_tapping(Ui& ui, TappingState& tapping) {
    tapping = {};
    ui.dialog = kTappingDialog;
}

void draw_tapping_dialog(Ui& ui, Workspace& work, TappingState& tapping) {
    if (!begin_dialog(ui, kTappingDialog)) return;
    draw_pad(ui, tapping);
    const Pattern* pattern = editable_layer(work);
    const double least_s = pattern == nullptr ? 0.0 : pattern->duration_s;
    const double step_s = tapping.step_s.value_or(estimated_step_s(tapping.taps));
    const TappedRhythm tapped = tapped_rhythm(tapping.taps, step_s, least_s);
    draw_taps(ui, tapping, tapped, least_s);
    draw_words(ui, tapping, tapped, least_s);
    draw_step_field(ui, tapping);
    const bool ready = pattern != nullptr && !tapping.taps.empty() && !tapping.down_s;
    if (draw_ends(ui, "Use rhythm", ready)) take(ui, work, tapped);
}

}  // namespace tact
