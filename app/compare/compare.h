// Metrics with people; why two differ.
#pragma once

#include <imgui.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/foreign/foreign.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/tables/tables.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/common/distributions.h"
#include "model/dtw/dtw.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/findings.h"
#include "model/evaluation/metric.h"
#include "model/evaluation/metric_comparison.h"
#include "model/evaluation/nuisance.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/nc_matrix.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/geometry.h"

namespace tact {

// What the publication found, checked on the sets that come with the program.
//
// Output    one outcome for each finding of model/evaluation/findings.h; nothing when stopped

struct CheckOptions {
    int threads = 0;                                  // 0: all cores
    std::optional<PerceptualModelParams> model = {};  // replaces each set's own
    std::stop_token stop = {};
    // Called with a set's name; returns the callback for the share of the work done on it.
    std::function<std::function<void(double)>(const std::string&)> progress_of = {};
};

std::optional<std::vector<Finding>> check_findings(const CheckOptions& options);

// "holds", "fails", "needs ratings", "needs stimuli".
const char* word_of(FindingStatus status);

// The metrics against the ratings of 598 people, who heard 36 Morse signals: the one test of PM on
// ratings that are public, and PM is not the best there.
//
// Source    Rothkopf 1957, J. Exp. Psychol. 53, 94-101: heard, not felt; the carrier (150 Hz, 1 g)
//           and the unit (50 ms) are ours
// Output    how well each metric agrees, also beyond what the length of the signals explains;
//           nothing when stopped
// Exact     same input, same bits, on any number of threads.

inline constexpr const char* kMorseSet = "sets/morse_rothkopf_1957.tactspace.json";

struct MorseRow {
    Metric metric = Metric::pm;
    Evaluation agreement;
    DurationControl beyond_length;
    std::size_t distinct = 0;  // distinct values among its pairs
};

struct MorseCheck {
    std::size_t patterns = 0;
    std::size_t pairs = 0;
    std::vector<MorseRow> rows;  // one per metric, the best rho first
};

struct MorseOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the work, 0..1
};

std::optional<MorseCheck> check_morse(const MorseOptions& options);

// Every metric on the shown set: its matrix, its map, and its agreement with people.
//
// PM, NC and OC come with the map on screen. The other metrics are computed here, and only for
// changed patterns; new ratings cost only the evaluation.
//
// Source    Lim & Park 2023, Table 2; the numbers are those of `tactspace compare`.
// Left out  means over sets: the window shows one set.
// Exact     the answer depends on the set alone.

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

// Why two patterns differ: the share of each channel in their NC, the times at which their brain
// waveforms differ, and the warping of their envelopes onto each other.
//
// Exact     the numbers of NC are those of the matrix; the path of long envelopes is computed on
//           decimated ones (`decimation`).

// Two rows of a shown map.
struct DifferenceRequest {
    std::shared_ptr<const LiveMap> map;
    std::size_t a = 0;
    std::size_t b = 0;

    bool operator==(const DifferenceRequest&) const = default;
};

struct LiveDifference {
    DifferenceRequest request;
    ChannelShares shares{};
    std::vector<double> apart;  // mean squared difference of the brain waveforms, per 5-ms step
    std::size_t decimation = 1;
    std::vector<double> envelope_a;  // decimated
    std::vector<double> envelope_b;
    DtwPath path;  // between the decimated envelopes
};

std::optional<LiveDifference> compute_live_difference(const DifferenceRequest& request,
                                                      std::stop_token stop,
                                                      std::atomic<float>& progress);

// State of the tabs that compare.

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

// Updates the comparison with people, and that of the chosen pair, when the map on screen changes.

// Collects finished jobs, and starts those that the open tab needs.
void take_compare_answers(Comparing& comparing);
void follow_comparing(const Ui& ui, const Workspace& work, const Layout& layout,
                      const ShownMap& shown_map, Comparing& comparing);

// The paper's findings, checked on its own sets.
void ask_for_findings(const Ui& ui, Comparing& comparing);

// The newest comparison; `is_stale`: it belongs to an earlier map.
struct ShownComparison {
    std::shared_ptr<const Comparison> comparison;  // null: no comparison yet
    bool is_stale = false;
    bool is_computing = false;
};
ShownComparison shown_comparison(const Workspace& work, const ShownMap& shown_map,
                                 const Comparing& comparing);

// A comparison of this many patterns waits until the person asks for it, or the person cancelled
// it.
bool comparison_waits(const Workspace& work, const Comparing& comparing);
void ask_for_comparison(const Workspace& work, Comparing& comparing);
void cancel_comparison(const Workspace& work, Comparing& comparing);

// Foreign metrics: a matrix in a file, or a Python function; one file may hold several.
void add_metric_dialog(Ui& ui, const Workspace& work, Comparing& comparing);
void add_metric(Ui& ui, Comparing& comparing, const std::filesystem::path& file);
void remove_metric(Comparing& comparing, const std::string& key);

// The map of the ratings, aligned to the one on screen: one row per pattern of the shown map, NaN
// for unrated patterns. Nullopt without ratings of its patterns, or while they are being compared.
std::optional<Eigen::MatrixXd> people_over_map(const ShownMap& shown_map,
                                               const Comparing& comparing);
std::string people_over_map_text(const Comparing& comparing);  // the raters

// The tabs that compare: metrics with people, the map with its distances, two patterns.

void draw_compare_panel(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                        TableState& table, Comparing& comparing);
void draw_shepard_panel(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing);
void draw_why_panel(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                    const ShownMap& shown_map, const Comparing& comparing);
// A table of all metrics, one of which can be chosen; with as many columns as fit into `area`.
void draw_metric_table(Ui& ui, Comparing& comparing, const Comparison& comparison,
                       const Rect& area);
// The Shepard diagram of the chosen metric, or of the ratings, in `area`; without the choice.
void draw_shepard_diagram(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                          const Rect& area);
ShepardFit shepard_fit(const FitRequest& request);  // sorts all pairs
void draw_compared_pairs(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                         TableState& table, Comparing& comparing, const Comparison& comparison);
// Rating against the chosen metric, one point per pair; needs ratings.
void draw_pairs_scatter(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                        const Comparison& comparison, const Rect& area);
void draw_findings(Ui& ui, Comparing& comparing, const Rect& area);

// Choosing a metric, and the state of the comparison: shared by the tabs that show one metric.

// "Msm: spectral matching, ... Park & Kuchenbecker 2019.": the explanation of its short name.
std::string metric_help(Metric metric);

// Metrics of the program, then foreign ones.
struct NamedMetric {
    std::string key;
    std::string name;
    std::string help;
};
std::vector<NamedMetric> named_metrics(const Comparing& comparing);

// A list of metrics to choose from; `with_people`: also the ratings' own map.
void draw_metric_choice(Ui& ui, const Workspace& work, Comparing& comparing, bool with_people);

// Progress, Cancel, or the reason why there is no comparison. True if there is one to draw, perhaps
// of an earlier state.
bool draw_comparison_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           Comparing& comparing);

// The chosen pair as two indices into `vibrations`; nullopt if the open set has other patterns.
std::optional<std::size_t> scatter_selection(const Workspace& work, const ShownMap& shown_map,
                                             const std::vector<Vibration>& vibrations);

// Chooses the clicked pair.
void choose_clicked(Workspace& work, const std::vector<Vibration>& vibrations,
                    std::optional<std::size_t> clicked);

// Words about the raters, for every place that shows a number made from their ratings.
//
// They name the raters, how many of them count, and the best agreement a metric can reach. Stale or
// synthetic ratings are labelled beside every number.

// "rho", or "synthetic rho", "stale rho", "synthetic, stale rho".
std::string of_people(const std::string& quantity, const NumberMark& mark);
// "rating (2 participants left out)", for places that do not name the raters otherwise.
std::string of_counted(const std::string& quantity, const NumberMark& mark);

// A line on the set's own ratings: "people.csv (2 participants left out): 18 participants, 6 of
// them synthetic, 72 passes, 9 of 12 patterns rated, 36 of 66 pairs".
std::string people_text(const PatternSet& set, const RatedPeople& people);

// Two ceilings: the agreement a metric can reach with the mean of the ratings, and that of one
// person with the others. Only the first is a ceiling for metrics.
std::string ceiling_text(const Reliability& reliability, const NumberMark& mark);

// The agreement of the best possible metric with single people, by its two bounds; empty if it
// cannot be computed.
std::string single_ceiling_text(const Ceilings& ceilings, const NumberMark& mark);

// Text to be read as sentences: on people, proofs and results.

// In the current font, in lines of readable length that break only at spaces, so that numbers stay
// whole.
void reading_text(ImU32 colour, const std::string& text);
void reading_text(Ui& ui, ImU32 colour, const Said& said);

}  // namespace tact
