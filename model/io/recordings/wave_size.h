// Whether a WAV file is as long as its header says. libsndfile reads a truncated one without a
// word.
//
// Source    RIFF (Microsoft & IBM 1991), RF64 (EBU Tech 3306), BW64 (ITU-R BS.2088), sizes as sox
// leaves them
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace tact {

// Empty if all of the data chunk is there; otherwise the end of a sentence ("has 10 of the 400
// bytes of samples that its header promises"). Sizes that a stream's writer left open are accepted.
std::string wave_size_fault(std::istream& stream, std::uint64_t file_bytes);

}  // namespace tact
