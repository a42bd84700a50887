// The view of studies: what people are asked, who took part, what they said.
#pragma once

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/study/study_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

void draw_study_design(Ui& ui, Workspace& work, const PlayState& play, StudyState& studying);
void draw_study_people(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                       const ShownMap& shown_map, Comparing& comparing, PlayState& play,
                       StudyState& studying);
void draw_people_table(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                       StudyState& studying, const StudyAnswers& answers);
void draw_study_answers(Ui& ui, const Workspace& work, ShownMap& shown_map, StudyState& studying);

// Who counts, decided by hand: someone left out with a reason, which the study's folder keeps, and
// rules on how people answered.

// Asks for the reason first.
void ask_to_leave_out(Ui& ui, StudyState& studying, const std::string& code);
void count_again(Ui& ui, const Workspace& work, StudyState& studying, const std::string& code);

// Dialog::leave_out and Dialog::conduct_rules.
void draw_leave_out_dialog(Ui& ui, const Workspace& work, StudyState& studying);
void draw_conduct_dialog(Ui& ui, StudyState& studying);

// "3 rules...": how many are on, for the link that opens the dialog.
std::string conduct_summary(const ConductRule& rule);

}  // namespace tact
