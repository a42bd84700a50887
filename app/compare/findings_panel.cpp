// The paper's findings, checked on request on the sets that come with the program.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "app/compare/check_findings.h"
#include "app/compare/compare_panels.h"
#include "app/progress/failure.h"
#include "app/progress/progress_line.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

ImU32 colour_of(const Theme& theme, FindingStatus status) {
    if (status == FindingStatus::holds) return theme.text;
    if (status == FindingStatus::fails) return theme.warning;
    return theme.dim_text;
}

// "3 hold, 1 fails, 12 cannot be checked".
std::string tally_of(const std::vector<Finding>& all) {
    const auto count = [&all](FindingStatus status) {
        return std::ranges::count(all, status, &Finding::status);
    };
    const auto holding = count(FindingStatus::holds);
    const auto failing = count(FindingStatus::fails);
    const auto unknown = static_cast<std::ptrdiff_t>(all.size()) - holding - failing;
    return std::to_string(holding) + (holding == 1 ? " holds, " : " hold, ") +
           std::to_string(failing) + (failing == 1 ? " fails, " : " fail, ") +
           std::to_string(unknown) + " cannot be checked";
}

// The evidence stands below the claim, or in a second column.
void draw_finding(Ui& ui, const Finding& finding, bool is_wide) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ui.theme, finding.status));
    ImGui::TextUnformatted(word_of(finding.status));
    ImGui::PopStyleColor();
    note_item(ui.rects, "finding:" + finding.id, word_of(finding.status));
    ImGui::TableNextColumn();
    wrapped_text(finding.claim);
    if (is_wide) ImGui::TableNextColumn();
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dim_text);
    wrapped_text(finding.id + ", " + finding.source);
    wrapped_text(finding.evidence);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace

void draw_findings(Ui& ui, Comparing& comparing, const Rect& area) {
    const bool busy = comparing.findings_job.busy();
    constexpr const char* kCheck = "Check findings";
    const auto check = [&](bool pressed) {
        if (pressed) ask_for_findings(ui, comparing);
    };
    if (!busy && !comparing.findings && comparing.findings_job.failure().empty() && !area.empty()) {
        check(draw_empty_with(ui, area, "Does the model find what people felt?",
                              "What the paper found, checked on its own sets.", kCheck));
        note_item(ui.rects, "button:check findings");
        return;
    }
    ImGui::BeginDisabled(busy);
    check(primary_button(ui, kCheck));
    note_item(ui.rects, "button:check findings");
    ImGui::EndDisabled();
    if (busy || comparing.findings) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        ImGui::AlignTextToFramePadding();
    }
    if (busy) {
        if (draw_progress(ui, {"Checking", comparing.findings_job.progress(), "findings"}, true))
            comparing.findings_job.cancel();
    } else if (comparing.findings) {
        const std::string text = tally_of(*comparing.findings);
        dim_text(ui, shortened(ui.theme.fonts.regular, text, ImGui::GetContentRegionAvail().x));
        note_item(ui.rects, "compare:findings", text);
    }
    (void)draw_failure(ui, "findings", comparing.findings_job.failure());
    if (!comparing.findings || area.empty()) return;
    ImGui::BeginChild("findings", ImGui::GetContentRegionAvail());
    const float scale = ui.theme.scale;
    const float width = std::min(ImGui::GetContentRegionAvail().x, 1240.0F * scale);
    const bool is_wide = width > 820.0F * scale;
    if (ImGui::BeginTable("findings", is_wide ? 3 : 2,
                          ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings, {width, 0.0F})) {
        ImGui::TableSetupColumn("status", ImGuiTableColumnFlags_WidthFixed, 96.0F * scale);
        ImGui::TableSetupColumn("claim");
        if (is_wide) ImGui::TableSetupColumn("evidence");
        for (const Finding& finding : *comparing.findings) draw_finding(ui, finding, is_wide);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace tact
