#include "app/study/study.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/compare/compare.h"
#include "app/measured/measured.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/people/exclusions_file.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"
#include "viz/charts/profile_view.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

// The table of who took part: a row a participant, what their answers are worth, and what each one
// goes by.

namespace {

constexpr int kColumns = 8;
constexpr float kStarLines = 2.2F;

std::string state_of(const ParticipantSummary& person) {
    std::string text = person.synthetic ? "synthetic" : "counts";
    if (!person.excluded.empty()) text = (person.synthetic ? "synthetic, " : "") + person.excluded;
    if (person.is_outlier) text += ", outlier";
    if (person.cut_short > 0) {
        text += ", " + std::to_string(person.cut_short) +
                (person.cut_short == 1 ? " play cut short" : " plays cut short");
    }
    return text;
}

// Where it is too long, without the last of its parts, never in the middle of one that can go.
std::string fitting(const ImFont* font, const std::string& state, float room_px) {
    if (text_size(font, state).x <= room_px) return state;
    for (std::size_t comma = state.rfind(", "); comma != state.npos && comma > 0;
         comma = state.rfind(", ", comma - 1)) {
        const std::string part = state.substr(0, comma) + "\u2026";
        if (text_size(font, part).x <= room_px) return part;
    }
    return shortened(font, state, room_px);
}

std::string identical_text(const ParticipantSummary& person) {
    std::string text;
    for (const double similarity : person.attention) {
        text += (text.empty() ? "" : ", ") + std::to_string(std::lround(similarity));
    }
    return text.empty() ? "\u2013" : text;
}

// Words stand in the middle of a row so high.
float text_inset_px(float row_px) {
    return std::round(0.5F * std::max(0.0F, row_px - ImGui::GetTextLineHeight()));
}

bool next_cell(float row_px) {
    const bool is_seen = ImGui::TableNextColumn();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + text_inset_px(row_px));
    return is_seen;
}

// The next action on a participant: continue, leave out, count again.
void draw_row_link(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                   StudyState& studying, const StudyRecord& record,
                   const ParticipantSummary& person) {
    const std::string& code = person.code;
    const auto pressed = [&](const char* what, const char* label, const char* tip) {
        const std::string id = std::string("link:") + what + " " + code;
        return link(ui, {.id = id, .label = label, .tip = tip});
    };
    if (!record.excluded.empty()) {
        if (pressed("count again", "Count again",
                    "Takes the record of why they were left out from the study's folder.")) {
            count_again(ui, work, studying, code);
        }
    } else if (person.answers < person.wanted && !person.synthetic) {
        if (pressed("go on", "Go on", "Takes the study up again at the trial where it was left.")) {
            resume_participant(ui, work, timeline, play, studying, record);
        }
    } else if (person.excluded.empty()) {
        if (pressed("leave out", "Leave out...",
                    "For a reason, which the study's folder keeps. They can count again.")) {
            ask_to_leave_out(ui, studying, code);
        }
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
        text +=
            "\n" + with_decimals(person.weights[r], 2) + "  from " + ends.low + " to " + ends.high;
    }
    return text + "\n" + with_decimals(100.0 * person.explained, 0) +
           " % of their ratings explained; thin line: the mean of all. Not tested.";
}

// The dimension that weighs most, with its weight; before it the star of all, as high as the row,
// where rows are high enough to tell stars apart.
void draw_weights_cell(Ui& ui, const StudyAnswers& answers, const std::string& code, float row_px,
                       bool has_stars) {
    if (!next_cell(row_px)) return;
    const PersonWeights* const person = weights_of(answers, code);
    if (person == nullptr) return dim_text(ui, "\u2013");
    const auto most = std::ranges::max_element(person->weights);
    const std::string words =
        "D" + std::to_string(most - person->weights.begin() + 1) + "  " + with_decimals(*most, 2);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    if (has_stars) {
        const Rect star = rect_at({corner.x, corner.y - text_inset_px(row_px)}, {row_px, row_px});
        draw_star(*ImGui::GetWindowDrawList(), ui.theme, star, person->weights,
                  answers.weights.mean);
        corner.x += row_px + ui.theme.gap_px;
        ImGui::SetCursorScreenPos(corner);
    }
    plain_text(ui, {.id = "goes by:" + code, .text = words});
    if (ImGui::IsItemHovered()) draw_tooltip(ui, weights_text(answers, *person).c_str());
}

// What the stars are, if there is room for a line of it below the rows.
void draw_star_legend(Ui& ui) {
    const ImFont* font = ui.theme.fonts.small;
    const char* text =
        "goes by: the dimension of a common map that weighs most; a ray for each, as long as its "
        "weight; thin line: the mean of all";
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size = text_size(font, text);
    if (size.x > room.x || size.y > room.y) return;
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, {.id = "study:stars", .text = text});
    ImGui::PopFont();
}

void draw_cells(Ui& ui, const StudyAnswers& answers, const ParticipantSummary& person, float row_px,
                bool has_stars) {
    const auto cell = [row_px](const std::string& text) {
        next_cell(row_px);
        ImGui::TextUnformatted(text.c_str());
    };
    cell(std::to_string(person.answers) + " of " + std::to_string(person.wanted));
    cell(identical_text(person));
    cell(std::isnan(person.rho_with_others) ? "\u2013" : significant(person.rho_with_others, 2));
    cell(significant(person.minutes, 2));
    draw_weights_cell(ui, answers, person.code, row_px, has_stars);
    next_cell(row_px);
    const std::string state = state_of(person);
    const bool is_odd = !person.excluded.empty() || person.is_outlier;
    ImGui::PushStyleColor(ImGuiCol_Text, is_odd ? ui.theme.warning : ui.theme.dim_text);
    const float room = ImGui::GetContentRegionAvail().x;
    plain_text(ui, {.id = "shown status:" + person.code,
                    .text = fitting(ui.theme.fonts.regular, state, room)});
    ImGui::PopStyleColor();
    say_of_last_item(
        ui,
        {.id = "status:" + person.code,
         .text = state,
         .tip = person.is_outlier ? "Agrees with the others far less than they do among themselves "
                                    "(below Tukey's lower fence). Counted all the same."
                                  : state});
}

void draw_row(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
              StudyState& studying, const StudyAnswers& answers, std::size_t k, float row_px,
              bool has_stars) {
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
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0.0F, 0.5F));
    if (option(ui,
               {.id = "participant:" + code,
                .label = code,
                .value = std::to_string(person->answers) + " of " + std::to_string(person->wanted) +
                         ", " + state_of(*person)},
               studying.shown == k, kRow, {0.0F, row_px})) {
        studying.shown = studying.shown == k ? std::nullopt : std::optional(k);
    }
    ImGui::PopStyleVar();
    draw_cells(ui, answers, *person, row_px, has_stars);
    next_cell(row_px);
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
         {"answers", "Given, of those wanted.", 1.5F},
         {"identical, of 100",
          "How similar they rated pairs of one and the same pattern, 100 the same: the test of "
          "attention.",
          2.2F, true},
         {"rho", "Spearman's rho with the mean of the others who count.", 1.5F},
         {"min", "Minutes spent on answers.", 0.8F, true},
         {"goes by",
          "The dimension of a common map in which most of their ratings stands, and how much; rest "
          "on it for all.",
          1.9F, true},
         {"status", "Whether their answers count, and if not, why.", 2.2F},
         {"action", "What can be done next.", 1.7F}}};
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    const bool has_room = ImGui::GetContentRegionAvail().x >= 700.0F * ui.theme.scale;
    // High rows only where all of them are seen at once.
    const float star_px = std::round(kStarLines * ImGui::GetTextLineHeight());
    const float lines = ImGui::GetContentRegionAvail().y - 3.0F * ImGui::GetFrameHeight();
    const float high_px = star_px + 2.0F * ImGui::GetStyle().CellPadding.y;
    const bool has_stars = has_room && !answers.weights.people.empty() &&
                           static_cast<float>(answers.records.size()) * high_px <= lines;
    const float row_px = has_stars ? star_px : ImGui::GetTextLineHeight();
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
        dim_text(ui,
                 of_people(name, {.synthetic = answers.results->mark.synthetic && name == "rho"}));
        draw_tooltip(ui, column.tip);
    }
    ImGui::PopFont();
    for (std::size_t k = 0; k < answers.records.size(); ++k)
        draw_row(ui, work, timeline, play, studying, answers, k, row_px, has_stars);
    ImGui::EndTable();
    if (has_stars) draw_star_legend(ui);
}

// Leaving participants out by hand, and rules on how they answered.

namespace {

void wrapped(const Ui& ui, const std::string& text) {
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, text);
    ImGui::PopTextWrapPos();
}

// A folder that cannot be written to leaves everybody as they were.
void record(Ui& ui, const Workspace& work, StudyState& studying, const CountRule& rule) {
    const auto said = record_exclusions(study_folder(work, studying), rule, utc_now());
    if (!said) return complain(ui, said.error().message + ".");
    ++studying.folder_revision;
    for (const std::string& one : *said) say(ui, one + ".");
}

// Below its check box, where its words begin.
void draw_limit(Ui& ui, const NumberRow& row, double& value) {
    const float words = check_width(ui.theme, "");
    ImGui::Indent(words);
    draw_number_row(ui, row, value);
    ImGui::Unindent(words);
}

struct RuleRow {
    const char* label;
    NumberRow limit;  // it is switched on with the normal one
    const char* tip;
};

void draw_rule_row(Ui& ui, const RuleRow& row, std::optional<double>& value) {
    bool is_on = value.has_value();
    if (check(ui, {.id = std::string("check:") + row.limit.id, .label = row.label, .tip = row.tip},
              is_on)) {
        value = is_on ? std::optional(row.limit.normal) : std::nullopt;
    }
    if (value) draw_limit(ui, row.limit, *value);
}

}  // namespace

void ask_to_leave_out(Ui& ui, StudyState& studying, const std::string& code) {
    studying.leaving_out = {code, {}};
    ui.dialog = kLeaveOutDialog;
}

void count_again(Ui& ui, const Workspace& work, StudyState& studying, const std::string& code) {
    CountRule rule;
    rule.include = {code};
    record(ui, work, studying, rule);
}

void draw_leave_out_dialog(Ui& ui, const Workspace& work, StudyState& studying) {
    if (ui.dialog != kLeaveOutDialog) return;
    LeavingOut& leaving = studying.leaving_out;
    if (leaving.code.empty()) {  // nobody to ask about
        ui.dialog = kNoDialog;
        return;
    }
    if (!begin_dialog(ui, kLeaveOutDialog, 480.0F)) return;
    wrapped(ui, "Why does " + leaving.code +
                    " not count? The reason is kept in the study's folder and stands wherever "
                    "results are told. No answer is lost: they can count again.");
    ImGui::Spacing();
    if (ImGui::IsWindowAppearing()) focus_next_item();
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##because", "such as: wore gloves", &leaving.because);
    note_item(ui.rects, "leave out:because", leaving.because);
    const bool has_reason =
        std::ranges::any_of(leaving.because, [](unsigned char one) { return one > ' '; });
    if (!draw_ends(ui, "Leave out", has_reason)) return;
    CountRule rule;
    rule.exclude = {leaving.code};
    rule.because = leaving.because;
    record(ui, work, studying, rule);
}

void draw_conduct_dialog(Ui& ui, StudyState& studying) {
    ConductRule& rule = studying.rule.who.conduct;
    if (!begin_dialog(ui, kConductDialog, 520.0F)) return;
    wrapped(ui,
            "Whoever breaks a rule does not count, and is named with the rule. Decide on the rules "
            "before you look at the answers; none is on until you switch it on.");
    ImGui::Spacing();
    draw_rule_row(ui,
                  {"Answers come too soon",
                   {"fast_below_s", "Sooner than", 1.0, limits::kFastBelowS,
                    "s after both patterns were felt"},
                   "Counted from when both patterns of a pair were felt."},
                  rule.fast_below_s);
    if (rule.fast_below_s) {
        double percent = 100.0 * rule.fast_share;
        draw_limit(ui, {"fast_share", "In more than", 10.0, {0.0, 100.0}, "% of their answers"},
                   percent);
        rule.fast_share = percent / 100.0;
    }
    draw_rule_row(ui,
                  {"Repetitions do not agree",
                   {"repeat_rho", "Rho below", 0.3, limits::kRho,
                    "Spearman's, between their own repetitions"},
                   "Applies to designs that ask each pair twice or more."},
                  rule.repeat_rho);
    draw_rule_row(ui,
                  {"Too many replays",
                   {"replays", "More than", 5.0, limits::kReplays, "replays a trial, on average"},
                   "Plays beyond the first of each side."},
                  rule.replays);
    end_dialog(ui);
}

std::string conduct_summary(const ConductRule& rule) {
    const auto on = std::ranges::count_if(kConductTests,
                                          [&rule](ConductTest test) { return is_on(rule, test); });
    if (on == 0) return "Rules...";
    return on == 1 ? "1 rule..." : std::to_string(on) + " rules...";
}

}  // namespace tact
