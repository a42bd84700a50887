// Who took part: what each one's answers are worth, how far they agree, and what to do next.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/compare/compare.h"
#include "app/progress/progress.h"
#include "app/study/parts.h"
#include "app/study/study.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void small_text(Ui& ui, ImU32 colour, const Said& said) {
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, colour, said);
    ImGui::PopFont();
}

void draw_buttons(Ui& ui, const Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                  PlayState& play, StudyState& studying) {
    const std::string nobody = participant_obstacle(work, play, studying);
    if (primary_button(ui, {.id = "button:run participant",
                            .label = "Run a participant...",
                            .tip = "Fills the window: consent, instructions, training, trials.",
                            .why_not = nobody,
                            .value = nobody})) {
        begin_participant(ui, work, timeline, play, studying);
    }
    const std::string no_map = simulation_obstacle(work, studying, shown_map);
    flow_on(button_width("Simulate one"), ui.theme.gap_px);
    if (button(ui, {.id = "button:simulate",
                    .label = "Simulate one",
                    .tip = "A simulated participant: it answers as the model predicts, with noise. "
                           "Labelled synthetic in its file and wherever it is shown.",
                    .why_not = no_map,
                    .value = no_map})) {
        simulate_participant(ui, work, shown_map, play, studying);
    }
    const std::filesystem::path folder = study_folder(work, studying);
    const std::string name = folder.filename().string();
    flow_on(ImGui::CalcTextSize(name.c_str()).x, 2.0F * ui.theme.gap_px);
    if (row_link(ui, {.id = "link:study folder",
                      .label = name.empty() ? "Choose a folder..." : name,
                      .tip = "Participants' files are in " + folder.string() +
                             ". Click to choose another folder.",
                      .value = folder.string()})) {
        choose_study_folder(ui, work, studying);
    }
}

// What it would be felt by, if by anything.
void draw_device(Ui& ui, const PlayState& play, const StudyState& studying) {
    const DeviceStatus status = studying.device->status();
    if (status.connected) {
        return small_text(
            ui, ui.theme.dim_text,
            {.id = "study:device",
             .text = "Felt on " + status.name + ", " + study_calibration(play) + "."});
    }
    small_text(
        ui, ui.theme.warning,
        {.id = "study:device",
         .text = "No device: nothing will be felt. A run is a rehearsal, and its files say so."});
}

std::string agreement_text(const StudyAnswers& answers) {
    const StudyResults& results = *answers.results;
    std::size_t counted = 0;
    for (const ParticipantSummary& person : results.people) counted += person.excluded.empty();
    std::string text =
        std::to_string(counted) + " of " + std::to_string(results.people.size()) +
        (results.people.size() == 1 ? " participant counts." : " participants count.");
    if (results.mark.synthetic) text += " Synthetic: nobody was asked.";
    if (results.order == StudyOrder::adaptive) text += " Adaptive order, not the full design.";
    const std::string unrated =
        remark_on_unrated(unrated_patterns(results.study), results.study.labels.size());
    if (counted > 0 && !unrated.empty()) text += " " + unrated + ".";
    return text + " " + ceiling_text(results.agreement, results.mark);
}

// How alike people rate by the numbers of other fields, and whether order or sides shift ratings.
std::string raters_text(const StudyAnswers& answers) {
    const InterRater& raters = answers.raters;
    std::string text;
    if (raters.people > 1) {
        text = "Agreement: " + of_people("ICC(2,1) ", answers.results->mark) +
               with_decimals(raters.single.value, 2) + ", ICC(3,k) " +
               with_decimals(raters.mean.value, 2) + ", Krippendorff's alpha " +
               with_decimals(raters.alpha, 2) + ".";
    }
    const auto add = [&text](const char* what, const Shift& shift) {
        if (shift.comparisons == 0 || std::isnan(shift.p)) return;
        const std::string p = shift.p < 0.001 ? "p < 0.001" : "p = " + with_decimals(shift.p, 3);
        text += text.empty() ? "" : " ";
        text += shift.p < 0.05 ? "Ratings shift with " : "No sign that ratings shift with ";
        text += std::string(what) + " (" + p + ").";
    };
    add("the order felt", answers.effects.felt_first);
    add("the side", answers.effects.side);
    add("practice", answers.effects.practice);
    return text;
}

void draw_settling(Ui& ui, const StudyAnswers& answers) {
    if (!answers.settling) return;
    const MapSettling& settling = *answers.settling;
    std::string text = "The latest participant's map still moves: more trials tell more.";
    if (settling.is_settled)
        text = "The latest participant's map has settled: more would change little.";
    if (settling.change.empty()) text = "Too few answers to tell whether the map has settled.";
    if (!settling.change.empty()) {
        text += " " + of_people("K ", answers.results->mark) +
                significant(settling.change.front(), 2) +
                " over the last trials, as many as there are patterns.";
    }
    small_text(ui, settling.is_settled ? ui.theme.text : ui.theme.dim_text,
               {.id = "study:settling", .text = text});
}

constexpr const char* kUnfinished = "Count unfinished ones";
constexpr const char* kUse = "Use as the set's ratings";
constexpr const char* kExport = "Export CSV...";

constexpr std::array kScalings{
    Choice{RatingScaling::none, "As rated", "The publication's: no scaling of people."},
    Choice{RatingScaling::min_max, "Own range", "Each one's lowest and highest to 0 and 100."},
    Choice{RatingScaling::standard, "Standardised", "Each one to mean 50, deviation 10."}};

// What is counted and what can be done with it, in one line: as wide as that is.
float foot_px(const Ui& ui, const StudyState& studying) {
    float width =
        check_width(ui.theme, kUnfinished) + segments_width(ui, kScalings) + 1.5F * ui.theme.gap_px;
    width += ImGui::CalcTextSize(conduct_summary(studying.rule.who.conduct).c_str()).x;
    return width + button_width(kUse) + button_width(kExport) + 4.5F * ui.theme.gap_px;
}

void draw_rule(Ui& ui, StudyState& studying) {
    CollectRule& rule = studying.rule;
    check(ui, {.id = "check:unfinished", .label = kUnfinished}, rule.unfinished_too);
    flow_on(segments_width(ui, kScalings), 1.5F * ui.theme.gap_px);
    draw_segments(ui, kScalings, rule.scaling, "study scaling:");
    const std::string rules = conduct_summary(rule.who.conduct);
    flow_on(ImGui::CalcTextSize(rules.c_str()).x, 1.5F * ui.theme.gap_px);
    if (row_link(
            ui, {.id = "link:conduct rules",
                 .label = rules,
                 .tip = "Speed, agreement of repetitions, replays: who does not count by them."})) {
        ui.dialog = kConductDialog;
    }
}

void draw_results(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline, Comparing& comparing,
                  PlayState& play, StudyState& studying, const StudyAnswers& answers) {
    const bool is_low = ImGui::GetContentRegionAvail().y < 210.0F * ui.theme.scale;
    const std::string raters = raters_text(answers);
    // In a low pane the table needs the room.
    small_text(
        ui, ui.theme.dim_text,
        {.id = "study:agreement", .text = agreement_text(answers), .tip = is_low ? raters : ""});
    if (!is_low && !raters.empty()) {
        small_text(
            ui, ui.theme.dim_text,
            {.id = "study:raters",
             .text = raters,
             .tip = "One person with another; the mean of all; both against chance. p: whether "
                    "the order in which a pair was felt, its sides, or the last repetition "
                    "against the first shift ratings (by signs, two-sided). Of one person nothing "
                    "can be said on that."});
    }
    draw_settling(ui, answers);
    if (answers.is_of_other_patterns) {
        small_text(ui, ui.theme.warning,
                   {.id = "study:other patterns",
                    .text = "These answers are about other patterns than the set now has."});
    }
    const bool is_one_line = foot_px(ui, studying) <= ImGui::GetContentRegionAvail().x;
    const float foot = (is_one_line ? 1.0F : 2.0F) * ImGui::GetFrameHeightWithSpacing();
    const float height = std::max(ImGui::GetContentRegionAvail().y - foot, 60.0F * ui.theme.scale);
    ImGui::BeginChild("participants", {0.0F, height});
    draw_people_table(ui, work, timeline, play, studying, answers);
    ImGui::EndChild();
    draw_rule(ui, studying);
    if (is_one_line) ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    if (button(ui, {.id = "button:use as ratings",
                    .label = kUse,
                    .tip = "Compare then shows which metric agrees with them best. One undo step.",
                    .enabled = !answers.results->study.judgements.empty()})) {
        use_as_ratings(ui, work, layout, comparing, studying);
    }
    flow_on(button_width(kExport), ui.theme.gap_px);
    if (button(ui,
               {.id = "button:export study",
                .label = kExport,
                .tip = "A line an answer, those who are not counted marked: for R and Python."})) {
        export_study_dialog(ui, work, studying);
    }
}

// A design that is another than the first participant's, and the two ways on.
void draw_design_changes(Ui& ui, Workspace& work, StudyState& studying) {
    const auto changes = design_changes(work, studying);
    if (changes.empty()) return;
    small_text(ui, ui.theme.warning,
               {.id = "study:another design", .text = another_study_words(changes)});
    if (link(ui, {.id = "link:another study",
                  .label = "Begin another study",
                  .tip = "Its participants go into a folder of their own beside this one."})) {
        begin_another_study(ui, work, studying);
    }
    flow_on(ImGui::CalcTextSize("Take the design back").x, 2.0F * ui.theme.gap_px);
    if (link(ui, {.id = "link:design back",
                  .label = "Take the design back",
                  .tip = "Asks as the first participant was asked. One undo step."})) {
        take_design_back(ui, work, studying);
    }
}

void draw_people(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                 const ShownMap& shown_map, Comparing& comparing, PlayState& play,
                 StudyState& studying) {
    draw_buttons(ui, work, timeline, shown_map, play, studying);
    draw_device(ui, play, studying);
    draw_design_changes(ui, work, studying);
    (void)draw_failure(ui, "study", studying.job.failure());
    const std::shared_ptr<const StudyAnswers> answers = studying.answers;
    if (!answers) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "Reading the answers",
                          "Whoever took part is listed here.");
    }
    if (!answers->fault.empty()) {
        return small_text(ui, ui.theme.error, {.id = "study:fault", .text = answers->fault});
    }
    if (answers->results)
        return draw_results(ui, work, layout, timeline, comparing, play, studying, *answers);
    const Rect area = rest_of_pane();
    if (area.empty()) return;
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "No participants yet",
               answers->others.empty()
                   ? "Run a participant: each becomes a file in the folder above."
                   : "There are participants of the other kind of study in this folder.");
}

}  // namespace

// Scrolls where the pane is too low for its buttons.
void draw_study_people(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                       const ShownMap& shown_map, Comparing& comparing, PlayState& play,
                       StudyState& studying) {
    ImGui::BeginChild("study people", ImGui::GetContentRegionAvail());
    draw_people(ui, work, layout, timeline, shown_map, comparing, play, studying);
    ImGui::EndChild();
}

}  // namespace tact
