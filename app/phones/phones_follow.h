// Phones of the room: the page served and withdrawn, and each frame what they are shown and say.
//
// Left out  the lesson and the folder of a study, which are other rooms': app/classroom/classroom.h
#pragma once

#include "app/document/workspace.h"
#include "app/phones/phones_state.h"
#include "app/play/play_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

void serve_phones(Ui& ui, PlayState& play, PhonesState& state);
// Everything that was under way ends; what has been answered is kept.
void stop_phones(Ui& ui, Timeline& timeline, PlayState& play, PhonesState& state);
// At the end of the program, without a word.
void end_phones(PhonesState& state);

bool are_phones_served(const PhonesState& state);

// What came of a frame, for other rooms.
struct PhonesNews {
    bool rated = false;                    // an answer of a rating was kept
    std::optional<PhoneTrials> all_tried;  // trials that have come to their end
};
// Each frame, before follow_sound.
PhonesNews follow_phones(Ui& ui, const Workspace& work, PlayState& play, PhonesState& state);

// What the lesson asks now; none: nothing. It comes before everything else that phones show.
void ask_phones(PhonesState& state, std::optional<ChoiceCard> question);

// "3 phones, 2 of which vibrate": who is here now.
std::string phones_words(const PhonesState& state);

void begin_rating(Ui& ui, Workspace& work, PhonesState& state, const std::filesystem::path& folder);
void end_rating(Ui& ui, PhonesState& state);

// Pairs of the map that is shown, with their PM.
void begin_trials(Ui& ui, const Workspace& work, PhonesState& state, int phone,
                  std::vector<TrialPair> pairs);
void end_trials(Ui& ui, PhonesState& state);

}  // namespace tact
