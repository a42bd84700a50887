#include "app/compare/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "assets/assets.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

struct Predicted {
    PatternSet set;
    Prediction prediction;
};

// A set reuses the matrices of a set predicted before if it shares them.
std::optional<Predicted> predicted(const std::string& name, const CheckOptions& check,
                                   const Prediction* previous) {
    const std::string path = "sets/" + name + ".tactspace.json";
    Expected<PatternSet> set = parse_set(asset(path), path, {});
    assert(set && "a compiled-in set does not parse");
    PredictOptions options;
    options.threads = check.threads;
    options.previous = previous;
    options.stop = check.stop;
    if (check.progress_of) options.progress = check.progress_of(set->name);
    auto prediction =
        predict(own_waveforms(*set, options.threads), check.model.value_or(set->model), options);
    if (!prediction) return std::nullopt;
    return Predicted{*std::move(set), *std::move(prediction)};
}

}  // namespace

std::optional<std::vector<Finding>> check_findings(const CheckOptions& options) {
    const auto am_4hz = predicted(kAm4HzSet, options, nullptr);
    if (!am_4hz) return std::nullopt;
    const auto am_5hz = predicted(kAm5HzSet, options, &am_4hz->prediction);
    if (!am_5hz) return std::nullopt;
    const auto twelve = predicted(kTwelveSet, options, nullptr);
    if (!twelve) return std::nullopt;
    return findings({{am_4hz->set, am_4hz->prediction.pm},
                     {am_5hz->set, am_5hz->prediction.pm},
                     {twelve->set, twelve->prediction.pm}});
}

const char* word_of(FindingStatus status) {
    switch (status) {
        case FindingStatus::holds:
            return "holds";
        case FindingStatus::fails:
            return "fails";
        case FindingStatus::needs_ratings:
            return "needs ratings";
        case FindingStatus::needs_stimuli:
            return "needs stimuli";
    }
    return "";
}

std::optional<MorseCheck> check_morse(const MorseOptions& options) {
    const Expected<PatternSet> set = parse_set(asset(kMorseSet), kMorseSet, {});
    assert(set && "a compiled-in set does not parse");
    const Expected<RatingStudy> study = study_of(*set);
    assert(study && "the set has its ratings");
    EvaluationParams params;
    params.threads = options.threads;
    const Expected<RatedPeople> people = rated_people(*study, params);
    assert(people && "36 patterns are rated, and not alike");
    MetricOptions metric;
    metric.threads = options.threads;
    metric.stop = options.stop;
    metric.progress = options.progress;
    const auto matrices = compared_matrices(*set, kMetrics, nullptr, metric);
    if (!matrices) return std::nullopt;
    std::vector<double> lasting_s;
    for (const Vibration& vibration : set->vibrations) {
        lasting_s.push_back(sounding_s(waveform_of(vibration)));
    }
    const Dissimilarity& ratings = people->rated.people.dissimilarity;
    MorseCheck check{set->vibrations.size(), people->rated_pairs, {}};
    auto evaluated = *evaluations(*matrices, *people, params);
    for (std::size_t k = 0; k < kMetrics.size(); ++k) {
        const Dissimilarity& matrix = (*matrices)[k];
        check.rows.push_back({kMetrics[k], std::move(evaluated[k]),
                              duration_control(matrix, ratings, lasting_s),
                              distinct_values(matrix)});
    }
    const auto order = [](const MorseRow& row) {
        return std::isfinite(row.agreement.rho) ? -row.agreement.rho : 2.0;
    };
    std::ranges::stable_sort(check.rows, {}, order);
    return check;
}

// The paper's findings, checked on request on the sets that come with the program.

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
    plain_text(ui, {.id = "finding:" + finding.id, .text = word_of(finding.status)});
    ImGui::PopStyleColor();
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
        return check(draw_empty_with(ui, area, "Does the model find what people felt?",
                                     "What the paper found, checked on its own sets.",
                                     {.id = "button:check findings", .label = kCheck}));
    }
    check(primary_button(ui, {.id = "button:check findings", .label = kCheck, .enabled = !busy}));
    if (busy || comparing.findings) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        ImGui::AlignTextToFramePadding();
    }
    if (busy) {
        if (draw_progress(ui, {"Checking", comparing.findings_job.progress(), "findings"}, true))
            comparing.findings_job.cancel();
    } else if (comparing.findings) {
        const std::string text = tally_of(*comparing.findings);
        dim_text(ui,
                 {.id = "compare:findings",
                  .text = shortened(ui.theme.fonts.regular, text, ImGui::GetContentRegionAvail().x),
                  .value = text});
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
