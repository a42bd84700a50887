#include "app/transform/transform_follow.h"

#include <utility>

#include "app/document/editing.h"
#include "model/set/named_place.h"

namespace tact {

namespace {

bool is_same(const TransformRequest& a, const TransformRequest& b) {
    return a.document == b.document && a.revision == b.revision && a.places == b.places &&
           a.edit == b.edit;
}

std::vector<std::size_t> editable_places(const Workspace& work) {
    std::vector<std::size_t> places;
    for (const std::size_t index : selected_indices(work)) {
        if (!work.document.set.vibrations[index].locked) places.push_back(index);
    }
    return places;
}

std::optional<Transformed> transformed(const TransformTask& task, const std::stop_token& stop,
                                       std::atomic<float>& progress) {
    Transformed made{task.request, task.patterns, {}, 0, {}};
    for (std::size_t k = 0; k < task.patterns.size(); ++k) {
        if (stop.stop_requested()) return std::nullopt;
        const Vibration& one = task.patterns[k];
        auto after = edited_source(one, std::span(&task.request.edit, 1), task.tables);
        if (!after && made.left++ == 0) {
            made.fault = "\"" + one.name + "\", " + after.error().message;
        }
        made.after.push_back(after ? *std::move(after) : one.source);
        progress = static_cast<float>(k + 1) / static_cast<float>(task.patterns.size());
    }
    return made;
}

Edit edit_of(const Workspace& work, const TransformState& state) {
    const EditTraits& about = traits(state.kind);
    Edit edit{state.kind,
              state.numbers[static_cast<std::size_t>(state.kind)].value_or(about.start)};
    if (about.needs == EditNeeds::pattern) {
        if (const auto other = place_named(work.document.set, state.other)) {
            edit.other = work.document.set.vibrations[*other].source;
            edit.other_name = state.other;
        }
    }
    return edit;
}

std::optional<TransformRequest> transform_request(const Workspace& work,
                                                  const TransformState& state) {
    if (!transform_obstacle(work, state).empty()) return std::nullopt;
    return TransformRequest{work.document_number, work.revision, editable_places(work),
                            edit_of(work, state)};
}

TransformTask task_of(const Workspace& work, const TransformRequest& request) {
    const PatternSet& set = work.document.set;
    TransformTask task{request, {}, set.model.coding.tables};
    for (const std::size_t place : request.places) task.patterns.push_back(set.vibrations[place]);
    return task;
}

}  // namespace

void open_transform(Ui& ui, const Workspace& work, TransformState& state) {
    const PatternSet& set = work.document.set;
    const Vibration* current = current_vibration(work);
    const auto is_other = [&](const std::string& name) {
        return place_named(set, name) && (current == nullptr || name != current->name);
    };
    if (is_other(work.selection.partner)) state.other = work.selection.partner;
    for (const Vibration& vibration : set.vibrations) {
        if (is_other(state.other)) break;
        state.other = vibration.name;
    }
    ui.dialog = Dialog::transform;
}

std::string transform_obstacle(const Workspace& work, const TransformState& state) {
    if (editable_places(work).empty()) {
        return "Select a pattern that is not locked.";
    }
    const bool needs_other = traits(state.kind).needs == EditNeeds::pattern;
    if (needs_other && !place_named(work.document.set, state.other)) {
        return "Choose another pattern.";
    }
    return {};
}

std::string transformed_words(const Workspace& work) {
    const std::size_t all = selected_indices(work).size();
    const std::vector<std::size_t> places = editable_places(work);
    if (places.empty()) return "nothing";
    const std::size_t left = all - places.size();
    std::string words = places.size() == 1 ? work.document.set.vibrations[places.front()].name
                                           : std::to_string(places.size()) + " patterns";
    if (left > 0) {
        words += "; " + std::to_string(left) + (left == 1 ? " is locked" : " are locked") +
                 " and stay" + (left == 1 ? "s" : "") + " as " + (left == 1 ? "it is" : "they are");
    }
    return words;
}

void follow_transform(const Ui& ui, const Workspace& work, TransformState& state) {
    const auto wanted = ui.dialog == Dialog::transform ? transform_request(work, state)
                                                       : std::optional<TransformRequest>();
    if (!wanted) return state.job.leave();
    const auto& asked = state.job.asked();
    if (!asked || !is_same(*wanted, asked->request)) {
        state.job.ask(task_of(work, *wanted), transformed, ui.wake);
    }
}

bool is_transforming(const TransformState& state) { return state.job.busy(); }

std::shared_ptr<const Transformed> current_transform(const Workspace& work,
                                                     const TransformState& state) {
    auto made = state.job.latest();
    if (!made) return nullptr;
    const auto wanted = transform_request(work, state);
    return wanted && is_same(*wanted, made->request) ? made : nullptr;
}

bool can_be_applied(const Transformed& made) { return made.left < made.after.size(); }

void apply_transform(Ui& ui, Workspace& work, const TransformState& state,
                     const Transformed& made) {
    if (!can_be_applied(made)) return;
    const std::string label = of_selection(work, traits(state.kind).label);
    put_sources(work, made.request.places, made.after);
    commit_step(ui, work, label);
    say(ui, label + ". Ctrl+Z takes it back.");
}

}  // namespace tact
