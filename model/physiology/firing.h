// The part of a type's firing that comes from the model, not from the skin.
//
// Source    ours; that a fibre fires about once a cycle: Talbot, Darian-Smith, Kornhuber &
//           Mountcastle 1968
// Input     a vibration and its stages
// Left out  bursts of less than four cycles; in a sweep, cycles are those of its fastest strong
//           part
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/common/units.h"
#include "model/physiology/neural_coding.h"

namespace tact {

// Largest leak of a filter, relative to the vibration's strongest component: less than this means
// that the type's band is empty, and the output is leak and ringing at the begin and end of the
// vibration. [ours]
inline constexpr double kLeakShare = 0.05;

// Whether the type follows only its filter's leak.
bool only_leaks(const NeuralCodingStages& stages, const NeuralCodingParams& params,
                Receptor receptor);

// Whether a type fires: following the filter's leak does not count, whatever the number of spikes.
// Everything that names firing types uses this.
enum class Firing { silent, leaks, fires };
PerReceptor<Firing> firing_of(const NeuralCodingStages& stages, const NeuralCodingParams& params);

// The 5 ms steps of a type's impulses without any change of the vibration since the step before:
// impulses there follow the ringing of filters.
std::vector<char> silent_steps(const Waveform& waveform, const ChannelStages& channel);

struct SilentFiring {
    std::int64_t in_silence = 0;  // impulses of all receptors of the type
    std::int64_t all = 0;
};
SilentFiring silent_firing(const Waveform& waveform, const ChannelStages& channel);

// Impulses of the receptor under the probe, in each 5 ms step; empty without such a receptor.
std::span<const int> spikes_under_probe(const ChannelStages& channel);

// From the lowest to the highest strong component of a type's band; nullopt: it has none.
std::optional<Range> strong_band_hz(const NeuralCodingStages& stages, Receptor receptor);

// Above this number of impulses a cycle, remarks tell it: a real fibre fires one. Smaller numbers
// round to 1 in two digits.
inline constexpr double kManyACycle = 1.05;

// Impulses of the receptor under the probe per cycle of the fastest strong component of its band,
// where the rate is highest: over 100 ms, or four cycles. 0 without impulses.
double impulses_a_cycle(const NeuralCodingStages& stages, Receptor receptor);

}  // namespace tact
