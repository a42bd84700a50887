// Every metric on the shown set: its matrix, its map, and its agreement with people.
//
// PM, NC and OC come with the map on screen. The other metrics are computed here, and only for
// changed patterns; new ratings cost only the evaluation.
//
// Source    Lim & Park 2023, Table 2; the numbers are those of `tactspace compare`.
// Left out  means over sets: the window shows one set.
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

// Above this number of patterns, metrics are compared only on request.
inline constexpr std::size_t kMostUnaskedComparison = 40;

struct ComparisonRequest {
    std::shared_ptr<const LiveMap> map;  // exact; its set has the ratings
    std::vector<ForeignMetric> foreign{};
};

// A pair that a metric ranks differently from the ratings.
struct Disagreement {
    std::size_t pair = 0;       // in condensed order
    double metric_rank = 0.0;   // rank among the rated pairs
    double ratings_rank = 0.0;  // rank by the metric
};

struct ComparedMetric {
    std::optional<Metric> metric;  // nullopt: a foreign metric
    std::string key;               // "pm", "mine (foreign)"
    std::string name;              // "PM", as the key of a foreign one
    std::string help;              // description with its source
    Dissimilarity matrix;          // the matrix that is evaluated
    std::vector<double> ranks;     // rank of each pair
    PerceptualSpace space;
    double rho_with_pm = 0.0;
    std::optional<Evaluation> evaluation;  // with ratings
    std::vector<Disagreement> farthest;    // only with ratings: a few pairs, the worst first
};

struct ComparedPeople {
    RatedPeople said;
    PerceptualSpace shown;  // rated patterns; as many dimensions as the map on screen
};

struct Comparison {
    ComparisonRequest request;
    std::optional<ComparedPeople> people;
    std::string fault;                    // the reason why no ratings can be compared
    std::vector<ComparedMetric> metrics;  // in the order of kMetrics, then the foreign ones
    std::vector<std::string> failed{};    // errors of foreign metrics, sentences
};

// The row with this key, or PM's if no row has it.
const ComparedMetric& metric_of_key(const Comparison& comparison, const std::string& key);

// One CSV row per metric, with all digits; without ratings, only its agreement with PM.
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
    std::vector<ForeignMetric> foreign_;   // those that are loaded or failed
    std::vector<ComparedMetric> metrics_;  // without evaluations
    std::vector<std::string> failed_;
};

// A warning if PM is not better than the best metric without a model of nerves; otherwise empty.
std::string verdict_on_pm(const Comparison& comparison);

// Rated pairs, ordered by the difference between their ranks by the metric and by the ratings,
// largest first.
std::vector<Disagreement> disagreements(const Dissimilarity& metric, const Dissimilarity& ratings);

// Whether some of the ratings are synthetic.
NumberMark mark_of(const Comparison& comparison);

}  // namespace tact
