// Every metric on the set that is shown: its matrix, its map, and how well it agrees with people.
//
// The map on screen brings PM, NC and OC along; the other metrics are computed here, and again only
// where a pattern changed: ratings that come or go cost their evaluation alone.
//
// Source    Lim & Park 2023, Table 2; the numbers are those of `tactspace compare`.
// Left out  means over sets: the window shows one.
// Exact     the answer depends on the set alone.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/foreign/foreign_metric.h"
#include "app/map/live_map.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/metric.h"
#include "model/evaluation/metric_comparison.h"

namespace tact {

// Above this many patterns metrics are compared only when asked for.
inline constexpr std::size_t kMostUnaskedComparison = 40;

struct ComparisonRequest {
    std::shared_ptr<const LiveMap> map;  // exact; its set has the ratings
    std::vector<ForeignMetric> foreign{};
};

// A pair whose rank by a metric is not that of the ratings.
struct Disagreement {
    std::size_t pair = 0;       // in condensed order
    double metric_rank = 0.0;   // among the rated pairs
    double ratings_rank = 0.0;  // the same
};

struct ComparedMetric {
    std::optional<Metric> metric;  // none: a foreign one
    std::string key;               // "pm", "mine (foreign)"
    std::string name;              // "PM", as the key of a foreign one
    std::string help;              // what it is, with its source
    Dissimilarity matrix;          // as it is evaluated
    std::vector<double> ranks;     // of all pairs
    PerceptualSpace space;
    double rho_with_pm = 0.0;
    std::optional<Evaluation> evaluation;  // with ratings
    std::vector<Disagreement> farthest;    // with ratings: a few pairs, the worst first
};

struct ComparedPeople {
    RatedPeople said;
    PerceptualSpace shown;  // of the rated patterns, in as many dimensions as the map on screen
};

struct Comparison {
    ComparisonRequest request;
    std::optional<ComparedPeople> people;
    std::string fault;                    // why there is nobody to compare with
    std::vector<ComparedMetric> metrics;  // in the order of kMetrics, then the foreign ones
    std::vector<std::string> failed{};    // why a foreign one is not there, sentences
};

// The row of this key, else that of PM.
const ComparedMetric& metric_of_key(const Comparison& comparison, const std::string& key);

// A row a metric in CSV, with all digits; without ratings only how it agrees with PM.
std::string comparison_csv(const Comparison& comparison);

// The work of one job.
class ComparisonWork {
  public:
    explicit ComparisonWork(int threads = 0) : threads_(threads) {}

    std::optional<Comparison> operator()(const ComparisonRequest& request, std::stop_token stop,
                                         std::atomic<float>& progress);

  private:
    bool follow_matrices(const ComparisonRequest& request, std::stop_token stop,
                         std::atomic<float>& progress);

    void add_row(ComparedMetric row, Dissimilarity matrix, const Prediction& prediction,
                 std::stop_token stop);

    int threads_;  // 0: all cores
    std::shared_ptr<const LiveMap> of_;
    std::vector<ForeignMetric> foreign_;   // that are among them, or failed
    std::vector<ComparedMetric> metrics_;  // without evaluations
    std::vector<std::string> failed_;
};

// Says so where PM is not better than the best metric that takes no model of the nerves; else
// empty.
std::string verdict_on_pm(const Comparison& comparison);

// Rated pairs by how far a metric's rank is from that of the ratings, the farthest first.
std::vector<Disagreement> disagreements(const Dissimilarity& metric, const Dissimilarity& ratings);

// Whether nobody was asked for some of the ratings.
NumberMark mark_of(const Comparison& comparison);

}  // namespace tact
