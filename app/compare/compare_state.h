// What the tabs that compare show.
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

// What the Shepard diagram is asked of: a matrix and its map, both held by the owner.
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
    std::string metric = "pm";              // key: whose scatter and Shepard diagram are shown
    bool shepard_of_people = false;         // instead
    bool cancelled = false;                 // by the person, until the next edit ...
    std::uint64_t cancelled_at = 0;         // ... of this revision
    std::uint64_t compute_large_of = 0;     // the document whose many patterns were asked for
    std::shared_ptr<const LiveMap> of;      // what was asked for last ...
    std::vector<ForeignMetric> of_foreign;  // ... with these
    std::shared_ptr<const ShepardFit> fit;  // kept while its map stays what it is
};

struct Comparing {
    Query<ComparisonRequest, Comparison> comparison_job;
    std::shared_ptr<const Comparison> comparison;  // of the map on screen, or of one before it
    Query<DifferenceRequest, LiveDifference> difference_job;
    std::shared_ptr<const LiveDifference> difference;
    Query<FitRequest, ShepardFit> fit_job;
    Query<int, std::vector<Finding>> findings_job;  // asked for by number
    std::shared_ptr<const std::vector<Finding>> findings;
    std::vector<ForeignMetric> foreign;  // metrics of one's own, of any document
    ComparePanelState panel;
};

}  // namespace tact
