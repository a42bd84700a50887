// Samples: WAV with what its full scale is beside it, and CSV. They hold g, and need no actuator.
//
// What others wrote is read as a recording (model/io/recordings/recording.h).
#pragma once

#include <array>

#include "model/io/effects_out/written_effect.h"

namespace tact {

// The least full scale that holds a peak at each of its whole-number steps; 1 g of silence.
double full_scale_of(double peak_g, WaveEncoding encoding);

// A peak above the full scale is turned down, with a remark.
WrittenEffect write_wav(const Waveform& waveform, const EffectTarget& target);
WrittenEffect write_csv(const Waveform& waveform, const EffectTarget& target);

// As they were written, at the model's rate. `name`: the file's, for messages.
Expected<Recording> wav_back(const WrittenEffect& written, const std::string& name,
                             const EffectTarget& target);
// The table's numbers at the rate that they were written at; nothing is taken off, as a reader of
// accelerometers would.
Expected<Recording> csv_back(const WrittenEffect& written, const std::string& name,
                             const EffectTarget& target);

inline constexpr std::array kSamplesTargets{TargetTraits{.format = TargetFormat::wav,
                                                         .key = "wav",
                                                         .title = "WAV",
                                                         .ending = ".wav",
                                                         .beside = ".wav.json",
                                                         .write_samples = write_wav,
                                                         .read_samples = wav_back},
                                            TargetTraits{.format = TargetFormat::csv,
                                                         .key = "csv",
                                                         .title = "CSV of accelerations",
                                                         .ending = ".csv",
                                                         .write_samples = write_csv,
                                                         .read_samples = csv_back}};

}  // namespace tact
