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
void draw_study_answers(Ui& ui, const Workspace& work, ShownMap& shown_map, StudyState& studying);

}  // namespace tact
