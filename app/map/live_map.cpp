#include "app/map/map.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "app/jobs/jobs.h"
#include "app/map/parts.h"
#include "app/rendering/rendering.h"
#include "model/common/parallel.h"
#include "model/dtw/dtw_kernel.h"
#include "model/io/tables/matrix_file.h"
#include "model/map/group_tree.h"
#include "model/map/landmarks.h"
#include "model/map/map_scale.h"
#include "model/perceptual_model/refinement.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/subset/separation.h"
#include "model/tasks/set_report.h"

namespace tact {

namespace {

// Envelopes at 1 kHz, 250 Hz, 100 Hz, 50 Hz, 25 Hz and 10 Hz.
constexpr std::array kGrains{PreviewGrain{10, 4},   PreviewGrain{40, 10},  PreviewGrain{100, 12},
                             PreviewGrain{200, 15}, PreviewGrain{400, 15}, PreviewGrain{1000, 25}};
// Pairs of pairs, of 100, whose order may change because codes are approximations.
constexpr int kQuickFlips = 2;
constexpr std::size_t kMostPreviewed = 2000;
constexpr double kMostPreviewCells = 4e10;  // 3 s of two cores with AVX2
constexpr double kCellsOfPair = 7e3;        // what a pair costs besides its cells
constexpr double kMostCodedSamples = 5e7;   // 1 s of two cores
constexpr float kPredictionShare = 0.9F;    // of the progress bar; the rest is the map

bool is_much_to_code(std::size_t patterns, std::size_t samples) {
    return static_cast<double>(patterns) * static_cast<double>(samples) > kMostCodedSamples;
}

// A step grows with the square of the patterns.
int preview_steps(std::size_t patterns) {
    const double pairs = static_cast<double>(pair_count(patterns));
    return static_cast<int>(std::clamp(1.5e7 / std::max(1.0, pairs), 5.0, 300.0));
}

// Starts where the points were if the set has kept its size, otherwise from classical scaling.
PerceptualSpace moved_space(const Dissimilarity& pm, int dimensions, const LiveMap* last,
                            std::stop_token stop) {
    MdsParams params;
    params.dimensions = dimensions;
    params.random_starts = 0;
    params.tolerance = 1e-6;
    params.max_steps = preview_steps(pm.size);
    params.threads = 1;
    const bool same_shape = last != nullptr && last->space.verdict == MdsVerdict::fine &&
                            last->space.points.rows() == static_cast<Eigen::Index>(pm.size) &&
                            last->space.points.cols() == dimensions;
    if (!same_shape && pm.size > kLandmarks) {
        return smacof(pm, landmark_scaling(pm, dimensions), params, stop);
    }
    if (!same_shape) return nonmetric_mds(pm, params, stop);
    params.is_interval = last->space.is_interval;  // or groups would fall together on the way
    return smacof(pm, last->space.points, params, stop);
}

// Cells of dynamic time warping a second and core: of the processors with each instruction set,
// between old and new.
double cells_per_s() {
    const std::string_view kernel = dtw_kernel().name;
    if (kernel == "avx512") return 1.8e10;
    return kernel == "avx2" ? 6.5e9 : 2.5e9;
}

// What is known of the pairs in six parts, which threads may note side by side. The order of the
// rows of 2,000 patterns takes a tenth of a second: a stop is heeded between them.
constexpr std::size_t kPairParts = 6;

void note_pairs(LiveMap& map, std::size_t part) {
    const Prediction& prediction = map.prediction;
    const Dissimilarity& pm = prediction.pm;
    const auto rows = [](const Dissimilarity& all) { return clustered_order(group_tree(all)); };
    switch (part) {
        case 0:
            map.alike.pm = rows(pm);
            break;
        case 1:
            map.alike.nc = rows(prediction.nc);
            break;
        case 2:
            map.alike.oc = rows(prediction.oc);
            break;
        case 3:
            map.nearest =
                nearest_neighbours(felt_pairs(as_ranked(Metric::pm, pm), unfelt(prediction.codes)));
            break;
        case 4:
            map.nc = as_ranked(Metric::nc, prediction.nc);
            map.oc = as_ranked(Metric::oc, prediction.oc);
            break;
        default:
            map.sorted_pm = sorted_values(pm);
            map.closest = static_cast<std::size_t>(std::ranges::min_element(pm.condensed) -
                                                   pm.condensed.begin());
    }
}

void note_pairs(LiveMap& map, int threads, const std::stop_token& stop) {
    parallel_for(kPairParts, threads, stop, [&map](std::size_t part) { note_pairs(map, part); });
}

void note_scale(LiveMap& map) {
    map.length_of_pm = length_of_one(map.space.points, map.prediction.pm);
}

void place(LiveMap& map, PerceptualSpace space) {
    map.space = std::move(space);
    note_scale(map);
}

}  // namespace

void note_facts(LiveMap& map) {
    note_pairs(map, 1, {});
    note_scale(map);
}

bool is_same_work(const LiveMapRequest& a, const LiveMapRequest& b) {
    return a.dimensions == b.dimensions && a.preview == b.preview &&
           a.rendered_by == b.rendered_by && a.set->model == b.set->model &&
           std::ranges::equal(a.set->vibrations, b.set->vibrations, {}, &Vibration::source,
                              &Vibration::source);
}

namespace {

std::vector<double> own_durations_s(const PatternSet& set) {
    std::vector<double> durations_s;
    for (const Vibration& vibration : set.vibrations) {
        durations_s.push_back(own_duration_s(vibration));
    }
    return durations_s;
}

// The cells that DTW fills for all pairs of envelopes.
double cells_of(std::vector<double> durations_s) {
    if (durations_s.size() < 2) return 0.0;
    const double tail_s = static_cast<double>(kEnvelopeSamples) / kModelRateHz;
    const double longest_s = *std::ranges::max_element(durations_s);
    const auto silent = std::ranges::partition(
        durations_s, [&](double duration_s) { return duration_s + tail_s >= longest_s; });
    double sum_s = 0.0;
    double squares_s2 = 0.0;
    for (const double duration_s : silent) {
        sum_s += duration_s + tail_s;
        squares_s2 += (duration_s + tail_s) * (duration_s + tail_s);
    }
    const std::size_t others = pair_count(durations_s.size()) - pair_count(silent.size());
    const double pairs_s2 =
        0.5 * (sum_s * sum_s - squares_s2) + static_cast<double>(others) * longest_s * longest_s;
    return pairs_s2 * kModelRateHz * kModelRateHz;
}

// Where waiting costs, silence counts as well: all pairs are as long as the longest.
double cells_of(const PatternSet& set, std::vector<double> durations_s) {
    if (set.model.envelope.waiting_cost > 0.0 && !durations_s.empty()) {
        std::ranges::fill(durations_s, std::ranges::max(durations_s));
    }
    return cells_of(std::move(durations_s));
}

}  // namespace

double expected_dtw_s(double cells) { return cells / (cells_per_s() * thread_count(0)); }

double expected_map_s(const PatternSet& set) {
    return expected_dtw_s(cells_of(set, own_durations_s(set)));
}

double expected_map_s(const PatternSet& set, std::size_t without) {
    std::vector<double> durations_s = own_durations_s(set);
    durations_s.erase(durations_s.begin() + static_cast<std::ptrdiff_t>(without));
    return expected_dtw_s(cells_of(set, std::move(durations_s)));
}

double expected_map_s(std::vector<double> durations_s) {
    return expected_dtw_s(cells_of(std::move(durations_s)));
}

double expected_map_s(std::size_t patterns, double longest_s) {
    return expected_map_s(std::vector<double>(patterns, longest_s));
}

std::optional<PreviewGrain> preview_grain(const PatternSet& set) {
    if (set.vibrations.size() > kMostPreviewed) return std::nullopt;
    const double cells = cells_of(set, own_durations_s(set));
    const double beside = kCellsOfPair * static_cast<double>(pair_count(set.vibrations.size()));
    // Approximate codes take a second or two as well.
    const double most = is_much_to_code(set.vibrations.size(), longest_samples(set))
                            ? 0.5 * kMostPreviewCells
                            : kMostPreviewCells;
    const auto fine_enough = std::ranges::find_if(kGrains, [&](const PreviewGrain& grain) {
        const auto factor = static_cast<double>(grain.decimation);
        return cells / (factor * factor) + beside <= most;
    });
    return fine_enough == kGrains.end() ? kGrains.back() : *fine_enough;
}

std::optional<PreviewGrain> preview_grain(const Prediction& prediction) {
    const auto found =
        std::ranges::find(kGrains, prediction.envelope_decimation, &PreviewGrain::decimation);
    if (found == kGrains.end()) return std::nullopt;
    PreviewGrain grain = *found;
    if (std::ranges::any_of(prediction.codes, [](const auto& code) { return code->is_quick; }))
        grain.most_flips += kQuickFlips;
    return grain;
}

bool needs_asking(const PatternSet& set) {
    return set.vibrations.size() > kMostLivePatterns || expected_map_s(set) > kLongestUnaskedS;
}

// The answer to the same question asked before; it becomes the one used last.
std::optional<LiveMap> LiveMapWork::kept(const LiveMapRequest& request) {
    if (request.preview) return std::nullopt;
    const auto found = std::ranges::find_if(
        all_, [&request](const auto& map) { return is_same_work(map->request, request); });
    if (found == all_.end()) return std::nullopt;
    std::rotate(found, found + 1, all_.end());
    last_ = all_.back();
    LiveMap map = *last_;
    map.request = request;
    return map;
}

void LiveMapWork::keep(const LiveMap& map) {
    last_ = std::make_shared<const LiveMap>(map);
    if (map.request.preview) return;
    all_.push_back(last_);
    std::size_t pairs = 0;
    auto oldest = all_.end();
    while (oldest != all_.begin()) {
        pairs += (*(oldest - 1))->prediction.pm.condensed.size();
        if (pairs > kKeptPairs || static_cast<std::size_t>(all_.end() - oldest) == kKeptMaps) break;
        --oldest;
    }
    all_.erase(all_.begin(), oldest);
}

// The set itself, or what a device makes of it; null when stopped.
std::shared_ptr<const PatternSet> LiveMapWork::played(const LiveMapRequest& request,
                                                      std::stop_token stop) {
    if (!request.rendered_by) return request.set;
    auto made = rendered_set(*request.set, *request.rendered_by, rendered_ ? &*rendered_ : nullptr,
                             {threads_, stop});
    if (!made) return nullptr;
    rendered_ = std::move(made);
    return std::make_shared<const PatternSet>(rendered_->played);
}

namespace {

constexpr std::size_t kMostInOneGo = 300;  // whose map is there before one could follow it
constexpr std::chrono::milliseconds kBetweenParts{500};

// The map that these points are.
PerceptualSpace space_at(const Dissimilarity& pm, const Eigen::MatrixXd& points, MdsParams params) {
    params.max_steps = 0;
    return smacof(pm, points, params);
}

}  // namespace

// What is on the way to the answer of one request.
struct LiveMapWork::Run {
    const LiveMapRequest& request;
    std::shared_ptr<const PatternSet> set;  // that is compared
    std::stop_token stop;
    std::atomic<float>& progress;
    const Partly& partly;  // may be empty
    PredictOptions options;
    // A part, whose points start from those of the one before it.
    std::shared_ptr<const LiveMap> shown;
    double earlier_s = 0.0;  // taken by earlier turns
};

namespace {

// Without what note_pairs() notes, and without points.
LiveMap map_of(const LiveMapRequest& request, std::shared_ptr<const PatternSet> set,
               Prediction prediction) {
    LiveMap map;
    map.request = request;
    map.request.coarse.reset();
    map.request.wanted.reset();
    map.prediction = std::move(prediction);
    map.played = std::move(set);
    return map;
}

// Codes that a map has of patterns of the same source, in sets of the same longest: by place, or by
// name where patterns came or went. Approximations are for previews alone.
void share_codes(const LiveMap& known, const PatternSet& set, bool preview,
                 std::vector<std::shared_ptr<const PatternCode>>& codes) {
    const PatternSet& was = *known.played;
    if (was.model.coding != set.model.coding || was.model.envelope != set.model.envelope ||
        longest_samples(was) != longest_samples(set) ||
        was.vibrations.size() != known.prediction.codes.size()) {
        return;
    }
    std::unordered_map<std::string_view, std::size_t> by_name;
    for (std::size_t k = 0; k < was.vibrations.size(); ++k) {
        by_name.emplace(was.vibrations[k].name, k);
    }
    const auto is_of = [&](std::size_t place, const Vibration& vibration) {
        return place < was.vibrations.size() && was.vibrations[place].source == vibration.source &&
               (preview || !known.prediction.codes[place]->is_quick);
    };
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (codes[k]) continue;
        const Vibration& vibration = set.vibrations[k];
        const auto named = by_name.find(vibration.name);
        if (is_of(k, vibration)) {
            codes[k] = known.prediction.codes[k];
        } else if (named != by_name.end() && is_of(named->second, vibration)) {
            codes[k] = known.prediction.codes[named->second];
        }
    }
}

}  // namespace

// Nothing of what did not change is rendered or coded. None where stopped.
std::vector<std::shared_ptr<const PatternCode>> LiveMapWork::codes_of(const Run& run) {
    const PatternSet& set = *run.set;
    std::vector<std::shared_ptr<const PatternCode>> codes(set.vibrations.size());
    const bool preview = run.request.preview;
    if (last_) share_codes(*last_, set, preview, codes);
    if (run.request.coarse) share_codes(*run.request.coarse, set, preview, codes);
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (!codes[k]) open.push_back(k);
    }
    PredictOptions options = run.options;
    options.previous = nullptr;
    options.threads = 1;
    options.samples = longest_samples(set);
    options.quick_codes = preview && is_much_to_code(open.size(), options.samples);
    parallel_for(open.size(), threads_, run.stop, [&](std::size_t k) {
        const Waveform waveform = waveform_of(set.vibrations[open[k]]);
        const auto code = pattern_codes({&waveform, 1}, set.model, options);
        if (!code.empty()) codes[open[k]] = code[0];
    });
    if (run.stop.stop_requested()) codes.clear();
    return codes;
}

std::optional<LiveMap> LiveMapWork::previewed(const Run& run) {
    auto codes = codes_of(run);
    if (codes.size() != run.set->vibrations.size()) return std::nullopt;
    PredictOptions options = run.options;
    options.envelope_decimation = preview_grain(*run.set).value_or(kGrains.back()).decimation;
    auto prediction = predict(std::move(codes), run.set->model, options);
    if (!prediction) return std::nullopt;
    LiveMap map = map_of(run.request, run.set, std::move(*prediction));
    PerceptualSpace space;
    parallel_for(kPairParts + 1, threads_, run.stop, [&](std::size_t part) {
        if (part > 0) return note_pairs(map, part - 1);
        space = moved_space(map.prediction.pm, run.request.dimensions, last_.get(), run.stop);
    });
    if (run.stop.stop_requested()) return std::nullopt;
    place(map, std::move(space));
    return map;
}

// A part of a full run, of a map without points: they drift from where they were shown last.
LiveMap LiveMapWork::part(Run& run, LiveMap map) {
    map.request.preview = true;
    place(map, moved_space(map.prediction.pm, run.request.dimensions, run.shown.get(), run.stop));
    run.shown = std::make_shared<const LiveMap>(map);
    return map;
}

// A request that the last turn did not finish continues where it was.
std::optional<LiveMapWork::Unfinished> LiveMapWork::begun(Run& run) {
    std::optional<Unfinished> last = std::exchange(unfinished_, std::nullopt);
    if (last && is_same_work(last->request, run.request)) {
        run.shown = last->shown;
        run.earlier_s = last->seconds;
        return last;
    }
    auto codes = codes_of(run);
    if (codes.size() != run.set->vibrations.size()) return std::nullopt;
    Refinement refinement = begin_refinement(std::move(codes), run.set->model, run.options);
    if (run.stop.stop_requested()) return std::nullopt;
    const auto& coarse = run.request.coarse;
    if (coarse && coarse->prediction.envelope_decimation > 1) {
        refinement.coarse = {coarse->prediction.oc, coarse->prediction.envelope_decimation};
    }
    const double cells = open_cells(refinement);
    return Unfinished{run.request, std::move(refinement), cells, run.shown, 0.0};
}

std::optional<Prediction> LiveMapWork::exact(Run& run) {
    auto work = begun(run);
    if (!work) return std::nullopt;
    Refining how{*run.request.set, run.request.wanted.get(), run.request.checkpoint, {}};
    how.cells = work->cells;
    how.is_over = is_turn_over;
    if (run.partly && run.request.coarse) {
        how.partly = [&](const Refinement& now, bool is_kept) {
            LiveMap map = map_of(run.request, run.set, prediction_of(now));
            note_pairs(map, threads_, run.stop);
            map.exact_share = exact_share(now);
            map.is_kept = is_kept;
            run.partly(part(run, std::move(map)));
        };
    }
    if (refine(work->refinement, run.options, how)) return prediction_of(work->refinement);
    if (!run.stop.stop_requested()) {
        work->shown = run.shown;
        unfinished_ = std::move(work);
        want_another_turn();
    }
    return std::nullopt;
}

// PM first, where the points were; the starts of its map take longer than a row of it.
std::optional<LiveMap> LiveMapWork::full(Run& run) {
    auto prediction = exact(run);
    if (!prediction) return std::nullopt;
    run.progress = kPredictionShare;
    const bool in_parts = run.partly && run.shown;
    LiveMap map = map_of(run.request, run.set, std::move(*prediction));
    note_pairs(map, threads_, run.stop);
    map.exact_share = 1.0;
    if (in_parts) run.partly(part(run, map));
    const Dissimilarity& pm = map.prediction.pm;
    MdsParams params = standard_mds_params(pm.size, run.request.dimensions);
    params.threads = threads_;
    std::function<void(const Eigen::MatrixXd&)> lower;
    auto told = std::chrono::steady_clock::now();
    if (in_parts && pm.size > kMostInOneGo) {
        lower = [&](const Eigen::MatrixXd& points) {
            if (std::chrono::steady_clock::now() - told < kBetweenParts) return;
            LiveMap on_its_way = map;
            on_its_way.request.preview = true;
            place(on_its_way, space_at(pm, points, params));
            run.partly(std::move(on_its_way));
            told = std::chrono::steady_clock::now();
        };
    }
    place(map, nonmetric_mds(pm, params, run.stop, {}, lower));
    return map;
}

std::optional<LiveMap> LiveMapWork::operator()(const LiveMapRequest& request, std::stop_token stop,
                                               std::atomic<float>& progress) {
    return in_parts(request, std::move(stop), progress, {});
}

std::optional<LiveMap> LiveMapWork::in_parts(const LiveMapRequest& request, std::stop_token stop,
                                             std::atomic<float>& progress, const Partly& partly) {
    if (std::optional<LiveMap> map = kept(request)) return map;
    const auto begin = std::chrono::steady_clock::now();
    std::shared_ptr<const PatternSet> set = played(request, stop);
    if (!set) return std::nullopt;
    Run run{request,
            std::move(set),
            stop,
            progress,
            partly,
            {},
            request.coarse ? request.coarse : last_};
    run.options.previous = last_ ? &last_->prediction : nullptr;
    run.options.threads = threads_;
    run.options.stop = stop;
    run.options.progress = [&progress](double share) {
        progress = kPredictionShare * static_cast<float>(share);
    };
    auto map = request.preview ? previewed(run) : full(run);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const double seconds = run.earlier_s + took.count();
    if (unfinished_) unfinished_->seconds = seconds;
    if (!map || stop.stop_requested()) return std::nullopt;
    map->seconds = seconds;
    keep(*map);
    return map;
}

double largest_pm(const LiveMap& map) { return map.sorted_pm.empty() ? 0.0 : map.sorted_pm.back(); }

std::string matrix_csv(const LiveMap& map) {
    std::vector<std::string> labels;
    const PatternSet& set = *map.request.set;
    for (const Vibration& one : set.vibrations) labels.push_back(one.name);
    std::ostringstream csv;
    write_matrix_csv(csv, labels, as_ranked(Metric::pm, map.prediction.pm),
                     corner_text(mark_of(set)));
    return csv.str();
}

}  // namespace tact
