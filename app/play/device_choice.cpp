// The device that plays, and its settings: chosen, remembered, searched for.

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "devices/device_list.h"
#include "devices/phone/phone_device.h"

namespace tact {

void keep_devices(Workspace& work, const PlayState& play) {
    Session& session = work.session;
    // Headphones and phones are chosen for this run only.
    const bool stays = !play.for_ear && play.choice.id != kPhonesId;
    session.device = stays ? play.choice.id : std::string();
    session.device_choices = play.choices;
    if (!session.device.empty()) {
        session.device_choices.insert(session.device_choices.begin(), play.choice);
    }
    session.full_scale_g = play.full_scale_g;
    session.whole_buffer_s = play.whole_buffer_s;
}

void restore_devices(Workspace& work, PlayState& play) {
    play.choices = work.session.device_choices;
    play.full_scale_g = work.session.full_scale_g;
    play.whole_buffer_s = work.session.whole_buffer_s;
    const auto chosen = std::ranges::find(play.choices, work.session.device, &DeviceChoice::id);
    if (work.session.device.empty() || chosen == play.choices.end()) return;
    play.choice = *chosen;
    play.choices.erase(chosen);
}

void refresh_devices(const Ui& ui, PlayState& play) {
    if (!play.audio) return;
    play.list_job.ask(
        ++play.lists_asked,
        [host = play.audio](int, std::stop_token, std::atomic<float>&) {
            return std::optional<Listing>(list_devices(*host));
        },
        ui.wake, JobPolicy::finish);
}

void begin_softly(PlayState& play) {
    play.was_softened = play.was_softened || play.level > kFirstLevel;
    play.level = std::min(play.level, kFirstLevel);
}

// Follows the sentence on the cause, said in the same frame.
void tell_softened(Ui& ui, PlayState& play) {
    if (!std::exchange(play.was_softened, false)) return;
    StatusLine& line = ui.status;
    std::string before = ui.time_s - line.since_s < 1.0 ? line.text : "";
    if (!before.empty()) before += before.ends_with('.') ? " " : ". ";
    const bool is_error = !before.empty() && line.is_error;
    before += "The level starts at 10 % again.";
    is_error ? complain(ui, before) : say(ui, before);
}

void choose_device(Ui& ui, Timeline& timeline, PlayState& play, const DeviceChoice& choice) {
    if (choice == play.choice) return;
    if (play.held) return say(ui, "A study is under way: its device stays");
    silence(timeline, play);
    const auto same = [](const std::string& id) {
        return [id](const DeviceChoice& other) { return other.id == id; };
    };
    const bool was_for_ear = std::exchange(play.for_ear, false);
    if (!play.choice.id.empty() && !was_for_ear) {
        std::erase_if(play.choices, same(play.choice.id));
        play.choices.insert(play.choices.begin(), play.choice);
    }
    std::erase_if(play.choices, same(choice.id));
    // A weak level on one actuator or with one calibration may be a strong one on the next.
    const bool is_other = was_for_ear || choice.id != play.choice.id ||
                          choice.channel != play.choice.channel ||
                          choice.of_channels != play.choice.of_channels ||
                          choice.calibration != play.choice.calibration;
    if (is_other) begin_softly(play);
    // A phone's own motor is on or off, and weak: 10 % is not felt, and nobody is startled.
    if (choice.id == kThisPhoneId) play.level = 1.0;
    play.choice = choice;
    if (was_for_ear) play.choice.everywhere = false;  // an actuator has one channel
    play.opened = {};
    play.device.reset();
    play.status = {};
    if (!choice.id.empty()) timeline.playhead.speed = 1.0;
}

DeviceChoice remembered_choice(const PlayState& play, const std::string& id) {
    if (play.choice.id == id && !play.for_ear) return play.choice;
    const auto known = std::ranges::find(play.choices, id, &DeviceChoice::id);
    if (known != play.choices.end()) return *known;
    DeviceChoice choice;
    choice.id = id;
    return choice;
}

std::optional<DeviceInfo> chosen_device(const PlayState& play) {
    if (!play.listed) return {};
    for (const DeviceInfo& device : *play.listed) {
        if (device.id == play.choice.id) return device;
    }
    return {};
}

namespace {

// "PulseAudio on Headphones": the chosen name, and the output that it stands for now.
std::string name_with_output(const DeviceInfo& info) {
    if (info.output_name.empty() || info.name.starts_with(info.output_name)) return info.name;
    return info.name + " on " + info.output_name;
}

}  // namespace

std::string device_text(const PlayState& play) {
    if (play.choice.id.empty()) {
        const bool is_any = play.listed && !play.listed->empty();
        return is_any ? "No device" : play.list_job.busy() ? "Looking..." : "No device";
    }
    const std::optional<DeviceInfo> info = chosen_device(play);
    if (play.for_ear) return "By ear: " + (info ? name_with_output(*info) : "no output");
    const std::string name =
        info ? info->name : play.choice.id.substr(play.choice.id.rfind('/') + 1);
    if (info && info->channels.empty()) return name;
    if (!info) return name + ", " + std::to_string(play.choice.channel);
    return name_with_output(*info) + ", " + channel_text(*info, play.choice.channel);
}

std::string device_trouble(const PlayState& play) {
    if (!play.status.trouble.empty()) return play.status.trouble;
    if (!play.listed) return {};
    const bool may_be_card = play.choice.id.empty() || play.choice.id.starts_with("audio/ALSA/");
    const std::optional<DeviceInfo> info = chosen_device(play);
    if (!info && may_be_card && !play.cards_fault.empty()) return play.cards_fault;
    if (play.choice.id.empty()) return play.listed->empty() ? advice_without_devices() : "";
    if (info) return info->trouble;
    return "It is not there: plug it in and refresh, or choose another. Until then everything "
           "plays silently.";
}

bool can_be_calibrated(const PlayState& play) {
    const std::optional<DeviceInfo> device = chosen_device(play);
    return device && device->kind == DeviceKind::audio && !play.for_ear;
}

}  // namespace tact
