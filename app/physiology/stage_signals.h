// The signals over time that make up a stage, for drawing, comparing and exporting them alike.
//
// Left out  grids and layers: those are no signals over time.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/physiology/live_stages.h"
#include "app/physiology/stages.h"

namespace tact {

struct StageSignal {
    std::string id{};                    // "filtered FA1", "brain"
    std::optional<Receptor> receptor{};  // of which channel; none: of all
    std::span<const double> samples{};
    double rate_hz = kModelRateHz;
    bool is_signed = false;
    double largest = 0.0;  // of its scale; 0: its own largest sample
    const char* unit = "";
};

// Views into `live`. Empty for stages that are no signals.
std::vector<StageSignal> signals_of(const LiveStages& live, Stage stage);

// How far two patterns are apart at each stage, 0 the same to 1 nothing in common
// (model/signal/relative_difference.h); none where a stage has no measure of its own.
using StageDifferences = std::array<std::optional<double>, kStages.size()>;
StageDifferences stage_differences(const LiveStages& a, const LiveStages& b);

// a - b, sample by sample, for each signal of a stage.
std::vector<std::vector<double>> signal_differences(const LiveStages& a, const LiveStages& b,
                                                    Stage stage);

}  // namespace tact
