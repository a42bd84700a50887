// A waveform as CSV: a line with the columns' names, then time and acceleration of each sample.
//
// Output    "time_s,acceleration_g"; 17 digits, which read back to the bit
// Left out  reading: model/io/recordings/acceleration_table.h.
#pragma once

#include <string>

#include "model/signal/waveform.h"

namespace tact {

std::string waveform_csv(const Waveform& waveform);

}  // namespace tact
