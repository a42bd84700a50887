// The view of studies: what people are asked, who took part, what they said.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_study_design(App& app);
void draw_study_people(App& app);
void draw_study_answers(App& app);

}  // namespace tact
