// State of the tabs that compare.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/compare/live_comparison.h"
#include "app/compare/live_difference.h"
#include "app/jobs/query.h"
#include "app/map/live_map.h"
#include "model/evaluation/findings.h"
#include "model/evaluation/metric.h"
#include "viz/charts/scatter_view.h"

namespace tact {

enum class CompareView { table, scatter, findings };

// A matrix and the map made from it, for the Shepard diagram; the owner holds both.
struct FitRequest {
    std::shared_ptr<const void> owner;
    const Dissimilarity* matrix = nullptr;
    const PerceptualSpace* space = nullptr;

    bool operator==(const FitRequest&) const = default;
};

// The points of the Shepard diagram.
struct ShepardFit {
    FitRequest request;
    std::vector<double> distances;  // in the map, of all pairs
    std::vector<double> disparities;
    ScatterSummary summary;  // of both
};

struct ComparePanelState {
    CompareView view = CompareView::table;
    std::string metric = "pm";              // key of the metric whose scatter and Shepard diagram
                                            // are shown
    bool shepard_of_people = false;         // shows the ratings' own map instead
    bool cancelled = false;                 // cancelled by the person, until the next edit ...
    std::uint64_t cancelled_at = 0;         // ... of this revision
    std::uint64_t compute_large_of = 0;     // document whose comparison of many patterns was asked
                                            // for
    std::shared_ptr<const LiveMap> of;      // the last request ...
    std::vector<ForeignMetric> of_foreign;  // ... with these foreign metrics
    std::shared_ptr<const ShepardFit> fit;  // kept as long as its map
};

struct Comparing {
    Query<ComparisonRequest, Comparison> comparison_job;
    std::shared_ptr<const Comparison> comparison;  // the map on screen, or an earlier one
    Query<DifferenceRequest, LiveDifference> difference_job;
    std::shared_ptr<const LiveDifference> difference;
    Query<FitRequest, ShepardFit> fit_job;
    Query<int, std::vector<Finding>> findings_job;  // looked up by number
    std::shared_ptr<const std::vector<Finding>> findings;
    std::vector<ForeignMetric> foreign;  // foreign metrics, whichever document they were loaded for
    ComparePanelState panel;
};

}  // namespace tact
