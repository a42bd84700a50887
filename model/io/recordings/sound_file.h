// Any sound as samples, to be made a vibration of: music, speech, a drum, a recording.
//
// Source    libsndfile: WAV, FLAC, Ogg, Opus, MP3, AIFF, AU, CAF and what else it knows; text and
//           tables of accelerations as model/io/recordings reads them
// Input     any rate of 100 Hz to 10 MHz, any number of channels
// Output    the mean of the channels at 10 kHz, without its constant offset, 1 being full scale; of
//           recordings in g, g. What was done to it as remarks. Errors as "FILE: .."
// Valid     1 ms to 60 s; kMaxWaveBytes and kMaxDecodedSamples of all channels. Silence is refused
// Left out  what a player would do: tags of loudness, loops, cue points.
#pragma once

#include <sndfile.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/signal/waveform.h"

namespace tact {

struct SoundFile {
    Waveform waveform;
    std::optional<double> scale_g;     // that 1 stands for, where the file or its sidecar says so
    double duration_s = 0.0;           // at the file's own rate
    std::vector<std::string> remarks;  // "2 channels are mixed", without the file
};

Expected<SoundFile> read_sound_file(const std::filesystem::path& path);

// Whether its first bytes are those of a sound, not of a table.
bool is_sound_file(const std::filesystem::path& path);

// A sound file in memory: written to the disk whole or not at all, and read from what was looked
// at.

struct MemorySound {
    std::string bytes;
    std::size_t position = 0;
};

// As sf_open_virtual; `memory` must outlive the result.
SNDFILE* open_for_reading(MemorySound& memory, SF_INFO& info);
SNDFILE* open_for_writing(MemorySound& memory, SF_INFO& info);

}  // namespace tact
