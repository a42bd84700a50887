#include "app/window/animation.h"

#include <utility>

#include "app/document/editing.h"
#include "app/export/exports.h"
#include "app/subset/subset_export.h"
#include "app/subset/subset_state.h"
#include "app/window/view_pictures.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

void draw_waiting_picture(App& app) {
    const fs::path file = std::exchange(app.exports.picture, {});
    PictureSize size = app.exports.picture_size;
    size.dark = app.ui.dark;
    size.format = extension_of(file) == ".svg" ? PictureFormat::svg : PictureFormat::png;
    const auto still = still_view(app);
    const Picture picture =
        view_picture(*still, app.exports.view, app.timeline.playhead.at_s, size);
    if (const Expected<Done> written = write_picture(file, picture); !written) {
        return complain(app.ui, "Not exported: " + written.error().message);
    }
    say(app.ui, "Exported " + file.string());
}

void draw_next_frame(App& app) {
    RunningAnimation& running = *app.exports.animation;
    const FrameSequence& sequence = running.sequence;
    const Picture picture = view_picture(*running.still, running.view,
                                         time_of_frame_s(sequence, running.done), running.size);
    const auto written = write_picture(path_of_frame(sequence, running.done), picture);
    if (!written) {
        complain(app.ui, "Export stopped: " + written.error().message);
        app.exports.animation.reset();
        return;
    }
    if (++running.done < sequence.frames) return;
    say(app.ui, "Exported " + std::to_string(sequence.frames) + " frames. A film: " +
                    film_command(sequence.folder, running.size.width, running.size.height));
    app.exports.animation.reset();
}

}  // namespace

void export_animation(App& app, const fs::path& folder) {
    const ExportState& state = app.exports;
    const FrameSequence sequence{folder, state.from_s, state.to_s, state.frames};
    if (const Expected<Done> open = open_sequence(sequence); !open) {
        return complain(app.ui, "Not exported: " + open.error().message);
    }
    PictureSize size = state.frame_size;
    size.dark = app.ui.dark;
    app.exports.animation = std::make_shared<RunningAnimation>(
        RunningAnimation{still_view(app), state.moving_view, size, sequence, 0, app.ui.time_s});
}

void cancel_animation(App& app) {
    const RunningAnimation& running = *app.exports.animation;
    say(app.ui, "Export cancelled: " + std::to_string(running.done) + " of " +
                    std::to_string(running.sequence.frames) + " frames are in " +
                    running.sequence.folder.string());
    app.exports.animation.reset();
}

bool is_exporting(const App& app) {
    return app.exports.animation != nullptr || !app.exports.picture.empty() ||
           !app.picking.export_to.empty() || !app.exports.effects.export_to.empty();
}

void continue_exports(App& app) {
    if (!app.picking.export_to.empty() || !app.picking.report_to.empty()) {
        continue_subset_export(app.ui, app.work, app.shown_map, app.picking);
    }
    if (!app.exports.effects.export_to.empty())
        return continue_effect_export(app.ui, app.exports.effects);
    if (!app.exports.picture.empty()) return draw_waiting_picture(app);
    if (app.exports.animation) draw_next_frame(app);
}

}  // namespace tact
