// What is opened, pointed at and compared in the stages of the model.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/query.h"
#include "app/physiology/live_stages.h"
#include "app/physiology/stage_signals.h"
#include "app/physiology/stages.h"

namespace tact {

// One receptor of one type: its place in the grid of the shown pattern.
struct ReceptorPlace {
    Receptor type = Receptor::pacinian;
    std::size_t index = 0;

    bool operator==(const ReceptorPlace&) const = default;
};

// The layers on screen, kept while neither the pattern nor the step changes.
struct ShownLayers {
    std::shared_ptr<const LiveStages> of;
    std::size_t step = 0;
    PerReceptor<std::vector<RelayLayer>> layers;
};

// Where two patterns part, kept while both stay what they are.
struct ShownDifference {
    std::shared_ptr<const LiveStages> a;
    std::shared_ptr<const LiveStages> b;
    StageDifferences stages;
    std::array<std::vector<std::vector<double>>, kStages.size()> signals;  // a - b
    double nc = 0.0;
};

// A threshold that is moved in the spectrum, in this frame.
struct ThresholdMove {
    Receptor type = Receptor::pacinian;
    double db = 0.0;
    bool is_last = false;
};

struct PhysiologyState {
    std::optional<Stage> open;              // fills the pane; none: all of them, small
    std::optional<Stage> explained;         // its text is open beside it
    Receptor network = Receptor::pacinian;  // whose layers the overview shows
    bool network_chosen = false;            // by the person; otherwise the strongest one
    bool textbook = false;                  // what was measured is laid over the stages
    bool tilted = false;
    double tilt_since_s = -10.0;
    std::optional<ReceptorPlace> hovered;  // in this frame, in any view
    std::optional<ReceptorPlace> hovered_last;
    std::optional<ReceptorPlace> selected;
    ShownLayers layers;
    ShownLayers pinned_layers;
    ShownDifference difference;
    std::optional<ThresholdMove> threshold_move;
    std::optional<double> pair_oc;  // of the two patterns on screen, where the map knows it
};

struct Physiology {
    Query<LiveStagesRequest, LiveStages> stages_job;
    std::shared_ptr<const LiveStages> stages;  // of the current vibration, or of one before it
    bool put_off = false;                      // newer ones, to the next frame
    Query<LiveStagesRequest, LiveStages> pinned_job;
    std::shared_ptr<const LiveStages> pinned_stages;
    PhysiologyState view;
};

}  // namespace tact
