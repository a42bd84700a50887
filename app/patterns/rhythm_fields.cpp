#include <imgui_internal.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "app/patterns/parts.h"
#include "app/patterns/patterns.h"
#include "model/pattern/rhythm_edit.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// A click on a rhythm step turns rest into note, note into hold (if possible), hold into rest.
std::string stepped(std::string text, std::size_t step) {
    const bool can_hold = step > 0 && text[step - 1] != '-';
    if (text[step] == '-') {
        text[step] = 'x';
    } else if (starts_note(text[step]) && can_hold) {
        text[step] = '=';
    } else {
        text[step] = '-';
        // A hold needs a note before it.
        for (std::size_t k = step + 1; k < text.size() && text[k] == '='; ++k) text[k] = '-';
    }
    return text;
}

void set_rhythm(Ui& ui, Workspace& work, const std::string& text) {
    edit_patterns(work, [&text](Pattern& p) { p.rhythm.text = text; });
    commit_step(ui, work, "Change " + of_selection(work, "rhythm"));
}

// While the mouse is held, the note reaches from the pressed step to the step under the mouse.
void follow_note_drag(Workspace& work, PatternPanes& pattern_panes, std::size_t under) {
    NoteDrag& drag = *pattern_panes.editor.note_drag;
    if (under == drag.from && !drag.moved) return;
    drag.moved = true;
    const std::string text = with_note(drag.before, drag.from, std::max(drag.from, under));
    edit_patterns(work, [&text](Pattern& p) { p.rhythm.text = text; });
}

// While the mouse is held on the pressed step, up makes it stronger and down weaker.
void follow_strength_drag(Workspace& work, NoteDrag& drag, float up_px, float ninth_px) {
    const int by = static_cast<int>(std::lround(up_px / ninth_px));
    if ((by == 0 && !drag.moved) || !starts_note(drag.before[drag.from])) return;
    drag.moved = true;
    const Pattern* pattern = shown_pattern(work);
    if (pattern == nullptr) return;
    Rhythm rhythm = pattern->rhythm;
    rhythm.text = drag.before;
    const NoteKind kind = kind_of(rhythm, drag.before[drag.from]);
    const double ninths = std::clamp(std::round(9.0 * kind.velocity) + by, 1.0, 9.0);
    rhythm.text[drag.from] = 'x';  // its letter can be used again if no other note has it
    const auto mark = mark_for(rhythm, {ninths / 9.0, kind.pitch});
    if (!mark) return;
    rhythm.text[drag.from] = *mark;
    edit_patterns(work, [&rhythm](Pattern& p) {
        p.rhythm.text = rhythm.text;
        p.rhythm.kinds = rhythm.kinds;
    });
}

// A step as a button: a click changes its mark, a drag draws a note over the steps.
void draw_step(Ui& ui, Workspace& work, PatternPanes& pattern_panes, const std::string& text,
               std::size_t k, ImVec2 size, float left) {
    std::optional<NoteDrag>& drag = pattern_panes.editor.note_drag;
    ImGui::PushID(static_cast<int>(k));
    const bool pressed = ImGui::InvisibleButton("step", size);
    note_item(ui.rects, "step:" + std::to_string(k), std::string(1, text[k]));
    if (ImGui::IsItemActivated()) drag = NoteDrag{text, k, false};
    if (drag && drag->from == k && ImGui::IsItemActive() && ImGui::IsMouseDown(0)) {
        const float steps = (ImGui::GetIO().MousePos.x - left) / size.x;
        const float last = static_cast<float>(drag->before.size() - 1);
        const auto under = static_cast<std::size_t>(std::clamp(steps, 0.0F, last));
        if (under == k) {
            const ImGuiIO& io = ImGui::GetIO();
            follow_strength_drag(work, *drag, io.MouseClickedPos[0].y - io.MousePos.y,
                                 5.0F * ui.theme.scale);
        } else {
            follow_note_drag(work, pattern_panes, under);
        }
    }
    const bool drawn = drag && drag->from == k && drag->moved;
    if (drawn && ImGui::IsItemDeactivated()) {
        commit_step(ui, work, "Change " + of_selection(work, "rhythm"));
    } else if (pressed && !drawn) {
        set_rhythm(ui, work, stepped(text, k));
    }
    if (drag && drag->from == k && ImGui::IsItemDeactivated()) drag.reset();
    ImGui::PopID();
}

constexpr std::size_t kMostCells = 256;  // with more, a step is too narrow to see

void draw_rhythm_grid(Ui& ui, Workspace& work, PatternPanes& pattern_panes, const Rhythm& rhythm) {
    const Theme& theme = ui.theme;
    const std::size_t steps = rhythm.text.size();
    if (steps > kMostCells) {
        const std::string words =
            grouped_digits(steps) + " steps: edit the text, or notes in the strip";
        return coloured_text(ui, theme.dim_text, {.id = "rhythm:long", .text = words});
    }
    const float width = ImGui::GetContentRegionAvail().x;
    const float cell = std::min(20.0F * theme.scale, width / static_cast<float>(steps));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float height = 1.0F;  // note of this step
    for (std::size_t k = 0; k < steps; ++k) {
        const char mark = rhythm.text[k];
        if (mark == '-') height = 1.0F;
        if (starts_note(mark)) height = static_cast<float>(kind_of(rhythm, mark).velocity);
        const ImVec2 min{corner.x + static_cast<float>(k) * cell, corner.y};
        const float gap = 1.5F * theme.scale;
        // A held step is joined to the one before it.
        const float left = mark == '=' ? min.x - gap : min.x + gap;
        ImGui::SetCursorScreenPos(min);
        draw_step(ui, work, pattern_panes, rhythm.text, k, {cell, cell}, corner.x);
        ImU32 colour = mark == '-' ? theme.field : theme.accent;
        if (ImGui::IsItemHovered()) colour = mark == '-' ? theme.hover : theme.text;
        const float bottom = min.y + cell - gap;
        const float top = bottom - height * (cell - 2.0F * gap);
        list.AddRectFilled({left, top}, {min.x + cell - gap, bottom}, colour, 2.0F * theme.scale);
        draw_tooltip(ui,
                     "Click: note, hold, rest. Drag to the right: a note as long as the drag. Drag "
                     "up or down: a stronger or a weaker note.");
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + cell});
    ImGui::Dummy({width, 2.0F * theme.scale});
}

// Beside the fields, never over them: before the second of two columns, beside a single column in a
// wide pane, or beside the pane.
void place_beside_fields(const Theme& theme, float width_px) {
    if (const ImGuiTable* table = ImGui::GetCurrentTable(); table != nullptr) {
        const float column = table->Columns[table->CurrentColumn].WorkMinX;
        return ImGui::SetNextWindowPos({column - theme.gap_px, ImGui::GetItemRectMin().y},
                                       ImGuiCond_Appearing, {1.0F, 0.0F});
    }
    const ImGuiWindow& pane = *ImGui::GetCurrentWindowRead()->RootWindow;
    const float left =
        ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x + 2.0F * theme.gap_px;
    if (left + width_px > pane.Pos.x + pane.Size.x) return open_beside_pane(theme, width_px);
    ImGui::SetNextWindowPos({left, ImGui::GetItemRectMin().y}, ImGuiCond_Appearing);
}

// The height of the popup: at most that of its pane, if that is high enough.
void keep_beside(const ImRect& pane) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const float height = ImGui::GetWindowSize().y;
    const float below = corner.y + height - pane.Max.y;
    if (below > 0.0F && height <= pane.GetHeight()) {
        ImGui::SetWindowPos({corner.x, corner.y - below});
    }
}

// Stays open while the person tries rhythms.
void draw_rhythm_popup(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                       const Pattern& pattern) {
    const float width = 340.0F * ui.theme.scale;
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, 1e4F});
    place_beside_fields(ui.theme, width);
    const ImRect pane = ImGui::GetCurrentWindowRead()->RootWindow->Rect();
    if (!ImGui::BeginPopup("rhythm list")) return;
    const auto chosen = [&pattern](const std::string& text) { return text == pattern.rhythm.text; };
    const RhythmListAction action =
        draw_rhythm_list(ui, pattern_panes.editor.rhythms, pattern, chosen);
    if (action.pressed) set_rhythm(ui, work, *action.pressed);
    keep_beside(pane);
    keep_on_screen(ui.theme);
    ImGui::EndPopup();
}

void draw_rhythm_links(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                       const Pattern& pattern) {
    constexpr const char* kList = "Rhythms...";
    constexpr const char* kGrid = "Make a rhythm";
    constexpr const char* kTap = "Tap...";
    const bool none = pattern.rhythm.text.empty();
    const auto px = [](const char* words) { return ImGui::CalcTextSize(words).x; };
    const float gap_px = 2.0F * ui.theme.gap_px;
    draw_label(ui, "", px(kList) + gap_px + px(kTap) + (none ? px(kGrid) + gap_px : 0.0F));
    if (none) {
        if (field_link(ui, work, "link:make a rhythm", kGrid,
                       "A grid of steps to click notes into")) {
            set_rhythm(ui, work, "x=--x=--");
        }
        flow_on(px(kList), gap_px);
    }
    if (field_link(ui, work, "link:rhythms", kList,
                   "Rhythms of a length and number of notes to pick from")) {
        ImGui::OpenPopup("rhythm list");
    }
    draw_rhythm_popup(ui, work, pattern_panes, pattern);
    flow_on(px(kTap), gap_px);
    if (field_link(ui, work, "link:tap", kTap,
                   "T: each press is a note, as long as the key is held")) {
        open_tapping(ui, pattern_panes.tapping);
    }
    if (none) return;
    const std::string summary = rhythm_summary(pattern.rhythm.text);
    flow_on(px(summary.c_str()), gap_px);
    dim_text(
        ui,
        {.id = "rhythm summary",
         .text = shortened(ui.theme.fonts.regular, summary, ImGui::GetContentRegionAvail().x),
         .tip = "Evenness is 1 where all notes are equally far apart, as the rhythm repeats, and "
                "less the more they crowd.",
         .value = summary});
}

void draw_tempo(Ui& ui, Workspace& work, const Rhythm& rhythm) {
    const Range& unit = numbers::kRhythmUnit.range;
    const int beat = rhythm.meter.steps_a_beat;
    const std::string tempo_help = "Beats a minute where " + std::to_string(beat) +
                                   (beat == 1 ? " step is" : " steps are") +
                                   " a beat: the length of a step once more.";
    edit_number(
        ui, work,
        {.id = "tempo_bpm",
         .label = "Tempo",
         .format = "%.4g BPM",
         .slider = {30.0, 300.0},
         .typed = {tempo_bpm(unit.high, beat), tempo_bpm(unit.low, beat)},
         .step = 1.0,
         .snap = 1.0,
         .help = tempo_help.c_str()},
        "tempo",
        [](const Pattern& p) { return tempo_bpm(p.rhythm.unit_s, p.rhythm.meter.steps_a_beat); },
        [](Pattern& p, double value) {
            p.rhythm.unit_s = unit_at_tempo(value, p.rhythm.meter.steps_a_beat);
        });
    edit_number(ui, work, numbers::kStepsABeat, field_of(numbers::kStepsABeat, "steps_a_beat"),
                "beat", [](auto& p) { return &p.rhythm.meter.steps_a_beat; });
    edit_number(ui, work, numbers::kBeatsABar, field_of(numbers::kBeatsABar, "beats_a_bar"), "bar",
                [](auto& p) { return &p.rhythm.meter.beats_a_bar; });
}

// Strength and pitch of each letter in the text.
void draw_kinds(Ui& ui, Workspace& work, const Rhythm& rhythm) {
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        if (rhythm.text.find(letter) == std::string::npos) continue;
        const std::string name = std::string("Note ") + letter;
        const std::string strength_id = std::string("kind_strength_") + letter;
        const std::string pitch_id = std::string("kind_pitch_") + letter;
        Field strength = field_of(numbers::kVelocity, strength_id.c_str());
        strength.label = name.c_str();
        edit_number(
            ui, work, strength, "strength of " + name,
            [letter](const Pattern& p) { return 100.0 * kind_of(p.rhythm, letter).velocity; },
            [letter](Pattern& p, double percent) {
                p.rhythm.kinds[letter].velocity = percent / 100.0;
            });
        edit_number(
            ui, work, field_of(numbers::kPitch, pitch_id.c_str()), "pitch of " + name,
            [letter](const Pattern& p) { return kind_of(p.rhythm, letter).pitch; },
            [letter](Pattern& p, double pitch) { p.rhythm.kinds[letter].pitch = pitch; });
    }
}

// Tells the number of steps behind the pattern's end, and offers to lengthen the pattern.
void draw_overrun(Ui& ui, Workspace& work, const Pattern& pattern) {
    const double whole_s = length_s(pattern.rhythm);
    if (whole_s <= pattern.duration_s * (1.0 + 1e-9)) return;
    const double played = std::ceil(pattern.duration_s / pattern.rhythm.unit_s - 1e-9);
    const std::string words = "Plays " + significant_digits(played, 6) + " of " +
                              std::to_string(pattern.rhythm.text.size()) + " steps";
    const double to_s = std::min(whole_s, limits::kDurationS.high);
    const std::string lengthen = "Lengthen to " + significant_digits(to_s, 4) + " s";
    draw_label(ui, "", ImGui::CalcTextSize(words.c_str()).x);
    coloured_text(ui, ui.theme.warning, {.id = "rhythm:overrun", .text = words});
    flow_on(ImGui::CalcTextSize(lengthen.c_str()).x, 2.0F * ui.theme.gap_px);
    if (!field_link(ui, work, "link:lengthen", lengthen, "The pattern lasts as long as its rhythm"))
        return;
    edit_patterns(work, [](Pattern& p) {
        const double end_s = std::min(length_s(p.rhythm), limits::kDurationS.high);
        if (end_s > p.duration_s) p = with_duration(std::move(p), end_s);
    });
    commit_step(ui, work, "Lengthen " + of_selection(work, "duration"));
}

}  // namespace

void draw_rhythm_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                        const Pattern& pattern) {
    EditorState& state = pattern_panes.editor;
    draw_label(ui, "Rhythm", 120.0F * ui.theme.scale);
    const std::string name = current_vibration(work)->name;
    if (state.rhythm_typed_for != name) state.rhythm_text = pattern.rhythm.text;
    ImGui::SetNextItemWidth(-1.0F);
    const char* long_hint = "e.g. x=--x- (x note, = hold, - rest)";
    const bool has_room = button_width(long_hint) <= ImGui::GetContentRegionAvail().x;
    ImGui::InputTextWithHint("##rhythm", has_room ? long_hint : "one note", &state.rhythm_text);
    say_of_last_item(
        ui, {.id = "rhythm",
             .text = pattern.rhythm.text,
             .tip = "x note, 1 to 9 a weaker one, A to Z one of a strength and pitch of its own, = "
                    "hold, - rest; the text repeats. Empty: one note throughout."});
    const bool is_typing = ImGui::IsItemActive();
    state.rhythm_typed_for = is_typing ? name : std::string();
    const std::string fault = rhythm_fault(state.rhythm_text);
    if (is_typing && fault.empty() && state.rhythm_text != pattern.rhythm.text) {
        edit_patterns(work, [&state](Pattern& p) { p.rhythm.text = state.rhythm_text; });
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        // The text was taken up to the last state that was a rhythm.
        commit_step(ui, work, "Change " + of_selection(work, "rhythm"));
        if (!fault.empty()) {
            const std::string& kept = pattern.rhythm.text;
            const bool is_long = kept.size() > 64;
            complain(ui, "Rhythm: " + fault + "; the pattern keeps " +
                             (kept.empty() ? "one note throughout"
                              : is_long    ? "the one before"
                                           : "\"" + kept + "\""));
        }
    }
    if (is_typing && !fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(ui.theme.error));
        ImGui::TextWrapped("%s", shown_text(fault).c_str());
        ImGui::PopStyleColor();
    }
    if (!pattern.rhythm.text.empty()) draw_rhythm_grid(ui, work, pattern_panes, pattern.rhythm);
    draw_rhythm_links(ui, work, pattern_panes, pattern);
    if (pattern.rhythm.text.empty()) return;
    draw_overrun(ui, work, pattern);
    edit_number(ui, work, numbers::kRhythmUnit, field_of(numbers::kRhythmUnit, "unit_ms"),
                "rhythm step", [](auto& p) { return &p.rhythm.unit_s; });
    draw_tempo(ui, work, pattern.rhythm);
    draw_kinds(ui, work, pattern.rhythm);
}

}  // namespace tact
