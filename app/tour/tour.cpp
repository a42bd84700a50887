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

void show_most(App& app) {
    if (const auto place = place_named(app.document.set, kShownPattern)) select_only(app, *place);
    app.layout.left = 0.18F;
    app.layout.right = 0.26F;
    app.layout.maximised.reset();
}

// The pattern that PM puts farthest away, where that is known; else the next one.
std::string farthest(const App& app) {
    const auto& all = app.document.set.vibrations;
    if (all.size() < 2) return {};
    const std::size_t current = app.selection.current;
    std::size_t best = (current + 1) % all.size();
    const bool known = map_state(app) == MapState::exact || map_state(app) == MapState::preview;
    if (!known || app.map.shown->prediction.pm.size != all.size()) return all[best].name;
    const Dissimilarity& pm = app.map.shown->prediction.pm;
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

void go_to_step(App& app, std::size_t step) {
    app.tour.step = std::min(step, kSteps.size() - 1);
    const TourScene& scene = kSteps[*app.tour.step].scene;
    if (scene.begins) show_most(app);
    app.physiology.open = scene.stage;
    app.physiology.explained.reset();
    app.time_range = scene.range;
    const bool moves = scene.speed > 0.0;
    app.playhead = {
        .at_s = 0.0, .speed = moves ? scene.speed : 0.1, .playing = moves, .loop = true};
    app.pinned = scene.compares ? farthest(app) : std::string();
}

void start_tour(App& app) {
    if (current_vibration(app) == nullptr) {
        return complain(app, "The tour needs a pattern: add one, or open the example set.");
    }
    if (!app.tour.step) {
        app.tour.before = {app.layout,   app.selection.current, app.pinned,
                           app.playhead, app.time_range,        app.physiology.open};
    }
    const std::size_t from = app.tour.left_at;
    go_to_step(app, 0);
    if (from > 0) go_to_step(app, from);
}

void leave_tour(App& app) {
    if (!app.tour.step) return;
    const bool finished = *app.tour.step + 1 == kSteps.size();
    app.tour.left_at = finished ? 0 : *app.tour.step;
    app.tour.step.reset();
    const ViewBeforeTour& before = app.tour.before;
    app.layout = before.layout;
    if (before.current < app.document.set.vibrations.size()) select_only(app, before.current);
    app.pinned = before.pinned;
    app.playhead = before.playhead;
    app.time_range = before.time_range;
    app.physiology.open = before.open;
}

void draw_tour(App& app, const Rect& window) {
    if (!app.tour.step) return;
    const std::size_t at = *app.tour.step;
    const TourStep& step = kSteps[at];
    const Theme& theme = app.theme;
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
            dim_text(app, count);
        }
        ImGui::PushTextWrapPos(width - theme.padding_px);
        ImGui::TextUnformatted(step.text);
        ImGui::PopTextWrapPos();
        ImGui::BeginDisabled(at == 0);
        if (ImGui::Button("Back")) go_to_step(app, at - 1);
        note_item(app.rects, "tour:back");
        ImGui::EndDisabled();
        const bool last = at + 1 == kSteps.size();
        if (!last) flow_on(button_width("Next"), theme.gap_px);
        if (!last && ImGui::Button("Next")) go_to_step(app, at + 1);
        if (!last) {
            note_item(app.rects, "tour:next");
        }
        const char* leave = last ? "Finish" : "Leave the tour";
        flow_on(button_width(leave), theme.gap_px);
        if (ImGui::Button(leave)) leave_tour(app);
        note_item(app.rects, last ? "tour:finish" : "tour:leave");
        note_rect(app.rects, "tour", ImGui::GetWindowPos(),
                  ImGui::GetWindowPos() + ImGui::GetWindowSize(), count);
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace tact
