// Measured facts beside what the model makes of one pattern, stage by stage, and where it parts
// from them.
//
// Source    the facts' own (textbook.h); what counts as parting is ours, and stands with each limit
// Input     a vibration, its stages, the tables that the model takes
// Output    facts that say something of this pattern, in the order of the textbook; the model's
//           number in the fact's unit
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

// A measured rate is exceeded by more than this share of it, a threshold missed by more than so
// many dB, a density by more than this share. [ours]
inline constexpr double kRateSlack = 0.1;
inline constexpr double kThresholdSlackDb = 6.0;
inline constexpr double kDensitySlack = 0.1;

struct BesideFact {
    const TextbookFact* fact = nullptr;  // never null
    std::optional<Receptor> receptor{};  // whose number the model's is
    std::optional<double> at_hz{};       // where a fact goes over frequency ...
    std::optional<double> measured{};    // ... what it is there
    std::optional<double> model{};       // none: the fact speaks for itself
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

// Those that part from what was measured.
std::vector<BesideFact> where_the_model_parts(std::string_view stage, const BesideInput& input);

// Facts of one kind, source and unit in one line: "density: Meissner 178, Merkel 134 fibres/cm2
// (..., monkey); here 140, 70". Those that part come first.
struct BesideLine {
    std::string text;
    bool parts = false;
};
std::vector<BesideLine> lines_of(const std::vector<BesideFact>& facts);

}  // namespace tact
