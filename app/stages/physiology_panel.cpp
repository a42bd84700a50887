// The middle column: the stages of the selected vibration in fingertip and nerves, and its
// differences from another one.

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/progress/progress.h"
#include "app/stages/parts.h"
#include "app/stages/stages.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// Patterns on screen: the current one, then the pinned one; a pattern whose stages are not computed
// yet is left out.
std::vector<ShownStages> shown_patterns(Ui& ui, const Workspace& work,
                                        const Physiology& physiology) {
    std::vector<ShownStages> patterns;
    const PatternSet& set = work.document.set;
    const auto add = [&](const std::shared_ptr<const LiveStages>& live, std::size_t index,
                         bool pinned) {
        const Vibration& wanted = set.vibrations[index];
        // Another pattern's signals would be worse than an empty pane.
        if (!live || live->request.vibration.name != wanted.name) return;
        const bool behind =
            live->request.vibration.source != wanted.source || live->request.model != set.model;
        const bool stale = looks_stale(ui, pinned ? "pinned stages" : "stages", live, behind);
        patterns.push_back({live, look_of(ui, work, index), stale, pinned});
    };
    add(physiology.stages, work.selection.current, false);
    const auto pinned = place_named(set, work.selection.pinned);
    if (pinned && !patterns.empty()) add(physiology.pinned_stages, *pinned, true);
    return patterns;
}

void follow_difference(Physiology& physiology, const std::vector<ShownStages>& patterns) {
    ShownDifference& known = physiology.view.difference;
    if (patterns.size() < 2) {
        known = {};
        return;
    }
    const auto& a = patterns[0].live;
    const auto& b = patterns[1].live;
    if (known.a == a && known.b == b) return;
    known = {a, b, stage_differences(*a, *b), {}, 0.0};
    if (a->neural.code.samples == b->neural.code.samples) {
        known.nc =
            nc_dissimilarity(a->neural.code, b->neural.code, a->request.model.channel_weight);
    }
    for (const Stage stage : kStages) {
        known.signals[index_of(stage)] = signal_differences(*a, *b, stage);
    }
}

// One line: the stage's name, the quantity, its controls at the right end, and a remark between
// them; if the remark does not fit, it stands below.
void draw_large(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                const std::vector<ShownStages>& patterns, Stage stage) {
    const Rect pane = rest_of_pane();
    const ImFont* font = ui.theme.fonts.small;
    const StageText& text = text_of(stage);
    const float name_px = text_size(font, text.name).x + 32.0F * ui.theme.scale;
    const bool has_controls = stage == Stage::receptors && !ui.as_picture;
    const float controls_px = has_controls ? view_choice_px(ui) : 0.0F;
    StageSize size;
    size.large = true;
    size.time_axis =
        stage != Stage::spectrum && stage != Stage::receptors && stage != Stage::networks;
    Rect line{pane.min, {pane.max.x, pane.min.y + ImGui::GetFrameHeight()}};
    const float down = std::floor(0.5F * (line.height() - text_size(font, "X").y));
    if (has_controls) {
        const float left = std::max(pane.min.x, pane.max.x - controls_px);
        size.controls = {left, line.min.y};
        if (left < pane.min.x + name_px) size.controls = {pane.min.x, line.max.y};
        if (left >= pane.min.x + name_px) line.max.x = left - ui.theme.gap_px;
    }
    const ImVec2 words = line.min + ImVec2{0.0F, down};
    draw_stage_label(ui, physiology, stage, {words, {words.x + name_px, line.max.y}});
    const float detail_px = words.x + name_px + ui.theme.gap_px;
    const std::string detail = shortened(font, text.detail, line.max.x - detail_px);
    draw_text(*ImGui::GetWindowDrawList(), font, {detail_px, words.y}, ui.theme.dim_text, detail);
    const float beside_px = detail_px + text_size(font, detail).x + 3.0F * ui.theme.gap_px;
    float top = line.max.y;
    if (size.controls && size.controls->y >= line.max.y) top += line.height();
    top += draw_remark(ui, physiology, patterns, stage, {{beside_px, words.y}, line.max},
                       {{pane.min.x, top}, pane.max});
    top += 0.5F * ui.theme.gap_px;
    top += draw_textbook(ui, physiology, patterns, stage, {{pane.min.x, top}, pane.max});
    Rect plots{{pane.min.x, top}, pane.max};
    if (!patterns.empty() && (stage == Stage::receptors || stage == Stage::networks)) {
        const float line_px = text_size(font, "X").y;
        plots.max.y -= line_px + ui.theme.gap_px;
        const Rect foot{{pane.min.x, pane.max.y - 1.1F * line_px}, pane.max};
        if (stage == Stage::receptors) {
            draw_receptor_key(ui, physiology, patterns.front(), foot);
        } else {
            draw_network_key(ui, patterns.front(), foot);
        }
    }
    draw_patterns(ui, work, timeline, physiology, patterns, stage, plots, size);
}

// Stages of a row, and the order in which they are left out if the columns are too narrow for their
// names: indices into the stages that remain.
constexpr std::array kRowStages{Stage::vibration, Stage::spikes, Stage::central, Stage::brain};
constexpr std::array<std::size_t, kRowStages.size() - 1> kGoFirst{2, 1, 1};

std::vector<Stage> stages_in_row(const Ui& ui, float width_px, float gap_px) {
    const auto name_px = [&ui](Stage stage) {
        return text_size(ui.theme.fonts.small, text_of(stage).short_name).x;
    };
    std::vector<Stage> stages(kRowStages.begin(), kRowStages.end());
    for (const std::size_t next : kGoFirst) {
        const float widest = name_px(std::ranges::max(stages, {}, name_px));
        const auto count = static_cast<float>(stages.size());
        if (count * (widest + gap_px) - gap_px <= width_px) break;
        stages.erase(stages.begin() + static_cast<std::ptrdiff_t>(next));
    }
    return stages;
}

void draw_row(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
              const std::vector<ShownStages>& patterns, const Rect& area) {
    const float gap = 1.5F * ui.theme.gap_px;
    const std::vector<Stage> stages = stages_in_row(ui, area.width(), gap);
    const float count = static_cast<float>(stages.size());
    const float width = (area.width() - gap * (count - 1.0F)) / count;
    const float label = text_size(ui.theme.fonts.small, "X").y + 0.5F * ui.theme.gap_px;
    float left = area.min.x;
    for (const Stage stage : stages) {
        Rect cell{{left, area.min.y}, {left + width, area.max.y}};
        draw_stage_label(ui, physiology, stage, {cell.min, {cell.max.x, cell.min.y + label}});
        cell.min.y += label;
        if (stage == Stage::vibration && cell.height() > 4.0F * label) {
            const float line = text_size(ui.theme.fonts.small, "X").y;
            draw_reach(ui, {cell.min, {cell.max.x, cell.min.y + line}}, stage,
                       reach_text(work, patterns[0], stage));
            cell.min.y += line;
        }
        StageSize size;
        size.names = false;
        draw_patterns(ui, work, timeline, physiology, patterns, stage, cell, size);
        left += width + gap;
    }
}

// A threshold moved in the spectrum changes the set's model.
void move_threshold(Ui& ui, Workspace& work, Physiology& physiology) {
    const auto move = std::exchange(physiology.view.threshold_move, std::nullopt);
    if (!move) return;
    constexpr Range kTable = kThresholdTable.values;
    Curve& curve = work.document.edit().model.coding.tables.threshold[index_of(move->type)];
    const double by = move->db / 20.0;
    const auto [low, high] = std::ranges::minmax(curve.value);
    if (by != 0.0 && low + by >= kTable.low && high + by <= kTable.high) {
        for (double& value : curve.value) value += by;
        model_changed(work);
    }
    if (move->is_last) {
        commit_step(ui, work, std::string("Move threshold of ") + traits(move->type).name);
    }
}

void fit_time(const Workspace& work, Timeline& timeline) {
    const double duration_s = shown_duration_s(work);
    timeline.range = unless_whole(timeline.range, duration_s);
    timeline.playhead.at_s = std::clamp(timeline.playhead.at_s, 0.0, duration_s);
}

StagesAction draw_nothing_to_show(const Ui& ui) {
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "No vibration to show",
               "Press New on the left to make one, or open a set.");
    return StagesAction::none;
}

void draw_on_their_way(const Ui& ui, const Rect& area, const Vibration& vibration) {
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "Computing",
               "The receptors and nerves of " + vibration.name + " are on their way.");
}

}  // namespace

void begin_pointing(Timeline& timeline, Physiology& physiology) {
    timeline.crosshair_last_s = timeline.crosshair_s;
    timeline.crosshair_s.reset();
    physiology.view.hovered_last = physiology.view.hovered;
    physiology.view.hovered.reset();
}

StagesAction draw_physiology_row(Ui& ui, Workspace& work, Timeline& timeline,
                                 Physiology& physiology) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) return draw_nothing_to_show(ui);
    fit_time(work, timeline);
    const float links = button_width("All stages");
    const Rect rest = rest_of_pane();
    const std::vector<ShownStages> patterns = shown_patterns(ui, work, physiology);
    const Rect row{rest.min, {rest.max.x - links - ui.theme.gap_px, rest.max.y}};
    const bool failed = draw_failure(ui, "physiology", physiology.stages_job.failure());
    if (!failed && patterns.empty()) {
        draw_on_their_way(ui, row, *vibration);
    }
    physiology.view.open.reset();
    follow_difference(physiology, {});  // a row shows one pattern
    if (!failed && !patterns.empty()) {
        draw_row(ui, work, timeline, physiology, {patterns.front()}, row);
    }
    // Drawn last because they stand at the right end: Tab moves from left to right.
    ImGui::SetCursorScreenPos({rest.max.x - links, rest.min.y});
    ImGui::BeginGroup();
    StagesAction action = physiology.view.open ? StagesAction::unfold : StagesAction::none;
    if (link(ui, {.id = "stages:unfold", .label = "All stages"})) action = StagesAction::unfold;
    if (link(ui, {.id = "stages:close",
                  .label = "Close",
                  .tip = "They come back by Stages in one row, in the View menu"})) {
        action = StagesAction::close;
    }
    ImGui::EndGroup();
    return action;
}

StagesAction draw_physiology_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                   Physiology& physiology, bool tour_begun) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) return draw_nothing_to_show(ui);
    fit_time(work, timeline);
    const std::vector<ShownStages> patterns = shown_patterns(ui, work, physiology);
    follow_difference(physiology, patterns);
    StagesAction action = StagesAction::none;
    if (!ui.as_picture) action = draw_strip(ui, work, physiology, tour_begun);
    // The links above may have changed the range.
    fit_time(work, timeline);
    const bool failed = draw_failure(ui, "physiology", physiology.stages_job.failure()) ||
                        draw_failure(ui, "physiology", physiology.pinned_job.failure());
    if (patterns.empty() && failed) return action;
    if (patterns.empty()) {
        draw_on_their_way(ui, rest_of_pane(), *vibration);
        return action;
    }
    if (physiology.view.open) {
        draw_large(ui, work, timeline, physiology, patterns, *physiology.view.open);
        move_threshold(ui, work, physiology);
    } else {
        draw_overview(ui, work, timeline, physiology, patterns);
    }
    return action;
}

}  // namespace tact
