#include "app/play/play.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/parts.h"
#include "devices/audio/audio_host.h"
#include "devices/device/ledger.h"
#include "devices/device_list.h"
#include "devices/phone/phone_device.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kHoverRestS = 0.15;
constexpr double kMeterFallDbPerS = 30.0;
bool is_phones(const DeviceInfo& device) { return device.id == kPhonesId; }

const Vibration* vibration_named(const Workspace& work, const std::string& name) {
    const auto place = place_named(work.document.set, name);
    return place ? &work.document.set.vibrations[*place] : nullptr;
}

void show_current(Workspace& work, Timeline& timeline, const Sounding& sounding) {
    timeline.playhead.playing = true;
    timeline.playhead.at_s = 0.0;
    if (!sounding.selects) return;
    select_only(work, *place_named(work.document.set, sounding.as_played.name));
    work.selection.scroll_to_current = true;
}

// The pattern of the queue that plays next; if it was removed, the queue ends.
void play_current(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    const Vibration* vibration = vibration_named(work, sounding.names[sounding.at]);
    if (vibration == nullptr) {
        silence(timeline, play);
        return;
    }
    sounding.rests_until_s.reset();
    sounding.position_s = 0.0;
    sounding.as_played = *vibration;
    sounding.has_begun = false;
    sounding.next_was_asked = false;
    sounding.next.reset();
    sounding.next_drive = 0;
    show_current(work, timeline, sounding);
    play_vibration(ui, timeline, play, *vibration);
}

void start(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, Sounding sounding) {
    silence(timeline, play);
    timeline.playhead.speed = 1.0;
    play.sounding = std::move(sounding);
    if (play.for_ear) say(ui, std::string("A ") + kEarWords + ".");
    play_current(ui, work, timeline, play);
}

void end(Timeline& timeline, PlayState& play) {
    const bool was_pattern = !play.sounding->names.empty();
    play.sounding.reset();
    if (!was_pattern) return;
    timeline.playhead.playing = false;
}

// The next place in the queue; nullopt: this one is the last.
std::optional<std::size_t> next_place(const Sounding& sounding) {
    if (sounding.at + 1 < sounding.names.size()) return sounding.at + 1;
    return sounding.repeats ? std::optional<std::size_t>(0) : std::nullopt;
}

// The device gets the next pattern while this one plays: the device then keeps the rest between
// them itself, independent of frames. The drive may take a while to compute.
void ask_for_next(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    if (sounding.next_was_asked || !sounding.is_prepared || sounding.names.size() < 2) return;
    const std::optional<std::size_t> at = next_place(sounding);
    const Vibration* next = at ? vibration_named(work, sounding.names[*at]) : nullptr;
    sounding.next_was_asked = true;
    if (next != nullptr) play_next(ui, timeline, play, *next);
}

// True: the next pattern on the device starts, or starts when its drive is ready. False: it was
// edited, removed or swapped meanwhile, and is dropped.
bool take_next(Workspace& work, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    if (!sounding.next) return false;
    const std::optional<std::size_t> at = next_place(sounding);
    const Vibration* wanted = at ? vibration_named(work, sounding.names[*at]) : nullptr;
    if (wanted == nullptr || *wanted != *sounding.next ||
        drive_request(play, *wanted).by != sounding.next_by) {
        play.device->stop();
        sounding.next.reset();
        sounding.next_drive = 0;
        return false;
    }
    if (sounding.next_drive != 0) return true;
    const std::optional<Vibration> taken = std::exchange(sounding.next, std::nullopt);
    sounding.at = *at;
    sounding.as_played = *taken;
    sounding.driven_by = sounding.next_by;
    sounding.position_s = 0.0;
    sounding.next_was_asked = false;
    show_current(work, timeline, sounding);
    return true;
}

// Called at the end of a pattern: starts the next one, rests, or ends.
void advance(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    if (take_next(work, timeline, play)) return;
    Sounding& sounding = *play.sounding;
    const bool is_last = sounding.at + 1 >= sounding.names.size();
    if (is_last && !sounding.repeats) return end(timeline, play);
    if (!sounding.rests_until_s) {
        sounding.rests_until_s = ui.time_s + play.gap_s;
        return;
    }
    if (ui.time_s < *sounding.rests_until_s) return;
    sounding.at = is_last ? 0 : sounding.at + 1;
    play_current(ui, work, timeline, play);
}

// A loop takes up another pattern at its next round.
void follow_selection(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    const Vibration* current = current_vibration(work);
    const bool new_round = play.status.position_s < sounding.position_s;
    if (!sounding.follows || !new_round || current == nullptr) return;
    if (current->name == sounding.as_played.name) return;
    sounding.names = {current->name};
    sounding.as_played = *current;
    sounding.has_begun = false;
    play_vibration(ui, timeline, play, *current);
}

void follow_device(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    if (play.halted) return;
    if (take_drive(ui, timeline, play)) return;  // this frame's status does not tell it yet
    if (take_next_drive(ui, timeline, play) && !play.sounding) return;
    Sounding& sounding = *play.sounding;
    if (!sounding.is_prepared && !play.status.playing) return;
    if (!play.status.playing || sounding.rests_until_s) return advance(ui, work, timeline, play);
    if (sounding.names.empty()) return;
    ask_for_next(ui, work, timeline, play);
    if (!play.sounding) return;
    follow_selection(ui, work, timeline, play);
    sounding.position_s = play.status.position_s;
    timeline.playhead.at_s = play.status.position_s;
}

// Opens the chosen device, if it is connected and not open yet.
void open_chosen(Ui& ui, PlayState& play) {
    DeviceChoice wanted = play.choice;
    wanted.buffer_s = play.gapless ? play.whole_buffer_s : play.live_buffer_s;
    if (play.opened == wanted) return;
    // A larger buffer is used between two plays: reopening during one would be another gap.
    DeviceChoice longer = play.opened;
    longer.buffer_s = wanted.buffer_s;
    if (longer == wanted && !play.gapless && play.sounding) return;
    const std::optional<DeviceInfo> info = chosen_device(play);
    if (!info || (!play.audio && !is_phones(*info))) return;
    play.opened = wanted;
    play.opened_place = place_of_sound(*info);
    if (is_phones(*info)) {
        auto phones = std::make_shared<PhoneDevice>(play.phones);
        play.phone_device = phones;
        play.device = std::move(phones);
        return;
    }
    auto device = open_device(play.audio, *info, wanted);
    if (device) {
        play.device = std::move(*device);
    } else {
        play.device.reset();
        complain(ui, device.error().message);
    }
}

// After a new search the same name may mean another output; that is another device.
void follow_place(Timeline& timeline, PlayState& play) {
    const std::optional<DeviceInfo> info = chosen_device(play);
    if (play.listed && !play.choice.id.empty() && !info) begin_softly(play);  // it may come back
    if (!play.device || !info || info->kind != DeviceKind::audio) return;
    if (play.opened_place.empty() || play.opened_place == place_of_sound(*info)) return;
    if (play.held || play.gapless) return;  // a study's device stays
    silence(timeline, play);
    begin_softly(play);
    play.opened = {};
    play.device.reset();
}

// A computer that is too slow gets a larger buffer, and the person is told the price.
void follow_gaps(Ui& ui, PlayState& play) {
    const bool has_gaps = play.sounding && play.status.dropouts > 0 && !play.gapless;
    if (!has_gaps || play.opened.buffer_s != play.live_buffer_s) return;
    if (play.live_buffer_s >= kBufferS) return;
    play.live_buffer_s = std::min(2.0 * play.live_buffer_s, kBufferS);
    say(ui, "The sound had gaps: from its next start it is rendered " +
                with_decimals(1e3 * play.live_buffer_s, 0) +
                " ms ahead, and edits are heard that much later.");
}

// A play is limited by earlier ones: the person is told once per play.
void follow_held(Ui& ui, PlayState& play) {
    if (!play.sounding) return;
    const std::string held = words_on_held(play.status.kept, play.status.is_warm);
    const bool is_new = !held.empty() && play.told_held.empty();
    play.told_held = held;
    if (!is_new) return;
    const std::string& name = play.sounding->as_played.name;
    say(ui, (name.empty() ? "This" : name) + " " + held + ".");
}

// It plays again: the error that it did not is taken back.
void take_back_complaint(Ui& ui, PlayState& play) {
    if (play.complaint.empty() || !play.status.playing || play.status.position_s <= 0.0) return;
    const std::string complaint = std::exchange(play.complaint, {});
    if (ui.status.is_error && ui.status.text.starts_with(complaint)) ui.status = {};
}

void follow_status(Ui& ui, Timeline& timeline, PlayState& play) {
    const double fall = std::pow(10.0, -kMeterFallDbPerS * ui.frame_s / 20.0);
    play.meter *= fall;
    if (play.meter < 1e-3) play.meter = 0.0;
    if (!play.device) return;
    play.device->set_level(level_now(play));
    play.status = play.device->status();
    play.meter = std::max(play.meter, play.status.peak);
    play.clip_light |= play.status.clipped && is_sounding(play);
    follow_gaps(ui, play);
    follow_held(ui, play);
    if (play.status.trouble.empty()) {
        play.told_trouble.clear();
        take_back_complaint(ui, play);
    } else if (play.told_trouble != play.status.trouble) {
        play.told_trouble = play.complaint = play.status.trouble;
        complain(ui, play.status.trouble);
        // A device that comes back may have another volume.
        if (!play.status.connected) begin_softly(play);
        if (play.sounding) end(timeline, play);
    }
}

// The reason why there are no cards is told once, and then in the list of devices.
void take_list(Ui& ui, PlayState& play, std::shared_ptr<const Listing> found) {
    play.found = std::move(found);
    const std::string fault = cards_fault(*play.audio);
    if (fault != play.cards_fault && !fault.empty()) complain(ui, fault);
    play.cards_fault = fault;
}

// Phones are a device as long as a page is served to them.
void list_phones(PlayState& play) {
    const bool has_phones = play.listed && std::ranges::any_of(*play.listed, is_phones);
    const bool is_new = play.found != play.listed_of || has_phones != (play.phones != nullptr);
    if (!is_new) return;
    play.listed_of = play.found;
    if (!play.phones) {
        play.listed = play.found;
        return;
    }
    Listing all = play.found ? *play.found : Listing{};
    all.push_back(phone_info(kPhonesId, "Phones"));
    play.listed = std::make_shared<const Listing>(std::move(all));
}

// A pattern that the mouse rests on in the map is played once.
void follow_hover(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    const auto hovered = std::exchange(play.hovered_in_map, std::nullopt);
    if (!hovered || !play.on_hover || *hovered >= work.document.set.vibrations.size()) {
        play.felt_on_hover.clear();
        return;
    }
    const std::string& name = work.document.set.vibrations[*hovered].name;
    if (name == play.felt_on_hover || ui.time_s - ui.hover_since_s < kHoverRestS) return;
    if (!can_sound(play)) return;
    play.felt_on_hover = name;
    start(ui, work, timeline, play, {.names = {name}});
}

Sounding of_transport(const Workspace& work, const Timeline& timeline, const ShownMap& shown_map,
                      const PlayState& play) {
    const std::string name = current_vibration(work)->name;
    const std::optional<ChosenPair> pair = chosen_pair(work, shown_map);
    if (play.alternates && pair) {
        const std::string& partner = work.document.set.vibrations[pair->partner].name;
        return {.names = {name, partner}, .repeats = timeline.playhead.loop};
    }
    return {.names = {name}, .loops = timeline.playhead.loop, .follows = timeline.playhead.loop};
}

}  // namespace

void make_sound(const Ui& ui, Timeline& timeline, PlayState& play) {
    play.audio = std::make_shared<AudioHost>();
    watch_devices([&ui, &play] {
        refresh_devices(ui, play);
        if (ui.wake) ui.wake();
    });
    refresh_devices(ui, play);
    // With an actuator connected, play means to feel it.
    if (!play.choice.id.empty()) timeline.playhead.speed = 1.0;
}

void stop_sound(Timeline& timeline, PlayState& play) {
    silence(timeline, play);
    play.device.reset();
}

bool can_sound(const PlayState& play) { return play.device != nullptr; }

bool is_sounding(const PlayState& play) { return play.sounding.has_value(); }

void follow_focus(Ui& ui, Timeline& timeline, PlayState& play, bool focused) {
    const bool is_lost = std::exchange(play.focused, focused) && !focused;
    const std::optional<DeviceInfo> device = chosen_device(play);
    if (!is_lost || !device || device->kind != DeviceKind::hid || play.held) return;
    if (silence(timeline, play)) say(ui, device->name + " is still: another window has the keys.");
}

void take_escape(Ui& ui, Timeline& timeline, PlayState& play, bool is_pressed) {
    ui.escape_taken = is_pressed && (silence(timeline, play) || play.halted);
    if (is_pressed) play.halted = false;
}

void follow_sound(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play) {
    if (auto found = play.list_job.latest()) take_list(ui, play, std::move(found));
    list_phones(play);
    follow_calibration(ui, work, rendered, play);
    tell_softened(ui, play);
    follow_place(timeline, play);
    open_chosen(ui, play);
    follow_status(ui, timeline, play);
    if (play.sounding) {
        // The playhead was halted, dragged or slowed down: it no longer follows the device.
        const bool is_pattern = !play.sounding->names.empty();
        if (is_pattern && (!timeline.playhead.playing || timeline.playhead.speed != 1.0)) {
            const bool goes_on = timeline.playhead.playing;
            silence(timeline, play);
            timeline.playhead.playing = goes_on;
        } else {
            follow_device(ui, work, timeline, play);
        }
    }
    follow_hover(ui, work, timeline, play);
}

namespace {

// Told where it was pressed, and not only in the list of devices.
void tell_silent(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    if (!play.choice.id.empty()) return say(ui, device_text(play) + ": " + device_trouble(play));
    say(ui, "Plays silently: no actuator is chosen. The list beside the speeds has them.");
    const std::optional<DeviceInfo> output = ear_output(play);
    if (!output) return;
    ui.status.more = "Listen on headphones, two octaves up";
    ui.status.show_more = [&ui, &work, &timeline, &play] {
        listen_by_ear(ui, work, timeline, play);
    };
}

}  // namespace

void toggle_playing(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                    PlayState& play) {
    if (is_sounding(play)) {
        silence(timeline, play);
        return;
    }
    Playhead& playhead = timeline.playhead;
    const double end_s = shown_duration_s(work);
    if (!playhead.playing && playhead.at_s >= end_s) playhead.at_s = 0.0;
    playhead.playing = !playhead.playing && end_s > 0.0;
    if (!playhead.playing) return;
    if (play.choice.id.empty() && !can_sound(play)) return tell_silent(ui, work, timeline, play);
    if (playhead.speed != 1.0) return;
    if (can_sound(play) && current_vibration(work) != nullptr) {
        start(ui, work, timeline, play, of_transport(work, timeline, shown_map, play));
    } else {
        tell_silent(ui, work, timeline, play);
    }
}

void listen_by_ear(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    const std::optional<DeviceInfo> output = ear_output(play);
    if (!output || current_vibration(work) == nullptr) return;
    DeviceChoice choice;
    choice.id = output->id;
    choice.everywhere = true;
    choose_device(ui, timeline, play, choice);
    play.for_ear = play.choice == choice;
    open_chosen(ui, play);
    if (!play.for_ear || !can_sound(play)) return;
    const bool loops = timeline.playhead.loop;
    start(ui, work, timeline, play,
          {.names = {current_vibration(work)->name}, .loops = loops, .follows = loops});
}

void set_speed(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
               PlayState& play, double speed) {
    const bool begins = timeline.playhead.playing && speed == 1.0 && timeline.playhead.speed != 1.0;
    timeline.playhead.speed = speed;
    if (begins && can_sound(play) && current_vibration(work) != nullptr) {
        start(ui, work, timeline, play, of_transport(work, timeline, shown_map, play));
    }
}

void toggle_alternating(PlayState& play) { play.alternates = !play.alternates; }

bool is_alternating(const PlayState& play) { return play.alternates; }

void play_once(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, std::size_t index) {
    if (index >= work.document.set.vibrations.size()) return;
    if (can_sound(play))
        return start(ui, work, timeline, play,
                     {.names = {work.document.set.vibrations[index].name}});
    timeline.playhead.at_s = 0.0;
    timeline.playhead.playing = shown_duration_s(work) > 0.0;
    tell_silent(ui, work, timeline, play);
}

void play_pair(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, std::size_t first,
               std::size_t second) {
    const auto& all = work.document.set.vibrations;
    if (std::max(first, second) >= all.size()) return;
    choose_pair(work, first, second);
    if (!can_sound(play)) return play_once(ui, work, timeline, play, first);
    start(ui, work, timeline, play,
          {.names = {all[first].name, all[second].name}, .selects = false});
}

void stop_playing(Timeline& timeline, PlayState& play) {
    silence(timeline, play);
    timeline.playhead.playing = false;
}

void play_all(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    if (!can_sound(play) || work.document.set.vibrations.empty()) return;
    start(ui, work, timeline, play, {.names = names_of(work.document.set), .selects = true});
}

void play_test_buzz(Ui& ui, Timeline& timeline, PlayState& play) {
    if (!can_sound(play)) return;
    silence(timeline, play);
    play.sounding = Sounding{};
    play_drive(ui, timeline, play, test_buzz(), false);
}

void play_signal(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, double level) {
    if (!can_sound(play)) return;
    silence(timeline, play);
    play.sounding = Sounding{};
    play.sounding->level = level;
    play_drive(ui, timeline, play, drive, false);
}

bool silence(Timeline& timeline, PlayState& play) {
    if (play.device) play.device->stop();
    if (!play.sounding) return false;
    end(timeline, play);
    return true;
}

}  // namespace tact
