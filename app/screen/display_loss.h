// The X server is gone: actuators come to rest, what is to be kept is kept, one sentence is said,
// the program ends with 1.
//
// Xlib ends the program by itself, with whichever thread found out; destructors that then run
// beside the other thread crash it. The program's own thread, which is inside Xlib and so changes
// nothing, does the keeping; any other waits for it.
//
// A Wayland compositor that is gone is noticed by GLFW, which asks every window to close.
#pragma once

#include <functional>
#include <string>

namespace tact {

// Arms this for the rest of the run. The drawing thread calls it, and calls `keep` once when the
// screen is lost; it answers with what could not be kept, empty: all is. An empty `keep` saves
// nothing.
void end_with_display(std::function<std::string()> keep);

// Ends so if a Wayland compositor is gone; otherwise does nothing. For whoever is asked to close.
void end_if_compositor_is_gone();

}  // namespace tact
