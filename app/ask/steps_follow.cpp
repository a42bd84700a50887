#include "app/ask/steps_follow.h"

#include "app/document/editing.h"
#include "model/ask/steps_set.h"
#include "model/set/named_place.h"

namespace tact {

namespace {

std::optional<FoundSteps> found_steps(const StepsRequest& request, std::stop_token stop,
                                      std::atomic<float>& progress) {
    StepsOptions options;
    options.stop = std::move(stop);
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    auto steps = even_steps(request.question, options);
    if (!steps) return std::nullopt;
    return FoundSteps{request, *std::move(steps)};
}

// The partner of the pattern in the editor, or another parametric pattern.
std::string other_than(const Workspace& work, const std::string& name) {
    const PatternSet& set = work.document.set;
    const std::string& partner = work.selection.partner;
    if (partner != name && pattern_named(set, partner) != nullptr) return partner;
    for (const std::size_t k : work.selection.others) {
        const Vibration& other = set.vibrations[k];
        if (other.name != name && std::holds_alternative<Pattern>(other.source)) return other.name;
    }
    std::string first;
    bool is_behind = false;
    for (const Vibration& vibration : set.vibrations) {
        if (vibration.name == name) {
            is_behind = true;
        } else if (std::holds_alternative<Pattern>(vibration.source)) {
            if (is_behind) return vibration.name;
            if (first.empty()) first = vibration.name;
        }
    }
    return first;
}

}  // namespace

void open_steps(Ui& ui, const Workspace& work, StepsState& state, const std::string& from,
                const std::string& to) {
    const Vibration* current = current_vibration(work);
    state.from = !from.empty() || current == nullptr ? from : current->name;
    state.to = to.empty() ? other_than(work, state.from) : to;
    state.along.reset();
    state.cancelled = false;
    ui.dialog = Dialog::steps;
}

std::string steps_obstacle(const Workspace& work, const StepsState& state) {
    const PatternSet& set = work.document.set;
    if (pattern_named(set, state.from) == nullptr || pattern_named(set, state.to) == nullptr) {
        return "Choose two patterns without layers that are no recordings: others have no numbers "
               "to go along.";
    }
    if (state.from == state.to) return "Choose another pattern for the end.";
    if (!steps_request(work, state)) {
        return std::string("One of the two has no ") + traits(*state.along).name + ".";
    }
    return {};
}

std::optional<StepsRequest> steps_request(const Workspace& work, const StepsState& state) {
    const PatternSet& set = work.document.set;
    const Pattern* from = pattern_named(set, state.from);
    const Pattern* to = pattern_named(set, state.to);
    if (from == nullptr || to == nullptr || state.from == state.to) return std::nullopt;
    const auto end = state.along ? end_along(*from, *to, *state.along) : std::optional(*to);
    if (!end) return std::nullopt;
    return StepsRequest{
        {*from, *end, static_cast<std::size_t>(state.count), state.measure, set.model}};
}

void follow_steps(const Ui& ui, const Workspace& work, StepsState& state) {
    const auto wanted =
        ui.dialog == Dialog::steps ? steps_request(work, state) : std::optional<StepsRequest>();
    if (wanted != state.job.asked()) state.cancelled = false;
    state.job.want(wanted, found_steps, ui.wake);
}

bool is_placing(const StepsState& state) { return state.job.busy(); }

std::shared_ptr<const FoundSteps> current_steps(const Workspace& work, const StepsState& state) {
    auto found = state.job.latest();
    if (!found || steps_request(work, state) != found->request) return nullptr;
    return found;
}

void add_steps(Ui& ui, Workspace& work, const StepsState& state, const FoundSteps& found) {
    const auto from = place_named(work.document.set, state.from);
    const auto to = place_named(work.document.set, state.to);
    if (!from || !to) return;
    std::vector<Vibration> fresh = vibrations_between(work.document.set, *from, *to, found.steps);
    if (fresh.empty()) return;
    const std::string what = std::to_string(fresh.size()) +
                             (fresh.size() == 1 ? " step" : " steps") + " from " + state.from +
                             " to " + state.to;
    select_only(work, *from);
    add_vibrations(ui, work, std::move(fresh), "Add " + what);
    say(ui, "Added " + what + ". Ctrl+Z takes them back.");
}

}  // namespace tact
