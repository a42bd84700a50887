#include "app/study/study.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/study/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using What = StudyEvent::What;

constexpr float kWindowWidthPx = 900.0F;  // that a page of ordinary size fills
constexpr float kWindowHeightPx = 600.0F;
constexpr float kMeasurePx = 400.0F;  // of text to read: about 65 letters
constexpr float kEntryPx = 172.0F;

const StudyRun& run_of(const StudyState& studying) { return *studying.run; }

std::string time_left_text(double minutes) {
    if (minutes < 1.0) return "less than a minute left";
    return "about " + with_decimals(std::ceil(minutes), 0) + " min left";
}

const char* keys_of(const StudyRun& run) {
    if (run.is_asking) return "Enter  go on      Q  leave";
    switch (run.page) {
        case StudyPage::consent:
            return "Tab  next field      Enter  agree, then begin      Esc  leave";
        case StudyPage::instructions:
        case StudyPage::rest:
            return "Enter  go on      Esc  pause";
        case StudyPage::finished:
            return "Enter  done";
        case StudyPage::training:
            return "\u2190 \u2192  choose      Space  feel      Enter  start rating      Esc  "
                   "pause";
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
    // All of it: its end says what to do.
    const ImU32 ink = studying.run->trouble.empty() ? theme.warning : theme.error;
    const auto lines = wrapped(theme.fonts.regular, warning, area.width());
    const float line_px = ImGui::GetTextLineHeightWithSpacing();
    float y = area.max.y - 52.0F * theme.scale - line_px * static_cast<float>(lines.size() - 1);
    for (const std::string& line : lines) {
        centred_text(theme.fonts.regular, ink, area, y, line);
        y += line_px;
    }
    note_rect(ui.rects, "study:warning", area.min, area.max, warning);
}

void draw_entry(Ui& ui, const char* label, const char* id, std::string& text, const char* hint) {
    draw_label(ui, label);
    ImGui::SetNextItemWidth(kEntryPx * ui.theme.scale);
    ImGui::InputText((std::string("##") + id).c_str(), &text, ImGuiInputTextFlags_AutoSelectAll);
    note_item(ui.rects, std::string("study field:") + id, text);
    if (*hint == '\0') return;
    ImGui::SameLine();
    dim_text(ui, hint);
}

// Height of draw_form().
float form_height() {
    return 5.0F * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
}

// Why the code cannot be begun with; empty: it can.
std::string code_fault(const Workspace& work, const StudyState& studying) {
    if (study_file_name(studying.code).empty()) return "letters or digits, please";
    if (is_code_taken(work, studying, studying.code)) return "This code is taken: choose another.";
    return {};
}

// Whether the person may continue. The folder is asked once a frame whether the code is taken: what
// is typed in this frame counts from the next one on.
bool draw_form(Ui& ui, const Workspace& work, StudyState& studying) {
    ImGui::BeginGroup();
    const std::string fault = code_fault(work, studying);
    if (ImGui::IsWindowAppearing()) focus_next_item();
    draw_entry(ui, "Code", "code", studying.code, fault.empty() ? "no name, please" : "");
    if (!fault.empty()) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
        plain_text(ui, {.id = "study field:code fault", .text = fault});
        ImGui::PopStyleColor();
    }
    draw_entry(ui, "Age", "age", studying.age, "years");
    draw_entry(ui, "Gender", "gender", studying.gender, "");
    draw_entry(ui, "Writing hand", "hand", studying.hand, "left or right");
    ImGui::Spacing();
    check(ui, {.id = "check:agree", .label = "I agree and take part"}, studying.agrees);
    ImGui::EndGroup();
    return studying.agrees && fault.empty();
}

// Enter ticks, then begins.
void take_consent_key(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying) {
    if (!code_fault(work, studying).empty()) return;
    if (studying.agrees) {
        act(ui, work, play, studying, {What::go_on, 0, 0.0, {}, {}});
    } else {
        studying.agrees = true;
    }
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
std::string paused_text(const StudyState& studying) {
    const StudyRun& run = run_of(studying);
    if (run.page == StudyPage::consent) return "Nothing has been written down yet.";
    const std::size_t given = answers_given(run.record);
    const std::string kept = given == 0   ? "You have not answered anything yet."
                             : given == 1 ? "Your answer is kept."
                                          : "Your " + std::to_string(given) + " answers are kept.";
    const int cut = run.cut_short_in_all;
    const std::string cuts = cut == 0 ? ""
                                      : "\n\n" + std::to_string(cut) +
                                            (cut == 1 ? " play was" : " plays were") +
                                            " cut short and felt once more.";
    return kept + " If you leave now, you can come back later and go on from here." + cuts +
           settling_text(studying);
}

// What a page that is read says, and the word on its button.
struct PageWords {
    const char* title;
    std::string text;
    const char* go_on;
};

PageWords words_of(const StudyState& studying) {
    const StudyRun& run = run_of(studying);
    const StudyDesign& design = run.record.header.design;
    if (run.is_asking) return {"Paused", paused_text(studying), "Go on"};
    if (run.page == StudyPage::consent) return {"Welcome", consent_of(design), "Begin"};
    if (run.page == StudyPage::instructions) {
        return {run.answers_before > 0 ? "Welcome back" : "What you will do",
                instructions_of(design, run.record.header.kind), "Go on"};
    }
    if (run.page == StudyPage::rest) return {"A break", rest_text(studying), "Go on"};
    return {"Thank you", "That was all. Your answers are kept.", "Done"};
}

void draw_asking_buttons(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                         std::span<const KeyPress> pressed) {
    const ImVec2 size = go_on_size(ui.theme);
    const bool stays = primary_button(ui, {.id = "button:stay", .label = "Go on"}, size) ||
                       was_pressed(pressed, key::kEnter);
    ImGui::SameLine(0.0F, ui.theme.padding_px);
    const bool leaves = button(ui, {.id = "button:leave", .label = "Leave the study"}, size) ||
                        was_typed(pressed, U'q');
    if (stays) {
        act(ui, work, play, studying, {What::stay, 0, 0.0, {}, {}});
    } else if (leaves) {
        act(ui, work, play, studying, {What::leave, 0, 0.0, {}, {}});
    }
}

// A page that is read: a column of comfortable width in the middle, which scrolls where it is too
// long.
void draw_column(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                 const Rect& area, std::span<const KeyPress> pressed) {
    const Theme& theme = ui.theme;
    const StudyRun& run = run_of(studying);
    const bool has_form = run.page == StudyPage::consent && !run.is_asking;
    const PageWords words = words_of(studying);
    const float width = std::min(kMeasurePx * theme.scale, area.width());
    const float gap = 24.0F * theme.scale;
    const float title = text_size(theme.fonts.large, words.title).y + gap;
    const float text = ImGui::CalcTextSize(words.text.c_str(), nullptr, false, width).y + gap;
    const float form = has_form ? form_height() + gap : 0.0F;
    const float height = title + text + form + go_on_size(theme).y;
    const float edge = 4.0F * theme.scale;  // for the outlines of what begins the lines
    ImGui::SetCursorScreenPos({area.centre().x - 0.5F * width - edge, area.min.y});
    ImGui::BeginChild("page", {width + 2.0F * edge, area.height()}, false, ImGuiWindowFlags_NoNav);
    const ImVec2 corner = ImGui::GetCursorScreenPos() +
                          ImVec2{edge, 0.45F * std::max(0.0F, area.height() - height - edge)};
    draw_text(*ImGui::GetWindowDrawList(), theme.fonts.large, corner, theme.text, words.title);
    ImGui::SetCursorScreenPos({corner.x, corner.y + title});
    ImGui::PushTextWrapPos(edge + width);
    plain_text(ui, {.id = "study:text", .text = words.text});
    ImGui::PopTextWrapPos();
    const ImVec2 below{corner.x, corner.y + title + text};
    ImGui::SetCursorScreenPos(below);
    const bool may_go_on = !has_form || draw_form(ui, work, studying);
    const ImVec2 foot{below.x, below.y + form};
    ImGui::SetCursorScreenPos(foot);
    if (run.is_asking) {
        draw_asking_buttons(ui, work, play, studying, pressed);
    } else {
        ImGui::BeginDisabled(!may_go_on);
        draw_go_on(ui, work, play, studying, {foot, foot}, words.go_on);
        ImGui::EndDisabled();
    }
    ImGui::EndChild();
}

void draw_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
               const Rect& area, std::span<const KeyPress> pressed) {
    const StudyRun& run = run_of(studying);
    const bool goes_on = was_pressed(pressed, key::kEnter);
    if (goes_on && !run.is_asking) {
        if (run.page == StudyPage::consent) {
            take_consent_key(ui, work, play, studying);
        } else {
            act(ui, work, play, studying, {What::go_on, 0, 0.0, {}, {}});
        }
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

float wanted_page_scale(const Ui& ui, ImVec2 window_px) {
    constexpr float kMost = 3.0F;
    const float own = ui.content_scale * ui.text_scale;
    const float room = std::min(window_px.x / kWindowWidthPx, window_px.y / kWindowHeightPx) / own;
    return std::clamp(std::floor(8.0F * room) / 8.0F, 1.0F, kMost);
}

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
            const ImVec2 head{0.0F, 48.0F * ui.theme.scale};
            const ImVec2 foot{0.0F, 84.0F * ui.theme.scale};
            draw_page(ui, work, play, studying, {area.min + head, area.max - foot}, pressed);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace tact
