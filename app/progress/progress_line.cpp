#include "app/progress/progress_line.h"

#include <imgui.h>

#include <string>

#include "app/progress/time_left.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// The words; the time left is told from when the work was first seen.
std::string progress_text(Ui& ui, const ProgressLine& line) {
    ProgressSeen& seen = ui.progress[line.cancels];
    // It begins again where it is less than it was, or was not drawn for a while.
    constexpr double kAwayS = 5.0;
    if (line.share < seen.share || ui.time_s - seen.last_s > kAwayS) seen.since_s = ui.time_s;
    seen.share = line.share;
    seen.last_s = ui.time_s;
    const std::string left = time_left_text(ui.time_s - seen.since_s, double{line.share});
    return std::string(line.doing) + ", " + percent_done(double{line.share}) +
           (left.empty() ? "" : ", " + left);
}

// Behind the widest words that the line may have: it stays under the pointer while they change.
void place_cancel(const Ui& ui, const ProgressLine& line, float begin_px, float room_px) {
    const std::string widest = std::string(line.doing) + ", 100 %, about 55 min left";
    const float behind_px = ImGui::CalcTextSize(widest.c_str()).x + ui.theme.gap_px;
    if (behind_px + ImGui::CalcTextSize(line.word).x > room_px) return;  // on a line of its own
    ImGui::SameLine(begin_px + behind_px);
}

}  // namespace

bool draw_progress(Ui& ui, const ProgressLine& line, bool beside_buttons) {
    const std::string text = progress_text(ui, line);
    const float begin_px = ImGui::GetCursorPosX();
    const float room_px = ImGui::GetContentRegionAvail().x;
    if (beside_buttons) ImGui::AlignTextToFramePadding();
    dim_text(ui, text);
    note_item(ui.rects, std::string("progress:") + line.cancels, text);
    place_cancel(ui, line, begin_px, room_px);
    const std::string id = std::string("cancel ") + line.cancels;
    const bool cancelled =
        beside_buttons ? row_link(ui, id.c_str(), line.word) : link(ui, id.c_str(), line.word);
    note_item(ui.rects, "link:" + id);
    return cancelled;
}

}  // namespace tact
