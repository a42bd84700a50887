#include "app/tour/tour.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"

namespace tact {

namespace {

// A pattern with two carriers and a slow modulation shows most; any other one serves.
constexpr const char* kShownPattern = "LH-4-full";

void show_most(Workspace& work, Layout& layout) {
    if (const auto place = place_named(work.document.set, kShownPattern)) select_only(work, *place);
    layout.left = 0.18F;
    layout.right = 0.26F;
    layout.maximised.reset();
}

// The pattern that PM puts farthest away, where that is known; else the next one.
std::string farthest(const Workspace& work, const ShownMap& shown_map) {
    const auto& all = work.document.set.vibrations;
    if (all.size() < 2) return {};
    const std::size_t current = work.selection.current;
    std::size_t best = (current + 1) % all.size();
    const bool known = map_state(work, shown_map) == MapState::exact ||
                       map_state(work, shown_map) == MapState::preview;
    if (!known || shown_map.transition.shown->prediction.pm.size != all.size())
        return all[best].name;
    const Dissimilarity& pm = shown_map.transition.shown->prediction.pm;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k != current && pm(current, k) > pm(current, best)) best = k;
    }
    return all[best].name;
}

constexpr std::array<TourStep, 11> kSteps{{
    {"A fingertip on a vibration",
     "In the middle is everything the model knows about one vibration, from the skin at the top to "
     "the cortex at the bottom. We will follow it down. Nothing here changes your set; leave "
     "whenever you like and come back through Help.",
     {.begins = true}},
    {"The vibration",
     "This is what the skin under a small probe does: acceleration in g. The line that travels is "
     "the playhead. It moves ten times slower than life; drag it, or press Space to halt it.",
     {.stage = Stage::vibration, .speed = 0.1}},
    {"What can be felt of it",
     "Its spectrum, as displacement. Each curve is the least that one receptor type notices. Where "
     "a bar rises above a curve, that type is driven; Pacinian corpuscles are the most sensitive "
     "near 250 Hz.",
     {.stage = Stage::spectrum}},
    {"Four filters",
     "The same vibration as each receptor type follows it. Meissner and Pacinian receptors answer "
     "to change, Merkel cells to what is slow, Ruffini endings to what stretches the skin.",
     {.stage = Stage::filtered, .speed = 0.1}},
    {"Receptors in the skin",
     "Four maps of the fingertip, to scale, in slow motion a hundredfold. Every mark is a receptor "
     "that fires; it flashes with each spike. The wave fades beyond the hot zone of 1.5 mm, so "
     "receptors farther out fire less. Point at one for its numbers.",
     {.stage = Stage::receptors, .speed = 0.01}},
    {"Spikes",
     "All receptors as rows, nearest to the probe on top; each tick is a spike. This is a tenth of "
     "the second: turn the wheel with Ctrl held to see more or less. Below, how many impulses each "
     "population sends.",
     {.stage = Stage::spikes, .speed = 0.01, .range = {0.0, 0.1}}},
    {"Relay networks",
     "On the way up, neurons add what their neighbours send, three times over, and then sharpen it "
     "by inhibition. Cells that reach 50 impulses in 5 ms can do no more and are marked.",
     {.stage = Stage::networks, .speed = 0.01}},
    {"Four voices",
     "Of each network only the centre is heard on. These are its spikes, one row for each type.",
     {.stage = Stage::central, .speed = 0.01, .range = {0.0, 0.1}}},
    {"The brain waveform",
     "The four voices, weighted and added: the model's prediction of what arrives in the cortex. "
     "Two vibrations are as different as these waveforms are. That number is called NC.",
     {.stage = Stage::brain, .speed = 0.1}},
    {"Rhythm",
     "Beside it runs the rhythm: how strong the vibration is from moment to moment. Two rhythms "
     "are compared with stretches of time forgiven. That number is called OC, and PM joins both.",
     {.stage = Stage::envelope, .speed = 0.1}},
    {"Two vibrations compared",
     "Now a second pattern runs below the first, with their difference between them. The orange "
     "bars under the stages say how much the two do not have in common there: see where they part. "
     "Try other pairs through \u201cCompare with\u2026\u201d.",
     {.speed = 0.1, .compares = true}},
}};

}  // namespace

std::span<const TourStep> tour_steps() { return kSteps; }

void go_to_step(Workspace& work, Layout& layout, Timeline& timeline, const ShownMap& shown_map,
                Physiology& physiology, TourState& tour, std::size_t step) {
    tour.step = std::min(step, kSteps.size() - 1);
    const TourScene& scene = kSteps[*tour.step].scene;
    if (scene.begins) show_most(work, layout);
    physiology.view.open = scene.stage;
    physiology.view.explained.reset();
    timeline.range = scene.range;
    const bool moves = scene.speed > 0.0;
    timeline.playhead = {
        .at_s = 0.0, .speed = moves ? scene.speed : 0.1, .playing = moves, .loop = true};
    work.selection.pinned = scene.compares ? farthest(work, shown_map) : std::string();
}

void start_tour(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                const ShownMap& shown_map, Physiology& physiology, TourState& tour) {
    if (current_vibration(work) == nullptr) {
        return complain(ui, "The tour needs a pattern: add one, or open the example set.");
    }
    if (!tour.step) {
        tour.before = {
            layout,         work.selection.current, work.selection.pinned, timeline.playhead,
            timeline.range, physiology.view.open};
    }
    const std::size_t from = tour.left_at;
    go_to_step(work, layout, timeline, shown_map, physiology, tour, 0);
    if (from > 0) go_to_step(work, layout, timeline, shown_map, physiology, tour, from);
}

void leave_tour(Workspace& work, Layout& layout, Timeline& timeline, Physiology& physiology,
                TourState& tour) {
    if (!tour.step) return;
    const bool finished = *tour.step + 1 == kSteps.size();
    tour.left_at = finished ? 0 : *tour.step;
    tour.step.reset();
    const ViewBeforeTour& before = tour.before;
    layout = before.layout;
    if (before.current < work.document.set.vibrations.size()) select_only(work, before.current);
    work.selection.pinned = before.pinned;
    timeline.playhead = before.playhead;
    timeline.range = before.time_range;
    physiology.view.open = before.open;
}

void draw_tour(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
               const ShownMap& shown_map, Physiology& physiology, TourState& tour,
               const Rect& window) {
    if (!tour.step) return;
    const std::size_t at = *tour.step;
    const TourStep& step = kSteps[at];
    const Theme& theme = ui.theme;
    const float width = std::min(380.0F * theme.scale, window.width() * 0.9F);
    const float margin = 2.0F * theme.padding_px;
    ImGui::SetNextWindowPos({window.max.x - margin, window.max.y - margin}, ImGuiCond_Always,
                            {1.0F, 1.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, window.height()});
    ImGui::PushStyleColor(ImGuiCol_Border, theme.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.hairline_px * 1.5F);
    if (ImGui::Begin("tour", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        char count[32];
        std::snprintf(count, sizeof count, "%zu of %zu", at + 1, kSteps.size());
        ImGui::PushFont(theme.fonts.semibold);
        ImGui::TextUnformatted(step.title);
        ImGui::PopFont();
        const float count_px = ImGui::CalcTextSize(count).x;
        if (ImGui::GetItemRectSize().x + count_px + 3.0F * theme.padding_px < width) {
            ImGui::SameLine(width - count_px - theme.padding_px);
            dim_text(ui, count);
        }
        ImGui::PushTextWrapPos(width - theme.padding_px);
        ImGui::TextUnformatted(step.text);
        ImGui::PopTextWrapPos();
        ImGui::BeginDisabled(at == 0);
        if (ImGui::Button("Back"))
            go_to_step(work, layout, timeline, shown_map, physiology, tour, at - 1);
        note_item(ui.rects, "tour:back");
        ImGui::EndDisabled();
        const bool last = at + 1 == kSteps.size();
        if (!last) flow_on(button_width("Next"), theme.gap_px);
        if (!last && ImGui::Button("Next"))
            go_to_step(work, layout, timeline, shown_map, physiology, tour, at + 1);
        if (!last) {
            note_item(ui.rects, "tour:next");
        }
        const char* leave = last ? "Finish" : "Leave the tour";
        flow_on(button_width(leave), theme.gap_px);
        if (ImGui::Button(leave)) leave_tour(work, layout, timeline, physiology, tour);
        note_item(ui.rects, last ? "tour:finish" : "tour:leave");
        note_rect(ui.rects, "tour", ImGui::GetWindowPos(),
                  ImGui::GetWindowPos() + ImGui::GetWindowSize(), count);
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace tact
