// Measured facts beside the model's results for one pattern, stage by stage, and the model's
// deviations from them.
//
// Source    the facts' own (textbook.h); the limits of a deviation are ours, and marked
// Input     a vibration, its stages, the model's tables
// Output    facts that apply to this pattern, in the order of the textbook; the model's number in
//           the fact's unit
// Left out  facts from memory: no stage shows them
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"
#include "model/textbook/textbook.h"

namespace tact {

// Limits of a deviation: a rate above the measured one by this share of it, a threshold off by this
// many dB, a density off by this share. [ours]
inline constexpr double kRateSlack = 0.1;
inline constexpr double kThresholdSlackDb = 6.0;
inline constexpr double kDensitySlack = 0.1;

struct BesideFact {
    const TextbookFact* fact = nullptr;  // never null
    std::optional<Receptor> receptor{};  // the type behind the model's number
    std::optional<double> at_hz{};       // for a fact that depends on frequency ...
    std::optional<double> measured{};    // ... its value there
    std::optional<double> model{};       // nullopt: the fact stands by itself
    bool parts = false;
};

struct BesideInput {
    const Waveform& waveform;
    const NeuralCodingStages& stages;
    const PhysiologyTables& tables;
    PerReceptor<Firing> firing;
};

// `stage` by its key: "spikes".
std::vector<BesideFact> beside_the_model(std::string_view stage, const BesideInput& input);

// Facts from which the model deviates.
std::vector<BesideFact> where_the_model_parts(std::string_view stage, const BesideInput& input);

// Facts of one kind, source and unit in one line: "density: Meissner 178, Merkel 134 fibres/cm2
// (..., monkey); here 140, 70". Deviations come first.
struct BesideLine {
    std::string text;
    bool parts = false;
};
std::vector<BesideLine> lines_of(const std::vector<BesideFact>& facts);

}  // namespace tact
