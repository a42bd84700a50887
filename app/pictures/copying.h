// Patterns on the clipboard of the desktop, as text: a set file.
//
// What is copied here can be pasted into another window, a message or an editor; a set file that
// was copied there can be pasted here.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

void copy_selected(Ui& ui, Workspace& work);

// What was copied last, here or as the text of a set file elsewhere; one step.
void paste(Ui& ui, Workspace& work);

}  // namespace tact
