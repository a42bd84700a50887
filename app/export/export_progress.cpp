#include "app/export/export_progress.h"

#include <string>

#include "app/progress/time_left.h"
#include "app/ui/widgets.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

std::string time_left(const Ui& ui, const RunningAnimation& running) {
    const double share = static_cast<double>(running.done) / running.sequence.frames;
    const std::string left = time_left_text(ui.time_s - running.begun_s, share);
    return left.empty() ? "" : ", " + left;
}

}  // namespace

bool draw_progress_plate(Ui& ui, const ProgressPlate& plate) {
    const Theme& theme = ui.theme;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - theme.padding_px, screen.y - 34.0F * theme.scale},
                            ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme.field);
    bool cancelled = false;
    if (ImGui::Begin("export progress", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::TextUnformatted(plate.text.c_str());
        note_item(ui.rects, "export progress", plate.text);
        if (plate.share) {
            ImGui::ProgressBar(*plate.share, {240.0F * theme.scale, 6.0F * theme.scale}, "");
        }
        cancelled = ImGui::Button(plate.cancel);
        note_item(ui.rects, std::string("button:") + lower_case(plate.cancel));
        draw_tooltip(ui, plate.told);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    return cancelled;
}

void draw_export_progress(Ui& ui, ExportState& exports) {
    const RunningAnimation& running = *exports.animation;
    exports.cancel_asked |= draw_progress_plate(
        ui,
        {.text = "Drawing frame " + std::to_string(running.done + 1) + " of " +
                 std::to_string(running.sequence.frames) + time_left(ui, running),
         .share = static_cast<float>(running.done) / static_cast<float>(running.sequence.frames),
         .cancel = "Cancel export",
         .told =
             running.film ? "No file is written (Esc)" : "Keeps the frames that are drawn (Esc)"});
}

}  // namespace tact
