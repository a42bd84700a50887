// The middle column: the selected vibration, what of it the receptors can feel, and what becomes
// of it in the model.

#include <cstdio>

#include "app/editing.h"
#include "app/panels/panels.h"
#include "app/widgets.h"
#include "viz/marks.h"
#include "viz/spectrum_view.h"
#include "viz/wave_view.h"

namespace tact {

namespace {

// What the model made of the shown vibration; `current` while it is of its present value.
struct Coded {
    const LiveCode* live = nullptr;
    bool current = false;
};

Coded coded(const App& app, const Vibration& vibration) {
    if (!app.code) return {};
    const Vibration& known = app.code->request.vibration;
    // Another pattern's signals would be worse than none.
    if (known.name != vibration.name) return {};
    return {app.code.get(), known.source == vibration.source};
}

// A heading and the rectangle beneath it.
Rect section(App& app, const char* title, const char* detail, float height) {
    ImGui::PushFont(app.theme.fonts.small);
    ImGui::TextUnformatted(title);
    ImGui::SameLine();
    dim_text(app, detail);
    ImGui::PopFont();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect area = rect_at(corner, {ImGui::GetContentRegionAvail().x, height});
    note_rect(app.rects, std::string("view:") + title, area.min, area.max);
    return area;
}

void end_section(const App& app, const Rect& area) {
    ImGui::SetCursorScreenPos({area.min.x, area.max.y});
    ImGui::Dummy({area.width(), app.theme.gap_px * 0.5F});
}

void draw_wave_section(App& app, const Vibration& vibration, float height) {
    const Rect area = section(app, "Acceleration", "at the skin", height);
    const Waveform& waveform = cached_waveform(app.cache, vibration);
    const WaveTrace trace{waveform.samples_g, waveform.rate_hz,
                          look_of(app, app.selection.current).colour};
    WaveScene scene;
    scene.traces = {&trace, 1};
    scene.end_s = std::max(duration_s(waveform), 1e-3);
    draw_wave("wave", app.theme, area, scene);
    end_section(app, area);
}

void draw_spectrum_section(App& app, const Vibration& vibration, float height) {
    const Rect area = section(app, "Displacement", "over the receptors' thresholds", height);
    const NeuralCodingParams& params = app.document.set.model.coding;
    SpectrumScene scene;
    scene.components = cached_components(app.cache, vibration, params);
    scene.thresholds = &params.tables.threshold;
    scene.colour = app.theme.text;
    draw_spectrum("spectrum", app.theme, area, scene);
    end_section(app, area);
}

float card_height(const App& app) {
    return 3.0F * (ImGui::GetTextLineHeight() + 2.0F * app.theme.scale);
}

void draw_receptor_card(App& app, const Rect& area, Receptor receptor, const Coded& coded) {
    const Theme& theme = app.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float s = theme.scale;
    const ReceptorTraits& type = traits(receptor);
    draw_receptor_mark(list, theme, {area.min.x + 8.0F * s, area.min.y + 9.0F * s}, 5.0F * s,
                       receptor);
    draw_text(list, theme.fonts.semibold, {area.min.x + 20.0F * s, area.min.y}, theme.text,
              shortened(theme.fonts.semibold, type.name, area.width() - 20.0F * s));
    std::string rate = "computing";
    std::string reach;
    if (coded.live != nullptr) {
        const std::size_t c = index_of(receptor);
        const Activation& activation = coded.live->code->neural.activation[c];
        char text[96];
        if (activation.rate_hz > 0.0) {
            std::snprintf(text, sizeof text, "%.0f imp/s", activation.rate_hz);
            rate = text;
            std::snprintf(text, sizeof text, "%zu within %.1f mm",
                          coded.live->code->neural.activated[c], activation.radius_mm);
            reach = text;
        } else {
            rate = "below threshold";
        }
    }
    const float line = ImGui::GetTextLineHeight() + 2.0F * s;
    draw_text(list, theme.fonts.regular, {area.min.x, area.min.y + line}, theme.text,
              shortened(theme.fonts.regular, rate, area.width()));
    draw_text(list, theme.fonts.small, {area.min.x, area.min.y + 2.0F * line}, theme.dim_text,
              shortened(theme.fonts.small, reach, area.width()));
    note_rect(app.rects, std::string("receptor:") + type.name, area.min, area.max, rate);
}

void draw_receptor_section(App& app, const Coded& coded) {
    const float height = card_height(app);
    const Rect area =
        section(app, "Receptors", "mean rate at the probe, how many, how far", height);
    const float gap = app.theme.gap_px;
    const float width = (area.width() - 3.0F * gap) / 4.0F;
    for (const Receptor receptor : kReceptors) {
        const float left = area.min.x + static_cast<float>(index_of(receptor)) * (width + gap);
        draw_receptor_card(app, rect_at({left, area.min.y}, {width, height}), receptor, coded);
    }
    if (coded.live != nullptr && !coded.current) {
        draw_stale(*ImGui::GetWindowDrawList(), app.theme, area, 0.0);
    }
    end_section(app, area);
}

// A signal drawn as an area, from zero up.
struct FilledSection {
    const char* title;
    const char* detail;
    float height;
    std::span<const double> samples;
    double largest;  // value at the upper edge; 0: the largest sample
    bool time_axis;
};

void draw_filled_section(App& app, const FilledSection& filled, bool stale) {
    const Rect area = section(app, filled.title, filled.detail, filled.height);
    const WaveTrace trace{filled.samples, kModelRateHz, app.theme.dim_text, TraceStyle::filled};
    WaveScene scene;
    scene.traces = {&trace, 1};
    scene.end_s = std::max(static_cast<double>(filled.samples.size()) / kModelRateHz, 1e-3);
    scene.largest = filled.largest;
    scene.signed_values = false;
    scene.unit = "";
    scene.time_axis = filled.time_axis;
    scene.stale = stale;
    draw_wave(filled.title, app.theme, area, scene);
    end_section(app, area);
}

}  // namespace

void draw_vibration_panel(App& app) {
    const Vibration* vibration = current_vibration(app);
    if (vibration == nullptr) {
        draw_empty(*ImGui::GetWindowDrawList(), app.theme, rest_of_pane(), "No vibration to show",
                   "Select a pattern on the left, or press New there.");
        return;
    }
    draw_hint(app, "vibration",
              "From top to bottom: the vibration, what each receptor type can feel of it, and the "
              "two signals the prediction compares.");
    const Coded now = coded(app, *vibration);
    // Five headings and the cards have their size; the plots share the rest.
    const ImGuiStyle& style = ImGui::GetStyle();
    const float heading =
        app.theme.fonts.small->FontSize + 2.0F * style.ItemSpacing.y + 0.5F * app.theme.gap_px;
    const float left = ImGui::GetContentRegionAvail().y - 5.0F * heading - card_height(app);
    const float unit = std::max(left, 240.0F * app.theme.scale) / 100.0F;
    draw_wave_section(app, *vibration, 30.0F * unit);
    draw_spectrum_section(app, *vibration, 38.0F * unit);
    draw_receptor_section(app, now);
    if (now.live == nullptr) return;
    double largest = 0.0;
    for (const double weight : now.live->request.model.channel_weight) largest += weight;
    draw_filled_section(app,
                        {.title = "Brain waveform",
                         .detail = "predicted, weighted sum of four channels (NC)",
                         .height = 14.0F * unit,
                         .samples = now.live->brain_waveform,
                         .largest = largest,
                         .time_axis = false},
                        !now.current);
    draw_filled_section(app,
                        {.title = "Rhythm envelope",
                         .detail = "10 ms mean (OC)",
                         .height = 18.0F * unit,
                         .samples = now.live->code->envelope,
                         .largest = 0.0,
                         .time_axis = true},
                        !now.current);
}

}  // namespace tact
