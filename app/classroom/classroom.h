// Phones in the room, joined with what else the window has: the question of the lesson, the folder
// of a study, the pairs of the map.
#pragma once

#include "app/document/workspace.h"
#include "app/lesson/lesson.h"
#include "app/map/map.h"
#include "app/phones/phones.h"
#include "app/play/play.h"
#include "app/study/study.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"

namespace tact {

// What a class with phones touches.
struct Classroom {
    Ui& ui;
    Workspace& work;
    Layout& layout;
    const ShownMap& map;
    PlayState& play;
    StudyState& studying;
    LessonState& lesson;
    PhonesState& phones;
};

// Each frame: what the lesson asks goes to the phones, what they answer to the lesson and the
// study.
void follow_class(const Classroom& room);

// What was pressed in the dialog on phones.
void act_on_phones(const Classroom& room, const PhonesActions& actions);

}  // namespace tact
