#include "app/export/export.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/export/parts.h"
#include "app/physiology/physiology.h"
#include "app/progress/progress.h"
#include "app/session/session.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

std::string set_word(const Workspace& work) {
    const std::string& name = work.document.set.name;
    return file_stem(name.empty() ? "untitled" : name);
}

std::vector<Stage> stages_to_export(const Physiology& physiology) {
    if (physiology.view.open) return {*physiology.view.open};
    return {kStages.begin(), kStages.end()};
}

// ", as a Joy-Con plays them, uncalibrated": goes with every number of what a device plays.
std::string as_played(const RenderingState& rendered) {
    const std::string words = rendered_words(rendered);
    return words.empty() ? "" : ", " + words;
}

}  // namespace

const char* name_of(PictureView view) {
    switch (view) {
        case PictureView::window:
            return "window";
        case PictureView::physiology:
            return "physiology";
        case PictureView::space:
            return "space";
        case PictureView::matrix:
            return "matrix";
        case PictureView::table:
            return "table";
        case PictureView::subset:
            return "subset";
        case PictureView::compare:
            return "compare";
        case PictureView::why:
            return "why";
    }
    return "";
}

void export_view_dialog(Ui& ui) { ui.dialog = kExportViewDialog; }

void export_animation_dialog(Ui& ui, const Workspace& work, ExportState& exports) {
    const double duration_s = shown_duration_s(work);
    if (exports.to_s <= 0.0 || exports.to_s > duration_s) exports.to_s = duration_s;
    if (exports.from_s >= exports.to_s) exports.from_s = 0.0;
    ui.dialog = kExportAnimationDialog;
}

void export_stages_dialog(Ui& ui, const Workspace& work, const RenderingState& rendered,
                          const Physiology& physiology) {
    std::vector<std::string> written;
    for (const Stage stage : stages_to_export(physiology)) {
        for (std::string& name : stage_csv_names(stage)) written.push_back(std::move(name));
    }
    const auto open = physiology.view.open;
    ask_for_file(
        ui,
        {.use = ChooserUse::save_folder,
         .title = open ? std::string("Export \"") + text_of(*open).name + "\" as CSV into a folder"
                       : "Export all stages as CSV into a folder",
         .extensions = {".csv"},
         .folders_too = true,
         .file_names = std::move(written),
         .take =
             [&](const fs::path& folder) {
                 export_stages(ui, work, rendered, physiology, folder);
             }},
        work.document.path.parent_path(),
        file_stem(current_vibration(work)->name) + " stages" + as_played(rendered));
}

void choose_picture(Ui& ui, const Workspace& work, ExportState& exports) {
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Export the view as a picture, .png or .svg",
                  .extensions = {".png", ".svg"},
                  .take = [&](const fs::path& file) { exports.picture = file; }},
                 work.document.path.parent_path(),
                 set_word(work) + " " + name_of(exports.view) + ".png");
}

void choose_frames(Ui& ui, const Workspace& work, ExportState& exports) {
    if (current_vibration(work) == nullptr) return;
    if (exports.film) {
        const std::string ending = ending_of(*exports.film);
        return ask_for_file(ui,
                            {.use = ChooserUse::save,
                             .title = "Export the animation as one file",
                             .extensions = {ending},
                             .take = [&](const fs::path& path) { exports.animation_to = path; }},
                            work.document.path.parent_path(),
                            file_stem(current_vibration(work)->name) + ending);
    }
    ask_for_file(ui,
                 {.use = ChooserUse::save_folder,
                  .title = "Export the animation as pictures into a folder",
                  .extensions = {".png"},
                  .folders_too = true,
                  .file_names = {path_of_frame({}, 0).string()},
                  .take = [&](const fs::path& path) { exports.animation_to = path; }},
                 work.document.path.parent_path(),
                 file_stem(current_vibration(work)->name) + " frames");
}

void export_stages(Ui& ui, const Workspace& work, const RenderingState& rendered,
                   const Physiology& physiology, const fs::path& folder) {
    if (current_vibration(work) == nullptr) return;
    if (const auto made = make_folder(folder); !made) return complain(ui, made.error().message);
    const PatternSet& set = work.document.set;
    // What is on the screen.
    Waveform played = waveform_of(*current_vibration(work));
    if (const auto by = rendered_by(rendered)) played = rendering(*by, played).waveform;
    const Waveform waveform = padded(played, longest_samples(set));
    const StageValues values = stage_values(waveform, set.model);
    std::size_t count = 0;
    for (const Stage stage : stages_to_export(physiology)) {
        for (const CsvFile& file : stage_csv(values, stage)) {
            const auto written = write_atomically(folder / file.name, file.text);
            if (!written) return complain(ui, "Not exported: " + written.error().message);
            ++count;
        }
    }
    say(ui, "Exported " + std::to_string(count) + (count == 1 ? " file" : " files") + " into " +
                folder.string() + as_played(rendered));
}

namespace {

std::string time_left(const Ui& ui, const RunningAnimation& running) {
    const double share = static_cast<double>(running.done) / running.sequence.frames;
    const std::string left = time_left_text(ui.time_s - running.begun_s, share);
    return left.empty() ? "" : ", " + left;
}

}  // namespace

bool draw_progress_plate(Ui& ui, const ProgressPlate& plate) {
    const Theme& theme = ui.theme;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - theme.padding_px, screen.y - 34.0F * theme.scale},
                            ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme.field);
    bool cancelled = false;
    if (ImGui::Begin("export progress", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        plain_text(ui, {.id = "export progress", .text = plate.text});
        if (plate.share) {
            ImGui::ProgressBar(*plate.share, {240.0F * theme.scale, 6.0F * theme.scale}, "");
        }
        cancelled = button(
            ui,
            {.id = "button:" + lower_case(plate.cancel), .label = plate.cancel, .tip = plate.told});
    }
    ImGui::End();
    ImGui::PopStyleColor();
    return cancelled;
}

void draw_export_progress(Ui& ui, ExportState& exports) {
    const RunningAnimation& running = *exports.animation;
    exports.cancel_asked |= draw_progress_plate(
        ui,
        {.text = "Drawing frame " + std::to_string(running.done + 1) + " of " +
                 std::to_string(running.sequence.frames) + time_left(ui, running),
         .share = static_cast<float>(running.done) / static_cast<float>(running.sequence.frames),
         .cancel = "Cancel export",
         .told =
             running.film ? "No file is written (Esc)" : "Keeps the frames that are drawn (Esc)"});
}

}  // namespace tact
