// Which device plays, and how: chosen, remembered, looked for. Declared in app/play/playing.h.

#include <algorithm>

#include "app/document/editing.h"
#include "app/play/playing.h"
#include "devices/device_list.h"

namespace tact {

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

void refresh_devices(App& app) {
    if (app.play.list_job) app.play.list_job->submit(++app.play.lists_asked);
}

void choose_device(App& app, const DeviceChoice& choice) {
    PlayState& play = app.play;
    if (choice == play.choice) return;
    if (play.held) return say(app, "A study is under way: its device stays");
    silence(app);
    const auto same = [](const std::string& id) {
        return [id](const DeviceChoice& other) { return other.id == id; };
    };
    if (!play.choice.id.empty()) {
        std::erase_if(play.choices, same(play.choice.id));
        play.choices.insert(play.choices.begin(), play.choice);
    }
    std::erase_if(play.choices, same(choice.id));
    // What is a weak level on one actuator may be a strong one on the next.
    const bool is_other = choice.id != play.choice.id || choice.channel != play.choice.channel;
    if (is_other) play.level = std::min(play.level, kFirstLevel);
    play.choice = choice;
    play.opened = {};
    play.device.reset();
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
           "plays silently.";
}

bool can_be_calibrated(const App& app) {
    const std::optional<DeviceInfo> device = chosen_device(app);
    return device && device->kind == DeviceKind::audio;
}

}  // namespace tact
