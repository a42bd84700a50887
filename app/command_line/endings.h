// How the program ends, whatever it was asked for: descriptors, signals and streams of the process.
//
// Source    signal-safety(7); what shells expect of exit codes
#pragma once

#include "model/common/expected.h"

namespace tact {

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

}  // namespace tact
