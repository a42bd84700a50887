#include "app/play/listening.h"

#include <chrono>

#include "app/document/editing.h"
#include "app/map/pair.h"
#include "app/play/calibrating.h"
#include "app/play/playing.h"
#include "app/play/sounding.h"
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

}  // namespace

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

}  // namespace tact
