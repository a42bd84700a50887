#include "app/map/parts.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

#include "app/jobs/jobs.h"
#include "app/progress/progress.h"
#include "model/common/fingerprint.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/checkpoint.h"
#include "model/perceptual_model/tiles.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr double kWorthWordsS = 5.0;  // what is over sooner is told by its end
constexpr double kMostParts = 200.0;
constexpr double kPartToTelling = 5.0;  // computing and telling, at least

TileKey key_of(const Refinement& refinement, const PatternSet& set) {
    const std::size_t patterns = refinement.codes.size();
    return {patterns, tile_side(patterns), vibrations_fingerprint(set), model_fingerprint(set),
            fingerprint(refinement.codes, refinement.params)};
}

void keep_tile(std::optional<Checkpoint>& file, const Refinement& refinement, std::size_t tile) {
    if (!file) return;
    const Tile area = tile_at(refinement.codes.size(), tile);
    if (!file->append(Part::oc, tile, tile_of(refinement.oc, area))) file.reset();
}

// The open file, with all in it that is known; none: the map is computed without.
std::optional<Checkpoint> taken_up(Refinement& refinement, const Refining& how) {
    if (how.checkpoint.empty()) return std::nullopt;
    const TileKey key = key_of(refinement, how.set);
    std::error_code fault;
    // One of an earlier state of the set is of no use any more.
    if (const auto kept = kept_key(how.checkpoint); kept && *kept != key) {
        fs::remove(how.checkpoint, fault);
    }
    fs::create_directories(how.checkpoint.parent_path(), fault);
    auto opened = Checkpoint::open(how.checkpoint, key);
    if (!opened) return std::nullopt;
    std::optional<Checkpoint> file(std::move(*opened));
    std::vector<std::uint8_t> in_file(refinement.is_made.size(), 0);
    const auto read = file->read(Part::oc, [&](std::size_t tile, std::span<const double> values) {
        take_tile(refinement, tile, values);
        in_file[tile] = 1;
    });
    if (!read) return std::nullopt;
    for (std::size_t tile = 0; tile < in_file.size(); ++tile) {
        if (refinement.is_made[tile] != 0 && in_file[tile] == 0) {
            keep_tile(file, refinement, tile);
        }
    }
    return file;
}

// The seconds since it was made.
class Watch {
  public:
    double s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

  private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

void WantedRows::tell(std::vector<std::size_t> rows) {
    const std::lock_guard lock(mutex_);
    rows_.swap(rows);
}

std::vector<std::size_t> WantedRows::now() const {
    const std::lock_guard lock(mutex_);
    return rows_;
}

std::vector<std::size_t> rows_looked_at(const Workspace& work, const ShownMap& shown_map) {
    enum Turn { hovered, current, selected, in_view, outside };
    const Eigen::MatrixXd& points = shown_map.transition.to;
    const auto count = static_cast<std::size_t>(points.rows());
    const Selection& selection = work.selection;
    if (selection.current >= count) return {};
    const auto point = [&](std::size_t k) {
        return point_of(points, static_cast<Eigen::Index>(k));
    };
    const Eigen::Vector3d centre = point(selection.current);
    const Rect& pane = shown_map.pane;
    const SpaceProjection seen = projection(shown_map.camera, fit(points), pane);
    std::vector<std::pair<Turn, double>> turn(count);
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_seen = pane.empty() || pane.contains(seen(point(k)).at);
        turn[k] = {is_seen ? in_view : outside, (point(k) - centre).norm()};
    }
    for (const std::size_t other : selection.others) {
        if (other < count) turn[other].first = selected;
    }
    turn[selection.current].first = current;
    if (selection.hovered_last && *selection.hovered_last < count) {
        turn[*selection.hovered_last].first = hovered;
    }
    std::vector<std::size_t> rows(count);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::ranges::stable_sort(rows, {}, [&](std::size_t k) { return turn[k]; });
    return rows;
}

fs::path map_checkpoint(const Workspace& work) {
    const fs::path& document = work.document.path;
    if (!document.empty()) return fs::path(document) += ".map-tiles";
    if (work.session.folder.empty()) return {};
    return work.session.folder / "maps" /
           (fingerprint_text(vibrations_fingerprint(work.document.set)) + ".map-tiles");
}

bool has_checkpoint(const Workspace& work) {
    const auto kept = kept_key(map_checkpoint(work));
    const PatternSet& set = work.document.set;
    return kept && kept->patterns == set.vibrations.size() &&
           kept->vibrations == vibrations_fingerprint(set) && kept->model == model_fingerprint(set);
}

bool refine(Refinement& refinement, const PredictOptions& options, const Refining& how) {
    std::optional<Checkpoint> file = taken_up(refinement, how);
    const double open = open_cells(refinement);
    const double whole = std::max(how.cells, open);
    const bool in_parts = expected_dtw_s(whole) >= how.parts_from_s;
    const bool in_lots = in_parts || work_takes_turns();
    double made = whole - open;
    // By cells, not by the clock: lots of few pairs fill registers badly, on a busy machine as
    // well.
    const double cells_per_s = 1.0 / expected_dtw_s(1.0);
    double cells = std::max(whole / kMostParts, how.part_s * cells_per_s);
    if (!in_parts) cells = 0.0;  // a tile after the other
    while (!options.stop.stop_requested()) {
        const auto wanted = how.wanted == nullptr ? std::vector<std::size_t>{} : how.wanted->now();
        const auto lot = next_tiles(refinement, wanted, in_lots ? cells : whole);
        if (lot.empty()) break;
        double of_lot = 0.0;
        for (const std::size_t tile : lot) of_lot += open_cells(refinement, tile);
        PredictOptions now = options;
        now.progress = [&](double share) {
            if (options.progress) options.progress((made + share * of_lot) / whole);
        };
        if (!make_tiles(refinement, lot, now)) return false;
        made += of_lot;
        for (const std::size_t tile : lot) keep_tile(file, refinement, tile);
        if (made >= whole) continue;
        const Watch telling;
        if (in_parts && how.partly) how.partly(refinement, file.has_value());
        if (how.is_over && how.is_over()) return false;
        if (!in_parts) continue;
        cells = std::max(cells, kPartToTelling * telling.s() * cells_per_s);
    }
    if (options.stop.stop_requested()) return false;
    if (file) file->remove();
    return true;
}

std::string preview_words(const LiveMap& map, bool exact_waits, double exact_s) {
    const auto grain = preview_grain(map.prediction);
    if (!map.request.preview || !grain) return {};
    // Two pairs that are exact keep their order.
    const double open = 1.0 - map.exact_share * map.exact_share;
    const int flips = static_cast<int>(std::ceil(grain->most_flips * open));
    const std::string may_change =
        "up to " + std::to_string(flips) + " % of the orders of pairs may change.";
    if (exact_waits) {
        return "A preview: " + may_change + " The exact map takes " + estimate_text(exact_s) + ".";
    }
    if (exact_s < kWorthWordsS || map.exact_share <= 0.0) return {};
    const int exact = static_cast<int>(100.0 * map.exact_share);
    std::string words = "A preview, " + std::to_string(exact) + " % exact: " + may_change;
    if (map.is_kept) words += " A restart continues it.";
    return words;
}

namespace {

bool is_shifted(const LiveMapRequest& request) {
    return request.set->model.coding.tables.threshold != default_tables().threshold;
}

LiveMapRequest without_shifts(const LiveMapRequest& request) {
    LiveMapRequest unshifted = request;
    PatternSet set = *request.set;
    set.model.coding.tables.threshold = default_tables().threshold;
    unshifted.set = std::make_shared<const PatternSet>(std::move(set));
    unshifted.preview = false;
    return unshifted;
}

// As is_same_work would find, without a copy of the set in every frame.
bool is_without_shifts(const LiveMapRequest& unshifted, const LiveMapRequest& shown) {
    PerceptualModelParams model = shown.set->model;
    model.coding.tables.threshold = default_tables().threshold;
    return !unshifted.preview && unshifted.dimensions == shown.dimensions &&
           unshifted.rendered_by == shown.rendered_by && unshifted.set->model == model &&
           std::ranges::equal(unshifted.set->vibrations, shown.set->vibrations, {},
                              &Vibration::source, &Vibration::source);
}

}  // namespace

bool keeps_anchor(const MapTransition& before, const LiveMap& fresh) {
    if (fresh.request.preview) return true;
    if (!is_shifted(fresh.request)) return false;
    return before.anchor && !is_shifted(before.anchor->request) &&
           before.anchor_points.cols() == fresh.space.points.cols();
}

bool shows_unshifted(const MapTransition& map) {
    if (!map.shown || !map.anchor || map.anchor == map.shown) return false;
    if (map.anchor_points.cols() != map.to.cols()) return false;
    return is_shifted(map.shown->request) &&
           is_without_shifts(map.anchor->request, map.shown->request);
}

void follow_unshifted(const Ui& ui, ShownMap& shown_map) {
    MapTransition& map = shown_map.transition;
    if (!map.shown || !has_jobs(ui) || map.shown->request.preview) return;
    const LiveMapRequest& shown = map.shown->request;
    if (!is_shifted(shown) || shows_unshifted(map) || needs_asking(*shown.set)) return;
    if (std::exchange(shown_map.unshifted_asked_of, map.shown) != map.shown) {
        shown_map.unshifted_job.ask(without_shifts(shown), LiveMapWork{}, ui.wake,
                                    JobPolicy::supersede, is_same_work);
    }
    auto unshifted = shown_map.unshifted_job.latest();
    if (!unshifted || !is_without_shifts(unshifted->request, shown)) return;
    map.anchor_points = aligned_to_anchor(map, *unshifted);
    map.anchor = std::move(unshifted);
    map.ghost = ghosts_of(*map.shown, map);
}

}  // namespace tact
