// How a command ends: exit codes, and Ctrl+C.
#pragma once

#include <atomic>
#include <stop_token>

#include "model/common/expected.h"
#include "model/system/signal_watch.h"

namespace tact {

// How the program ends, whatever it was asked for: descriptors, signals and streams of the process.
//
// Source    signal-safety(7); what shells expect of exit codes

// First thing in main(), once.
//
// - Standard descriptors that are closed are taken, so that no file gets their number: reading
// finds
//   the end, writing results fails, remarks are lost.
// - Signals that end the program remove the temporary files of what is being written, and say so.
//   Who waits for them otherwise (Interrupt) blocks them. One that is ignored stays ignored.
// - A reader that has gone away is an error of writing, with its sentence.
// - Nothing on a terminal steers it: see model/text/shown_text.h. A remark on standard error is
//   written in pieces, of which only the last one ends a line; results keep their lines, and go to
//   files and pipes byte by byte.
void prepare_endings();

// An Error unless all that was printed has reached standard output.
Expected<Done> flushed_output();

// Ctrl+C, Ctrl+\, SIGTERM and a closed terminal as a request to stop, for work that has something
// to keep.
//
// The first one asks the work to stop and says so; the second ends the program at once. One that
// another process of the same work had counts as a first, but not towards the second. A signal that
// was ignored when the program began (nohup, a shell's background job) stays ignored.

// What a signal is to the work that it stops: an end before its time, or the end that it waits for,
// as a page does that is served until Ctrl+C.
enum class Interrupted { too_early, is_the_end };

// While it lives, signals go to its thread. To be made before any other thread, as threads inherit
// the mask of signals.
class Interrupt {
  public:
    explicit Interrupt(Interrupted what = Interrupted::too_early);
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return stop_.get_token(); }

    // Asks the work to stop as if the signal had come here. From any thread.
    void stop_by(int signal);

    // From now on another process speaks for this one.
    void be_silent() { is_silent_ = true; }

  private:
    Interrupted what_;
    std::stop_source stop_;
    std::atomic<bool> is_silent_{false};
    SignalWatch watch_;  // last: ends before what it stops
};

// The signal that an Interrupt was asked to stop by; 0: none.
int interrupting_signal();

// The exit code that shells expect of a program that was interrupted: 130 after Ctrl+C, 143 after
// SIGTERM, 129 after SIGHUP, 131 after SIGQUIT. 0: no Interrupt was asked to stop.
int interrupted_exit_code();

}  // namespace tact
