#include "app/export/exports.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/document/folders.h"
#include "app/physiology/stage_csv.h"
#include "app/subset/subset_export.h"
#include "app/subset/subset_state.h"
#include "app/timeline/time_rows.h"
#include "app/ui/file_question.h"
#include "app/window/view_pictures.h"
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

void draw_waiting_picture(App& app) {
    const fs::path file = std::exchange(app.exports.picture, {});
    PictureSize size = app.exports.picture_size;
    size.dark = app.dark;
    size.format = extension_of(file) == ".svg" ? PictureFormat::svg : PictureFormat::png;
    App still = still_view(app);
    const Picture picture = view_picture(still, app.exports.view, app.playhead.at_s, size);
    if (const Expected<Done> written = write_picture(file, picture); !written) {
        return complain(app, "Not exported: " + written.error().message);
    }
    say(app, "Exported " + file.string());
}

void draw_next_frame(App& app) {
    RunningAnimation& running = *app.exports.animation;
    const FrameSequence& sequence = running.sequence;
    const Picture picture = view_picture(running.still, running.view,
                                         time_of_frame_s(sequence, running.done), running.size);
    const auto written = write_picture(path_of_frame(sequence, running.done), picture);
    if (!written) {
        complain(app, "Export stopped: " + written.error().message);
        app.exports.animation.reset();
        return;
    }
    if (++running.done < sequence.frames) return;
    say(app, "Exported " + std::to_string(sequence.frames) + " frames. A film: " +
                 film_command(sequence.folder, running.size.width, running.size.height));
    app.exports.animation.reset();
}

}  // namespace

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

void export_animation(App& app, const fs::path& folder) {
    const ExportState& state = app.exports;
    const FrameSequence sequence{folder, state.from_s, state.to_s, state.frames};
    if (const Expected<Done> open = open_sequence(sequence); !open) {
        return complain(app, "Not exported: " + open.error().message);
    }
    PictureSize size = state.frame_size;
    size.dark = app.dark;
    app.exports.animation = std::make_shared<RunningAnimation>(
        RunningAnimation{still_view(app), state.moving_view, size, sequence, 0, app.time_s});
}

void cancel_animation(App& app) {
    const RunningAnimation& running = *app.exports.animation;
    say(app, "Export cancelled: " + std::to_string(running.done) + " of " +
                 std::to_string(running.sequence.frames) + " frames are in " +
                 running.sequence.folder.string());
    app.exports.animation.reset();
}

bool is_exporting(const App& app) {
    return app.exports.animation != nullptr || !app.exports.picture.empty() ||
           !app.subset->export_to.empty();
}

void continue_exports(App& app) {
    if (!app.subset->export_to.empty()) return continue_subset_export(app);
    if (!app.exports.picture.empty()) return draw_waiting_picture(app);
    if (app.exports.animation) draw_next_frame(app);
}

}  // namespace tact
