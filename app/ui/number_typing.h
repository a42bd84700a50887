// The number that is being typed in an entry: what of it outlives a frame.
#pragma once

#include <string>

namespace tact {

struct NumberTyping {
    unsigned entry = 0;    // ImGui's name of the one with the keyboard; 0: none
    int frame = 0;         // when it was last drawn so
    std::string text;      // as it stands there
    std::string first;     // as it stood there at first: what Esc goes back to ...
    double before = 0.0;   // ... and the number that was
    std::string taken;     // as it stood when it was last taken: an arrow takes at once
    unsigned refused = 0;  // the entry whose last text was no good
};

}  // namespace tact
