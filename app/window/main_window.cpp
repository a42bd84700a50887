#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/lesson/lesson.h"
#include "app/map/map.h"
#include "app/phones/phones.h"
#include "app/play/play.h"
#include "app/screen/screen.h"
#include "app/session/session.h"
#include "app/study/study.h"
#include "app/window/window.h"

namespace tact {

namespace {

WindowOptions options_of(const App& app) {
    WindowOptions options;
    options.width = app.work.session.window_width;
    options.height = app.work.session.window_height;
    options.maximised = app.work.session.window_maximised;
    return options;
}

// Notes for the speaker, in the terminal: on its first line, or if it is not a terminal, as one
// line each.
void tell_speaker(const std::string& line, std::string& told) {
    if (line == told) return;
    told = line;
    if (line.empty()) return;
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    std::cerr << (terminal ? "\033[H\033[2J" : "") << line << std::endl;
}

// The second window, if the speaker has one.
void show_notes(App& app, FrameRequest& request) {
    const auto notes = speaker_notes(app.lesson, app.ui.time_s);
    app.lesson.shows_notes = notes && wants_notes_window(app.lesson, has_second_screen());
    if (!app.lesson.shows_notes) return;
    request.side = notes_window(*notes, app.ui.dark);
    request.wake_after_s = std::min(request.wake_after_s, notes_wake_s(app.lesson, app.ui.time_s));
}

// The set, the pattern that is edited, the card or what panes tell, and the last message.
std::string reading_of(const App& app) {
    std::string words = document_title(app.work) + "\n";
    const Vibration* vibration = current_vibration(app.work);
    if (vibration != nullptr) words += "Pattern " + vibration->name + "\n";
    return words + app.ui.reading + app.ui.status.text;
}

FrameRequest draw_window_frame(App& app, EmergencyStop& stop, const FrameContext& context) {
    app.play.halted |= stop.take();
    app.ui.content_scale = context.content_scale;
    if (!is_study_running(app.studying) && !is_presenting(app.lesson)) {  // those fill the screen
        app.work.session.window_width = context.width;
        app.work.session.window_height = context.height;
        app.work.session.window_maximised = context.maximised;
    }
    follow_focus(app.ui, app.timeline, app.play, context.focused);
    draw_frame(app, context.pressed, context.time_s);
    stop.watch(is_study_running(app.studying) ? app.studying.device
               : is_sounding(app.play)        ? app.play.device
                                              : nullptr);
    FrameRequest request;
    request.animate = wants_another_frame(app);
    request.wake_after_s = next_wake_s(app);
    request.rebuild_fonts = app.ui.fonts_outdated;
    request.close = app.ui.quit;
    if (request.close) stop.stop();  // the window's objects end first
    request.full_screen = is_study_running(app.studying) || is_presenting(app.lesson);
    if (context.side_closed) app.lesson.notes_wanted = false;
    show_notes(app, request);
    tell_speaker(speaker_line(app.lesson), app.lesson.told);
    request.title = document_title(app.work) + " - tactspace";
    request.reading = reading_of(app);
    request.background = app.ui.theme.background;
    return request;
}

struct Running {
    App app = make_app();
    EmergencyStop stop;
};

void end(Running& running) {
    App& app = running.app;
    running.stop.watch(nullptr);
    release_device(app.studying);
    stop_sound(app.timeline, app.play);
    app.play.phones.reset();
    end_phones(app.phones);
    stop_study(app.studying);
    end_session(app);
}

WindowClient client_of(const std::shared_ptr<Running>& running) {
    WindowClient client;
    client.frame = [running](const FrameContext& context) {
        return draw_window_frame(running->app, running->stop, context);
    };
    client.escape = [running] { running->stop.stop(); };
    client.display_gone = [running] {
        const Expected<Done> kept = keep_before_end(running->app);
        return kept ? std::string() : kept.error().message;
    };
    client.drop = [running](const std::vector<std::filesystem::path>& paths) {
        drop_paths(running->app, paths);
    };
    client.close = [running] {
        const bool closes = close_window(running->app);
        if (closes) running->stop.stop();
        return closes;
    };
    client.build_fonts = [running](float content_scale) {
        running->app.ui.content_scale = content_scale;
        make_theme(running->app);
    };
    client.after_frame = [running] { continue_exports(running->app); };
    client.end = [running] { end(*running); };
    return client;
}

}  // namespace

Expected<Done> run_main_window(const std::vector<std::filesystem::path>& sets) {
    for (const std::filesystem::path& set : sets) {
        std::error_code fault;
        if (!std::filesystem::exists(set, fault)) {
            return Error{set.string() + ": there is no such file, folder or command"};
        }
    }
    if (!display_available()) {
        return Error{
            "no display to open a window on; \"tactspace predict SET\" and \"tactspace snapshot "
            "SET\" work without one (see tactspace --help)"};
    }
    // The page of a browser keeps it longer than this function runs.
    const auto running = std::make_shared<Running>();
    App& app = running->app;
    watch_for_crashes(crash_report_file());
    app.ui.pick_files = file_picker();
    app.ui.for_fingers = is_for_fingers();
    app.manual.program = running_program();
    app.exports.paper.program = app.manual.program;
    const Expected<Done> started = start_session(app, sets);
    if (!started) return started.error();
    app.ui.wake = wake_window;  // jobs may begin; the files above were read in place
    make_sound(app.ui, app.timeline, app.play);
    request_maps(app.ui, app.work, app.shown_map, app.rendered);
    const Expected<Done> answer = run_window(options_of(app), client_of(running));
    if (!answer) end(*running);
    return answer;
}

}  // namespace tact
