#include "app/pictures/pictures.h"

#include <algorithm>
#include <cstdio>

#include "app/document/pattern_looks.h"
#include "app/rendering/labels.h"
#include "model/signal/spectrum.h"
#include "viz/charts/matrix_view.h"
#include "viz/charts/spectrum_view.h"
#include "viz/charts/wave_view.h"
#include "viz/drawing/marks.h"
#include "viz/picture/svg.h"

namespace tact {

namespace {

PictureOptions options_of(const PictureSize& size, std::string extra_text) {
    PictureOptions options;
    options.dark = size.dark;
    options.scale = size.scale;
    options.extra_text = std::move(extra_text);
    options.svg_ids = size.svg_ids;
    return options;
}

Rect whole() { return rect_at(ImGui::GetWindowPos(), ImGui::GetWindowSize()); }

// Title at the top left, a dim detail after it; what is left of the picture.
Rect draw_title(const Theme& theme, const std::string& title, const std::string& detail) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetWindowPos();
    const Rect area = inset(rect_at(corner, ImGui::GetWindowSize()), 1.5F * theme.padding_px);
    draw_text(list, theme.fonts.semibold, area.min, theme.text, title);
    const float width = text_size(theme.fonts.semibold, title + "  ").x;
    draw_text(list, theme.fonts.regular, {area.min.x + width, area.min.y}, theme.dim_text, detail);
    return {{area.min.x, area.min.y + 2.0F * ImGui::GetTextLineHeight()}, area.max};
}

std::string after_comma(const std::string& mark) { return mark.empty() ? "" : ", " + mark; }

}  // namespace

Picture drawn(const PictureSize& size, const PictureOptions& options,
              const std::function<void(const Theme&)>& draw) {
    if (size.format == PictureFormat::svg) {
        return Svg{draw_svg(size.width, size.height, options, draw)};
    }
    return draw_picture(size.width, size.height, options, draw);
}

Picture matrix_picture(const std::vector<std::string>& labels, const Dissimilarity& matrix,
                       const std::string& quantity, const PictureSize& size,
                       const std::string& mark) {
    std::string names;
    for (const std::string& label : labels) names += label;
    return drawn(size, options_of(size, names), [&](const Theme& theme) {
        const Rect area = draw_title(theme, quantity,
                                     "predicted dissimilarity of every pair" + after_comma(mark));
        MatrixScene scene;
        scene.condensed = matrix.condensed;
        scene.labels = labels;
        scene.quantity = quantity;
        draw_matrix("matrix", theme, area, scene);
    });
}

Picture space_picture(const PatternSet& set, const Dissimilarity& pm, const PerceptualSpace& space,
                      const PictureSize& size, const SpaceMarks& marks) {
    const std::vector<std::string> labels = names_of(set);
    char stress[64];
    std::snprintf(stress, sizeof stress, ", stress-1 %.3f, ", space.stress1);
    const std::string detail =
        (marks.source.empty() ? "predicted by " + marks.quantity : marks.source) + stress +
        fit_label(space) +
        after_comma(marks.mark.empty() && marks.source.empty() ? phrase_of(mark_of(set))
                                                               : marks.mark);
    return drawn(size, options_of(size, drawn_text(set)), [&](const Theme& theme) {
        const Rect area = size.titled ? draw_title(theme, "Perceptual space", detail) : whole();
        std::vector<PatternLook> looks;
        for (std::size_t k = 0; k < labels.size(); ++k) {
            looks.push_back(look_of(theme, set, k));
        }
        SpaceScene scene;
        scene.labels = labels;
        scene.looks = looks;
        scene.points = &space.points;
        scene.chosen = marks.chosen;
        scene.links = marks.links;
        scene.paths = marks.paths;
        scene.ghosts = marks.before;
        scene.ghost_opacity = 1.0;
        scene.arrows = true;
        scene.dissimilarity = [&pm](std::size_t i, std::size_t j) { return pm(i, j); };
        scene.quantity = marks.quantity;
        SpaceCamera camera;
        draw_space("space", theme, area, scene, camera);
    });
}

Picture wave_picture(const Vibration& vibration, const PictureSize& size) {
    const Waveform waveform = waveform_of(vibration);
    return drawn(size, options_of(size, vibration.name), [&](const Theme& theme) {
        const Rect area = draw_title(theme, vibration.name, "acceleration at the skin");
        const WaveTrace trace{waveform.samples_g, waveform.rate_hz, theme.series};
        WaveScene scene;
        scene.traces = {&trace, 1};
        scene.end_s = std::max(duration_s(waveform), 1e-3);
        draw_wave("wave", theme, area, scene);
    });
}

Picture spectrum_picture(const Vibration& vibration, const NeuralCodingParams& params,
                         const PictureSize& size) {
    const Waveform waveform = waveform_of(vibration);
    const std::vector<double> input =
        params.remove_mean ? without_mean(waveform.samples_g) : waveform.samples_g;
    const std::vector<Component> found =
        components(amplitude_spectrum(input, waveform.rate_hz), params);
    return drawn(size, options_of(size, vibration.name), [&](const Theme& theme) {
        const Rect area = draw_title(theme, vibration.name,
                                     "displacement over the receptors' "
                                     "thresholds");
        SpectrumScene scene;
        scene.components = found;
        scene.thresholds = &params.tables.threshold;
        scene.colour = theme.text;
        draw_spectrum("spectrum", theme, area, scene);
    });
}

Expected<Done> write_picture(const std::filesystem::path& path, const Picture& picture) {
    if (const auto* svg = std::get_if<Svg>(&picture)) return write_svg(path.string(), svg->text);
    return write_png(path.string(), std::get<Image>(picture));
}

}  // namespace tact
