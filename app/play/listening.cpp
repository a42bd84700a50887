#include "app/play/play.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/parts.h"
#include "app/progress/progress.h"
#include "devices/phone/phone_device.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Time at which the last edit was sent: a story measures the delay until it is felt.
void note_edit(Ui& ui, PlayState& play, bool is_edit) {
    if (ui.rects.file.empty()) return;
    if (is_edit) {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        play.edited_s = std::chrono::duration<double>(now).count();
    }
    note_rect(ui.rects, "heard edit", {}, {}, fixed_digits(play.edited_s, 6));
}

// Another protection, full scale or calibration applies to playing drives: a loop changes to its
// new drive, a single unprotected pass ends.
void hear_settings(Ui& ui, Timeline& timeline, PlayState& play) {
    if (!play.sounding || play.halted || play.sounding->as_played.name.empty()) return;
    Sounding& sounding = *play.sounding;
    const DrivenBy now = driven_by(play);
    const DrivenBy before = std::exchange(sounding.driven_by, now);
    if (now == before || sounding.rests_until_s) return;
    if (sounding.loops) {
        const Vibration same = sounding.as_played;
        return play_vibration(ui, timeline, play, same);
    }
    const bool was_free = !before.calibration && !before.is_protected;
    if (!was_free || !(now.calibration || now.is_protected)) return;
    silence(timeline, play);
    say(ui, "Stopped, as it was not protected: play it again.");
}

void hear_edits(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play) {
    hear_settings(ui, timeline, play);
    if (!play.sounding || !play.sounding->follows || play.halted) return;
    const Vibration* current = current_vibration(work);
    Vibration& before = play.sounding->as_played;
    if (current == nullptr || current->name != before.name) return;
    const bool is_edit = !(current->source == before.source);
    note_edit(ui, play, is_edit);
    if (!is_edit) return;
    before = *current;
    play_vibration(ui, timeline, play, before);
}

void follow_hold(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play) {
    const std::optional<Vibration> pressed = std::exchange(work.selection.pressed, std::nullopt);
    if (!pressed) {
        play.hold_taken = false;
        if (play.sounding && play.sounding->while_held) silence(timeline, play);
        return;
    }
    const bool rests = static_cast<double>(ImGui::GetIO().MouseDownDuration[0]) < kHoldS;
    if (rests || play.hold_taken || !can_sound(play)) return;
    play.hold_taken = true;  // Esc ends it until the next press
    stop_playing(timeline, play);
    play.sounding = Sounding{.names = {}, .loops = true, .as_played = *pressed, .while_held = true};
    play_vibration(ui, timeline, play, *pressed);
}

}  // namespace

void hear_changes(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play) {
    hear_edits(ui, work, timeline, play);
    follow_hold(ui, work, timeline, play);
    follow_level(work, rendered, play);
}

std::optional<std::pair<std::string, std::string>> alternating_pair(const Workspace& work,
                                                                    const ShownMap& shown_map,
                                                                    const PlayState& play) {
    if (play.sounding && play.sounding->names.size() == 2) {
        return std::pair{play.sounding->names[0], play.sounding->names[1]};
    }
    const std::optional<ChosenPair> pair = chosen_pair(work, shown_map);
    if (!pair) return std::nullopt;
    const auto& all = work.document.set.vibrations;
    return std::pair{all[pair->current].name, all[pair->partner].name};
}

void swap_pair(Workspace& work, const ShownMap& shown_map, PlayState& play) {
    const auto names = alternating_pair(work, shown_map, play);
    if (!names) return;
    const auto a = place_named(work.document.set, names->first);
    const auto b = place_named(work.document.set, names->second);
    if (!a || !b) return;
    choose_pair(work, *b, *a);
    if (!play.sounding || play.sounding->names.size() != 2) return;
    std::swap(play.sounding->names[0], play.sounding->names[1]);
    play.sounding->at = 1 - play.sounding->at;
}

Pattern for_ear(Pattern pattern) {
    for (Carrier& carrier : pattern.carriers) carrier.frequency_hz *= kEarFactor;
    for (FrequencyPoint& point : pattern.frequency_curve) point.frequency_hz *= kEarFactor;
    for (Transient& transient : pattern.transients) transient.frequency_hz *= kEarFactor;
    return pattern;
}

LayeredPattern for_ear(LayeredPattern layered) {
    for (Layer& layer : layered.layers) {
        auto* pattern = std::get_if<Pattern>(&layer.source);
        if (pattern != nullptr) *pattern = for_ear(std::move(*pattern));
    }
    return layered;
}

std::optional<DeviceInfo> ear_output(const PlayState& play) {
    if (!play.listed || !play.audio) return std::nullopt;
    const auto is_output = [](const DeviceInfo& device) {
        return device.kind == DeviceKind::audio && device.trouble.empty();
    };
    constexpr std::array<std::string_view, 3> kBySystem{"/pulse", "/pipewire", "/default"};
    for (const std::string_view end : kBySystem) {
        const auto found = std::ranges::find_if(*play.listed, [&](const DeviceInfo& device) {
            return is_output(device) && device.id.ends_with(end);
        });
        if (found != play.listed->end()) return *found;
    }
    const auto any = std::ranges::find_if(*play.listed, is_output);
    return any == play.listed->end() ? std::nullopt : std::optional(*any);
}

namespace {

// Longer patterns are rendered in the background: this length takes about a millisecond.
constexpr double kLongestAtOnceS = 2.0;

// Returns the number of the request.
std::uint64_t submit(const Ui& ui, PlayState& play, DriveRequest request) {
    request.number = ++play.drives_asked;
    play.drive_job.ask(
        std::move(request),
        [](const DriveRequest& asked, std::stop_token, std::atomic<float>&) {
            return std::optional(made_drive(asked));
        },
        ui.wake, JobPolicy::finish);
    return play.drives_asked;
}

// When two play in turn, phones of side A play the first, those of side B the second.
void aim_phones(const PlayState& play, std::size_t at) {
    const auto phones = play.phone_device.lock();
    if (!phones) return;
    const bool in_turn = play.sounding->names.size() == 2 && !play.sounding->selects;
    phones->set_side(!in_turn ? PhoneSide::both : at == 0 ? PhoneSide::a : PhoneSide::b);
}

void give_next(Ui& ui, Timeline& timeline, PlayState& play, const MadeDrive& made) {
    if (!made.remark.empty()) say(ui, made.remark);
    aim_phones(play,
               (play.sounding->at + 1) % std::max<std::size_t>(play.sounding->names.size(), 1));
    const Expected<Done> waits = play.device->play_after(made.drive, play.gap_s);
    if (waits) return;
    complain(ui, waits.error().message);
    silence(timeline, play);
}

// True: the requested drive cannot be played, and playing has ended.
bool fails_to_make(Ui& ui, Timeline& timeline, PlayState& play) {
    const std::string failure = play.drive_job.failure();
    if (failure.empty()) return false;
    complain(ui, "This cannot be played: " + failure + ".");
    silence(timeline, play);
    return true;
}

}  // namespace

double level_now(const PlayState& play) {
    return play.sounding ? play.sounding->level.value_or(play.level) : play.level;
}

void play_drive(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, bool loop) {
    play.halted = false;
    aim_phones(play, play.sounding->at);
    if (play.sounding->has_begun) return play.device->change(drive);
    play.sounding->has_begun = true;
    play.device->set_level(level_now(play));
    const Expected<Done> begun = play.device->play(drive, loop);
    if (begun) return;
    play.sounding.reset();
    timeline.playhead.playing = false;
    complain(ui, begun.error().message);
}

bool is_made_at_once(const DriveRequest& request) {
    const bool is_made = !std::holds_alternative<Measurement>(request.vibration.source);
    const bool is_long = is_made && own_duration_s(request.vibration) > kLongestAtOnceS;
    return !request.by.calibration && !is_long;
}

void play_vibration(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& vibration) {
    DriveRequest request = drive_request(play, vibration);
    request.loops = play.sounding->loops;
    play.sounding->driven_by = request.by;
    if (is_made_at_once(request)) {
        const MadeDrive made = made_drive(request);
        if (!made.remark.empty()) say(ui, made.remark);
        return play_drive(ui, timeline, play, made.drive, play.sounding->loops);
    }
    const std::uint64_t number = submit(ui, play, std::move(request));
    play.sounding->is_prepared = false;
    if (!play.sounding->has_begun) play.sounding->first_drive = number;
}

void play_next(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& next) {
    DriveRequest request = drive_request(play, next);
    Sounding& sounding = *play.sounding;
    sounding.next = next;
    sounding.next_by = request.by;
    if (is_made_at_once(request)) return give_next(ui, timeline, play, made_drive(request));
    sounding.next_drive = submit(ui, play, std::move(request));
}

bool take_next_drive(Ui& ui, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    if (sounding.next_drive == 0) return false;
    if (fails_to_make(ui, timeline, play)) return true;
    const auto made = play.drive_job.latest();
    if (!made || made->request.number != sounding.next_drive) return false;
    sounding.next_drive = 0;
    play.drive_taken = made->request.number;
    give_next(ui, timeline, play, *made);
    return true;
}

bool take_drive(Ui& ui, Timeline& timeline, PlayState& play) {
    Sounding& sounding = *play.sounding;
    const auto made = play.drive_job.latest();
    if (sounding.is_prepared) return false;
    if (fails_to_make(ui, timeline, play)) return true;
    if (!made || made->request.number < sounding.first_drive ||
        made->request.number == std::exchange(play.drive_taken, made->request.number)) {
        return false;
    }
    sounding.is_prepared = made->request.number == play.drives_asked;
    if (!made->remark.empty()) say(ui, made->remark);
    play_drive(ui, timeline, play, made->drive, sounding.loops);
    return true;
}

}  // namespace tact
