#include "app/playing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bench_follow.h"
#include "app/calibrating.h"
#include "app/editing.h"
#include "app/study_follow.h"
#include "devices/audio_host.h"
#include "devices/device_list.h"
#include "devices/memory_device.h"

namespace tact {

namespace {

constexpr double kHoverRestS = 0.15;
constexpr double kMeterFallDbPerS = 30.0;

const Vibration* vibration_named(const App& app, const std::string& name) {
    const auto place = place_named(app.document.set, name);
    return place ? &app.document.set.vibrations[*place] : nullptr;
}

void play_drive(App& app, const Drive& drive, bool loop) {
    PlayState& play = app.play;
    play.device->set_level(play.level);
    const Expected<Done> begun = play.device->play(drive, loop);
    if (begun) return;
    play.sounding.reset();
    app.playhead.playing = false;
    complain(app, begun.error().message);
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
        app.set_panel.scroll_to_current = true;
    }
    play_drive(app, drive_for(app, *vibration), sounding.loops);
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
    play_drive(app, drive_for(app, *current), sounding.loops);
}

void follow_device(App& app) {
    Sounding& sounding = *app.play.sounding;
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
        if (app.study && !is_study_running(app)) app.study->device = play.device;
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
    play.device->set_level(play.level);
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

void keep_devices(App& app) {
    Session& session = app.session;
    session.device = app.play.choice.id;
    session.device_choices = app.play.choices;
    if (!session.device.empty()) {
        session.device_choices.insert(session.device_choices.begin(), app.play.choice);
    }
    session.full_scale_g = app.play.full_scale_g;
}

void restore_devices(App& app) {
    app.play.choices = app.session.device_choices;
    app.play.full_scale_g = app.session.full_scale_g;
    const auto chosen = std::ranges::find(app.play.choices, app.session.device, &DeviceChoice::id);
    if (app.session.device.empty() || chosen == app.play.choices.end()) return;
    app.play.choice = *chosen;
    app.play.choices.erase(chosen);
}

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
    // A study would keep it longer than its library lives.
    if (app.study) app.study->device = std::make_shared<MemoryDevice>(false);
    app.play.device.reset();
    app.play.list_job.reset();
    app.play.audio.reset();
}

void refresh_devices(App& app) {
    if (app.play.list_job) app.play.list_job->submit(++app.play.lists_asked);
}

void choose_device(App& app, const DeviceChoice& choice) {
    PlayState& play = app.play;
    if (choice == play.choice) return;
    if (app.study && is_study_running(app))
        return say(app, "A study is under way: its device stays");
    silence(app);
    const auto same = [](const std::string& id) {
        return [id](const DeviceChoice& other) { return other.id == id; };
    };
    if (!play.choice.id.empty()) {
        std::erase_if(play.choices, same(play.choice.id));
        play.choices.insert(play.choices.begin(), play.choice);
    }
    std::erase_if(play.choices, same(choice.id));
    play.choice = choice;
    play.opened = {};
    play.device.reset();
    if (app.study) app.study->device = std::make_shared<MemoryDevice>(false);
    play.status = {};
    if (!choice.id.empty()) app.playhead.speed = 1.0;
}

DeviceChoice remembered_choice(const App& app, const std::string& id) {
    if (app.play.choice.id == id) return app.play.choice;
    const auto known = std::ranges::find(app.play.choices, id, &DeviceChoice::id);
    if (known != app.play.choices.end()) return *known;
    DeviceChoice choice;
    choice.id = id;
    return choice;
}

std::optional<DeviceInfo> chosen_device(const App& app) {
    if (!app.play.listed) return {};
    for (const DeviceInfo& device : *app.play.listed) {
        if (device.id == app.play.choice.id) return device;
    }
    return {};
}

std::string device_text(const App& app) {
    const PlayState& play = app.play;
    if (play.choice.id.empty()) {
        const bool is_any = play.listed && !play.listed->empty();
        return is_any                                   ? "Silent"
               : play.list_job && play.list_job->busy() ? "Looking..."
                                                        : "No device";
    }
    const std::optional<DeviceInfo> info = chosen_device(app);
    const std::string name =
        info ? info->name : play.choice.id.substr(play.choice.id.rfind('/') + 1);
    if (info && info->channels.empty()) return name;
    return name + ", " + std::to_string(play.choice.channel);
}

std::string device_trouble(const App& app) {
    const PlayState& play = app.play;
    if (!play.status.trouble.empty()) return play.status.trouble;
    if (!play.listed) return {};
    if (play.choice.id.empty()) return play.listed->empty() ? advice_without_devices() : "";
    const std::optional<DeviceInfo> info = chosen_device(app);
    if (info) return info->trouble;
    return "It is not there: plug it in and refresh, or choose another. Until then everything "
           "plays "
           "silently.";
}

bool can_sound(const App& app) { return app.play.device != nullptr; }

bool is_sounding(const App& app) { return app.play.sounding.has_value(); }

void follow_sound(App& app) {
    PlayState& play = app.play;
    play.escaped = false;
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

bool silence(App& app) {
    if (app.play.device) app.play.device->stop();
    if (!app.play.sounding) return false;
    end(app);
    return true;
}

}  // namespace tact
