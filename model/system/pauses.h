// Long work on the only thread there is: it pauses, so that the window draws and listens meanwhile.
//
// Input     work, which says where it may pause
// Output    what it has without pauses
// Source    JavaScript Promise Integration, a standard of WebAssembly: Chrome and Edge from 137 on
// Valid     pages without threads. Other browsers, and other systems, do the work in one piece
#pragma once

#include <functional>

namespace tact {

// Returns when the work ends or pauses; it then continues between later frames, to its end, in turn
// with other work that was called so meanwhile. `work` must not throw.
void call_with_pauses(std::function<void()> work);

// Called by work as often as it likes: it pauses if it has taken long since it did last.
void pause_if_due();

// Whether the caller is work that can pause.
bool is_pausable();

}  // namespace tact
