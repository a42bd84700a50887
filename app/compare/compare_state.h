// What the tabs that compare show.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/compare/live_comparison.h"
#include "app/compare/live_difference.h"
#include "app/jobs/latest_job.h"
#include "app/map/live_map.h"
#include "model/evaluation/findings.h"
#include "model/evaluation/metric.h"
#include "viz/charts/scatter_view.h"

namespace tact {

enum class CompareView { table, scatter, findings };

// The points of the Shepard diagram, kept while its map stays what it is.
struct ShepardFit {
    std::shared_ptr<const void> owner;
    const PerceptualSpace* of = nullptr;  // in the owner
    std::vector<double> distances;        // in the map, of all pairs
    std::vector<double> disparities;
    ScatterSummary summary;  // of both: sorting half a million pairs is not for every frame
};

struct ComparePanelState {
    CompareView view = CompareView::table;
    Metric metric = Metric::pm;          // whose scatter is shown, and whose Shepard diagram
    bool shepard_of_people = false;      // instead
    bool cancelled = false;              // by the person, until the next edit ...
    std::uint64_t cancelled_at = 0;      // ... of this revision
    std::uint64_t compute_large_of = 0;  // the document whose many patterns were asked for
    std::shared_ptr<const LiveMap> of;   // what was asked for last
    ShepardFit fit;
};

struct Comparing {
    std::unique_ptr<LatestJob<ComparisonRequest, Comparison>> comparison_job;
    std::shared_ptr<const Comparison> comparison;  // of the map on screen, or of one before it
    std::unique_ptr<LatestJob<DifferenceRequest, LiveDifference>> difference_job;
    std::shared_ptr<const LiveDifference> difference;
    DifferenceRequest difference_asked;
    std::unique_ptr<LatestJob<int, std::vector<Finding>>> findings_job;  // asked for by number
    std::shared_ptr<const std::vector<Finding>> findings;
    ComparePanelState panel;
};

}  // namespace tact
