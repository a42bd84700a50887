// A waveform as text: one sample a line, in g, at 10 kHz.
//
// Source    the layout of the files that the paper's authors publish
// Input     Windows line ends, a byte-order mark and blank lines at the end are accepted
// Output    errors as "FILE:LINE: expected .."
// Valid     1 sample to 60 s; a file of at most kMaxTextWaveformBytes
// Left out  other rates, several columns, comments.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/signal/waveform.h"

namespace tact {

inline constexpr std::size_t kMaxTextWaveformBytes = std::size_t{1} << 26;  // 100 a sample

Expected<Waveform> parse_text_waveform(std::string_view text, const std::string& file);
Expected<Waveform> read_text_waveform(const std::filesystem::path& path);

// Shortest digits that read back as the same samples. Another rate is resampled to 10 kHz. What is
// not finite or above 1,000,000 g is not written, as it could not be read again.
std::string print_text_waveform(const Waveform& waveform);
Expected<Done> write_text_waveform(const std::filesystem::path& path, const Waveform& waveform);

// A waveform as CSV: a line with the columns' names, then time and acceleration of each sample.
//
// Output    "time_s,acceleration_g"; 17 digits, which read back to the bit
// Left out  reading: model/io/recordings/acceleration_table.h.

std::string waveform_csv(const Waveform& waveform);

}  // namespace tact
