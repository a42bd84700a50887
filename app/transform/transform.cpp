#include "app/transform/transform.h"

#include <utility>

#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/set/pattern_set.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

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
    ui.dialog = kTransformDialog;
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
    const auto wanted = ui.dialog == kTransformDialog ? transform_request(work, state)
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

namespace {

constexpr float kTransformPx = 560.0F;
constexpr float kTransformChoicePx = 260.0F;

void draw_kind(Ui& ui, TransformState& state) {
    draw_label(ui, "Transform");
    drop_down(
        ui, {.id = "transform:kind", .label = traits(state.kind).label},
        kTransformChoicePx * ui.theme.scale,
        [&] {
            for (std::size_t k = 0; k < kEditKindCount; ++k) {
                const auto kind = static_cast<EditKind>(k);
                const Item item{.id = std::string("transform:kind:") + traits(kind).key,
                                .label = traits(kind).label};
                if (option(ui, item, kind == state.kind)) state.kind = kind;
            }
        },
        ImGuiComboFlags_HeightLarge);
}

void draw_number(Ui& ui, const EditTraits& about, std::optional<double>& number) {
    const bool whole = about.needs == EditNeeds::whole_number;
    draw_label(ui, "By");
    const std::string format = std::string(whole ? "%.0f" : "%.4g") +
                               (*about.unit == '%' ? " %%" : std::string(" ") + about.unit);
    double value = number.value_or(about.start);
    const NumberEntry entry{.id = "transform number",
                            .label = about.label,
                            .format = format.c_str(),
                            .rules = {about.range},
                            .width_px = 140.0F * ui.theme.scale,
                            .live = true};
    if (whole) {
        int count = static_cast<int>(value);
        if (enter_whole(ui, entry, count)) number = count;
    } else if (enter_number(ui, entry, value)) {
        number = value;
    }
    note_item(ui.rects, "transform:number", shortest_digits(number.value_or(about.start)));
}

void draw_other(Ui& ui, const PatternSet& set, std::string& name) {
    draw_label(ui, "With");
    const float width = kTransformChoicePx * ui.theme.scale;
    const float room = width - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const Item shown{.id = "transform:other",
                     .label = shortened(ui.theme.fonts.regular, name, room),
                     .value = name};
    drop_down(
        ui, shown, width,
        [&] {
            for (const Vibration& vibration : set.vibrations) {
                const Item item{.id = "transform:other:" + vibration.name, .label = vibration.name};
                if (option(ui, item, vibration.name == name)) name = vibration.name;
            }
        },
        ImGuiComboFlags_HeightRegular);
}

std::string sentence_of(const char* help) {
    std::string words = std::string(help) + ".";
    if (words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
}

// "; the notes become a curve; 8 points, 2 ticks"
std::string change_words(const VibrationSource& from, const VibrationSource& to) {
    if (const auto* layered = std::get_if<LayeredPattern>(&to)) {
        return "; " + counted(layered->layers.size(), "layer", "layers");
    }
    const auto* after = std::get_if<Pattern>(&to);
    if (after == nullptr) {
        return std::holds_alternative<Measurement>(from) ? "" : "; it becomes samples";
    }
    const auto* before = std::get_if<Pattern>(&from);
    const bool had_notes = before != nullptr && !before->rhythm.text.empty();
    std::string words;
    if (had_notes && after->rhythm.text.empty()) words += "; the notes become a curve";
    const std::size_t points = after->amplitude_curve.size() + after->frequency_curve.size();
    if (points > 0) words += "; " + counted(points, "point", "points");
    const std::size_t ticks = after->transients.size();
    if (ticks > 0) words += ", " + counted(ticks, "tick", "ticks");
    return words;
}

// "1 s becomes 2 s; 8 points, 2 ticks."
std::string outcome(const Transformed& made) {
    if (!can_be_applied(made)) return made.fault;
    if (made.after.size() > 1) {
        const std::size_t ready = made.after.size() - made.left;
        std::string words =
            counted(ready, "pattern", "patterns") + (ready == 1 ? " is ready" : " are ready");
        if (made.left > 0)
            words += ", " + std::to_string(made.left) + " cannot change: " + made.fault;
        return words + ".";
    }
    const Vibration& before = made.before.front();
    Vibration after = before;
    after.source = made.after.front();
    if (before.source == after.source) return "Nothing changes.";
    const double before_s = own_duration_s(before);
    const double after_s = own_duration_s(after);
    const std::string words = before_s == after_s
                                  ? significant_digits(after_s, 6) + " s as before"
                                  : significant_digits(before_s, 6) + " s becomes " +
                                        significant_digits(after_s, 6) + " s";
    return words + change_words(before.source, after.source) + ".";
}

void draw_outcome(Ui& ui, const TransformState& state, const Transformed* made) {
    if (made == nullptr && draw_failure(ui, "transform", state.job.failure())) return;
    const std::string words = made == nullptr ? "..." : outcome(*made);
    const bool failed = made != nullptr && made->left > 0;
    coloured_text(ui, failed ? ui.theme.warning : ui.theme.text,
                  {.id = "transform:outcome", .text = words});
}

}  // namespace

void draw_transform_dialog(Ui& ui, Workspace& work, TransformState& state) {
    if (!begin_dialog(ui, kTransformDialog, kTransformPx)) return;
    draw_kind(ui, state);
    const EditTraits& about = traits(state.kind);
    if (about.needs == EditNeeds::pattern) {
        draw_other(ui, work.document.set, state.other);
    } else if (about.needs != EditNeeds::nothing) {
        draw_number(ui, about, state.numbers[static_cast<std::size_t>(state.kind)]);
    }
    coloured_text(ui.theme.dim_text, sentence_of(about.help));
    ImGui::Spacing();
    draw_label(ui, "Changes");
    wrapped_text(ui, {.id = "transform:changes", .text = transformed_words(work)});
    const std::string obstacle = transform_obstacle(work, state);
    const auto made = current_transform(work, state);
    if (!obstacle.empty()) {
        coloured_text(ui, ui.theme.dim_text, {.id = "transform:obstacle", .text = obstacle});
    } else {
        draw_outcome(ui, state, made.get());
    }
    const bool ready = made != nullptr && can_be_applied(*made);
    if (draw_ends(ui, "Apply", ready)) apply_transform(ui, work, state, *made);
}

}  // namespace tact
