// The least change of each number that people are taken to feel, with its source.

#include <cmath>

#include "app/document/editing.h"
#include "app/model_bench/felt_step_fields.h"
#include "app/model_bench/model_panel.h"
#include "app/ui/widgets.h"
#include "model/pattern/felt_steps.h"

namespace tact {

namespace {

// How a step is written: decibels of an amplitude, percent of a ratio, or the number's own unit.
struct StepWords {
    const char* format;
    Range slider;
    double (*shown)(double size);
    double (*size)(double shown);
};

StepWords words_of_step(PatternParameter parameter) {
    if (parameter == PatternParameter::amplitude) {
        return {"%.3g dB",
                {0.5, 6.0},
                [](double size) { return 20.0 * std::log10(size); },
                [](double db) { return std::pow(10.0, db / 20.0); }};
    }
    if (traits(parameter).by_ratio) {
        return {"%.3g %%",
                {2.0, 100.0},
                [](double size) { return 100.0 * (size - 1.0); },
                [](double percent) { return 1.0 + percent / 100.0; }};
    }
    const auto same = [](double value) { return value; };
    const bool is_time = *traits(parameter).unit != '\0';
    return {is_time ? "%.3g s" : "%.3g", {0.01, is_time ? 0.2 : 1.0}, same, same};
}

std::string source_text(PatternParameter parameter) {
    const FeltSource source = source_of_step(parameter);
    return std::string(source.is_guess ? "Guess: " : "Source: ") + source.words;
}

}  // namespace

void draw_felt_step_fields(Ui& ui, Workspace& work) {
    const FeltSteps usual;
    for (std::size_t k = 0; k < kPatternParameters.size(); ++k) {
        const PatternParameter parameter = kPatternParameters[k];
        const StepWords words = words_of_step(parameter);
        const std::string id = std::string("felt_step_") + traits(parameter).key;
        const std::string help =
            "The least change that people are taken to feel. " + source_text(parameter);
        const Range sizes = step_range(parameter);
        double shown = words.shown(work.document.set.felt_steps.size[k]);
        const FieldEdit edit =
            draw_field(ui,
                       {.id = id.c_str(),
                        .label = traits(parameter).name,
                        .format = words.format,
                        .slider = words.slider,
                        .typed = {words.shown(sizes.low), words.shown(sizes.high)},
                        .step = words.slider.low,
                        .help = help.c_str(),
                        .right_room_px = beside_field_px(ui),
                        .normal = words.shown(usual.size[k])},
                       shown);
        if (edit.changed) {
            work.document.edit().felt_steps.size[k] = words.size(shown);
            document_changed(work);
        }
        if (edit.finished) {
            commit_step(ui, work, std::string("Change felt step of ") + traits(parameter).name);
        }
        ImGui::PushFont(ui.theme.fonts.small);
        draw_label(ui, "", 200.0F * ui.theme.scale);
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, source_text(parameter));
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
}

}  // namespace tact
