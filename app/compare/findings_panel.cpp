// The paper's findings, checked on request on the sets that come with the program.

#include <algorithm>
#include <cstdio>

#include "app/compare/check_findings.h"
#include "app/compare/compare_panels.h"
#include "app/progress/failure.h"
#include "app/progress/progress_line.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

ImU32 colour_of(const Theme& theme, FindingStatus status) {
    if (status == FindingStatus::holds) return theme.accent;
    if (status == FindingStatus::fails) return theme.warning;
    return theme.dim_text;
}

void draw_finding(Ui& ui, const Finding& finding) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ui.theme, finding.status));
    ImGui::TextUnformatted(word_of(finding.status));
    ImGui::PopStyleColor();
    note_item(ui.rects, "finding:" + finding.id, word_of(finding.status));
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", finding.claim.c_str());
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, finding.id + ", " + finding.source + ": " + finding.evidence);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace

void draw_findings(Ui& ui, Comparing& comparing, const Rect& area) {
    const bool busy = comparing.findings_job && comparing.findings_job->busy();
    constexpr const char* kCheck = "Check findings";
    const auto check = [&comparing](bool pressed) {
        if (pressed && comparing.findings_job) comparing.findings_job->submit(0);
    };
    if (!busy && !comparing.findings && failure_of(comparing.findings_job).empty() &&
        !area.empty()) {
        check(draw_empty_with(ui, area, "Does the model find what people felt?",
                              "What the paper found, checked on its own sets.", kCheck));
        note_item(ui.rects, "button:check findings");
        return;
    }
    ImGui::BeginDisabled(busy);
    check(ImGui::Button(kCheck));
    note_item(ui.rects, "button:check findings");
    ImGui::EndDisabled();
    if (busy || comparing.findings) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        ImGui::AlignTextToFramePadding();
    }
    if (busy) {
        if (draw_progress(ui, {"Checking", comparing.findings_job->progress(), "findings"}, true))
            comparing.findings_job->cancel();
    } else if (comparing.findings) {
        char text[64];
        std::snprintf(
            text, sizeof text, "%td hold, %td fail of %zu",
            std::ranges::count(*comparing.findings, FindingStatus::holds, &Finding::status),
            std::ranges::count(*comparing.findings, FindingStatus::fails, &Finding::status),
            comparing.findings->size());
        dim_text(ui, text);
    }
    (void)draw_failure(ui, "findings", failure_of(comparing.findings_job));
    if (!comparing.findings || area.empty()) return;
    ImGui::BeginChild("findings", ImGui::GetContentRegionAvail());
    if (ImGui::BeginTable("findings", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) {
        ImGui::TableSetupColumn("status", ImGuiTableColumnFlags_WidthFixed, 96.0F * ui.theme.scale);
        ImGui::TableSetupColumn("claim");
        for (const Finding& finding : *comparing.findings) draw_finding(ui, finding);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace tact
