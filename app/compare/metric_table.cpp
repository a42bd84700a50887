// One row per metric: its agreement with people, and with PM.

#include <array>
#include <cmath>

#include "app/compare/compare.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The best of a column among the defined values.
struct Best {
    double rho = -2.0;
    double rho_p = 2.0;
    double k = 2.0;
    double k_p = 2.0;
};

Best best_of(const Comparison& comparison) {
    Best best;
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) continue;
        best.rho = std::fmax(best.rho, row.evaluation->rho);
        best.rho_p = std::fmin(best.rho_p, row.evaluation->rho_p);
        best.k = std::fmin(best.k, row.evaluation->k);
        best.k_p = std::fmin(best.k_p, row.evaluation->k_p);
    }
    return best;
}

// The best value has its own background. Where many rows share it, as with the smallest p of all
// draws, they are only bold.
enum class Mark { none, best, shared };

void draw_cell(const Ui& ui, const std::string& text, Mark mark) {
    ImGui::TableNextColumn();
    if (mark != Mark::none) ImGui::PushFont(ui.theme.fonts.semibold);
    if (mark == Mark::best) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, ui.theme.hover);
    right_aligned(text);
    if (mark != Mark::none) ImGui::PopFont();
}

// All digits: tests compare them with the command line.
std::string row_value(const ComparedMetric& row) {
    if (!row.evaluation) return with_decimals(row.rho_with_pm, 17);
    const Evaluation& e = *row.evaluation;
    std::string text;
    for (const double value :
         {e.rho, e.rho_interval.low, e.rho_interval.high, e.rho_p, e.k, e.k_p}) {
        text += shortest_digits(value) + " ";
    }
    return text;
}

std::string interval_text(const Evaluation& e) {
    return with_decimals(e.rho_interval.low, 2) + " to " + with_decimals(e.rho_interval.high, 2);
}

std::string tip_of(const ComparedMetric& row, const NumberMark& mark) {
    std::string tip = row.help;
    if (!row.evaluation) return tip;
    const Evaluation& e = *row.evaluation;
    tip += "\n" + of_people("rho ", mark) + with_decimals(e.rho, 2) + ", 95 % " + interval_text(e) +
           ", p of K " + with_decimals(e.k_p, 4) + ".\n" + of_people("tau-b ", mark) +
           with_decimals(e.tau_b, 3) + ", K over maps that fit as well " +
           with_decimals(e.k_spread.low, 2) + " to " + with_decimals(e.k_spread.high, 2) +
           ", 1 - K/chance " + with_decimals(e.k_corrected, 2) + ", stress-1 " +
           with_decimals(e.stress1, 3);
    for (const std::string& remark : e.remarks) tip += "\n" + remark;
    return tip;
}

// Two columns without ratings; with ratings, as many as fit. The tooltip of a row has the rest.
enum class Columns { few, least, most, all };

void draw_row(Ui& ui, Comparing& comparing, const ComparedMetric& row, const Best& best,
              const NumberMark& mark) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x;
    if (option(ui,
               {.id = "metric:" + row.key,
                .label = row.name,
                .tip = tip_of(row, mark),
                .value = row_value(row)},
               comparing.panel.metric == row.key, ImGuiSelectableFlags_SpanAllColumns)) {
        comparing.panel.metric = row.key;
        comparing.panel.shepard_of_people = false;
    }
    constexpr const char* kOurs = "ours";
    const float beside = ImGui::CalcTextSize(row.name.c_str()).x + ImGui::GetStyle().ItemSpacing.x +
                         text_size(ui.theme.fonts.small, kOurs).x;
    if (row.metric && traits(*row.metric).is_reference && beside <= room) {
        ImGui::SameLine();
        ImGui::PushFont(ui.theme.fonts.small);
        dim_text(ui, {.id = "ours:" + row.key, .text = kOurs});
        ImGui::PopFont();
    }
    if (row.evaluation) {
        const Evaluation& e = *row.evaluation;
        const auto best_if = [](bool is_best, Mark as) { return is_best ? as : Mark::none; };
        draw_cell(ui, with_decimals(e.rho, 2), best_if(e.rho == best.rho, Mark::best));
        draw_cell(ui, interval_text(e), Mark::none);
        draw_cell(ui, with_decimals(e.rho_p, 4), best_if(e.rho_p == best.rho_p, Mark::shared));
        draw_cell(ui, e.is_failed_map ? "no map" : with_decimals(e.k, 2),
                  best_if(e.k == best.k, Mark::best));
        draw_cell(ui, with_decimals(e.k_p, 4), best_if(e.k_p == best.k_p, Mark::shared));
    }
    draw_cell(ui, with_decimals(row.rho_with_pm, 2), Mark::none);
}

struct Column {
    const char* name;
    const char* tip;
    Columns from;  // up to here; without ratings, the first and the last column
    float weight;
};
constexpr std::array<Column, 7> kColumns{
    {{"metric", "Click one for its pairs and its Shepard diagram.", Columns::least, 2.4F},
     {"rho",
      "Spearman's rank correlation with the ratings, pair by pair: 1 the same order. Bold: the "
      "highest.",
      Columns::least, 1.0F},
     {"95 %", "Interval of rho if other patterns had been drawn: bootstrap over patterns.",
      Columns::all, 1.6F},
     {"p",
      "How often patterns under exchanged names agree as well: Mantel's test. Bold: the least, "
      "which many share where no draw agreed as well.",
      Columns::all, 1.0F},
     {"K",
      "Alienation of the two maps: 0 one shape; unrelated maps have about .5, not 1. Bold: the "
      "lowest.",
      Columns::least, 1.0F},
     {"p of K",
      "How often maps under exchanged names are as close in shape. Bold: the least, which many "
      "share where no draw came as close.",
      Columns::all, 1.0F},
     {"with PM", "Spearman's rank correlation with PM: how much the metric is another one.",
      Columns::most, 1.0F}}};

void draw_heading(Ui& ui, const Column& column, const NumberMark& mark) {
    const std::string name = column.name;
    // An interval and a p stand to the right of their number.
    const std::string of = words_of(mark);
    const bool labelled = !of.empty() && (name == "rho" || name == "K");
    const bool is_with_pm = &column == &kColumns.back();
    // Columns are narrow: the second line of a heading says what the number is about.
    const std::string below = labelled ? of : is_with_pm ? "with PM" : "";
    const auto head = [&](const std::string& words, bool is_left) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dim_text);
        is_left ? ImGui::TextUnformatted(words.c_str()) : right_aligned(words);
        ImGui::PopStyleColor();
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    head(is_with_pm ? "rho" : name, &column == &kColumns.front());
    say_of_last_item(ui, {.id = "compare:head " + name,
                          .text = of_people(name, labelled ? mark : NumberMark{}),
                          .tip = column.tip});
    if (!below.empty()) {
        head(below, false);
        draw_tooltip(ui, column.tip);
    }
    ImGui::PopStyleVar();
}

void draw_head(Ui& ui, Columns columns, const NumberMark& mark) {
    const auto is_left_out = [&](const Column& column) {
        return columns == Columns::few && &column != &kColumns.front() &&
               &column != &kColumns.back();
    };
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : kColumns) {
        if (is_left_out(column)) continue;
        const bool is_shown = columns == Columns::few || column.from <= columns;
        const ImGuiTableColumnFlags shown = is_shown ? 0 : ImGuiTableColumnFlags_Disabled;
        ImGui::TableSetupColumn(column.name, ImGuiTableColumnFlags_WidthStretch | shown,
                                column.weight);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.theme.fonts.small);
    for (const Column& column : kColumns) {
        if (is_left_out(column)) continue;
        ImGui::TableNextColumn();
        draw_heading(ui, column, mark);
    }
    ImGui::PopFont();
}

void draw_remarks(Ui& ui, const Comparison& comparison) {
    ImGui::PushFont(ui.theme.fonts.small);
    std::string all;
    if (comparison.people) all = remark_on_people_map(comparison.people->said.rated);
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) continue;
        for (const std::string& remark : row.evaluation->remarks) {
            all += std::string(all.empty() ? "" : "\n") + row.name + ": " + remark;
        }
    }
    if (comparison.people && comparison.request.map->prediction.pm.size <= 7) {
        all += std::string(all.empty() ? "" : "\n") +
               "So few patterns fit any map: K and stress say little.";
    }
    if (!all.empty()) {
        reading_text(
            ui, ui.theme.dim_text,
            {.id = "compare:remarks", .text = all, .value = all.substr(0, all.find('\n'))});
    }
    ImGui::PopFont();
}

}  // namespace

void draw_metric_table(Ui& ui, Comparing& comparing, const Comparison& comparison,
                       const Rect& area) {
    const NumberMark mark = mark_of(comparison);
    const float room = area.width() / ui.theme.scale;
    const Columns columns = !comparison.people ? Columns::few
                            : room >= 560.0F   ? Columns::all
                            : room >= 300.0F   ? Columns::most
                                               : Columns::least;
    const Best best = best_of(comparison);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::BeginChild("metrics", area.size());
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    if (ImGui::BeginTable("metrics", comparison.people ? 7 : 2, kFlags)) {
        draw_head(ui, columns, mark);
        for (const ComparedMetric& row : comparison.metrics) {
            draw_row(ui, comparing, row, best, mark);
        }
        ImGui::EndTable();
    }
    draw_remarks(ui, comparison);
    ImGui::EndChild();
}

}  // namespace tact
