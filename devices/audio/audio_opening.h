// Keeps what ALSA, JACK and PortAudio write of their own insides from a person's terminal.
//
// Left out  what else is written to standard error: it passes.
#pragma once

namespace tact {

// PortAudio has no other way than to write to stderr ("Expression ... failed in ..."); such lines
// are dropped from now on. Before other threads.
void filter_standard_error();

// ALSA and JACK say by it what they did not find. Before PortAudio starts, each time.
void silence_libraries();

}  // namespace tact
