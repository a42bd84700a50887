#include "app/transform/transform_dialog.h"

#include "app/progress/failure.h"
#include "app/progress/progress_line.h"
#include "app/transform/transform_follow.h"
#include "app/ui/dialog.h"
#include "app/ui/number_field.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kTransformPx = 560.0F;
constexpr float kTransformChoicePx = 260.0F;

void draw_kind(Ui& ui, TransformState& state) {
    draw_label(ui, "Transform");
    ImGui::SetNextItemWidth(kTransformChoicePx * ui.theme.scale);
    if (ImGui::BeginCombo("##kind", traits(state.kind).label, ImGuiComboFlags_HeightLarge)) {
        for (std::size_t k = 0; k < kEditKindCount; ++k) {
            const auto kind = static_cast<EditKind>(k);
            if (ImGui::Selectable(traits(kind).label, kind == state.kind)) state.kind = kind;
            note_item(ui.rects, std::string("transform:kind:") + traits(kind).key);
        }
        ImGui::EndCombo();
    }
    note_item(ui.rects, "transform:kind", traits(state.kind).label);
}

void draw_number(Ui& ui, const EditTraits& about, std::optional<double>& number) {
    const bool whole = about.needs == EditNeeds::whole_number;
    draw_label(ui, "By");
    const std::string format = std::string(whole ? "%.0f" : "%.4g") +
                               (*about.unit == '%' ? " %%" : std::string(" ") + about.unit);
    double value = number.value_or(about.start);
    const NumberEntry entry{.id = "transform number",
                            .label = about.label,
                            .format = format.c_str(),
                            .rules = {about.range},
                            .width_px = 140.0F * ui.theme.scale,
                            .live = true};
    if (whole) {
        int count = static_cast<int>(value);
        if (enter_whole(ui, entry, count)) number = count;
    } else if (enter_number(ui, entry, value)) {
        number = value;
    }
    note_item(ui.rects, "transform:number", shortest_digits(number.value_or(about.start)));
}

void draw_other(Ui& ui, const PatternSet& set, std::string& name) {
    draw_label(ui, "With");
    const float width = kTransformChoicePx * ui.theme.scale;
    ImGui::SetNextItemWidth(width);
    const float room = width - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const std::string shown = shortened(ui.theme.fonts.regular, name, room);
    if (ImGui::BeginCombo("##other", label_of(shown).c_str())) {
        for (const Vibration& vibration : set.vibrations) {
            if (ImGui::Selectable(label_of(vibration.name).c_str(), vibration.name == name)) {
                name = vibration.name;
            }
            note_item(ui.rects, "transform:other:" + vibration.name);
        }
        ImGui::EndCombo();
    }
    note_item(ui.rects, "transform:other", name);
}

std::string sentence_of(const char* help) {
    std::string words = std::string(help) + ".";
    if (words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
}

// "; the notes become a curve; 8 points, 2 ticks"
std::string change_words(const VibrationSource& from, const VibrationSource& to) {
    if (const auto* layered = std::get_if<LayeredPattern>(&to)) {
        return "; " + counted(layered->layers.size(), "layer", "layers");
    }
    const auto* after = std::get_if<Pattern>(&to);
    if (after == nullptr) {
        return std::holds_alternative<Measurement>(from) ? "" : "; it becomes samples";
    }
    const auto* before = std::get_if<Pattern>(&from);
    const bool had_notes = before != nullptr && !before->rhythm.text.empty();
    std::string words;
    if (had_notes && after->rhythm.text.empty()) words += "; the notes become a curve";
    const std::size_t points = after->amplitude_curve.size() + after->frequency_curve.size();
    if (points > 0) words += "; " + counted(points, "point", "points");
    const std::size_t ticks = after->transients.size();
    if (ticks > 0) words += ", " + counted(ticks, "tick", "ticks");
    return words;
}

// "1 s becomes 2 s; 8 points, 2 ticks."
std::string outcome(const Transformed& made) {
    if (!can_be_applied(made)) return made.fault;
    if (made.after.size() > 1) {
        const std::size_t ready = made.after.size() - made.left;
        std::string words =
            counted(ready, "pattern", "patterns") + (ready == 1 ? " is ready" : " are ready");
        if (made.left > 0)
            words += ", " + std::to_string(made.left) + " cannot change: " + made.fault;
        return words + ".";
    }
    const Vibration& before = made.before.front();
    Vibration after = before;
    after.source = made.after.front();
    if (before.source == after.source) return "Nothing changes.";
    const double before_s = own_duration_s(before);
    const double after_s = own_duration_s(after);
    const std::string words = before_s == after_s
                                  ? significant_digits(after_s, 6) + " s as before"
                                  : significant_digits(before_s, 6) + " s becomes " +
                                        significant_digits(after_s, 6) + " s";
    return words + change_words(before.source, after.source) + ".";
}

void draw_outcome(Ui& ui, const TransformState& state, const Transformed* made) {
    if (made == nullptr && draw_failure(ui, "transform", state.job.failure())) return;
    const std::string words = made == nullptr ? "..." : outcome(*made);
    const bool failed = made != nullptr && made->left > 0;
    coloured_text(failed ? ui.theme.warning : ui.theme.text, words);
    note_item(ui.rects, "transform:outcome", words);
}

}  // namespace

void draw_transform_dialog(Ui& ui, Workspace& work, TransformState& state) {
    if (!begin_dialog(ui, "Transform", kTransformPx)) return;
    draw_kind(ui, state);
    const EditTraits& about = traits(state.kind);
    if (about.needs == EditNeeds::pattern) {
        draw_other(ui, work.document.set, state.other);
    } else if (about.needs != EditNeeds::nothing) {
        draw_number(ui, about, state.numbers[static_cast<std::size_t>(state.kind)]);
    }
    coloured_text(ui.theme.dim_text, sentence_of(about.help));
    ImGui::Spacing();
    draw_label(ui, "Changes");
    wrapped_text(transformed_words(work));
    note_item(ui.rects, "transform:changes", transformed_words(work));
    const std::string obstacle = transform_obstacle(work, state);
    const auto made = current_transform(work, state);
    if (!obstacle.empty()) {
        coloured_text(ui.theme.dim_text, obstacle);
        note_item(ui.rects, "transform:obstacle", obstacle);
    } else {
        draw_outcome(ui, state, made.get());
    }
    const bool ready = made != nullptr && can_be_applied(*made);
    if (draw_ends(ui, "Apply", ready)) apply_transform(ui, work, state, *made);
}

}  // namespace tact
