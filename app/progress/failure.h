// Why a job that a pane waits for has no answer: said in place of the waiting.
#pragma once

#include <string>

#include "app/ui/ui.h"

namespace tact {

// The sentence at the cursor; false: nothing to say. `pane` is its name for tests.
bool draw_failure(Ui& ui, const char* pane, const std::string& failure);

}  // namespace tact
