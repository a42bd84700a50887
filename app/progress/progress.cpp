#include "app/progress/progress.h"

#include <imgui.h>

#include <cmath>
#include <cstdint>
#include <string>

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
    const float begin_px = ImGui::GetCursorPosX();
    const float room_px = ImGui::GetContentRegionAvail().x;
    if (beside_buttons) ImGui::AlignTextToFramePadding();
    dim_text(ui, {.id = std::string("progress:") + line.cancels, .text = progress_text(ui, line)});
    place_cancel(ui, line, begin_px, room_px);
    const Item cancel{.id = std::string("link:cancel ") + line.cancels, .label = line.word};
    return beside_buttons ? row_link(ui, cancel) : link(ui, cancel);
}

namespace {

constexpr double kLeastElapsedS = 2.0;
constexpr double kLeastShare = 0.01;
constexpr double kLeastLeftS = 3.0;

std::string rounded_up(double value, double step, const char* unit) {
    const auto whole = static_cast<std::int64_t>(std::ceil(value / step - 1e-9) * step);
    return "about " + std::to_string(whole) + " " + unit;
}

std::string coarse(double seconds) {
    if (seconds <= 10.0) return rounded_up(seconds, 1.0, "s");
    if (seconds <= 60.0) return rounded_up(seconds, 5.0, "s");
    if (seconds <= 120.0) return rounded_up(seconds, 10.0, "s");
    if (seconds <= 3600.0) return rounded_up(seconds / 60.0, 1.0, "min");
    return rounded_up(seconds / 3600.0, 1.0, "h");
}

}  // namespace

std::string time_left_text(double elapsed_s, double share) {
    if (!(elapsed_s >= kLeastElapsedS) || !(share >= kLeastShare) || share >= 1.0) return {};
    const double left_s = elapsed_s * (1.0 - share) / share;
    if (left_s < kLeastLeftS) return {};
    return coarse(left_s) + " left";
}

std::string estimate_text(double seconds) {
    return seconds < 1.0 ? "less than 1 s" : coarse(seconds);
}

bool draw_failure(Ui& ui, const char* pane, const std::string& failure) {
    if (failure.empty()) return false;
    coloured_text(
        ui, ui.theme.error,
        {.id = std::string("failed:") + pane,
         .text = "This could not be computed: " + failure + ". The next change asks for it again.",
         .value = failure});
    return true;
}

}  // namespace tact
