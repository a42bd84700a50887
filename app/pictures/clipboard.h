// A picture on the clipboard of the desktop, by the program that the desktop has for it.
//
// Output    PNG; an Error that names the package where no such program is installed
// Left out  clipboards of our own: GLFW's hold text, and what a window owns is gone when it closes
#pragma once

#include "model/common/expected.h"
#include "viz/picture/picture.h"

namespace tact {

Expected<Done> copy_to_clipboard(const Image& image);

}  // namespace tact
