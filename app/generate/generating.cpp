#include "app/generate/generate.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// A start that shows what a design is: six vibrations around the current pattern.
DesignSpace first_draft(const Workspace& work) {
    Pattern around;
    around.duration_s = work.document.set.duration_s;
    if (const Vibration* current = current_vibration(work)) {
        if (const auto* pattern = std::get_if<Pattern>(&current->source)) around = *pattern;
    }
    DesignSpace space = space_around(around);
    space.carriers[0].frequency_hz = Span{60.0, 240.0, 3, true, 1.0};
    space.modulation_hz = std::vector<double>{0.0, 8.0};
    return space;
}

GenerateOutcome outcome_of(const GenerateRequest& request, const Candidates& found, Before before) {
    GenerateOutcome outcome;
    outcome.fresh = new_to(*request.set, found.kept, before);
    std::vector<double> durations_s;
    for (const Vibration& vibration : request.set->vibrations) {
        if (!is_replaced(vibration, before)) durations_s.push_back(own_duration_s(vibration));
    }
    for (const Candidate& candidate : outcome.fresh) {
        durations_s.push_back(candidate.pattern.duration_s);
    }
    outcome.patterns_after = durations_s.size();
    outcome.map_s = expected_map_s(std::move(durations_s));
    return outcome;
}

}  // namespace

DesignSpace space_around(const Pattern& pattern) {
    DesignSpace space;
    space.amplitude_g = fixed(pattern.amplitude_g);
    space.carriers.clear();
    for (const Carrier& carrier : pattern.carriers) {
        space.carriers.push_back({fixed(carrier.frequency_hz), fixed(carrier.weight)});
    }
    // Weights that are shares are one number; others stay what they are.
    if (pattern.carriers.size() == 2) {
        const double first = pattern.carriers[0].weight;
        const double second = pattern.carriers[1].weight;
        constexpr double kRounding = 1e-9;
        const bool are_shares = std::abs(first + second - 1.0) <= kRounding;
        if (are_shares && limits::kMix.contains(second)) space.mix = fixed(second);
    }
    space.kinds = {pattern.modulation.kind};
    space.modulation_hz = fixed(pattern.modulation.frequency_hz);
    space.depth = fixed(pattern.modulation.depth);
    space.rhythms = {pattern.rhythm.text};
    space.unit_s = fixed(pattern.rhythm.unit_s);
    space.attack_s = fixed(pattern.attack_s);
    space.release_s = fixed(pattern.release_s);
    space.duration_s = fixed(pattern.duration_s);
    return space;
}

void open_generate(Ui& ui, const Workspace& work, GenerateState& generating) {
    const auto& own = work.document.set.generator;
    // What was tried out without adding anything is not lost.
    if (!generating.begun || generating.draft_of != own) {
        generating.draft = own ? *own : first_draft(work);
        generating.draft_of = own;
        generating.begun = true;
    }
    generating.asking.reset();
    generating.typing.clear();
    ui.dialog = kGenerateDialog;
}

std::optional<GeneratePlan> plan_of(const GenerateRequest& request, std::stop_token stop) {
    GeneratePlan plan;
    plan.request = request;
    const PatternSet& set = *request.set;
    auto found = candidates(request.space, set.model.coding.tables, stop);
    if (stop.stop_requested()) return std::nullopt;
    if (!found) {
        plan.fault = found.error().message;
        return plan;
    }
    plan.found = *std::move(found);
    plan.generated_before = static_cast<std::size_t>(std::ranges::count_if(
        set.vibrations, [](const Vibration& v) { return is_replaced(v, Before::replaced); }));
    plan.add = outcome_of(request, plan.found, Before::kept);
    plan.replace = outcome_of(request, plan.found, Before::replaced);
    return plan;
}

void follow_generate(const Ui& ui, const Workspace& work, GenerateState& generating) {
    if (ui.dialog != kGenerateDialog) return;
    generating.job.want(
        GenerateRequest{generating.draft, work.document.committed},
        [](const GenerateRequest& request, std::stop_token stop, std::atomic<float>&) {
            return plan_of(request, std::move(stop));
        },
        ui.wake);
}

std::shared_ptr<const GeneratePlan> current_plan(const Workspace& work,
                                                 const GenerateState& generating) {
    auto plan = generating.job.latest();
    const bool current = plan && plan->request.space == generating.draft &&
                         plan->request.set == work.document.committed;
    return current ? plan : nullptr;
}

void add_candidates(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan& plan,
                    Before before) {
    const GenerateOutcome& outcome = before == Before::kept ? plan.add : plan.replace;
    auto set = with_candidates(work.document.set, plan.request.space, outcome.fresh, before);
    if (!set) return complain(ui, "Nothing was generated: " + set.error().message);
    const std::size_t count = outcome.fresh.size();
    work.document.edit() = *std::move(set);
    const std::size_t size = work.document.set.vibrations.size();
    generating.draft_of = work.document.set.generator;
    select_only(work, size == 0 ? 0 : std::min(size - count, size - 1));
    work.selection.scroll_to_current = true;
    document_changed(work);
    const std::string what = grouped_digits(count) + (count == 1 ? " candidate" : " candidates");
    commit_step(ui, work, (before == Before::kept ? "Generate " : "Replace generated by ") + what);
    say(ui, "Generated " + what + ". Ctrl+Z takes them back.");
}

}  // namespace tact
