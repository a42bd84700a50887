// Work in the background gives way to the window.
#pragma once

namespace tact {

// The calling thread, and threads it starts from now on, run when the interface has nothing to do.
// Where the system has no such thing, nothing happens.
void give_way_to_interface();

}  // namespace tact
