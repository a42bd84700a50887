// The predicted space of a set, computed in the background: from the document to the map.
//
// Two runs answer each edit: a preview with coarse envelopes and one start, which always finishes
// and follows a drag, and the full run, whose numbers are those of the command line. Where the
// full run takes long the preview is the first map, and the full run makes it exact in place, in
// parts.
//
// Exact     the full run depends on the set alone, not on what was shown before.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/rendering/rendered_set.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/refinement.h"
#include "model/set/pattern_set.h"

namespace tact {

// Above this many patterns, or this long by estimate, a map is made only when asked for.
inline constexpr std::size_t kMostLivePatterns = 1000;
inline constexpr double kLongestUnaskedS = 60.0;

// Rough time of a first exact map on this machine: its comparison of envelopes, which is nearly all
// of it. A pair takes the product of its own two lengths, but for pairs with the longest patterns:
// their envelopes sound to the end (dtw_batches.h).
double expected_map_s(const PatternSet& set);
double expected_map_s(const PatternSet& set, std::size_t without);  // one of its patterns
double expected_map_s(std::vector<double> durations_s);
double expected_map_s(std::size_t patterns, double longest_s);  // all of one length

bool needs_asking(const PatternSet& set);

// Rough time that all cores take to fill this number of cells by dynamic time warping.
double expected_dtw_s(double cells);

// How coarse the envelopes of a preview are: the more cells its pairs have, the coarser.
struct PreviewGrain {
    std::size_t decimation = 10;  // of 10 kHz
    // Pairs of pairs, of 100, whose order differs from the exact one: the most that was measured
    // with the bundled sets and 38 Pulsar presets; half of that is common.
    int most_flips = 4;
};

// None: there are too many patterns for a preview in seconds.
std::optional<PreviewGrain> preview_grain(const PatternSet& set);

// That of a map; none for an exact one.
std::optional<PreviewGrain> preview_grain(const Prediction& prediction);

struct LiveMap;
class WantedRows;

struct LiveMapRequest {
    std::uint64_t revision = 0;  // of the document
    std::uint64_t document = 0;  // its number
    std::shared_ptr<const PatternSet> set;
    int dimensions = 3;
    bool preview = false;
    std::optional<RenderedBy> rendered_by{};  // the patterns as a device plays them
    // How the full run goes about it; the answer does not depend on these.
    std::shared_ptr<const LiveMap> coarse{};     // the preview of this very set, or null
    std::shared_ptr<const WantedRows> wanted{};  // what becomes exact first, or null
    std::filesystem::path checkpoint{};          // keeps what is finished; empty: nothing does
};

// Whether both have one answer: names, notes and locks make no difference to the model.
bool is_same_work(const LiveMapRequest& a, const LiveMapRequest& b);

// The rows of each matrix with alike ones beside each other (group_tree.h).
struct RowOrders {
    std::vector<std::size_t> pm;
    std::vector<std::size_t> nc;
    std::vector<std::size_t> oc;
};

// One answer: a snapshot that panels draw as long as they like.
struct LiveMap {
    LiveMapRequest request;
    Prediction prediction;
    PerceptualSpace space;
    double seconds = 0.0;                      // it took; 0: not to be told
    std::shared_ptr<const PatternSet> played;  // what was compared: the set, or what a device plays
    // Share of the pairs whose PM comes of exact values, 0..1. At 1 a preview has PM itself, and
    // its points are on their way.
    double exact_share = 0.0;
    bool is_kept = false;  // what is finished of it is in a file
    // Facts of all pairs: of half a million, no frame could wait for them.
    std::vector<double> sorted_pm;  // ascending
    std::size_t closest = 0;        // the pair of the least PM, in condensed order
    RowOrders alike;
    double length_of_pm = 0.0;  // of one PM in the space (map_scale.h)
};

// Fills in the facts of a map that has its matrices and its points.
void note_facts(LiveMap& map);

// Largest PM of all pairs; 0 without pairs.
double largest_pm(const LiveMap& map);

// PM of every pair, as a matrix file has it.
std::string matrix_csv(const LiveMap& map);

// The maps that are kept for undo, and the pairs of all of them: 48 bytes each. An edit of one
// pattern keeps its code, too: 180 kB for each second of it.
inline constexpr std::size_t kKeptMaps = 50;
inline constexpr std::size_t kKeptPairs = 500'000;

// The work of one job. It keeps its answers: an edit of one pattern costs one row of the last, a
// preview starts from where the points were, and a set as it was before, by undo, costs nothing.
class LiveMapWork {
  public:
    explicit LiveMapWork(int threads = 0) : threads_(threads) {}

    // Nothing when stopped. `progress` runs 0..1.
    std::optional<LiveMap> operator()(const LiveMapRequest& request, std::stop_token stop,
                                      std::atomic<float>& progress);

    // The same; `partly` gets previews (request.preview) of a full run that is under way.
    using Partly = std::function<void(LiveMap)>;
    std::optional<LiveMap> in_parts(const LiveMapRequest& request, std::stop_token stop,
                                    std::atomic<float>& progress, const Partly& partly);

  private:
    struct Run;          // one request
    struct Unfinished {  // where turns are taken (app/jobs/turns.h): the exact run of a request
        LiveMapRequest request;
        Refinement refinement;
        double cells;  // of all of it
        std::shared_ptr<const LiveMap> shown;
        double seconds;  // it took by now
    };

    std::optional<LiveMap> kept(const LiveMapRequest& request);
    void keep(const LiveMap& map);
    std::shared_ptr<const PatternSet> played(const LiveMapRequest& request, std::stop_token stop);
    std::vector<std::shared_ptr<const PatternCode>> codes_of(const Run& run);
    std::optional<LiveMap> previewed(const Run& run);
    std::optional<LiveMap> full(Run& run);
    std::optional<Unfinished> begun(Run& run);
    std::optional<Prediction> exact(Run& run);
    LiveMap part(Run& run, LiveMap map);

    int threads_;                                      // 0: all cores
    std::vector<std::shared_ptr<const LiveMap>> all_;  // exact ones; used last, last
    std::shared_ptr<const LiveMap> last_;
    std::optional<RenderedSet> rendered_;  // the last one
    std::optional<Unfinished> unfinished_;
};

}  // namespace tact
