#include "app/planning/plan_follow.h"

#include <utility>

#include "app/document/editing.h"
#include "app/report/preregistration_files.h"
#include "app/session/program_version.h"
#include "app/ui/file_question.h"
#include "model/set/named_place.h"
#include "model/set/set_ratings.h"
#include "model/set/set_study.h"
#include "model/subset/set_subset.h"
#include "model/text/utc_time.h"

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

void choose_preregistration_folder(Ui& ui, const Workspace& work) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::preregister,
                  .use = ChooserUse::save_folder,
                  .title = "Freeze the plan in a folder",
                  .extensions = {".json", ".html"},
                  .folders_too = true,
                  .file_names = {"preregistration.json", "preregistration.html"}},
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

}  // namespace tact
