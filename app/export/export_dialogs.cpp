// The dialogs before an export, and the progress of an animation.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/export/parts.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr Range kPixels{64.0, 8192.0};
constexpr Range kTextScale{0.75, 4.0};

const char* label_of(PictureView view) {
    switch (view) {
        case PictureView::window:
            return "Window";
        case PictureView::physiology:
            return "Physiology";
        case PictureView::space:
            return "Space";
        case PictureView::matrix:
            return "Matrix";
        case PictureView::table:
            return "Table";
        case PictureView::subset:
            return "Subset";
        case PictureView::compare:
            return "Compare";
        case PictureView::why:
            return "Why";
    }
    return "";
}

// A size that suits the view; a person who set another one sets it again for another view.
void suit(PictureSize& size, PictureView view, bool pair) {
    const bool upright = view == PictureView::physiology;
    const bool wide = view == PictureView::window;
    size.width = wide ? 1600 : 1000;
    size.height = wide ? 1000 : upright && pair ? 1800 : upright ? 1200 : 900;
}

void draw_views(Ui& ui, const Workspace& work, std::span<const PictureView> views,
                PictureView& chosen, PictureSize& size) {
    draw_label(ui, "View");
    for (const PictureView view : views) {
        if (view == PictureView::table) {  // two rows of four
            ImGui::NewLine();
            draw_label(ui, "");
        }
        const bool is_chosen = chosen == view;
        const Item item{.id = std::string("export view:") + name_of(view),
                        .label = label_of(view),
                        .value = is_chosen ? "chosen" : ""};
        if (toggle(ui, item, is_chosen) && !is_chosen) {
            chosen = view;
            suit(size, view, !work.selection.pinned.empty());
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    }
    ImGui::NewLine();
}

NumberEntry entry_of(const Ui& ui, const char* id, const char* label, Range allowed) {
    return {.id = id,
            .label = label,
            .format = "%.6g",
            .rules = {allowed},
            .width_px = 90.0F * ui.theme.scale};
}

// Sizes of screens and projectors.
void draw_presets(Ui& ui, PictureSize& size) {
    struct Preset {
        const char* name;
        int width;
        int height;
        float scale;
    };
    constexpr std::array<Preset, 3> kPresets{{{"1280 \u00d7 720", 1280, 720, 1.0F},
                                              {"1920 \u00d7 1080", 1920, 1080, 1.5F},
                                              {"3840 \u00d7 2160", 3840, 2160, 3.0F}}};
    draw_label(ui, "16:9");
    for (const Preset& preset : kPresets) {
        const bool lit = size.width == preset.width && size.height == preset.height;
        const Item item{.id = "export preset:" + std::to_string(preset.height),
                        .label = preset.name};
        if (toggle(ui, item, lit)) {
            size.width = preset.width;
            size.height = preset.height;
            size.scale = preset.scale;
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    }
    ImGui::NewLine();
}

void draw_size(Ui& ui, const Workspace& work, PictureView view, PictureSize& size) {
    draw_label(ui, "Size");
    if (is_reset_asked(ui)) suit(size, view, !work.selection.pinned.empty());
    enter_whole(ui, entry_of(ui, "width", "Width", kPixels), size.width);
    note_item(ui.rects, "export:width", std::to_string(size.width));
    ImGui::SameLine();
    dim_text(ui, "\u00d7");
    ImGui::SameLine();
    enter_whole(ui, entry_of(ui, "height", "Height", kPixels), size.height);
    note_item(ui.rects, "export:height", std::to_string(size.height));
    ImGui::SameLine();
    dim_text(ui, "pixels");
    draw_presets(ui, size);
    draw_label(ui, "Text");
    double scale = static_cast<double>(size.scale);
    if (reset_by_label(ui, 1.0, scale)) size.scale = PictureSize{}.scale;
    if (enter_number(ui, entry_of(ui, "scale", "Text", kTextScale), scale)) {
        size.scale = static_cast<float>(scale);
    }
    note_item(ui.rects, "export:scale", std::to_string(size.scale));
    ImGui::SameLine();
    dim_text(ui, "times as large as usual");
}

void draw_view_dialog(Ui& ui, const Workspace& work, ExportState& exports) {
    if (!begin_dialog(ui, kExportViewDialog)) return;
    draw_views(ui, work, kPictureViews, exports.view, exports.picture_size);
    draw_size(ui, work, exports.view, exports.picture_size);
    dim_text(ui, "PNG for pixels, SVG to magnify and to edit: chosen beside the file's name.");
    if (!draw_ends(ui, "Choose a file...", true)) return;
    choose_picture(ui, work, exports);
}

void draw_seconds(Ui& ui, const Workspace& work, const char* id, const char* label, double normal,
                  double& value) {
    draw_label(ui, label);
    reset_by_label(ui, normal, value);
    NumberEntry entry = entry_of(ui, id, label, {0.0, shown_duration_s(work)});
    entry.rules.unit = "s";
    enter_number(ui, entry, value);
    note_item(ui.rects, std::string("export:") + id, std::to_string(value));
    ImGui::SameLine();
    dim_text(ui, "s");
}

constexpr const char* label_of(std::optional<FilmFormat> film) {
    if (!film) return "Pictures in a folder";
    return *film == FilmFormat::gif ? "GIF" : *film == FilmFormat::apng ? "APNG" : "MP4";
}

void draw_formats(Ui& ui, ExportState& exports) {
    struct Format {
        std::optional<FilmFormat> film;
        const char* tip;
    };
    constexpr std::array<Format, 4> kFormats{
        {{FilmFormat::gif, "Plays everywhere; 255 colours a picture"},
         {FilmFormat::apng, "Every colour; plays in browsers and slides"},
         {FilmFormat::mp4, "Made by ffmpeg, where that is installed"},
         {{}, ""}}};
    draw_label(ui, "As");
    for (const auto& [film, tip] : kFormats) {
        const char* name = label_of(film);
        const bool chosen = exports.film == film;
        const Item item{.id = std::string("export as:") + name,
                        .label = name,
                        .tip = tip,
                        .value = chosen ? "chosen" : ""};
        if (toggle(ui, item, chosen)) exports.film = film;
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    }
    ImGui::NewLine();
}

double frames_per_s(const ExportState& exports) {
    return exports.film ? kFilmFileFramesPerS : kFilmFramesPerS;
}

// How many times slower than life, which says how many frames there are, and the other way round.
void draw_slower(Ui& ui, ExportState& exports) {
    const double length_s = exports.to_s - exports.from_s;
    if (length_s <= 0.0) return;
    draw_label(ui, "Slower");
    double slower = exports.frames / (frames_per_s(exports) * length_s);
    NumberEntry entry = entry_of(ui, "slower", "Slower", {0.01, 10'000.0});
    if (enter_number(ui, entry, slower)) {
        exports.frames = frames_of(length_s, slower, frames_per_s(exports));
    }
    note_item(ui.rects, "export:slower", significant_digits(slower, 4));
    ImGui::SameLine();
    dim_text(ui, "times slower than life");
}

void draw_animation_dialog(Ui& ui, const Workspace& work, ExportState& exports) {
    if (!begin_dialog(ui, kExportAnimationDialog)) return;
    constexpr std::array<PictureView, 2> kMoving{PictureView::physiology, PictureView::window};
    draw_views(ui, work, kMoving, exports.moving_view, exports.frame_size);
    draw_seconds(ui, work, "from", "From", 0.0, exports.from_s);
    draw_seconds(ui, work, "to", "To", shown_duration_s(work), exports.to_s);
    draw_slower(ui, exports);
    draw_label(ui, "Frames");
    reset_by_label(ui, ExportState{}.frames, exports.frames);
    enter_whole(ui, entry_of(ui, "frames", "Frames", {1.0, kMostFrames}), exports.frames);
    note_item(ui.rects, "export:frames", std::to_string(exports.frames));
    const double duration_s = shown_duration_s(work);
    const bool is_good = exports.from_s >= 0.0 && exports.from_s < exports.to_s &&
                         exports.to_s <= duration_s && exports.frames >= 1 &&
                         exports.frames <= kMostFrames;
    const std::string text =
        is_good
            ? "a film of " + significant_digits(exports.frames / frames_per_s(exports), 3) + " s"
            : "times from 0 to " + significant_digits(duration_s, 4) + " s, frames from 1 to " +
                  std::to_string(kMostFrames);
    ImGui::SameLine();
    dim_text(ui, text);
    draw_size(ui, work, exports.moving_view, exports.frame_size);
    draw_formats(ui, exports);
    const PictureSize& size = exports.frame_size;
    const std::string even =
        exports.film ? film_size_words(*exports.film, {size.width, size.height}) : "";
    if (!even.empty()) {
        draw_label(ui, "");
        coloured_text(ui, ui.theme.warning,
                      {.id = "export:even", .text = "The film has " + even + ".", .value = even});
    }
    const char* choose = exports.film ? "Choose a file..." : "Choose a folder...";
    if (!draw_ends(ui, choose, is_good)) return;
    choose_frames(ui, work, exports);
}

}  // namespace

void draw_exports(Ui& ui, const Workspace& work, ExportState& exports) {
    draw_view_dialog(ui, work, exports);
    draw_animation_dialog(ui, work, exports);
    draw_effect_dialog(ui, work, exports.effects);
    if (exports.animation) draw_export_progress(ui, exports);
}

}  // namespace tact
