// The table of who took part: a row a participant, what their answers are worth, and what each one
// goes by. Declared in app/study/study_panels.h.

#include <array>
#include <cmath>

#include "app/compare/people_text.h"
#include "app/study/study_follow.h"
#include "app/study/study_panels.h"
#include "app/ui/widgets.h"
#include "viz/charts/star_view.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr int kColumns = 8;
constexpr float kStarLines = 1.2F;

std::string state_of(const ParticipantSummary& person) {
    if (!person.excluded.empty()) return (person.synthetic ? "synthetic, " : "") + person.excluded;
    std::string text = person.synthetic ? "synthetic" : "counts";
    if (person.is_outlier) text += ", outlier";
    return text;
}

std::string identical_text(const ParticipantSummary& person) {
    std::string text;
    for (const double similarity : person.attention) {
        text += (text.empty() ? "" : " ") + std::to_string(std::lround(similarity));
    }
    return text.empty() ? "\u2013" : text;
}

// What is next to be done about a participant: go on, leave out, count again.
void draw_row_link(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                   StudyState& studying, const StudyRecord& record,
                   const ParticipantSummary& person) {
    const std::string& code = person.code;
    if (!record.excluded.empty()) {
        if (link(ui, "count again", "Count again")) count_again(ui, work, studying, code);
        note_item(ui.rects, "link:count again " + code);
        draw_tooltip(ui, "Takes the record of why they were left out from the study's folder.");
    } else if (person.answers < person.wanted && !person.synthetic) {
        if (link(ui, "go on", "Go on"))
            resume_participant(ui, work, timeline, play, studying, record);
        note_item(ui.rects, "link:go on " + code);
        draw_tooltip(ui, "Takes the study up again at the trial where it was left.");
    } else if (person.excluded.empty()) {
        if (link(ui, "leave out", "Leave out...")) ask_to_leave_out(ui, studying, code);
        note_item(ui.rects, "link:leave out " + code);
        draw_tooltip(ui, "For a reason, which the study's folder keeps. They can count again.");
    }
}

const PersonWeights* weights_of(const StudyAnswers& answers, const std::string& code) {
    for (const PersonWeights& one : answers.weights.people) {
        if (one.participant == code) return &one;
    }
    return nullptr;
}

std::string weights_text(const StudyAnswers& answers, const PersonWeights& person) {
    std::string text = person.participant + " goes by dimensions of one common map (INDSCAL):";
    for (std::size_t r = 0; r < person.weights.size(); ++r) {
        const DimensionEnds ends = ends_of(answers.weights, r);
        text += "\n" + digits(person.weights[r], 2) + "  from " + ends.low + " to " + ends.high;
    }
    return text + "\n" + digits(100.0 * person.explained, 0) +
           " % of their ratings explained; thin line: the mean of all. Not tested.";
}

// A star as high as the row.
void draw_star_cell(Ui& ui, const StudyAnswers& answers, const std::string& code) {
    if (!ImGui::TableNextColumn()) return;
    const PersonWeights* const person = weights_of(answers, code);
    if (person == nullptr) return dim_text(ui, "\u2013");
    const float side = kStarLines * ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    draw_star(*ImGui::GetWindowDrawList(), ui.theme, {corner, corner + ImVec2(side, side)},
              person->weights, answers.weights.mean);
    std::string noted;
    for (const double weight : person->weights) noted += digits(weight, 2) + " ";
    note_item(ui.rects, "star:" + code, noted);
    if (ImGui::IsItemHovered()) draw_tooltip(ui, weights_text(answers, *person).c_str());
}

// What the stars are, if there is room for a line of it below the rows.
void draw_star_legend(Ui& ui) {
    const ImFont* font = ui.theme.fonts.small;
    const char* text =
        "goes by: a ray for each dimension of a common map, as long as its weight; thin line: the "
        "mean of all";
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size = text_size(font, text);
    if (size.x > room.x || size.y > room.y) return;
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, text);
    ImGui::PopFont();
    note_item(ui.rects, "study:stars", text);
}

void draw_cells(Ui& ui, const StudyAnswers& answers, const ParticipantSummary& person) {
    const auto cell = [](const std::string& text) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
    };
    cell(std::to_string(person.answers) + " of " + std::to_string(person.wanted));
    cell(identical_text(person));
    cell(std::isnan(person.rho_with_others) ? "\u2013" : significant(person.rho_with_others, 2));
    cell(significant(person.minutes, 2));
    draw_star_cell(ui, answers, person.code);
    ImGui::TableNextColumn();
    const std::string state = state_of(person);
    const bool is_odd = !person.excluded.empty() || person.is_outlier;
    ImGui::PushStyleColor(ImGuiCol_Text, is_odd ? ui.theme.warning : ui.theme.dim_text);
    ImGui::TextUnformatted(state.c_str());
    ImGui::PopStyleColor();
    draw_tooltip(ui, person.is_outlier
                         ? "Agrees with the others far less than they do among themselves "
                           "(below Tukey's lower fence). Counted all the same."
                         : state.c_str());
}

void draw_row(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
              StudyState& studying, const StudyAnswers& answers, std::size_t k) {
    const StudyRecord& record = answers.records[k];
    const std::string& code = record.header.participant.code;
    const ParticipantSummary* person = nullptr;
    for (const ParticipantSummary& one : answers.results->people) {
        if (one.code == code) person = &one;
    }
    if (person == nullptr) return;
    ImGui::PushID(static_cast<int>(k));
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    // It lies under all columns: a click on the link in the last one is not one on the row.
    constexpr ImGuiSelectableFlags kRow =
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap;
    if (ImGui::Selectable(code.c_str(), studying.shown == k, kRow)) {
        studying.shown = studying.shown == k ? std::nullopt : std::optional(k);
    }
    note_item(ui.rects, "participant:" + code,
              std::to_string(person->answers) + " of " + std::to_string(person->wanted) + ", " +
                  state_of(*person));
    draw_cells(ui, answers, *person);
    ImGui::TableSetColumnIndex(kColumns - 1);
    draw_row_link(ui, work, timeline, play, studying, record, *person);
    ImGui::PopID();
}

}  // namespace

// Widths are set: columns that fit their content would move after the first frame.
void draw_people_table(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                       StudyState& studying, const StudyAnswers& answers) {
    struct Column {
        const char* name;
        const char* tip;
        float weight;
        bool needs_room = false;
    };
    constexpr std::array<Column, kColumns> kHeads{
        {{"participant", "Click one for their own matrix and map.", 2.2F},
         {"answers", "Given, of those wanted.", 1.4F},
         {"identical", "Similarities of identical patterns: the test of attention.", 1.5F, true},
         {"rho", "Spearman's rho with the mean of the others who count.", 1.5F},
         {"min", "Minutes spent on answers.", 0.8F, true},
         {"goes by",
          "How much of each one's ratings stands in every dimension of a common map: a ray each.",
          1.0F, true},
         {"", "", 2.6F},
         {"", "", 1.7F}}};
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    const bool has_room = ImGui::GetContentRegionAvail().x >= 660.0F * ui.theme.scale;
    if (!ImGui::BeginTable("participants", kColumns, kFlags)) return;
    for (const Column& column : kHeads) {
        const bool is_shown = has_room || !column.needs_room;
        const ImGuiTableColumnFlags shown = is_shown ? 0 : ImGuiTableColumnFlags_Disabled;
        ImGui::TableSetupColumn(column.name, ImGuiTableColumnFlags_WidthStretch | shown,
                                column.weight);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.theme.fonts.small);
    for (const Column& column : kHeads) {
        ImGui::TableNextColumn();
        const std::string name = column.name;
        dim_text(ui, of_people(name, answers.results->synthetic && name == "rho"));
        if (*column.tip != '\0') draw_tooltip(ui, column.tip);
    }
    ImGui::PopFont();
    for (std::size_t k = 0; k < answers.records.size(); ++k)
        draw_row(ui, work, timeline, play, studying, answers, k);
    ImGui::EndTable();
    if (has_room && !answers.weights.people.empty()) draw_star_legend(ui);
}

}  // namespace tact
