// What people are asked: the design of the document's study, every change an undo step.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string_view>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/planning/planning.h"
#include "app/study/parts.h"
#include "app/study/study.h"
#include "app/ui/widgets.h"
#include "model/set/set_ratings.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

void change(Workspace& work, const std::function<void(StudyDesign&)>& edit) {
    edit(work.document.edit().study);
    document_changed(work);
}

void change_at_once(Ui& ui, Workspace& work, const std::string& label,
                    const std::function<void(StudyDesign&)>& edit) {
    change(work, edit);
    commit_step(ui, work, label);
}

void draw_number(Ui& ui, Workspace& work, const DescribedField<StudyDesign>& row) {
    double value = row.get(work.document.set.study);
    Field field = row.field;
    field.normal = row.get(StudyDesign{});
    const FieldEdit edit = draw_field(ui, field, value);
    if (edit.changed) change(work, [&](StudyDesign& design) { row.set(design, value); });
    if (edit.finished) commit_step(ui, work, std::string("study: ") + row.field.label);
}

// The output that is an actuator's or gone is told below the choice.
void draw_headphones(Ui& ui, Workspace& work, const PlayState& play) {
    const StudyDesign& design = work.document.set.study;
    if (design.masking <= 0.0) return;
    const auto listed = play.listed;
    const auto name_of = [&](const std::string& id) {
        for (std::size_t k = 0; listed && k < listed->size(); ++k) {
            if ((*listed)[k].id == id) return (*listed)[k].name;
        }
        return id.substr(id.rfind('/') + 1);
    };
    draw_label(ui, "Headphones", 200.0F * ui.theme.scale);
    const auto offer = [&](const DeviceInfo& device) {
        const bool is_actuator = is_actuators(play, device);
        const Item item{.id = "study headphones:" + device.id,
                        .label = device.name + (is_actuator ? " (the actuator's)" : ""),
                        .enabled = !is_actuator,
                        .value = is_actuator ? "the actuator's" : ""};
        if (!option(ui, item, device.id == design.headphones)) return;
        change_at_once(ui, work, "study: headphones",
                       [id = device.id](StudyDesign& d) { d.headphones = id; });
    };
    const Item shown{
        .id = "study:headphones",
        .label = design.headphones.empty() ? "choose an output" : name_of(design.headphones),
        .tip = "The sound output that the participant's headphones are on",
        .value = design.headphones};
    drop_down(
        ui, shown, -1.0F,
        [&] {
            for (std::size_t k = 0; listed && k < listed->size(); ++k) {
                if ((*listed)[k].kind == DeviceKind::audio) offer((*listed)[k]);
            }
        },
        ImGuiComboFlags_HeightRegular);
    const Expected<DeviceInfo> output = masking_output(play, work.document.set.study.headphones);
    if (output) return;
    coloured_text(
        ui, ui.theme.warning,
        {.id = "study:no masking", .text = "No masking noise: " + output.error().message + "."});
}

void draw_kind(Ui& ui, StudyState& studying) {
    constexpr std::array kKinds{
        Choice{StudyKind::pairwise, "Rate pairs",
               "Two patterns at a time, similarity from 0 to 100: every pair several times."},
        Choice{StudyKind::sorting, "Sort into groups",
               "All patterns at once, put together where they feel alike, several times with "
               "given numbers of groups. Quicker, and coarser."}};
    if (draw_segments(ui, kKinds, studying.kind, "study kind:")) studying.shown.reset();
}

void draw_order(Ui& ui, Workspace& work) {
    constexpr std::array kOrders{
        Choice{StudyOrder::full, "Full design",
               "The publication's: all pairs in random order, pass by pass."},
        Choice{StudyOrder::adaptive, "Adaptive",
               "Not the publication's: pairs in an order that settles the map early, with a word "
               "when more trials would change little. Its answers are kept apart."}};
    draw_label(ui, "Order", segments_width(ui, kOrders));
    StudyOrder order = work.document.set.study.order;
    if (!draw_segments(ui, kOrders, order, "study order:")) return;
    change_at_once(ui, work, "study: order", [order](StudyDesign& d) { d.order = order; });
}

// What the identical pairs are worth.
void draw_chance(Ui& ui, const StudyDesign& design) {
    const bool is_weak = chance_to_pass(design.attention_pairs, design.attention) > 0.05;
    const std::string text = words_on_chance(design.attention_pairs, design.attention) +
                             " would pass the identical pairs" +
                             (is_weak ? ": more of them, or fewer to miss, let fewer pass." : ".");
    coloured_text(ui, is_weak ? ui.theme.warning : ui.theme.dim_text,
                  {.id = "study:chance",
                   .text = text,
                   .tip = "Binomial, exact: each whole number of the slider as likely, each "
                          "identical pair for itself."});
}

// "20 min"; of more than three hours "337 h".
std::string minutes_text(double minutes) {
    constexpr double kInHours = 180.0;
    return minutes <= kInHours
               ? significant_digits(minutes, 3) + " min"
               : grouped_digits(static_cast<std::size_t>(std::llround(minutes / 60.0))) + " h";
}

// The line that an experimenter plans by.
void draw_prediction(Ui& ui, const Workspace& work, const StudyState& studying) {
    const StudyDesign& design = work.document.set.study;
    const std::size_t patterns = study_names(work).size();
    std::string text;
    if (studying.kind == StudyKind::sorting) {
        const std::size_t rounds = design.groups.empty()
                                       ? sorting_rounds(patterns, patterns / 2).size()
                                       : design.groups.size();
        text = counted(rounds, "round", "rounds") + ", about " +
               minutes_text(3.0 * static_cast<double>(rounds));
    } else {
        const double minutes =
            std::ceil(predicted_minutes(design, patterns, study_duration_s(work)));
        text = counted(trial_count(design, patterns), "trial", "trials") + ", about " +
               minutes_text(minutes);
    }
    ImGui::PushFont(ui.theme.fonts.large);
    wrapped_text(ui, {.id = "study:prediction",
                      .text = text,
                      .tip = "18 s a trial, as in the publication; longer for longer patterns."});
    ImGui::PopFont();
    if (studying.kind != StudyKind::pairwise) return;
    if (link(ui, {.id = "link:plan",
                  .label = "How many people?",
                  .tip = "Simulates studies: how sure would this one be, and which patterns "
                         "decide?"})) {
        ui.dialog = kPlanDialog;
    }
    draw_chance(ui, design);
}

// Numbers of groups, as text; taken when the entry is left.
void draw_rounds(Ui& ui, Workspace& work, StudyState& studying) {
    const std::size_t patterns = study_names(work).size();
    std::string& typed = studying.rounds_text;
    const std::string hint = rounds_text(sorting_rounds(patterns, patterns / 2));
    draw_label(ui, "Rounds");
    ImGui::SetNextItemWidth(-1.0F);
    std::string shown = rounds_text(work.document.set.study.groups);
    ImGui::InputTextWithHint("##rounds", hint.c_str(), &shown);
    if (ImGui::IsItemActive()) typed = shown;
    const bool is_left = ImGui::IsItemDeactivatedAfterEdit();
    say_of_last_item(
        ui,
        {.id = "study:rounds",
         .text = shown,
         .tip = "Numbers of groups, a round each, or free: as many as the participant likes. Left "
                "empty: a free round, then 3, 6, 9, 12 and 15 without the one nearest to it."});
    if (!is_left) return;
    const auto rounds = rounds_in(typed, patterns);
    if (!rounds) {
        return complain(ui, "Rounds are numbers of groups from 2 to " + std::to_string(patterns) +
                                ", or free: " + hint + ".");
    }
    change_at_once(ui, work, "study: rounds",
                   [&](StudyDesign& design) { design.groups = *rounds; });
}

void toggle_pattern(Ui& ui, Workspace& work, const std::string& name, bool takes_part) {
    change_at_once(ui, work, "study: patterns", [&](StudyDesign& design) {
        design.patterns = study_patterns(work.document.set);
        if (takes_part) {
            design.patterns.push_back(name);
        } else {
            std::erase(design.patterns, name);
        }
        if (design.patterns.size() == work.document.set.vibrations.size()) design.patterns.clear();
    });
}

void draw_patterns(Ui& ui, Workspace& work) {
    const std::vector<std::string> chosen = study_names(work);
    const std::vector<std::string> all = names_of(work.document.set);
    const std::string head = std::to_string(chosen.size()) + " of " + std::to_string(all.size()) +
                             " patterns###study patterns";
    const bool is_open = ImGui::TreeNodeEx(
        head.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
    note_item(ui.rects, "study:patterns", std::to_string(chosen.size()));
    if (!is_open) return;
    const std::set<std::string_view> taking_part(chosen.begin(), chosen.end());
    for (const std::string& name : all) {
        bool takes_part = taking_part.contains(name);
        if (check(ui, {.id = "study pattern:" + name, .label = name}, takes_part)) {
            toggle_pattern(ui, work, name, takes_part);
        }
    }
}

// Words of the study; while they are edited as a field, whose entry is one undo step.
struct TextRow {
    const char* id;
    const char* title;
    std::string StudyDesign::*text;
};

void draw_text_field(Ui& ui, Workspace& work, const TextRow& row, const std::string& shown) {
    constexpr float kLines = 8.0F;
    std::string typed = shown;
    if (ImGui::InputTextMultiline((std::string("##") + row.id).c_str(), &typed,
                                  {-1.0F, kLines * ImGui::GetTextLineHeight()})) {
        change(work, [&](StudyDesign& design) { design.*row.text = typed; });
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) commit_step(ui, work, std::string("study: ") + row.id);
    note_item(ui.rects, std::string("study text:") + row.id);
}

void draw_text_row(Ui& ui, Workspace& work, StudyState& studying, const TextRow& row,
                   const std::string& shown) {
    ImGui::Spacing();
    ImGui::PushID(row.id);
    dim_text(ui, row.title);
    bool is_edited = studying.edited_text == row.id;
    ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    if (link(ui,
             {.id = std::string("study:edit ") + row.id, .label = is_edited ? "Done" : "Edit"})) {
        is_edited = !is_edited;
        studying.edited_text = is_edited ? row.id : "";
    }
    if (!(work.document.set.study.*row.text).empty()) {
        ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
        if (link(ui, {.id = std::string("study:standard ") + row.id, .label = "Standard text"})) {
            change_at_once(ui, work, std::string("study: ") + row.id,
                           [&](StudyDesign& design) { (design.*row.text).clear(); });
        }
    }
    if (is_edited) {
        draw_text_field(ui, work, row, shown);
    } else {
        reading_text(ui.theme.text, shown);
    }
    ImGui::PopID();
}

}  // namespace

void draw_study_design(Ui& ui, Workspace& work, const PlayState& play, StudyState& studying) {
    ImGui::BeginChild("study design", ImGui::GetContentRegionAvail());
    draw_kind(ui, studying);
    draw_prediction(ui, work, studying);
    ImGui::Spacing();
    const bool rates = studying.kind == StudyKind::pairwise;
    if (rates) draw_order(ui, work);
    if (!rates) draw_rounds(ui, work, studying);
    for (const StudyNumber& number : study_numbers()) {
        if (rates || !number.of_pairs) draw_number(ui, work, number.row);
    }
    draw_headphones(ui, work, play);
    ImGui::Spacing();
    draw_patterns(ui, work);
    const StudyDesign& design = work.document.set.study;
    draw_text_row(ui, work, studying, {"instructions", "Instructions", &StudyDesign::instructions},
                  instructions_of(design, studying.kind));
    draw_text_row(ui, work, studying, {"consent", "Consent", &StudyDesign::consent},
                  consent_of(design));
    ImGui::EndChild();
}

}  // namespace tact
