// Ctrl+Z and its like: a program that is halted drives nothing, so all that plays is put to rest
// before, and stays at rest when the program continues. A page is halted when it is hidden or left.
//
// Source    signal-safety(7); SIGTSTP, SIGTTIN and SIGTTOU, where nobody else answers them
// Left out  SIGSTOP, which no program hears: a controller keeps doing what it was told last, JACK
//           repeats its last period, other outputs fall silent within what was rendered ahead.
#pragma once

#include <cstdint>

namespace tact {

// Handles every signal to halt that still has its default action. A second call changes nothing.
void rest_before_halts();

// The same for who ends the program without its destructors, from any thread: returns when all is
// at rest.
void rest_all();

// Called by the signal's handler, which may do little; null: nothing.
void call_before_halts(void (*before_halt)());

// How often the program was about to be halted. What plays looks at it every 20 ms or so, and ends
// with a fade or neutral packets when it has grown.
std::uint64_t halts();

// Why a play ended by itself after that, for its status.
extern const char* const kHalted;

}  // namespace tact
