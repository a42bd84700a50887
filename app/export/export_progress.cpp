#include "app/export/export_progress.h"

#include <cstdio>
#include <string>

#include "app/progress/time_left.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

std::string time_left(const Ui& ui, const RunningAnimation& running) {
    const double share = static_cast<double>(running.done) / running.sequence.frames;
    const std::string left = time_left_text(ui.time_s - running.begun_s, share);
    return left.empty() ? "" : ", " + left;
}

}  // namespace

void draw_export_progress(Ui& ui, ExportState& exports) {
    const RunningAnimation& running = *exports.animation;
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
        char text[96];
        std::snprintf(text, sizeof text, "Drawing frame %d of %d%s", running.done + 1,
                      running.sequence.frames, time_left(ui, running).c_str());
        ImGui::TextUnformatted(text);
        note_item(ui.rects, "export progress", text);
        const float share =
            static_cast<float>(running.done) / static_cast<float>(running.sequence.frames);
        ImGui::ProgressBar(share, {240.0F * theme.scale, 6.0F * theme.scale}, "");
        cancelled = ImGui::Button("Cancel export");
        note_item(ui.rects, "button:cancel export");
        draw_tooltip(ui, running.film ? "No file is written (Esc)"
                                      : "Keeps the frames that are drawn (Esc)");
    }
    ImGui::End();
    ImGui::PopStyleColor();
    exports.cancel_asked |= cancelled;
}

}  // namespace tact
