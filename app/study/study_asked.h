// How a study asks: the numbers of its design that are typed, with their words and bounds; and what
// of the design the first participant has fixed, as what is asked otherwise is another study.
//
// Left out  the comparison of two designs: model/study/study_record.h
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/study/study_state.h"
#include "app/ui/described_field.h"
#include "app/ui/ui.h"
#include "model/study/study_design.h"

namespace tact {

// A number of the design.
struct StudyNumber {
    DescribedField<StudyDesign> row;
    bool of_pairs = true;  // sorting has none of it
};

std::span<const StudyNumber> study_numbers();

// What the study now asks otherwise than the folder's first participant was asked, as phrases; by
// the participants as they were last read.
std::vector<std::string> design_changes(const Workspace& work, const StudyState& studying);

// "Another study than that of this folder's first participant: repetitions 2, not 4."
std::string another_study_words(const std::vector<std::string>& changes);

// The words; empty where nothing has changed.
std::string design_obstacle(const Workspace& work, const StudyState& studying);

// The two ways on: participants go into a folder beside, which has nobody yet, or participants of
// the design as it now is; or the design is again as it was, in one undo step.
void begin_another_study(Ui& ui, const Workspace& work, StudyState& studying);
void take_design_back(Ui& ui, Workspace& work, const StudyState& studying);

}  // namespace tact
