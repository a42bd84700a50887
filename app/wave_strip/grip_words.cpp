// Words for the grips.

#include "app/wave_strip/wave_strip.h"

namespace tact {

const char* name_of(GripKind kind) {
    switch (kind) {
        case GripKind::level:
            return "amplitude";
        case GripKind::frequency:
            return "frequency";
        case GripKind::amplitude_point:
            return "amplitude curve";
        case GripKind::frequency_point:
            return "frequency curve";
        case GripKind::transient:
            return "transient";
        case GripKind::attack:
            return "attack";
        case GripKind::release:
            return "release";
        case GripKind::note_start:
        case GripKind::note:
        case GripKind::note_end:
        case GripKind::note_top:
            return "rhythm";
        case GripKind::end:
            return "duration";
    }
    return "";
}

const char* help_on(GripKind kind) {
    switch (kind) {
        case GripKind::level:
            return "Drag: amplitude. Click: a point of its curve.";
        case GripKind::frequency:
            return "Drag: frequency. Click: a point of its curve.";
        case GripKind::amplitude_point:
        case GripKind::frequency_point:
            return "Drag: move the point; Shift along one axis, Alt free of the grid. Double click "
                   "or Del: remove.";
        case GripKind::transient:
            return "Drag: move the transient. Double click or Del: remove.";
        case GripKind::attack:
            return "Drag: attack of every note.";
        case GripKind::release:
            return "Drag: release of every note.";
        case GripKind::note_start:
            return "Drag: where the note begins; Shift to beats, Alt to quarters of a step.";
        case GripKind::note:
            return "Drag: move the note; Shift by beats, Alt to quarters of a step. Shift and a "
                   "click: choose it, too. Double click: remove.";
        case GripKind::note_end:
            return "Drag: where the note ends; Shift to beats, Alt to quarters of a step.";
        case GripKind::note_top:
            return "Drag: strength of the note, and of all that are chosen, in ninths.";
        case GripKind::end:
            return "Drag: duration.";
    }
    return "";
}

const char* help_on(StripTool tool) {
    switch (tool) {
        case StripTool::curves:
            return "Double click: a transient. Wheel: zoom, with Shift: along.";
        case StripTool::notes:
            return "Drag: draw a note; with Shift: choose several. Wheel: zoom, with Shift: along.";
        case StripTool::ticks:
            return "Press: a transient. Wheel: zoom, with Shift: along.";
    }
    return "";
}

const char* name_of(StripTool tool) {
    switch (tool) {
        case StripTool::curves:
            return "Curves";
        case StripTool::notes:
            return "Notes";
        case StripTool::ticks:
            return "Ticks";
    }
    return "";
}

}  // namespace tact
