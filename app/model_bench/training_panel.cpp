// Fitting the model to what people said: on which sets, how, and what came of it.

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/model_bench/model_bench.h"
#include "app/model_bench/parts.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/common/parallel.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

std::string size_text(const SetToFit& set) {
    const std::size_t patterns = set.set->vibrations.size();
    const std::size_t gone = set.study->gone.size();
    return std::to_string(patterns) + " patterns, " + std::to_string(set.people) +
           (set.people == 1 ? " person" : " people") +
           (gone == 0   ? ""
            : gone == 1 ? ", 1 rated one is gone"
                        : ", " + std::to_string(gone) + " rated ones are gone");
}

void draw_set(Ui& ui, const SetToFit& set, bool& takes_part, bool* removed) {
    ImGui::PushID(set.file.empty() ? "the document" : set.file.c_str());
    check(ui, {.id = "train on:" + set.shown_name, .label = set.shown_name}, takes_part);
    const std::string size = size_text(set);
    flow_on(ImGui::CalcTextSize(size.c_str()).x, ui.theme.gap_px);
    dim_text(ui, {.id = "train:size", .text = size});
    if (removed != nullptr) {
        flow_on(ImGui::CalcTextSize("Remove").x, ui.theme.gap_px);
        *removed = link(ui, {.id = "link:remove " + set.shown_name, .label = "Remove"});
    }
    ImGui::PopID();
}

// Where the document's ratings stand for nothing to train on, why.
void draw_no_ratings(Ui& ui, const Workspace& work, TableState& table, const OwnRatings& own) {
    if (!own.fault.empty()) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "train:fault",
                       .text = "The ratings do not fit the set: " + own.fault,
                       .value = own.fault});
        return;
    }
    ImGui::TextWrapped(
        "The open set has no ratings. Load what people said, or ask some in the view of studies.");
    if (button(ui, {.id = "button:load ratings", .label = "Load ratings..."}))
        load_ratings_dialog(ui, work, table);
}

void draw_sets(Ui& ui, const Workspace& work, TableState& table, ModelBench& model_bench) {
    TrainingState& state = model_bench.training;
    const OwnRatings& own = own_ratings(work, model_bench);
    if (own.set) {
        draw_set(ui, *own.set, state.own_takes_part, nullptr);
    } else {
        draw_no_ratings(ui, work, table, own);
    }
    std::optional<std::size_t> gone;
    for (std::size_t k = 0; k < state.others.size(); ++k) {
        bool removed = false;
        draw_set(ui, state.others[k], state.others[k].takes_part, &removed);
        if (removed) gone = k;
    }
    if (gone) state.others.erase(state.others.begin() + static_cast<std::ptrdiff_t>(*gone));
    if (link(ui, {.id = "link:add a set",
                  .label = "Add a set with ratings...",
                  .tip = "Fits one model to several sets, each with what people said of it."})) {
        add_training_set_dialog(ui, work, model_bench);
    }
}

void draw_settings(Ui& ui, ModelBench& model_bench) {
    TrainingState& state = model_bench.training;
    constexpr std::array kObjectives{
        Choice{TrainingObjective::mean_rho, "mean rho",
               "Mean over the sets of Spearman's rho between PM and the ratings: the paper's."},
        Choice{TrainingObjective::mean_absolute_rho, "mean |rho|",
               "The paper's averages drop the sign: it also counts orders that are wrong way "
               "round."}};
    draw_label(ui, "Objective", segments_width(ui, kObjectives));
    draw_segments(ui, kObjectives, state.objective, "train:");
    constexpr std::array kSteps{Choice{10, "0.1", "The paper's grid of 44 million combinations."},
                                Choice{20, "0.05", "26 times as many combinations."},
                                Choice{40, "0.025", "Above 700 times as many: takes long."}};
    draw_label(ui, "Weights by", segments_width(ui, kSteps));
    draw_segments(ui, kSteps, state.units, "train:");
    constexpr const char* kLeaveOut = "leave each person out";
    draw_label(ui, "Also", check_width(ui.theme, kLeaveOut));
    check(ui,
          {.id = "train:leave out",
           .label = kLeaveOut,
           .tip = "Fits without each person in turn, and tries the fit on just that person: what "
                  "to expect of people nobody has asked."},
          state.leave_out_participants);
}

// What the search costs, kept while the question stays.
const TrainingEstimate& estimate(ModelBench& model_bench, const TrainingRequest& request) {
    TrainingEstimate& known = model_bench.training.estimate;
    std::vector<std::size_t> patterns;
    for (const SetToFit& set : request.sets) patterns.push_back(set.set->vibrations.size());
    if (known.units == request.units && known.patterns == patterns) return known;
    const TrainingCost cost = training_cost(patterns, request.units);
    known = {patterns, request.units, cost};
    return known;
}

void draw_search(Ui& ui, ModelBench& model_bench) {
    const float share = model_bench.training.job.progress();
    const Rect bar = rect_at(ImGui::GetCursorScreenPos(),
                             {ImGui::GetContentRegionAvail().x, 3.0F * ui.theme.scale});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(bar.min, bar.max, ui.theme.field);
    list.AddRectFilled(bar.min, {bar.min.x + bar.width() * share, bar.max.y}, ui.theme.accent);
    ImGui::Dummy({bar.width(), bar.height()});
    if (draw_progress(ui, {"Searching", share, "training"})) cancel_training(model_bench);
}

void draw_begin(Ui& ui, const Workspace& work, ModelBench& model_bench) {
    const TrainingRequest request = training_request(work, model_bench);
    const bool has_sets = !request.sets.empty();
    if (primary_button(ui, {.id = "button:train",
                            .label = "Train",
                            .enabled = has_sets,
                            .value = has_sets ? "enabled" : "disabled"})) {
        begin_training(ui, work, model_bench);
    }
    std::string text = "No ratings to train on.";
    if (has_sets) {
        const TrainingCost& cost = estimate(model_bench, request).cost;
        const double cores = thread_count(0);
        text = grouped_digits(cost.combinations) + " combinations, ";
        std::size_t fits = 1;
        for (const SetToFit& set : request.sets) fits += set.people;
        if (request.leave_out_participants) text += "each of " + std::to_string(fits) + " fits ";
        text += estimate_text(cost.one_core_s / cores);
    }
    flow_on(ImGui::CalcTextSize(text.c_str()).x, ui.theme.gap_px);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, {.id = "train:cost", .text = text});
}

}  // namespace

void draw_training(Ui& ui, Workspace& work, TableState& table, ModelBench& model_bench) {
    ImGui::BeginChild("training", ImGui::GetContentRegionAvail());
    const std::string hint = "Tries every combination of the model's " +
                             std::to_string(kTrainedParameters) +
                             " trained numbers, and finds those whose prediction orders the pairs "
                             "most as people did.";
    draw_hint(ui, "training", hint.c_str());
    draw_sets(ui, work, table, model_bench);
    draw_settings(ui, model_bench);
    if (is_training(model_bench)) {
        draw_search(ui, model_bench);
    } else if (has_jobs(ui)) {
        draw_begin(ui, work, model_bench);
        (void)draw_failure(ui, "training", model_bench.training.job.failure());
    }
    const auto found = model_bench.training.found;  // kept while it is drawn
    if (found && found->fault.empty()) draw_training_result(ui, work, model_bench, *found);
    ImGui::EndChild();
}

}  // namespace tact
