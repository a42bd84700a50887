#include "app/play/playing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/editing.h"
#include "app/map/pair.h"
#include "app/play/calibrating.h"
#include "devices/audio/audio_host.h"
#include "devices/device_list.h"

namespace tact {

namespace {

constexpr double kHoverRestS = 0.15;
constexpr double kMeterFallDbPerS = 30.0;

const Vibration* vibration_named(const App& app, const std::string& name) {
    const auto place = place_named(app.document.set, name);
    return place ? &app.document.set.vibrations[*place] : nullptr;
}

// As the bar says, but for a signal that has a level of its own.
double level_now(const PlayState& play) {
    return play.sounding ? play.sounding->level.value_or(play.level) : play.level;
}

void play_drive(App& app, const Drive& drive, bool loop) {
    PlayState& play = app.play;
    play.halted = false;
    play.device->set_level(level_now(play));
    const Expected<Done> begun = play.device->play(drive, loop);
    if (begun) return;
    play.sounding.reset();
    app.playhead.playing = false;
    complain(app, begun.error().message);
}

// At once, or when its drive by the calibration is computed; until then what sounded goes on.
void play_vibration(App& app, const Vibration& vibration) {
    PlayState& play = app.play;
    DriveRequest request = drive_request(app, vibration);
    request.loops = play.sounding->loops;
    if (!request.calibration) {
        const MadeDrive made = made_drive(request);
        if (!made.remark.empty()) say(app, made.remark);
        return play_drive(app, made.drive, play.sounding->loops);
    }
    if (!play.drive_job) {
        play.drive_job = std::make_unique<LatestJob<DriveRequest, MadeDrive>>(
            JobPolicy::supersede,
            [](const DriveRequest& asked, std::stop_token, std::atomic<float>&) {
                return std::optional(made_drive(asked));
            },
            app.wake);
    }
    request.number = ++play.drives_asked;
    play.sounding->is_prepared = false;
    play.drive_job->submit(std::move(request));
}

// The pattern of the queue that is to sound now; one that was removed ends it all.
void play_current(App& app) {
    Sounding& sounding = *app.play.sounding;
    const Vibration* vibration = vibration_named(app, sounding.names[sounding.at]);
    if (vibration == nullptr) {
        silence(app);
        return;
    }
    sounding.rests_until_s.reset();
    sounding.position_s = 0.0;
    sounding.as_played = *vibration;
    app.playhead.playing = true;
    app.playhead.at_s = 0.0;
    if (sounding.selects) {
        select_only(app, *place_named(app.document.set, vibration->name));
        app.selection.scroll_to_current = true;
    }
    play_vibration(app, *vibration);
}

void start(App& app, Sounding sounding) {
    silence(app);
    app.playhead.speed = 1.0;
    app.play.sounding = std::move(sounding);
    play_current(app);
}

void end(App& app) {
    const bool was_pattern = !app.play.sounding->names.empty();
    app.play.sounding.reset();
    if (!was_pattern) return;
    app.playhead.playing = false;
}

// What comes after a pattern that has been felt to its end.
void advance(App& app) {
    Sounding& sounding = *app.play.sounding;
    const bool is_last = sounding.at + 1 >= sounding.names.size();
    if (is_last && !sounding.repeats) return end(app);
    if (!sounding.rests_until_s) {
        sounding.rests_until_s = app.time_s + app.play.gap_s;
        return;
    }
    if (app.time_s < *sounding.rests_until_s) return;
    sounding.at = is_last ? 0 : sounding.at + 1;
    play_current(app);
}

// A loop takes up what was edited, or another pattern, at its next round.
void follow_edits(App& app) {
    Sounding& sounding = *app.play.sounding;
    const Vibration* current = current_vibration(app);
    const bool new_round = app.play.status.position_s < sounding.position_s;
    if (!sounding.follows || !new_round || current == nullptr) return;
    if (*current == sounding.as_played) return;
    sounding.names = {current->name};
    sounding.as_played = *current;
    play_vibration(app, *current);
}

// Begins what was being computed for the one that sounds.
bool take_drive(App& app) {
    Sounding& sounding = *app.play.sounding;
    const auto made = app.play.drive_job ? app.play.drive_job->latest() : nullptr;
    if (sounding.is_prepared || !made || made->request.number != app.play.drives_asked) {
        return false;
    }
    sounding.is_prepared = true;
    if (!made->remark.empty()) say(app, made->remark);
    play_drive(app, made->drive, sounding.loops);
    return true;
}

void follow_device(App& app) {
    if (app.play.halted) return;
    if (take_drive(app)) return;  // of which this frame's status says nothing yet
    Sounding& sounding = *app.play.sounding;
    if (!sounding.is_prepared && !app.play.status.playing) return;
    if (!app.play.status.playing || sounding.rests_until_s) return advance(app);
    if (sounding.names.empty()) return;
    follow_edits(app);
    sounding.position_s = app.play.status.position_s;
    app.playhead.at_s = app.play.status.position_s;
}

// The chosen device where it is there and not open yet, as it is chosen.
void open_chosen(App& app) {
    PlayState& play = app.play;
    if (play.opened == play.choice) return;
    const std::optional<DeviceInfo> info = chosen_device(app);
    if (!info || !play.audio) return;
    auto device = open_device(play.audio, *info, play.choice);
    play.opened = play.choice;
    if (device) {
        play.device = std::move(*device);
    } else {
        play.device.reset();
        complain(app, device.error().message);
    }
}

void follow_status(App& app) {
    PlayState& play = app.play;
    const double fall = std::pow(10.0, -kMeterFallDbPerS * app.frame_s / 20.0);
    play.meter *= fall;
    if (play.meter < 1e-3) play.meter = 0.0;
    if (!play.device) return;
    play.device->set_level(level_now(play));
    play.status = play.device->status();
    play.meter = std::max(play.meter, play.status.peak);
    play.clip_light |= play.status.clipped && is_sounding(app);
    if (play.status.trouble.empty()) {
        play.told_trouble.clear();
    } else if (play.told_trouble != play.status.trouble) {
        play.told_trouble = play.status.trouble;
        complain(app, play.status.trouble);
        if (play.sounding) end(app);
    }
}

// A pattern that the mouse has rested on in the map is felt once.
void follow_hover(App& app) {
    PlayState& play = app.play;
    const auto hovered = std::exchange(play.hovered_in_map, std::nullopt);
    if (!hovered || !play.on_hover || *hovered >= app.document.set.vibrations.size()) {
        play.felt_on_hover.clear();
        return;
    }
    const std::string& name = app.document.set.vibrations[*hovered].name;
    if (name == play.felt_on_hover || app.time_s - app.hover_since_s < kHoverRestS) return;
    if (!can_sound(app)) return;
    play.felt_on_hover = name;
    start(app, {.names = {name}});
}

Sounding of_transport(const App& app) {
    const std::string name = current_vibration(app)->name;
    const std::optional<ChosenPair> pair = chosen_pair(app);
    if (app.play.alternates && pair) {
        const std::string& partner = app.document.set.vibrations[pair->partner].name;
        return {.names = {name, partner}, .repeats = app.playhead.loop};
    }
    return {.names = {name}, .loops = app.playhead.loop, .follows = app.playhead.loop};
}

}  // namespace

void make_sound(App& app) {
    app.play.audio = std::make_shared<AudioHost>();
    app.play.list_job = std::make_unique<LatestJob<int, Listing>>(
        JobPolicy::finish,
        [host = app.play.audio](int, std::stop_token, std::atomic<float>&) {
            return std::optional<Listing>(list_devices(*host));
        },
        app.wake);
    refresh_devices(app);
    // With an actuator at hand, play is meant to be felt.
    if (!app.play.choice.id.empty()) app.playhead.speed = 1.0;
}

void stop_sound(App& app) {
    silence(app);
    app.play.device.reset();
    app.play.list_job.reset();
    app.play.drive_job.reset();
    app.play.audio.reset();
}

bool can_sound(const App& app) { return app.play.device != nullptr; }

bool is_sounding(const App& app) { return app.play.sounding.has_value(); }

void follow_focus(App& app, bool focused) {
    const bool is_lost = std::exchange(app.play.focused, focused) && !focused;
    const std::optional<DeviceInfo> device = chosen_device(app);
    if (!is_lost || !device || device->kind != DeviceKind::hid || app.play.held) return;
    if (silence(app)) say(app, device->name + " is still: another window has the keys.");
}

void take_escape(App& app, bool is_pressed) {
    app.escape_taken = is_pressed && (silence(app) || app.play.halted);
    if (is_pressed) app.play.halted = false;
}

void follow_sound(App& app) {
    PlayState& play = app.play;
    if (play.list_job) {
        if (auto listed = play.list_job->latest()) play.listed = std::move(listed);
    }
    follow_calibration(app);
    open_chosen(app);
    follow_status(app);
    if (play.sounding) {
        // The playhead was halted, dragged or slowed down: it goes its own way.
        const bool is_pattern = !play.sounding->names.empty();
        if (is_pattern && (!app.playhead.playing || app.playhead.speed != 1.0)) {
            const bool goes_on = app.playhead.playing;
            silence(app);
            app.playhead.playing = goes_on;
        } else {
            follow_device(app);
        }
    }
    follow_hover(app);
}

void toggle_playing(App& app) {
    if (is_sounding(app)) {
        silence(app);
        return;
    }
    Playhead& playhead = app.playhead;
    const double end_s = shown_duration_s(app);
    if (!playhead.playing && playhead.at_s >= end_s) playhead.at_s = 0.0;
    playhead.playing = !playhead.playing && end_s > 0.0;
    if (!playhead.playing || playhead.speed != 1.0) return;
    if (can_sound(app) && current_vibration(app) != nullptr) {
        start(app, of_transport(app));
    } else if (!app.play.choice.id.empty()) {
        say(app, device_text(app) + ": " + device_trouble(app));
    }
}

void set_speed(App& app, double speed) {
    const bool begins = app.playhead.playing && speed == 1.0 && app.playhead.speed != 1.0;
    app.playhead.speed = speed;
    if (begins && can_sound(app) && current_vibration(app) != nullptr) {
        start(app, of_transport(app));
    }
}

void toggle_alternating(App& app) { app.play.alternates = !app.play.alternates; }

bool is_alternating(const App& app) { return app.play.alternates; }

void play_once(App& app, std::size_t index) {
    if (index >= app.document.set.vibrations.size()) return;
    if (can_sound(app)) return start(app, {.names = {app.document.set.vibrations[index].name}});
    app.playhead.at_s = 0.0;
    app.playhead.playing = shown_duration_s(app) > 0.0;
}

void play_pair(App& app, std::size_t first, std::size_t second) {
    const auto& all = app.document.set.vibrations;
    if (std::max(first, second) >= all.size()) return;
    choose_pair(app, first, second);
    if (!can_sound(app)) return play_once(app, first);
    start(app, {.names = {all[first].name, all[second].name}, .selects = false});
}

void stop_playing(App& app) {
    silence(app);
    app.playhead.playing = false;
}

void play_all(App& app) {
    if (!can_sound(app) || app.document.set.vibrations.empty()) return;
    start(app, {.names = names_of(app.document.set), .selects = true});
}

void play_test_buzz(App& app) {
    if (!can_sound(app)) return;
    silence(app);
    app.play.sounding = Sounding{};
    play_drive(app, test_buzz(), false);
}

void play_signal(App& app, const Drive& drive, double level) {
    if (!can_sound(app)) return;
    silence(app);
    app.play.sounding = Sounding{};
    app.play.sounding->level = level;
    play_drive(app, drive, false);
}

bool silence(App& app) {
    if (app.play.device) app.play.device->stop();
    if (!app.play.sounding) return false;
    end(app);
    return true;
}

}  // namespace tact
