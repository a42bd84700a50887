// The paper's findings, checked on request on the sets that come with the program.

#include <algorithm>
#include <cstdio>

#include "app/compare/check_findings.h"
#include "app/compare/compare_panels.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

ImU32 colour_of(const Theme& theme, FindingStatus status) {
    if (status == FindingStatus::holds) return theme.accent;
    if (status == FindingStatus::fails) return theme.warning;
    return theme.dim_text;
}

void draw_finding(App& app, const Finding& finding) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(app.theme, finding.status));
    ImGui::TextUnformatted(word_of(finding.status));
    ImGui::PopStyleColor();
    note_item(app.rects, "finding:" + finding.id, word_of(finding.status));
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", finding.claim.c_str());
    ImGui::PushFont(app.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(app, finding.id + ", " + finding.source + ": " + finding.evidence);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace

void draw_findings(App& app, const Rect& area) {
    const bool busy = app.findings_job && app.findings_job->busy();
    ImGui::BeginDisabled(busy);
    if (ImGui::Button("Check findings") && app.findings_job) app.findings_job->submit(0);
    note_item(app.rects, "button:check findings");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (busy) {
        char text[32];
        std::snprintf(text, sizeof text, "checking, %d %%",
                      static_cast<int>(100.0F * app.findings_job->progress()));
        dim_text(app, text);
        ImGui::SameLine();
        if (link(app, "cancel findings", "Cancel")) app.findings_job->cancel();
        note_item(app.rects, "link:cancel findings");
    } else if (app.findings) {
        char text[64];
        std::snprintf(text, sizeof text, "%td hold, %td fail of %zu",
                      std::ranges::count(*app.findings, FindingStatus::holds, &Finding::status),
                      std::ranges::count(*app.findings, FindingStatus::fails, &Finding::status),
                      app.findings->size());
        dim_text(app, text);
    } else {
        dim_text(app, "what the paper says comes out, on its own sets");
    }
    if (!app.findings || area.empty()) return;
    ImGui::BeginChild("findings", ImGui::GetContentRegionAvail());
    if (ImGui::BeginTable("findings", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) {
        ImGui::TableSetupColumn("status", ImGuiTableColumnFlags_WidthFixed,
                                96.0F * app.theme.scale);
        ImGui::TableSetupColumn("claim");
        for (const Finding& finding : *app.findings) draw_finding(app, finding);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace tact
