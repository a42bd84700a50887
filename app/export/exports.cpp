#include "app/export/exports.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/physiology/stage_csv.h"
#include "app/session/folders.h"
#include "app/timeline/time_rows.h"
#include "app/ui/file_question.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// Names of sets and patterns may hold anything; files may not.
std::string file_word(std::string text) {
    std::ranges::replace(text, '/', '-');
    if (text.starts_with('.')) text.front() = '-';
    return text;
}

std::string set_word(const App& app) {
    const std::string& name = app.document.set.name;
    return file_word(name.empty() ? "untitled" : name);
}

std::vector<Stage> stages_to_export(const App& app) {
    if (app.physiology.open) return {*app.physiology.open};
    return {kStages.begin(), kStages.end()};
}

// ", as a Joy-Con plays them, uncalibrated": goes with every number of what a device plays.
std::string as_played(const App& app) {
    const std::string words = rendered_words(app.rendering);
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
    }
    return "";
}

void export_view_dialog(App& app) { app.dialog = Dialog::export_view; }

void export_animation_dialog(App& app) {
    const double duration_s = shown_duration_s(app);
    ExportState& state = app.exports;
    if (state.to_s <= 0.0 || state.to_s > duration_s) state.to_s = duration_s;
    if (state.from_s >= state.to_s) state.from_s = 0.0;
    app.dialog = Dialog::export_animation;
}

void export_stages_dialog(App& app) {
    std::vector<std::string> written;
    for (const Stage stage : stages_to_export(app)) {
        for (std::string& name : stage_csv_names(stage)) written.push_back(std::move(name));
    }
    const auto open = app.physiology.open;
    ask_for_file(
        app,
        {.purpose = ChooserPurpose::export_stages,
         .use = ChooserUse::save_folder,
         .title = open ? std::string("Export \"") + text_of(*open).name + "\" as CSV into a folder"
                       : "Export all stages as CSV into a folder",
         .extensions = {".csv"},
         .folders_too = true,
         .file_names = std::move(written)},
        app.document.path.parent_path(),
        file_word(current_vibration(app)->name) + " stages" + as_played(app));
}

void choose_picture(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::export_view,
                  .use = ChooserUse::save,
                  .title = "Export the view as a picture, .png or .svg",
                  .extensions = {".png", ".svg"}},
                 app.document.path.parent_path(),
                 set_word(app) + " " + name_of(app.exports.view) + ".png");
}

void choose_frames(App& app) {
    if (current_vibration(app) == nullptr) return;
    ask_for_file(app,
                 {.purpose = ChooserPurpose::export_animation,
                  .use = ChooserUse::save_folder,
                  .title = "Export the animation as pictures into a folder",
                  .extensions = {".png"},
                  .folders_too = true,
                  .file_names = {path_of_frame({}, 0).string()}},
                 app.document.path.parent_path(),
                 file_word(current_vibration(app)->name) + " frames");
}

void export_view(App& app, const fs::path& file) { app.exports.picture = file; }

void export_stages(App& app, const fs::path& folder) {
    if (current_vibration(app) == nullptr) return;
    if (const auto made = make_folder(folder); !made) return complain(app, made.error().message);
    const PatternSet& set = app.document.set;
    // What is on the screen.
    Waveform played = waveform_of(*current_vibration(app));
    if (const auto by = rendered_by(app.rendering)) played = rendering(*by, played).waveform;
    const Waveform waveform = padded(played, longest_samples(set));
    const StageValues values = stage_values(waveform, set.model);
    std::size_t count = 0;
    for (const Stage stage : stages_to_export(app)) {
        for (const CsvFile& file : stage_csv(values, stage)) {
            const auto written = write_atomically(folder / file.name, file.text);
            if (!written) return complain(app, "Not exported: " + written.error().message);
            ++count;
        }
    }
    say(app, "Exported " + std::to_string(count) + (count == 1 ? " file" : " files") + " into " +
                 folder.string() + as_played(app));
}

}  // namespace tact
