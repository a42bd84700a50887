#include "app/planning/planning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/subset/set_subset.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

PatternSet study_part(const PatternSet& set) {
    std::vector<std::size_t> places;
    for (const std::string& name : study_patterns(set)) {
        if (const auto place = place_named(set, name)) places.push_back(*place);
    }
    PatternSet part = part_of(set, places);
    part.study.patterns.clear();
    return part;
}

PlanRequest request_of(const Workspace& work, const PlanChoice& choice) {
    return {work.document_number, work.revision, choice, nullptr};
}

Expected<SetPlan> plan_of(const PlanRequest& request, std::stop_token stop,
                          std::atomic<float>& progress) {
    const PlanChoice& choice = request.choice;
    PlanQuestion question{
        .set = *request.set,
        .rival = choice.rival,
        .people = people_between(static_cast<std::size_t>(choice.first),
                                 static_cast<std::size_t>(choice.last)),
        .pairs = choice.all_pairs ? 0 : static_cast<std::size_t>(choice.pairs),
        .decide = choice.all_patterns ? 0 : static_cast<std::size_t>(choice.decide)};
    if (choice.by_ratings) {
        Expected<RatingStudy> pilot = study_of(*request.set);
        if (!pilot) return pilot.error();
        question.pilot = *std::move(pilot);
        for (const std::string& sentence : sentences_of(mark_of(*question.pilot))) {
            question.of_pilot += (question.of_pilot.empty() ? "" : "; ") + sentence;
        }
    } else {
        question.rho = choice.rho;
        question.reliability = choice.reliability;
    }
    // Simulating takes most of the time.
    constexpr float kBefore = 0.1F;
    return set_plan(
        question, {std::move(stop), [&progress](const char* what, double share) {
                       const bool simulates = std::string_view(what) == "simulating studies";
                       progress = simulates ? kBefore + (1.0F - kBefore) * static_cast<float>(share)
                                            : kBefore * static_cast<float>(share);
                   }});
}

}  // namespace

void simulate_plan(Ui& ui, const Workspace& work, PlanState& planning) {
    PlanRequest request = request_of(work, planning.choice);
    request.set = std::make_shared<const PatternSet>(study_part(work.document.set));
    planning.chosen.reset();
    planning.job.ask(
        std::move(request),
        [](const PlanRequest& asked, const std::stop_token& stop,
           std::atomic<float>& progress) -> std::optional<LivePlan> {
            Expected<SetPlan> plan = plan_of(asked, stop, progress);
            if (stop.stop_requested()) return std::nullopt;
            return LivePlan{asked, std::move(plan)};
        },
        ui.wake);
}

std::string plan_obstacle(const Workspace& work) {
    const std::size_t patterns = study_patterns(work.document.set).size();
    if (patterns >= kLeastRated) return {};
    return "A study can be planned of " + std::to_string(kLeastRated) +
           " patterns and more; this one has " + std::to_string(patterns) + ".";
}

bool is_planning(const PlanState& planning) { return planning.job.busy(); }

bool is_plan_current(const Workspace& work, const PlanState& planning) {
    const auto live = planning.job.latest();
    return live && live->request == request_of(work, planning.choice);
}

void use_planned_patterns(Ui& ui, Workspace& work, const SetPlan& plan) {
    work.document.edit().study.patterns = names_of(plan.set);
    document_changed(work);
    commit_step(ui, work, "study: patterns");
    say(ui, "The study asks about these " + std::to_string(plan.set.vibrations.size()) +
                " patterns. Ctrl+Z takes that back.");
}

void choose_preregistration_folder(Ui& ui, const Workspace& work, const PlanState& planning) {
    ask_for_file(
        ui,
        {.use = ChooserUse::save_folder,
         .title = "Freeze the plan in a folder",
         .extensions = {".json", ".html"},
         .folders_too = true,
         .file_names = {"preregistration.json", "preregistration.html"},
         .take =
             [&](const std::filesystem::path& folder) { preregister(ui, work, planning, folder); }},
        work.document.path.parent_path(), "preregistration");
}

void preregister(Ui& ui, const Workspace& work, const PlanState& planning,
                 const std::filesystem::path& folder) {
    const auto live = planning.job.latest();
    if (!live || !live->plan || !planning.chosen) return;
    SetPlan plan = *live->plan;
    if (*planning.chosen >= plan.studies.size()) return;
    plan.studies = {plan.studies[*planning.chosen]};
    const std::string& named = work.document.set.name;
    const std::string name = named.empty() ? work.document.path.filename().string() : named;
    const Preregistration frozen = preregistration_of(plan, name, kProgramVersion, utc_now());
    const Expected<Done> written = write_preregistration(folder, frozen);
    if (!written) return complain(ui, "Not written: " + written.error().message);
    say(ui, "The plan is frozen in " + (folder / "preregistration.html").string());
}

namespace {

constexpr float kPlanDialogPx = 900.0F;
constexpr double kEnoughPower = 0.8;

void enter_count(Ui& ui, const char* id, const char* label, Range most, int& value) {
    enter_whole_with_buttons(ui,
                             {.id = id,
                              .label = label,
                              .format = "%.0f",
                              .rules = {most},
                              .width_px = 110.0F * ui.theme.scale},
                             value);
}

void draw_people(Ui& ui, PlanChoice& choice) {
    const Range people{1.0, static_cast<double>(kMostPlannedPeople)};
    draw_label(ui, "People");
    enter_count(ui, "plan first", "People from", people, choice.first);
    ImGui::SameLine();
    dim_text(ui, "to");
    ImGui::SameLine();
    enter_count(ui, "plan last", "People to", people, choice.last);
    choice.last = std::max(choice.first, choice.last);
}

void draw_rival(Ui& ui, Metric& rival) {
    draw_label(ui, "Told from");
    const Item shown{
        .id = "plan:rival",
        .label = traits(rival).name,
        .tip = "The metric that PM is to be told from: does it agree with people less?",
        .value = traits(rival).key};
    drop_down(ui, shown, 240.0F * ui.theme.scale, [&] {
        for (const Metric metric : kMetrics) {
            if (metric == Metric::pm) continue;
            const Item item{.id = std::string("plan rival:") + traits(metric).key,
                            .label = traits(metric).name};
            if (option(ui, item, metric == rival)) rival = metric;
        }
    });
}

// All, or a number that stands beside it.
void draw_all_or(Ui& ui, const char* label, const char* id, bool& all, Range most, int& value,
                 const char* words) {
    draw_label(ui, label);
    ImGui::PushID(id);
    if (segment(ui, {.id = std::string(id) + ":all", .label = "All"}, all)) all = true;
    ImGui::SameLine(0.0F, 0.0F);
    if (segment(ui, {.id = std::string(id) + ":some", .label = "Some"}, !all)) all = false;
    ImGui::PopID();
    if (all) return;
    ImGui::SameLine();
    enter_count(ui, id, label, most, value);
    ImGui::SameLine();
    dim_text(ui, words);
}

void draw_assumed(Ui& ui, const PatternSet& set, PlanChoice& choice) {
    constexpr std::array kSources{
        Choice{false, "Stated", "Nobody was asked yet: what is assumed stands below."},
        Choice{true, "As the ratings of this set",
               "How alike people rate, and how far PM agrees with them, as the ratings have it "
               "that the set keeps: a pilot."}};
    const bool has_ratings = !set.ratings.empty();
    if (!has_ratings) choice.by_ratings = false;
    draw_label(ui, "Assumed");
    ImGui::BeginDisabled(!has_ratings);
    draw_segments(ui, kSources, choice.by_ratings, "plan assumed:");
    ImGui::EndDisabled();
    if (choice.by_ratings) return;
    const PlanAssumptions guess = guessed_assumptions();
    draw_field(ui,
               {.id = "plan_rho",
                .label = "rho of PM",
                .format = "%.2f",
                .slider = {0.05, 0.99},
                .typed = {0.0, 0.99},
                .step = 0.01,
                .help = "Spearman's, with what people feel on average. The default is the mean of "
                        "Table 2 of Lim & Park 2023.",
                .normal = guess.rho},
               choice.rho);
    draw_field(ui,
               {.id = "plan_reliability",
                .label = "Reliability",
                .format = "%.2f",
                .slider = {0.05, 0.99},
                .typed = {0.01, 0.99},
                .step = 0.01,
                .help = "The share of one person's ratings that is not their own noise. The "
                        "default is a guess: a pilot says more.",
                .normal = guess.reliability},
               choice.reliability);
}

std::string half_width_text(double half) {
    return std::isnan(half) ? with_decimals(half, 2) : "±" + with_decimals(half, 2);
}

// A row a number of people; one of them is chosen for the preregistration.
void draw_studies(Ui& ui, const SetPlan& plan, std::optional<std::size_t>& chosen) {
    constexpr int kColumns = 7;
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchSame |
                                       ImGuiTableFlags_NoSavedSettings |
                                       ImGuiTableFlags_BordersInnerH;
    if (!ImGui::BeginTable("plans", kColumns, kFlags)) return;
    for (const char* head : {"People", "rho, over patterns", "over people", "over both",
                             "Told, over patterns", "over people", "over both"}) {
        ImGui::TableNextColumn();
        dim_text(ui, head);
    }
    for (std::size_t k = 0; k < plan.studies.size(); ++k) {
        const PlannedStudy& one = plan.studies[k];
        ImGui::TableNextColumn();
        const std::string people = std::to_string(one.people);
        const double power_over_both = one.power[static_cast<std::size_t>(Resampled::both)];
        if (radio(ui,
                  {.id = "plan row:" + people, .label = people, .value = percent(power_over_both)},
                  chosen == k)) {
            chosen = k;
        }
        for (const double half : one.half_width) {
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted(half_width_text(half).c_str());
        }
        for (const double power : one.power) {
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            const bool is_enough = power >= kEnoughPower;
            coloured_text(is_enough ? ui.theme.text : ui.theme.dim_text, percent(power));
        }
    }
    ImGui::EndTable();
}

// What the table comes to.
std::string verdict(const SetPlan& plan) {
    const auto enough = enough_people(plan.studies, Resampled::both, kEnoughPower);
    if (enough) {
        return std::to_string(*enough) + " people of those tried tell PM from " +
               traits(plan.rival).name + " in 80 % of the studies, over patterns and people.";
    }
    return std::string("No number of people that was tried tells PM from ") +
           traits(plan.rival).name +
           " in 80 % of the studies, over patterns and people: more patterns, or patterns on which "
           "the two disagree, do more than more people.";
}

void draw_plan(Ui& ui, Workspace& work, PlanState& planning, const SetPlan& plan) {
    const PlanAssumptions& people = plan.plan.assumed;
    coloured_text(ui.theme.warning, "Simulated: nobody was asked.");
    const std::size_t patterns = plan.set.vibrations.size();
    const std::size_t pairs = plan.plan.pairs == 0 ? pair_count(patterns) : plan.plan.pairs;
    dim_text(ui, "Assumed: rho " + stepped(people.rho, 0.01) + ", reliability " +
                     stepped(people.reliability, 0.01) + " (" + people.source + "). " +
                     counted(patterns, "pattern", "patterns") + ", " +
                     counted(pairs, "pair", "pairs") + " a person, about " +
                     std::to_string(std::lround(minutes_of(plan))) + " min.");
    if (plan.decided) {
        std::string names;
        for (const std::string& name : names_of(plan.set)) {
            names += (names.empty() ? "" : ", ") + name;
        }
        wrapped_text("PM and " + std::string(traits(plan.rival).name) + " disagree most on: " +
                     names + ". rho between the two " + stepped(plan.decided->rho, 0.01) +
                     ", of all patterns " + stepped(plan.decided->rho_all, 0.01) + ".");
        if (link(ui,
                 {.id = "link:use planned patterns", .label = "Ask about these in the study"})) {
            use_planned_patterns(ui, work, plan);
        }
    }
    ImGui::Spacing();
    draw_studies(ui, plan, planning.chosen);
    ImGui::Spacing();
    wrapped_text(ui, {.id = "plan:verdict", .text = verdict(plan)});
    dim_text(ui,
             "rho: half of its 95 % interval. Told: the share of studies that find PM's rho above "
             "the other's, p < .05.");
}

void draw_answer(Ui& ui, Workspace& work, PlanState& planning) {
    const auto live = planning.job.latest();
    if (is_planning(planning)) {
        if (draw_progress(ui, {"Planning", planning.job.progress(), "planning"})) {
            planning.job.cancel();
        }
    }
    if (draw_failure(ui, "plan", planning.job.failure())) return;
    if (!live || live->request.document != work.document_number) return;
    if (!live->plan) {
        return coloured_text(ui, ui.theme.warning,
                             {.id = "plan:fault", .text = live->plan.error().message + "."});
    }
    const bool stale = !is_plan_current(work, planning);
    if (stale) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5F);
    if (stale) dim_text(ui, "For an earlier choice:");
    draw_plan(ui, work, planning, *live->plan);
    if (stale) ImGui::PopStyleVar();
}

}  // namespace

void draw_plan_dialog(Ui& ui, Workspace& work, PlanState& planning) {
    if (!begin_dialog(ui, kPlanDialog, kPlanDialogPx)) return;
    wrapped_text(
        "How sure would a study of these patterns be? Studies are simulated from PM of this set, "
        "and each is analysed as a real one is.");
    draw_divider(ui.theme);
    PlanChoice& choice = planning.choice;
    const std::size_t patterns = study_patterns(work.document.set).size();
    const std::string obstacle = plan_obstacle(work);
    draw_people(ui, choice);
    draw_rival(ui, choice.rival);
    draw_all_or(ui, "Patterns", "plan patterns", choice.all_patterns,
                {static_cast<double>(kLeastRated),
                 std::max(static_cast<double>(patterns), static_cast<double>(kLeastRated))},
                choice.decide, "on which the two disagree most");
    draw_all_or(ui, "Pairs", "plan pairs", choice.all_pairs,
                {1.0, static_cast<double>(std::max<std::size_t>(pair_count(patterns), 1))},
                choice.pairs, "a person, dealt so that all are rated as often");
    draw_assumed(ui, work.document.set, choice);
    draw_divider(ui.theme);
    if (!obstacle.empty()) coloured_text(ui.theme.warning, obstacle);
    const bool current = is_plan_current(work, planning);
    if (primary_button(ui, {.id = "button:simulate plan",
                            .label = "Simulate",
                            .enabled = obstacle.empty() && !is_planning(planning) && !current})) {
        simulate_plan(ui, work, planning);
    }
    ImGui::SameLine();
    if (button(ui, {.id = "button:preregister",
                    .label = "Preregister...",
                    .tip = "Choose a number of people in the table; the plan is then frozen in a "
                           "folder.",
                    .enabled = current && planning.chosen})) {
        give_way(ui);
        return choose_preregistration_folder(ui, work, planning);
    }
    draw_answer(ui, work, planning);
    end_dialog(ui);
}

}  // namespace tact
