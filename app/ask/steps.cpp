#include "app/ask/ask.h"

#include <algorithm>
#include <array>

#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/ask/steps.h"
#include "model/set/pattern_set.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

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
    ui.dialog = kStepsDialog;
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
        ui.dialog == kStepsDialog ? steps_request(work, state) : std::optional<StepsRequest>();
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

namespace {

constexpr float kDialogPx = 640.0F;
constexpr float kChoicePx = 240.0F;

void draw_name_choice(Ui& ui, const PatternSet& set, const char* label, std::string& name) {
    draw_label(ui, label);
    const float width = kChoicePx * ui.theme.scale;
    const float room = width - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const std::string id = std::string("steps:") + label;
    const Item shown{
        .id = id, .label = shortened(ui.theme.fonts.regular, name, room), .value = name};
    drop_down(
        ui, shown, width,
        [&] {
            for (const Vibration& vibration : set.vibrations) {
                if (!std::holds_alternative<Pattern>(vibration.source)) continue;
                const Item item{.id = id + ":" + vibration.name, .label = vibration.name};
                if (option(ui, item, vibration.name == name)) name = vibration.name;
            }
        },
        ImGuiComboFlags_HeightRegular);
}

void draw_count(Ui& ui, StepsState& state) {
    draw_label(ui, "How many");
    enter_whole_with_buttons(ui,
                             {.id = "steps count",
                              .label = "How many",
                              .format = "%.0f",
                              .rules = {{3.0, static_cast<double>(kMostSteps)}},
                              .width_px = 120.0F * ui.theme.scale},
                             state.count);
    note_item(ui.rects, "steps:count", std::to_string(state.count));
    ImGui::SameLine();
    dim_text(ui, "including both ends");
}

void draw_along(Ui& ui, StepsState& state) {
    draw_label(ui, "Change");
    const Item shown{
        .id = "steps:along",
        .label = state.along ? traits(*state.along).name : "all that differs",
        .tip =
            "One number of the first pattern alone, up to what the other one has; or all in "
            "which they differ. Rhythms are morphed: notes move, stretch, split and fade."};
    drop_down(
        ui, shown, kChoicePx * ui.theme.scale,
        [&] {
            if (option(ui, {.id = "steps:along:all", .label = "all that differs"}, !state.along))
                state.along.reset();
            for (const PatternParameter parameter : kPatternParameters) {
                const Item item{.id = std::string("steps:along:") + traits(parameter).key,
                                .label = traits(parameter).name};
                if (option(ui, item, state.along == parameter)) state.along = parameter;
            }
        },
        ImGuiComboFlags_HeightRegular);
}

void draw_measure(Ui& ui, StepsState& state) {
    constexpr std::array kMeasures{
        Choice{StepMeasure::pm, "continuous PM",
               "Both parts of PM, each as a share of its largest on the way. PM itself counts "
               "ranks of pairs: neighbours are always the closest pairs, so they cannot be equal "
               "in it."},
        Choice{StepMeasure::nc, "NC", "Neural coding alone: strength, frequency, modulation."},
        Choice{StepMeasure::oc, "OC", "The rhythm's envelope alone."}};
    draw_label(ui, "Even in", segments_width(ui, kMeasures));
    draw_segments(ui, kMeasures, state.measure);
}

void draw_search_of_steps(Ui& ui, StepsState& state) {
    if (draw_progress(ui, {"Placing the steps", state.job.progress(), "steps", "Stop"})) {
        state.job.cancel();
        state.cancelled = true;
    }
}

// The position of each step along the path: dots on a line, with the distances of neighbours below.
void draw_way(const Ui& ui, const EvenSteps& steps) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - 16.0F * s;
    ImGui::Dummy({width, 24.0F * s});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = corner.y + 12.0F * s;
    const auto x = [&](double share) {
        return corner.x + 8.0F * s + static_cast<float>(share) * (width - 16.0F * s);
    };
    list.AddLine({x(0.0), y}, {x(1.0), y}, theme.dim_text, theme.hairline_px);
    for (const double share : steps.shares) {
        draw_disc(list, theme, {x(share), y}, 4.5F * s, theme.series);
    }
    if (!steps.jump) return;
    const float at = x(steps.jump->share);
    list.AddLine({at, y - 9.0F * s}, {at, y + 9.0F * s}, theme.warning, 2.0F * s);
}

void draw_step_rows(Ui& ui, Workspace& work, const StepsState& state, const EvenSteps& steps) {
    if (!ImGui::BeginTable("steps", 4, ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* head : {"Step", "Share of the way", "To the next", "PM to the next"}) {
        ImGui::TableNextColumn();
        dim_text(ui, head);
    }
    for (std::size_t k = 0; k < steps.patterns.size(); ++k) {
        ImGui::TableNextColumn();
        const std::string name = k == 0 ? state.from
                                 : k + 1 == steps.patterns.size() && !state.along
                                     ? state.to
                                     : std::to_string(k + 1);
        option(ui,
               {.id = "step:" + std::to_string(k + 1),
                .label = name,
                .tip = k == 0 ? kHoldHelp : "",
                .value = significant(steps.shares[k], 6)},
               false, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_DontClosePopups);
        if (ImGui::IsItemActive()) {
            Vibration felt;
            felt.name = name;
            felt.source = steps.patterns[k];
            note_pressed(work, felt);
        }
        ImGui::TableNextColumn();
        dim_text(ui, percent(steps.shares[k]));
        const bool last = k + 1 == steps.patterns.size();
        ImGui::TableNextColumn();
        if (!last) dim_text(ui, significant(steps.apart[k], 3));
        ImGui::TableNextColumn();
        if (!last) dim_text(ui, significant(steps.pm[k], 3));
    }
    ImGui::EndTable();
}

void draw_answer(Ui& ui, Workspace& work, StepsState& state, const FoundSteps* found) {
    if (found == nullptr) {
        if (state.job.busy()) return draw_search_of_steps(ui, state);
        if (draw_failure(ui, "steps", state.job.failure())) return;
        if (!state.cancelled) return;
        dim_text(ui, "Stopped.");
        ImGui::SameLine();
        if (link(ui, {.id = "link:place steps", .label = "Place them"})) state.job.leave();
        return;
    }
    const EvenSteps& steps = found->steps;
    draw_way(ui, steps);
    draw_step_rows(ui, work, state, steps);
    coloured_text(ui, is_even(steps) ? ui.theme.text : ui.theme.warning,
                  {.id = "steps:verdict", .text = sentence_on(found->request.question, steps)});
    coloured_text(ui.theme.dim_text, pm_sentence_on(steps));
}

std::string add_text(const Workspace& work, const StepsState& state, const FoundSteps* found) {
    if (found == nullptr) return "Add";
    const auto from = place_named(work.document.set, state.from);
    const auto to = place_named(work.document.set, state.to);
    const std::size_t count =
        vibrations_between(work.document.set, *from, *to, found->steps).size();
    return "Add " + std::to_string(count) + (count == 1 ? " pattern" : " patterns");
}

}  // namespace

void draw_steps_dialog(Ui& ui, Workspace& work, StepsState& state) {
    if (!begin_dialog(ui, kStepsDialog, kDialogPx)) return;
    draw_name_choice(ui, work.document.set, "From", state.from);
    draw_name_choice(ui, work.document.set, "To", state.to);
    draw_count(ui, state);
    draw_along(ui, state);
    draw_measure(ui, state);
    ImGui::Spacing();
    const std::string obstacle = steps_obstacle(work, state);
    const auto found = current_steps(work, state);
    if (!obstacle.empty()) {
        coloured_text(ui, ui.theme.dim_text, {.id = "steps:obstacle", .text = obstacle});
    } else {
        draw_answer(ui, work, state, found.get());
    }
    const std::string action = add_text(work, state, found.get());
    if (draw_ends(ui, action.c_str(), found != nullptr)) add_steps(ui, work, state, *found);
}

}  // namespace tact
