#include "app/pictures/pictures.h"

#include <algorithm>

#include "app/document/workspace.h"
#include "app/pictures/parts.h"
#include "app/rendering/rendering.h"
#include "model/signal/spectrum.h"
#include "model/text/numbers.h"
#include "viz/charts/matrix_view.h"
#include "viz/charts/spectrum_view.h"
#include "viz/charts/wave_view.h"
#include "viz/drawing/marks.h"
#include "viz/picture/svg.h"

namespace tact {

namespace {

std::string after_comma(const std::string& mark) { return mark.empty() ? "" : ", " + mark; }

void draw_map(const Theme& theme, const Rect& area, const PatternSet& set, const char* id,
              const std::vector<std::string>& names, const MapPanel& panel) {
    std::vector<PatternLook> looks;
    for (std::size_t k = 0; k < names.size(); ++k) looks.push_back(look_of(theme, set, k));
    const SpaceMarks& marks = panel.marks;
    SpaceScene scene;
    scene.labels = names;
    scene.looks = looks;
    scene.points = &panel.space->points;
    scene.chosen = marks.chosen;
    scene.links = marks.links;
    scene.paths = marks.paths;
    scene.ghosts = marks.before;
    scene.ghost_opacity = 1.0;
    scene.arrows = true;
    scene.dissimilarity = [apart = panel.apart](std::size_t i, std::size_t j) {
        return (*apart)(i, j);
    };
    scene.quantity = marks.quantity;
    SpaceCamera camera;
    draw_space(id, theme, area, scene, camera);
}

std::string stress_text(const PerceptualSpace& space) {
    return "stress-1 " + with_decimals(space.stress1, 3) + ", " + fit_label(space);
}

// Mark and name of every pattern, in as many columns as fit; the rest of the area above.
Rect draw_legend(const Theme& theme, const Rect& area, const PatternSet& set) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::vector<std::string> names = names_of(set);
    float widest = 0.0F;
    for (const std::string& name : names) {
        widest = std::max(widest, text_size(theme.fonts.small, name).x);
    }
    const float column_px = 3.0F * theme.mark_px + widest + 2.0F * theme.gap_px;
    const auto columns = std::clamp<std::size_t>(static_cast<std::size_t>(area.width() / column_px),
                                                 1, std::max<std::size_t>(names.size(), 1));
    const std::size_t rows = (names.size() + columns - 1) / columns;
    const float row_px = 1.3F * text_size(theme.fonts.small, "L").y;
    const float top = area.max.y - row_px * static_cast<float>(rows);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::size_t row = k / columns;
        const ImVec2 at{area.min.x + column_px * static_cast<float>(k % columns),
                        top + row_px * static_cast<float>(row)};
        draw_pattern_mark(list, theme, {at.x + theme.mark_px, at.y + 0.4F * row_px}, theme.mark_px,
                          look_of(theme, set, k), theme.pane);
        draw_text(list, theme.fonts.small, {at.x + 3.0F * theme.mark_px, at.y}, theme.text,
                  names[k]);
    }
    return {area.min, {area.max.x, top - theme.gap_px}};
}

}  // namespace

PictureOptions options_of(const PictureSize& size, std::string extra_text) {
    PictureOptions options;
    options.dark = size.dark;
    options.scale = size.scale;
    options.extra_text = std::move(extra_text);
    options.svg_ids = size.svg_ids;
    return options;
}

Rect whole_picture() { return rect_at(ImGui::GetWindowPos(), ImGui::GetWindowSize()); }

Rect draw_title(const Theme& theme, const std::string& title, const std::string& detail) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Rect area = inset(whole_picture(), 1.5F * theme.padding_px);
    draw_text(list, theme.fonts.semibold, area.min, theme.text, title);
    const float width = text_size(theme.fonts.semibold, title + "  ").x;
    draw_text(list, theme.fonts.regular, {area.min.x + width, area.min.y}, theme.dim_text,
              shortened(theme.fonts.regular, detail, area.width() - width));
    return {{area.min.x, area.min.y + 2.0F * ImGui::GetTextLineHeight()}, area.max};
}

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
    const std::string detail =
        (marks.source.empty() ? "predicted by " + marks.quantity : marks.source) + ", " +
        stress_text(space) +
        after_comma(marks.mark.empty() && marks.source.empty() ? phrase_of(mark_of(set))
                                                               : marks.mark);
    return drawn(size, options_of(size, drawn_text(set)), [&](const Theme& theme) {
        const Rect area =
            size.titled ? draw_title(theme, "Perceptual space", detail) : whole_picture();
        draw_map(theme, area, set, "space", names_of(set), {&pm, &space, marks});
    });
}

Picture space_panels_picture(const PatternSet& set, std::span<const MapPanel> panels,
                             const std::string& title, const std::string& detail,
                             const PictureSize& size) {
    return drawn(size, options_of(size, drawn_text(set) + title + detail), [&](const Theme& theme) {
        const Rect rest = draw_legend(theme, draw_title(theme, title, detail), set);
        const std::size_t columns = panel_columns(panels.size());
        const std::size_t rows = (panels.size() + columns - 1) / columns;
        const ImVec2 cell{rest.width() / static_cast<float>(columns),
                          rest.height() / static_cast<float>(std::max<std::size_t>(rows, 1))};
        const float title_px = 1.3F * text_size(theme.fonts.small, "L").y;
        // The legend has the names.
        const std::vector<std::string> no_names(set.vibrations.size());
        for (std::size_t k = 0; k < panels.size(); ++k) {
            const std::size_t row = k / columns;
            const ImVec2 corner{rest.min.x + cell.x * static_cast<float>(k % columns),
                                rest.min.y + cell.y * static_cast<float>(row)};
            const Rect place = inset(rect_at(corner, cell), 0.5F * theme.gap_px);
            const std::string said =
                panels[k].marks.quantity + ", " + stress_text(*panels[k].space);
            draw_text(*ImGui::GetWindowDrawList(), theme.fonts.small, place.min, theme.text,
                      shortened(theme.fonts.small, said, place.width()));
            draw_map(theme, {{place.min.x, place.min.y + title_px}, place.max}, set,
                     ("panel" + std::to_string(k)).c_str(), no_names, panels[k]);
        }
    });
}

std::size_t panel_columns(std::size_t panels) {
    return panels < 4 ? std::max<std::size_t>(panels, 1) : panels < 5 ? 2 : panels < 10 ? 3 : 4;
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
