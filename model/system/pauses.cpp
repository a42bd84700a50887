#include "model/system/pauses.h"

namespace tact {

void call_with_pauses(std::function<void()> work) { work(); }

void pause_if_due() {}

bool is_pausable() { return false; }

}  // namespace tact
