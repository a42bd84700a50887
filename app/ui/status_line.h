// What was last said at the foot of the window.
#pragma once

#include <string>

namespace tact {

// A line at the foot of the window; errors stay until replaced, the rest fades.
struct StatusLine {
    std::string text;
    bool is_error = false;
    double since_s = 0.0;
};

}  // namespace tact
