// A sound file in memory: written to the disk whole or not at all, and read from what was looked
// at.
#pragma once

#include <sndfile.h>

#include <cstddef>
#include <string>

namespace tact {

struct MemorySound {
    std::string bytes;
    std::size_t position = 0;
};

// As sf_open_virtual; `memory` must outlive the result.
SNDFILE* open_for_reading(MemorySound& memory, SF_INFO& info);
SNDFILE* open_for_writing(MemorySound& memory, SF_INFO& info);

}  // namespace tact
