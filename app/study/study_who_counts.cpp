// Leaving participants out by hand, and rules on how they answered. Declared in
// app/study/study_panels.h.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/measured/recording_fields.h"
#include "app/study/study_follow.h"
#include "app/study/study_panels.h"
#include "app/ui/dialog.h"
#include "app/ui/widgets.h"
#include "model/io/people/exclusions_file.h"
#include "model/text/utc_time.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

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
    if (draw_check(ui.theme, row.label, is_on)) {
        value = is_on ? std::optional(row.limit.normal) : std::nullopt;
    }
    note_item(ui.rects, std::string("check:") + row.limit.id, is_on ? "on" : "off");
    draw_tooltip(ui, row.tip);
    if (value) draw_limit(ui, row.limit, *value);
}

}  // namespace

void ask_to_leave_out(Ui& ui, StudyState& studying, const std::string& code) {
    studying.leaving_out = {code, {}};
    ui.dialog = Dialog::leave_out;
}

void count_again(Ui& ui, const Workspace& work, StudyState& studying, const std::string& code) {
    CountRule rule;
    rule.include = {code};
    record(ui, work, studying, rule);
}

void draw_leave_out_dialog(Ui& ui, const Workspace& work, StudyState& studying) {
    LeavingOut& leaving = studying.leaving_out;
    if (leaving.code.empty()) {  // nobody to ask about
        ui.dialog = Dialog::none;
        return;
    }
    if (!begin_dialog(ui, "Leave a participant out", 480.0F)) return;
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
    if (!begin_dialog(ui, "Rules on how people answered", 520.0F)) return;
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
