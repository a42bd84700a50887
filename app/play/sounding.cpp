#include "app/play/sounding.h"

#include <algorithm>
#include <utility>

#include "app/play/calibrating.h"
#include "app/play/playing.h"
#include "app/progress/failure.h"
#include "devices/phone/phone_device.h"

namespace tact {

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
