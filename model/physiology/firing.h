// What of a type's firing is the model's doing and not the skin's.
//
// Source    ours; that a fibre fires about once a cycle: Talbot, Darian-Smith, Kornhuber &
//           Mountcastle 1968
// Input     a vibration and its stages
// Left out  bursts of less than four cycles; of a sweep, cycles are those of its fastest strong
// part
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/common/range.h"
#include "model/physiology/neural_coding.h"

namespace tact {

// What a filter lets through of a vibration's strongest component, or of any other, is at most this
// share of the strongest: nothing of the type's band, but what the filter leaks, and how it rings
// where the vibration begins and ends. [ours]
inline constexpr double kLeakShare = 0.05;

// The type follows nothing but what its filter leaks.
bool only_leaks(const NeuralCodingStages& stages, const NeuralCodingParams& params,
                Receptor receptor);

// Whether a type fires: what its filter leaks is no firing, however often it is counted. All that
// names types that fire goes by this.
enum class Firing { silent, leaks, fires };
PerReceptor<Firing> firing_of(const NeuralCodingStages& stages, const NeuralCodingParams& params);

// The 5 ms steps of a type's impulses in which nothing has moved since the step before: what is
// fired there answers to filters that ring on.
std::vector<char> silent_steps(const Waveform& waveform, const ChannelStages& channel);

struct SilentFiring {
    std::int64_t in_silence = 0;  // impulses of all receptors of the type
    std::int64_t all = 0;
};
SilentFiring silent_firing(const Waveform& waveform, const ChannelStages& channel);

// Impulses of the receptor under the probe, in each 5 ms step; empty where there is none.
std::span<const int> spikes_under_probe(const ChannelStages& channel);

// From the lowest to the highest strong component of a type's band; none: it has none.
std::optional<Range> strong_band_hz(const NeuralCodingStages& stages, Receptor receptor);

// More impulses a cycle than this are said: a fibre fires one. Less is 1 in two digits.
inline constexpr double kManyACycle = 1.05;

// How many impulses the receptor under the probe fires in a cycle of the fastest strong component
// of its band, where it fires most: over 100 ms, or four cycles. 0 where it does not fire.
double impulses_a_cycle(const NeuralCodingStages& stages, Receptor receptor);

}  // namespace tact
