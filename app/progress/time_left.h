// How long a run under way will still take, from how far it is: "about 40 s left".
//
// Input     seconds since it began, share done (0 to 1)
// Output    words; empty while too little is known or too little is left to be worth them
// Valid     work that continues at its pace so far
#pragma once

#include <string>

namespace tact {

// Rounded up, coarser the longer it is: a number that dances tells less.
std::string time_left_text(double elapsed_s, double share);

// What work will take by a rough estimate, said as one: "about 40 s", "less than 1 s".
std::string estimate_text(double seconds);

}  // namespace tact
