#include "app/window/window.h"

#include <utility>

#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/lesson/lesson.h"
#include "app/pictures/pictures.h"
#include "app/subset/subset.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

void copy_view(App& app) {
    app.exports.copy_asked = false;
    PictureSize size = app.exports.picture_size;
    size.dark = app.ui.dark;
    const auto still = snapshot_of(app);
    const Picture picture =
        view_picture(*still, app.exports.view, app.timeline.playhead.at_s, size);
    if (const auto copied = copy_to_clipboard(std::get<Image>(picture)); !copied) {
        return complain(app.ui, copied.error().message + ".");
    }
    say(app.ui,
        std::string("The picture of the ") + name_of(app.exports.view) + " is on the clipboard.");
}

void draw_waiting_picture(App& app) {
    const fs::path file = std::exchange(app.exports.picture, {});
    PictureSize size = app.exports.picture_size;
    size.dark = app.ui.dark;
    size.format = extension_of(file) == ".svg" ? PictureFormat::svg : PictureFormat::png;
    const auto still = snapshot_of(app);
    const Picture picture =
        view_picture(*still, app.exports.view, app.timeline.playhead.at_s, size);
    if (const Expected<Done> written = write_picture(file, picture); !written) {
        return complain(app.ui, "Not exported: " + written.error().message);
    }
    say(app.ui, "Exported " + file.string());
}

void finish_film(App& app) {
    const RunningAnimation running = *std::exchange(app.exports.animation, nullptr);
    if (const Expected<Done> done = finish(*running.film); !done) {
        return complain(app.ui, "Not exported: " + done.error().message);
    }
    const std::string& size = running.another_size;
    say(app.ui, "Exported " + running.film->path.string() + ", " +
                    film_speed(running.sequence, kFilmFileFramesPerS) +
                    (size.empty() ? "" : ", " + size) + ".");
}

void draw_next_frame(App& app) {
    RunningAnimation& running = *app.exports.animation;
    const FrameSequence& sequence = running.sequence;
    const Picture picture = view_picture(*running.still, running.view,
                                         time_of_frame_s(sequence, running.done), running.size);
    const auto written = running.film
                             ? add_frame(*running.film, std::get<Image>(picture))
                             : write_picture(path_of_frame(sequence, running.done), picture);
    if (!written) {
        complain(app.ui, "Export stopped: " + written.error().message);
        app.exports.animation.reset();
        return;
    }
    if (++running.done < sequence.frames) return;
    if (running.film) return finish_film(app);
    say(app.ui,
        "Exported " + counted(static_cast<std::size_t>(sequence.frames), "frame", "frames") +
            ". A film: " + film_command(sequence.folder, running.size.width, running.size.height));
    app.exports.animation.reset();
}

// Draws one step per frame, then writes the page.
void draw_next_of_sheet(App& app) {
    LessonState& state = app.lesson;
    if (!state.lesson) return state.sheet_to.clear();
    const LessonAnswers* answers = answers_of(state);
    const Lesson& lesson = *state.shown;
    if (state.job.busy()) return;  // the answers are being computed
    const std::size_t next = state.sheet_pictures.size();
    if (next < lesson.steps.size()) {
        state.sheet_pictures.push_back(step_picture(lesson, next));
        return;
    }
    const fs::path file = std::exchange(state.sheet_to, {});
    const LessonAnswers own = answers == nullptr ? lesson_answers(lesson) : *answers;
    LessonSheet sheet{lesson, own, std::exchange(state.sheet_pictures, {}),
                      std::string("tactspace ") + TACT_VERSION};
    if (std::exchange(state.hands_on, false)) {
        const auto whole = whole_lesson_file(lesson_to_save(app.work, state));
        if (!whole) return complain(app.ui, "Not handed on: " + with_stop(whole.error().message));
        sheet.lesson_file = *whole;
    }
    const bool for_students = sheet.lesson_file.empty();
    const std::string page = lesson_sheet(sheet);
    if (const Expected<Done> written = write_atomically(file, page); !written) {
        return complain(app.ui, "Not written: " + written.error().message);
    }
    say(app.ui, (for_students ? "Wrote the student sheet " : "Wrote the lesson to hand on, ") +
                    file.string() + ".");
}

}  // namespace

std::string step_picture(const Lesson& lesson, std::size_t step_at) {
    const LessonStep& step = lesson.steps[step_at];
    const auto place = place_named(lesson.set, step.pattern);
    if (!place && !shows_map(step)) return {};
    ViewChoice choice;
    choice.view = shows_map(step) ? PictureView::space : PictureView::physiology;
    choice.pattern = place.value_or(0);
    choice.pinned = place_named(lesson.set, step.partner);
    choice.stage = stage_of_view(step.view);
    const bool places = step.question && step.question->kind == QuestionKind::place;
    if (places) choice.dimensions = 2;
    const auto still = opened_view(lesson.set, choice);
    still->app.timeline.range = {step.from_s, step.to_s};
    if (places) {  // hides the pattern to be placed
        show_lesson(still->app.lesson, std::make_shared<const Lesson>(lesson));
        still->app.lesson.step = step_at;
    }
    PictureSize size;
    size.width = 1200;
    size.height = choice.stage || choice.view == PictureView::space ? 650 : 1500;
    size.scale = 1.5F;  // as large as the page's text
    size.dark = false;
    size.format = PictureFormat::svg;
    size.svg_ids = "step" + std::to_string(step_at + 1) + "-";
    constexpr double kWithinS = 0.1;  // a playhead at the very start has nothing behind it
    const double at_s = step.at_s > 0.0 ? step.at_s : kWithinS;
    return std::get<Svg>(view_picture(*still, choice.view, at_s, size)).text;
}

void export_animation(App& app, const fs::path& folder) {
    const ExportState& state = app.exports;
    const FrameSequence sequence{folder, state.from_s, state.to_s, state.frames};
    PictureSize size = state.frame_size;
    size.dark = app.ui.dark;
    RunningAnimation running{snapshot_of(app), state.moving_view, size, sequence, nullptr, {}, 0,
                             app.ui.time_s};
    if (const auto format = film_format(folder)) {
        const FilmSize asked{size.width, size.height};
        const FilmSize drawn = film_size(*format, asked);
        const auto film = open_film(folder, drawn);
        if (!film) return complain(app.ui, "Not exported: " + film.error().message);
        running.film = *film;
        running.size.width = drawn.width;
        running.size.height = drawn.height;
        running.another_size = film_size_words(*format, asked);
    } else if (const Expected<Done> open = open_sequence(sequence); !open) {
        return complain(app.ui, "Not exported: " + open.error().message);
    }
    app.exports.animation = std::make_shared<RunningAnimation>(std::move(running));
}

void cancel_animation(App& app) {
    const RunningAnimation& running = *app.exports.animation;
    if (running.film) {
        app.exports.animation.reset();
        return say(app.ui, "Export cancelled; no file was written.");
    }
    say(app.ui, "Export cancelled: " + std::to_string(running.done) + " of " +
                    counted(static_cast<std::size_t>(running.sequence.frames), "frame", "frames") +
                    (running.done == 1 ? " is in " : " are in ") +
                    running.sequence.folder.string());
    app.exports.animation.reset();
}

bool is_exporting(const App& app) {
    return app.exports.animation != nullptr || !app.exports.picture.empty() ||
           !app.exports.effects.export_to.empty() || !app.lesson.sheet_to.empty() ||
           app.exports.copy_asked;
}

void continue_exports(App& app) {
    if (!app.picking.export_to.empty() || !app.picking.report_to.empty()) {
        continue_subset_export(app.ui, app.work, app.shown_map, app.picking);
    }
    if (!app.exports.effects.export_to.empty())
        return continue_effect_export(app.ui, app.exports.effects);
    if (!app.exports.picture.empty()) return draw_waiting_picture(app);
    if (app.exports.animation) return draw_next_frame(app);
    if (app.exports.copy_asked) return copy_view(app);
    if (!app.lesson.sheet_to.empty()) draw_next_of_sheet(app);
}

}  // namespace tact
