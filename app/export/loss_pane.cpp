#include "app/export/parts.h"

#include <algorithm>

#include "app/document/workspace.h"
#include "app/progress/progress.h"
#include "app/rendering/rendering.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/export/loss_words.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"
#include "viz/space/space_view.h"

namespace tact {

namespace {

constexpr ImGuiTableFlags kLossTable =
    ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
constexpr float kMapShare = 0.36F;   // of the pane's width
constexpr float kNarrowPx = 560.0F;  // where the map has no room

void wrapped_line(const Ui& ui, const std::string& text, bool dim) {
    ImGui::PushTextWrapPos(0.0F);
    if (dim) dim_text(ui, text);
    if (!dim) ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void head_row(const Ui& ui, const std::vector<std::string>& heads) {
    ImGui::TableNextRow();
    ImGui::PushFont(ui.theme.fonts.small);
    for (const std::string& head : heads) {
        ImGui::TableNextColumn();
        dim_text(ui, head);
    }
    ImGui::PopFont();
}

void draw_before_after(Ui& ui, const ExportLoss& loss) {
    const std::vector<BeforeAfter> rows = before_after_rows(loss);
    if (rows.empty() || !ImGui::BeginTable("before after", 3, kLossTable)) return;
    for (int k = 0; k < 3; ++k) ImGui::TableSetupColumn("", 0, k == 0 ? 1.2F : 1.0F);
    head_row(ui, {"PM", "as it was meant", "as it comes back"});
    for (const BeforeAfter& row : rows) {
        ImGui::TableNextRow();
        for (const std::string* cell : {&row.what, &row.before, &row.after}) {
            ImGui::TableNextColumn();
            wrapped_line(ui, *cell, cell == &row.what);
        }
        note_item(ui.rects, "export:after " + row.what, row.after);
    }
    ImGui::EndTable();
}

// Those that are not written are in the set, of which the best for the target is chosen.
void draw_pattern_losses(Ui& ui, const ExportLoss& loss, const std::vector<std::size_t>& written) {
    if (!ImGui::BeginTable("patterns", 4, kLossTable)) return;
    ImGui::TableSetupColumn("", 0, 3.4F);
    for (int k = 0; k < 3; ++k) ImGui::TableSetupColumn("", 0, 1.0F);
    head_row(ui, {"Pattern", "RMS error, g", "PSNR, dB", "PM from itself"});
    const std::vector<std::size_t> places = written_first(loss, written);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k == written.size()) head_row(ui, {"Not exported", "", "", ""});
        const PatternLoss& one = loss.patterns[places[k]];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(shown_text(one.name).c_str());
        ImGui::PushFont(ui.theme.fonts.small);
        for (const std::string& remark : one.remarks) wrapped_line(ui, remark, true);
        ImGui::PopFont();
        for (const std::string& cell :
             {loss_number(one.rms_error_g), psnr_text(one), moved_text(one)}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cell.c_str());
        }
        note_item(ui.rects, "export:loss of " + one.name, moved_text(one));
    }
    ImGui::EndTable();
}

void draw_moved_pairs(Ui& ui, const ExportLoss& loss) {
    if (loss.most_moved.empty() || !ImGui::BeginTable("moved", 3, kLossTable)) return;
    ImGui::TableSetupColumn("", 0, 3.4F);
    for (int k = 0; k < 2; ++k) ImGui::TableSetupColumn("", 0, 1.0F);
    head_row(ui, {"Pairs that moved most", "PM before", "after"});
    for (const PairChange& one : loss.most_moved) {
        ImGui::TableNextRow();
        for (const std::string& cell :
             {pair_text(loss, one.a, one.b), loss_number(one.before), loss_number(one.after)}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cell.c_str());
        }
    }
    ImGui::EndTable();
}

void draw_loss(Ui& ui, const LiveLoss& live, const ModelOrigin& origin) {
    const ExportLoss& loss = live.loss;
    if (const std::string mark = phrase_of(mark_of(origin)); !mark.empty()) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "loss:mark", .text = "Predicted " + mark + ".", .value = mark});
    }
    const std::string verdict = subset_verdict(loss) + ".";
    const std::string summary = summary_of(loss, live.request.written);
    wrapped_line(ui, summary + ".", false);
    note_item(ui.rects, "export:summary", summary);
    ImGui::Spacing();
    wrapped_line(ui, verdict, false);
    note_item(ui.rects, "export:verdict", verdict);
    ImGui::Spacing();
    draw_before_after(ui, loss);
    ImGui::Spacing();
    draw_pattern_losses(ui, loss, live.request.written);
    ImGui::Spacing();
    draw_moved_pairs(ui, loss);
    ImGui::PushFont(ui.theme.fonts.small);
    wrapped_line(ui, std::string(kAfterScale) + ".", true);
    ImGui::PopFont();
}

// Discs as it comes back, rings and the way from there as it was meant.
void draw_loss_map(const Ui& ui, EffectExport& effects, const LiveLoss& live, const Rect& area) {
    const MapChange& map = *live.loss.map;
    const std::vector<std::string> labels = names_of(*live.request.part);
    std::vector<PatternLook> looks;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        looks.push_back(look_of(ui.theme, *live.request.part, k));
    }
    SpaceScene scene;
    scene.labels = labels;
    scene.looks = looks;
    scene.points = &map.after;
    scene.ghosts = &map.before;
    scene.ghost_opacity = 1.0;
    scene.arrows = true;
    const std::vector<std::size_t> best = best_for_target(live.loss);
    scene.chosen = best;
    draw_space("loss map", ui.theme, area, scene, effects.camera);
}

void draw_map_beside(Ui& ui, EffectExport& effects, const LiveLoss& live, ImVec2 size) {
    ImGui::SameLine();
    if (ImGui::BeginChild("map", size)) {
        ImGui::PushFont(ui.theme.fonts.small);
        wrapped_line(ui,
                     "The map as it comes back, ringed: the best for this target. Arrows: from "
                     "where each was meant to be.",
                     true);
        ImGui::PopFont();
        draw_loss_map(ui, effects, live, rest_of_pane());
        note_item(ui.rects, "export:map", std::to_string(live.loss.patterns.size()));
    }
    ImGui::EndChild();
}

// In the middle of the line's height.
void draw_bar(const Ui& ui, float share) {
    const float s = ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetFrameHeight();
    ImGui::Dummy({160.0F * s, line});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from{corner.x, corner.y + 0.5F * line - 3.0F * s};
    const float round = ui.theme.rounding_px;
    list.AddRectFilled(from, from + ImVec2{160.0F * s, 6.0F * s}, ui.theme.field, round);
    list.AddRectFilled(from, from + ImVec2{160.0F * s * share, 6.0F * s}, ui.theme.accent, round);
}

// What the pane waits for, or why it does not.
void draw_state(Ui& ui, EffectExport& effects) {
    if (draw_failure(ui, "export", effects.job.failure())) return;
    if (is_predicting_loss(effects)) {
        const float share = effects.job.progress();
        if (draw_progress(ui, {"Predicting what it costs", share, "predicting", "Skip"}, true))
            stop_predicting(effects);
        ImGui::SameLine();
        draw_bar(ui, share);
        return;
    }
    if (effects.without && !is_loss_current(effects)) {
        ImGui::AlignTextToFramePadding();
        dim_text(ui, effects.large ? "What it costs takes minutes to predict." : "Skipped.");
        ImGui::SameLine();
        if (button(ui, {.id = "button:predict loss", .label = "Predict it"}))
            predict_anyway(ui, effects);
        ImGui::SameLine();
        dim_text(ui, "Without it the files are written alone.");
        return;
    }
    ImGui::AlignTextToFramePadding();
    dim_text(ui, is_loss_current(effects) ? "Written beside the files as export_report.html." : "");
}

}  // namespace

void draw_loss_pane(Ui& ui, const Workspace& work, EffectExport& effects, float height_px) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const Rect area = rect_at(corner, {width, height_px});
    const bool stale = effects.answer && !is_loss_current(effects);
    if (effects.answer) {
        const LiveLoss& live = *effects.answer;
        const bool has_map = live.loss.map && width > kNarrowPx * ui.theme.scale;
        const float map_px = has_map ? kMapShare * width : 0.0F;
        if (ImGui::BeginChild("loss", {width - map_px, height_px}))
            draw_loss(ui, live, work.document.set.model_origin);
        ImGui::EndChild();
        if (has_map) draw_map_beside(ui, effects, live, {0.0F, height_px});
        if (stale) draw_stale(*ImGui::GetWindowDrawList(), ui.theme, area, ui.time_s);
    } else {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "What the export costs",
                   "Each file is read back and predicted, before anything is written.");
        ImGui::Dummy(area.size());
    }
    note_rect(ui.rects, "export:loss", area.min, area.max,
              !effects.answer ? "none"
              : stale         ? "stale"
                              : "current");
    draw_state(ui, effects);
}

}  // namespace tact
