#include "app/study/study_pages.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/study/study_actuator.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using What = StudyEvent::What;

const StudyRun& run_of(const StudyState& studying) { return *studying.run; }

std::string time_left_text(double minutes) {
    char text[48];
    if (minutes < 1.0) return "less than a minute left";
    std::snprintf(text, sizeof text, "about %.0f min left", std::ceil(minutes));
    return text;
}

const char* keys_of(const StudyRun& run) {
    if (run.is_asking) return "Enter  go on      Q  leave";
    switch (run.page) {
        case StudyPage::consent:
            return "Tab  next field      Enter  agree, then begin      Esc  leave";
        case StudyPage::instructions:
        case StudyPage::rest:
        case StudyPage::finished:
            return "Enter  go on      Esc  pause";
        case StudyPage::training:
            return "\u2190 \u2192  choose      Space  feel      Enter  go on      Esc  pause";
        case StudyPage::trial:
            return "A, B  feel      0\u20139, Home, End  rate      \u2190 \u2192  finer (Shift: by "
                   "10)      Enter  next      Esc  pause";
        case StudyPage::sorting:
            return "\u2190 \u2192  choose      Space  feel      1\u20139  put into a group      0  "
                   "back      Enter  done      Esc  pause";
    }
    return "";
}

const char* name_of(StudyPage page) {
    switch (page) {
        case StudyPage::consent:
            return "consent";
        case StudyPage::instructions:
            return "instructions";
        case StudyPage::training:
            return "training";
        case StudyPage::trial:
            return "trial";
        case StudyPage::sorting:
            return "sorting";
        case StudyPage::rest:
            return "break";
        case StudyPage::finished:
            return "finished";
    }
    return "";
}

// Where one is on the way, and for how long still.
void draw_progress(Ui& ui, const StudyState& studying, const Rect& area) {
    const StudyRun& run = run_of(studying);
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::size_t wanted = answers_wanted(run.record);
    const std::size_t given = std::min(wanted, answers_given(run.record));
    const bool pairs = run.record.header.kind == StudyKind::pairwise;
    std::string text = std::string(pairs ? "Trial " : "Round ") +
                       std::to_string(std::min(given + 1, wanted)) + " of " +
                       std::to_string(wanted);
    const bool is_at_work = run.page == StudyPage::trial || run.page == StudyPage::sorting;
    if (!is_at_work) text = run.page == StudyPage::training ? "Training" : "";
    draw_text(list, theme.fonts.regular, area.min, theme.dim_text, text);
    note_rect(
        ui.rects, "study page", area.min, area.max,
        std::string(run.is_asking ? "asking" : name_of(run.page)) + " " + std::to_string(given));
    const bool is_begun = given > 0 || is_at_work;
    const std::string left = is_begun && given < wanted ? time_left_text(minutes_left(run)) : "";
    const float width = text_size(theme.fonts.regular, left).x;
    draw_text(list, theme.fonts.regular, {area.max.x - width, area.min.y}, theme.dim_text, left);
    if (!is_begun) return;
    const float y = area.min.y + 26.0F * theme.scale;
    const float share = wanted == 0 ? 0.0F : static_cast<float>(given) / static_cast<float>(wanted);
    const float half = 2.0F * theme.scale;
    list.AddRectFilled({area.min.x, y}, {area.max.x, y + 2.0F * half}, theme.field, half);
    if (given == 0) return;
    list.AddRectFilled({area.min.x, y}, {area.min.x + share * area.width(), y + 2.0F * half},
                       theme.accent, half);
}

void draw_foot(Ui& ui, const StudyState& studying, const Rect& area) {
    const Theme& theme = ui.theme;
    centred_text(theme.fonts.small, theme.dim_text, area, area.max.y - 24.0F * theme.scale,
                 keys_of(*studying.run));
    std::string warning = studying.run->trouble;
    if (!warning.empty()) warning = "Not on the disk, please call the experimenter. " + warning;
    if (warning.empty()) warning = studying.actuator.fault;
    if (warning.empty()) {
        const DeviceStatus status = studying.device->status();
        warning = status.trouble;
        if (!status.connected && warning.empty()) {
            warning = "Rehearsal: no actuator is connected, nothing can be felt.";
        }
        // Where the experimenter is still at hand.
        const bool is_first = studying.run->page == StudyPage::consent;
        if (is_first && warning.empty()) warning = strength_words(studying.actuator);
    }
    if (!studying.masking_fault.empty() && studying.run->trouble.empty()) {
        warning += (warning.empty() ? "" : " ") + studying.masking_fault;
    }
    if (warning.empty()) return;
    centred_text(theme.fonts.regular, studying.run->trouble.empty() ? theme.warning : theme.error,
                 area, area.max.y - 52.0F * theme.scale, warning);
    note_rect(ui.rects, "study:warning", area.min, area.max, warning);
}

void wrapped(const Rect& area, const std::string& text) {
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + area.width());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

// A page that is read: a title, words, and the way on.
void draw_reading_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                       const Rect& area, const char* title, const std::string& text,
                       const char* go_on) {
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushFont(ui.theme.fonts.large);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    wrapped({{area.min.x, area.min.y + 44.0F * ui.theme.scale}, area.max}, text);
    const float y = ImGui::GetCursorScreenPos().y + 28.0F * ui.theme.scale;
    draw_go_on(ui, work, play, studying, {{area.min.x, y}, {area.max.x, y}}, go_on);
}

void draw_entry(Ui& ui, const char* label, const char* id, std::string& text) {
    draw_label(ui, label);
    ImGui::SetNextItemWidth(240.0F * ui.theme.scale);
    ImGui::InputText((std::string("##") + id).c_str(), &text);
    note_item(ui.rects, std::string("study field:") + id, text);
}

void draw_consent(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                  const Rect& area, std::span<const KeyPress> pressed) {
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushFont(ui.theme.fonts.large);
    ImGui::TextUnformatted("Welcome");
    ImGui::PopFont();
    wrapped({{area.min.x, area.min.y + 44.0F * ui.theme.scale}, area.max},
            consent_of(studying.run->record.header.design));
    const float y = ImGui::GetCursorScreenPos().y + 20.0F * ui.theme.scale;
    ImGui::SetCursorScreenPos({area.min.x, y});
    ImGui::BeginGroup();
    draw_entry(ui, "Code", "code", studying.code);
    ImGui::SameLine();
    dim_text(ui, "no name, please");
    draw_entry(ui, "Age", "age", studying.age);
    draw_entry(ui, "Gender", "gender", studying.gender);
    draw_entry(ui, "Hand", "hand", studying.hand);
    ImGui::SameLine();
    dim_text(ui, "that writes");
    ImGui::Spacing();
    draw_check(ui.theme, "I agree and take part", studying.agrees);
    note_item(ui.rects, "check:agree", studying.agrees ? "on" : "off");
    ImGui::EndGroup();
    if (was_pressed(pressed, key::kEnter)) {
        if (studying.agrees) {
            act(ui, work, play, studying, {What::go_on, 0, 0.0, {}, {}});
        } else {
            studying.agrees = true;
        }
        if (!studying.run) return;
    }
    const float foot = ImGui::GetCursorScreenPos().y + 20.0F * ui.theme.scale;
    ImGui::BeginDisabled(!studying.agrees || study_file_name(studying.code).empty());
    draw_go_on(ui, work, play, studying, {{area.min.x, foot}, {area.max.x, foot}}, "Begin");
    ImGui::EndDisabled();
}

// A word to the experimenter, where the order is adaptive.
std::string settling_text(const StudyState& state) {
    if (!state.settling || !state.settling->is_settled) return {};
    return "\n\nThe map has settled: more trials would change little.";
}

std::string rest_text(const StudyState& state) {
    const StudyRecord& record = state.run->record;
    return "Take a break for as long as you like. " + std::to_string(answers_given(record)) +
           " of " + std::to_string(answers_wanted(record)) + " trials are done." +
           settling_text(state);
}

// Esc: nothing is lost either way, and the page says so.
void draw_asking(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                 const Rect& area, std::span<const KeyPress> pressed) {
    const StudyRun& run = run_of(studying);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushFont(ui.theme.fonts.large);
    ImGui::TextUnformatted("Paused");
    ImGui::PopFont();
    const std::size_t given = answers_given(run.record);
    const bool is_new = run.page == StudyPage::consent;
    wrapped({{area.min.x, area.min.y + 44.0F * ui.theme.scale}, area.max},
            is_new ? "Nothing has been written yet."
                   : std::to_string(given) + (given == 1 ? " answer is" : " answers are") +
                         " kept. Who leaves can go on later with the trial on the screen." +
                         settling_text(studying));
    ImGui::SetCursorScreenPos({area.min.x, ImGui::GetCursorScreenPos().y + 28.0F * ui.theme.scale});
    const bool stays = primary_button(ui.theme, "Go on") || was_pressed(pressed, key::kEnter);
    note_item(ui.rects, "button:stay");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const bool leaves = ImGui::Button("Leave the study") || was_typed(pressed, U'q');
    note_item(ui.rects, "button:leave");
    if (stays) {
        act(ui, work, play, studying, {What::stay, 0, 0.0, {}, {}});
    } else if (leaves) {
        act(ui, work, play, studying, {What::leave, 0, 0.0, {}, {}});
    }
}

// A page that is read: a column of comfortable width, which scrolls where it is too long.
void draw_column(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                 const Rect& area, std::span<const KeyPress> pressed) {
    const StudyRun& run = run_of(studying);
    const float width = std::min(640.0F * ui.theme.scale, area.width());
    ImGui::SetCursorScreenPos({area.centre().x - 0.5F * width, area.min.y});
    ImGui::BeginChild("page", {width, area.height()}, false, ImGuiWindowFlags_NoNav);
    const Rect column =
        rect_at(ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x, area.height()});
    if (run.is_asking) {
        draw_asking(ui, work, play, studying, column, pressed);
    } else if (run.page == StudyPage::consent) {
        draw_consent(ui, work, play, studying, column, pressed);
    } else if (run.page == StudyPage::instructions) {
        draw_reading_page(ui, work, play, studying, column,
                          run.answers_before > 0 ? "Welcome back" : "What you will do",
                          instructions_of(run.record.header.design, run.record.header.kind),
                          "Go on");
    } else if (run.page == StudyPage::rest) {
        draw_reading_page(ui, work, play, studying, column, "A break", rest_text(studying),
                          "Go on");
    } else {
        draw_reading_page(ui, work, play, studying, column, "Thank you",
                          "That was all. Your answers are kept.", "Done");
    }
    ImGui::EndChild();
}

void draw_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
               const Rect& area, std::span<const KeyPress> pressed) {
    const StudyRun& run = run_of(studying);
    const bool goes_on = was_pressed(pressed, key::kEnter);
    if (goes_on && !run.is_asking && run.page != StudyPage::consent) {
        act(ui, work, play, studying, {What::go_on, 0, 0.0, {}, {}});
        if (!studying.run) return;
    }
    if (run.is_asking) return draw_column(ui, work, play, studying, area, pressed);
    switch (run.page) {
        case StudyPage::training:
            return draw_training_page(ui, work, play, studying, area, pressed);
        case StudyPage::trial:
            return draw_trial_page(ui, work, play, studying, area, pressed);
        case StudyPage::sorting:
            return draw_sorting_page(ui, work, play, studying, area, pressed);
        case StudyPage::consent:
        case StudyPage::instructions:
        case StudyPage::rest:
        case StudyPage::finished:
            return draw_column(ui, work, play, studying, area, pressed);
    }
}

}  // namespace

void draw_study_pages(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                      std::span<const KeyPress> pressed) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(screen);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    if (ImGui::Begin("study run", nullptr, kFlags)) {
        const float margin = 32.0F * ui.theme.scale;
        const Rect area = inset({{0.0F, 0.0F}, screen}, margin);
        draw_progress(ui, studying, area);
        draw_foot(ui, studying, area);
        if (was_pressed(pressed, key::kEscape) && !run_of(studying).is_asking) {
            act(ui, work, play, studying, {What::ask, 0, 0.0, {}, {}});
        } else {
            // Low windows have no room for air above.
            const bool is_low = area.height() < 700.0F * ui.theme.scale;
            const float head = 40.0F * ui.theme.scale;
            const float top = area.min.y + (is_low ? head : std::max(head, 0.16F * area.height()));
            draw_page(ui, work, play, studying,
                      {{area.min.x, top}, {area.max.x, area.max.y - 72.0F * ui.theme.scale}},
                      pressed);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace tact
