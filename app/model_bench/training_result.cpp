#include "app/model_bench/model_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/compare/compare.h"
#include "app/model_bench/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/charts/profile_view.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

// What training has found: the parameters, how sharply the data tell them, and for which people
// they hold.

namespace {

constexpr std::size_t kListedTies = 20;
constexpr Range kShownDrop{0.02, 0.1};  // of the objective, from head to foot of the profiles

const char* objective_name(const Training& training) {
    return training.objective == TrainingObjective::mean_rho ? "mean rho" : "mean |rho|";
}

void draw_heading(const Ui& ui, const char* text) {
    ImGui::Dummy({1.0F, 0.5F * ui.theme.gap_px});
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void small_text(const Ui& ui, const std::string& text) {
    ImGui::PushFont(ui.theme.fonts.small);
    coloured_text(ui.theme.dim_text, text);
    ImGui::PopFont();
}

void draw_headline(Ui& ui, const FoundTraining& found) {
    const Training& training = found.training;
    const std::string headline =
        of_people(objective_name(training), {.synthetic = is_partly_synthetic(found.record)}) +
        " " + with_decimals(training.best.value, 3);
    draw_heading(ui, headline.c_str());
    note_item(ui.rects, "train:result", with_decimals(training.best.value, 3));
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    dim_text(ui, "was " + with_decimals(training.value_before, 3));
    const std::string remark = remark_on_synthetic({training.model, found.record});
    if (!remark.empty()) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "train:synthetic",
                       .text = "These parameters were " + remark + ".",
                       .value = headline});
    }
    const std::uint64_t equal = training.best.combinations;
    const std::string near = percent(training.share_near_best);
    small_text(ui, (equal == 1 ? std::string("No other combination is as good; ")
                               : grouped_digits(equal) + " combinations are equally good, shown "
                                                         "is the one nearest to yours; ") +
                       near + " of all come within " + with_decimals(kNearBest, 2) +
                       " of it. How well it does on what it was fitted to says little of others.");
}

void draw_actions(Ui& ui, Workspace& work, ModelBench& model_bench, const FoundTraining& found,
                  bool stale) {
    const bool in_use = work.document.set.model == found.training.model;
    if (primary_button(
            ui, {.id = "button:use trained",
                 .label = "Use these parameters",
                 .tip = "For this set, as one step that undo takes back; kept for other sets too.",
                 .enabled = !stale && !in_use,
                 .value = stale    ? "stale"
                          : in_use ? "in use"
                                   : "enabled"})) {
        use_trained(ui, work, model_bench);
    }
    flow_on(button_width("Save to file..."), ui.theme.gap_px);
    if (button(ui, {.id = "button:save trained", .label = "Save to file..."}))
        save_trained_dialog(ui, work, model_bench);
    if (stale) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "train:stale",
                       .text = "The sets, ratings or choices have changed since: train again."});
    } else if (in_use) {
        flow_on(ImGui::CalcTextSize("In use.").x, ui.theme.gap_px);
        ImGui::AlignTextToFramePadding();
        dim_text(ui, "In use.");
    }
}

// One range for all eight, so that a flat one looks flat.
Range shown_range(const Training& training) {
    Range range{training.best.value, training.best.value};
    for (const auto& best : training.best_of) {
        for (const double value : best) {
            if (std::isfinite(value)) range.low = std::min(range.low, value);
        }
    }
    range.low = range.high - std::clamp(range.high - range.low, kShownDrop.low, kShownDrop.high);
    return range;
}

// The place of a value among a parameter's steps; none between them.
std::optional<std::size_t> place_of_value(double value, std::size_t parameter, int units) {
    const double steps = parameter < 2 ? value : value * units;
    const double most = parameter < 2 ? kMostTrainedLayers : units;
    if (std::abs(steps - std::round(steps)) > 1e-6 || steps < 0.0 || steps > most) return {};
    return static_cast<std::size_t>(std::lround(steps));
}

void draw_profile_of(Ui& ui, const Training& training, std::size_t p, const Rect& area) {
    const double step = 1.0 / training.grid.units;
    const auto now = trained_values(training.model);
    const auto texts = parameter_texts(training.model, step);
    const auto before = trained_values(training.before);
    ProfileScene scene;
    const std::string title = std::string(kTrainedNames[p]) + "  " + texts[p];
    const bool changed = std::abs(now[p] - before[p]) > 1e-9;
    const std::string was = "was " + significant_digits(before[p], 4);
    scene.title = title;
    scene.detail = changed ? std::string_view(was) : "";
    scene.best = training.best_of[p];
    scene.shown = shown_range(training);
    scene.chosen = place_of_value(now[p], p, training.grid.units).value_or(scene.best.size());
    if (changed) scene.before = place_of_value(before[p], p, training.grid.units);
    scene.readout = [&](std::size_t k) {
        const std::string value =
            p < 2 ? std::to_string(k) : weight_text(static_cast<double>(k) * step, step);
        const double best = training.best_of[p][k];
        return std::vector<std::string>{
            std::string(kTrainedNames[p]) + " = " + value,
            std::isfinite(best) ? "at best " + with_decimals(best, 3) : "no order with it"};
    };
    draw_profile(kTrainedNames[p], ui.theme, area, scene);
    note_rect(ui.rects, std::string("profile:") + kTrainedNames[p], area.min, area.max, texts[p]);
}

void draw_profiles(Ui& ui, const Training& training) {
    const Range range = shown_range(training);
    draw_heading(ui, "How sharply the ratings tell each");
    small_text(ui, std::string("The best ") + objective_name(training) +
                       " that each value allows, the others free: " + with_decimals(range.high, 3) +
                       " at the head, " + with_decimals(range.low, 3) +
                       " or less at the foot. Flat: any value would do.");
    const float gap = 1.5F * ui.theme.gap_px;
    const float width = ImGui::GetContentRegionAvail().x;
    const float least = 96.0F * ui.theme.scale;
    const std::size_t columns = width >= 4.0F * least + 3.0F * gap   ? 4
                                : width >= 2.0F * least + 1.0F * gap ? 2
                                                                     : 1;
    const float wide =
        (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const float high = 64.0F * ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        const ImVec2 at{corner.x + static_cast<float>(p % columns) * (wide + gap),
                        corner.y + static_cast<float>(p / columns) * (high + gap)};
        draw_profile_of(ui, training, p, rect_at(at, {wide, high}));
    }
    const float rows = static_cast<float>((kTrainedParameters + columns - 1) / columns);
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({width, rows * (high + gap)});
}

void draw_cells(const std::vector<std::string>& cells) {
    ImGui::TableNextRow();
    for (const std::string& cell : cells) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(shown_text(cell).c_str());
    }
}

void draw_heads(const Ui& ui, const std::vector<std::string>& heads) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.theme.fonts.small);
    for (const std::string& head : heads) {
        ImGui::TableNextColumn();
        dim_text(ui, head);
    }
    ImGui::PopFont();
}

constexpr ImGuiTableFlags kTable =
    ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;

void draw_sets(Ui& ui, const Training& training) {
    draw_heading(ui, "Set by set");
    const bool several = !training.without_set.empty();
    if (!ImGui::BeginTable("sets", several ? 4 : 3, kTable)) return;
    std::vector<std::string> heads{"rho with PM", "before", "trained"};
    if (several) heads.emplace_back("trained without it");
    draw_heads(ui, heads);
    for (std::size_t k = 0; k < training.sets.size(); ++k) {
        const TrainedSet& set = training.sets[k];
        std::vector<std::string> cells{set.name, with_decimals(set.rho_before, 3),
                                       with_decimals(set.rho_after, 3)};
        if (several) cells.push_back(with_decimals(training.without_set[k].rho_after, 3));
        draw_cells(cells);
        note_item(ui.rects, "trained set:" + set.name, with_decimals(set.rho_after, 3));
    }
    ImGui::EndTable();
}

void draw_people(Ui& ui, const Training& training) {
    if (training.without_participant.empty()) return;
    draw_heading(ui, "Person by person");
    const LeftOutMean mean = mean_of(training.without_participant);
    if (!std::isnan(mean.rho_after)) {
        small_text(ui, "On average rho " + with_decimals(mean.rho_after, 3) +
                           " with a person that the fit had not seen, on the same vibrations; " +
                           with_decimals(mean.rho_before, 3) + " with the parameters before.");
    }
    if (!ImGui::BeginTable("people", 3, kTable)) return;
    draw_heads(ui, {"rho with one person", "before", "trained without"});
    for (const LeftOut& one : training.without_participant) {
        draw_cells({one.name, with_decimals(one.rho_before, 3), with_decimals(one.rho_after, 3)});
        note_item(ui.rects, "left out:" + one.name, with_decimals(one.rho_after, 3));
    }
    ImGui::EndTable();
}

void draw_ties(Ui& ui, ModelBench& model_bench, const Training& training) {
    if (training.best.classes < 2) return;
    bool& open = model_bench.training.shows_ties;
    ImGui::Dummy({1.0F, 0.5F * ui.theme.gap_px});
    const std::string text = std::string(open ? "Hide" : "Show") + " the equally good, in " +
                             grouped_digits(training.best.classes) + " proportions";
    if (link(ui,
             {.id = "link:ties", .label = text, .value = grouped_digits(training.best.classes)})) {
        open = !open;
    }
    if (!open) return;
    ImGui::PushFont(ui.theme.fonts.small);
    const std::size_t rows = std::min(training.best.points.size(), kListedTies);
    const float height = (static_cast<float>(rows) + 3.0F) * ImGui::GetTextLineHeightWithSpacing();
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX | ImGuiTableFlags_NoSavedSettings;
    if (ImGui::BeginTable("ties", 9, kFlags, {0.0F, height})) {
        std::vector<std::string> heads(kTrainedNames.begin(), kTrainedNames.end());
        heads.emplace_back("combinations");
        draw_heads(ui, heads);
        for (std::size_t k = 0; k < rows; ++k) {
            const GridPoint& point = training.best.points[k];
            std::vector<std::string> cells = parameter_texts(training.grid, point);
            cells.push_back(grouped_digits(combinations_of(training.grid, point)));
            draw_cells(cells);
            note_item(ui.rects, "tie:" + std::to_string(k));
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
    if (training.best.classes > rows) {
        small_text(ui, "and " + grouped_digits(training.best.classes - rows) +
                           " more: train on the command line lists them all.");
    }
}

}  // namespace

void draw_training_result(Ui& ui, Workspace& work, ModelBench& model_bench,
                          const FoundTraining& found) {
    const bool stale = is_training_stale(work, model_bench);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    if (std::exchange(model_bench.training.scroll_to_result, false)) ImGui::SetScrollHereY(0.0F);
    draw_headline(ui, found);
    draw_actions(ui, work, model_bench, found, stale);
    const ImVec2 numbers = ImGui::GetCursorScreenPos();
    draw_profiles(ui, found.training);
    draw_sets(ui, found.training);
    draw_people(ui, found.training);
    draw_ties(ui, model_bench, found.training);
    if (!stale) return;
    const Rect veil{{from.x, numbers.y},
                    {from.x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y}};
    draw_stale(*ImGui::GetWindowDrawList(), ui.theme, veil, 0.0);
}

namespace {

constexpr std::size_t kLayerParameters = 2;
constexpr std::size_t kMixParameters = 2;  // the last ones

}  // namespace

std::string weight_text(double weight, double step) {
    int digits = 1;
    for (double ten = 10.0; digits < 3; ++digits, ten *= 10.0) {
        if (std::abs(step * ten - std::round(step * ten)) < 1e-9) break;
    }
    return fixed_digits(weight, digits);
}

std::vector<std::string> parameter_texts(const PerceptualModelParams& model, double step) {
    std::vector<std::string> texts;
    for (const double value : trained_values(model)) {
        texts.push_back(texts.size() < kLayerParameters ? fixed_digits(value, 0)
                                                        : weight_text(value, step));
    }
    return texts;
}

std::vector<std::string> parameter_texts(const TrainingGrid& grid, const GridPoint& point) {
    PerceptualModelParams none;
    none.channel_weight = {};
    none.nc_weight = none.oc_weight = 0.0;
    auto texts = parameter_texts(nearest_model(grid, point, none), 1.0 / grid.units);
    if (point.channel == kAny) std::fill(texts.begin(), texts.end() - kMixParameters, "any");
    return texts;
}

}  // namespace tact
