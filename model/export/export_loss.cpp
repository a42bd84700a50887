#include "model/export/export_loss.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/common/portable.h"
#include "model/export/ranks_among.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/subset/set_subset.h"

namespace tact {

namespace {

// Both sets, coded and compared.
struct BothSides {
    Prediction meant;
    Prediction back;
};

// Root of the mean square of the difference, g; of waveforms of one length.
double rms_error_g(const Waveform& a, const Waveform& b) {
    Waveform difference = a;
    for (std::size_t n = 0; n < difference.samples_g.size(); ++n) {
        difference.samples_g[n] -= b.samples_g[n];
    }
    return rms_g(difference);
}

// Share of a set's largest dissimilarity: closer ones are taken as equal. Steps of 24 bits and the
// ends of a filter stay below it. Otherwise equal pairs would get other ranks, though nothing is
// felt.
constexpr double kSame = 1e-4;

double same_of(const Dissimilarity& meant) {
    if (meant.condensed.empty()) return 0.0;
    return kSame * std::ranges::max(meant.condensed);
}

// What came back the same is the same, to the bit.
void keep_same(Dissimilarity& came, const Dissimilarity& meant) {
    const double same = same_of(meant);
    for (std::size_t k = 0; k < meant.condensed.size(); ++k) {
        const double before = meant.condensed[k];
        if (std::abs(came.condensed[k] - before) <= same) came.condensed[k] = before;
    }
}

void rank_again(Prediction& prediction) {
    prediction.nc_rank = average_ranks(prediction.nc.condensed);
    prediction.oc_rank = average_ranks(prediction.oc.condensed);
    const auto& params = prediction.params;
    for (std::size_t k = 0; k < prediction.pm.condensed.size(); ++k) {
        prediction.pm.condensed[k] =
            pm_of(prediction.nc_rank[k], prediction.oc_rank[k], params.nc_weight, params.oc_weight);
    }
}

std::function<void(double)> share_of(const std::function<void(double)>& progress, double from,
                                     double to) {
    if (!progress) return {};
    return [&progress, from, to](double share) { progress(from + (to - from) * share); };
}

// Both as long as the longer one, so that a waveform that comes back as it was is the same one.
std::optional<BothSides> both_sides(const PatternSet& set, const PatternSet& back,
                                    const ExportLossOptions& options) {
    PredictOptions how;
    how.samples = std::max(longest_samples(set), longest_samples(back));
    how.threads = options.threads;
    how.stop = options.stop;
    how.previous = options.known;
    how.progress = share_of(options.progress, 0.0, 0.45);
    auto meant = predict(own_waveforms(set, options.threads), set.model, how);
    if (!meant) return std::nullopt;
    how.previous = &*meant;
    how.progress = share_of(options.progress, 0.45, 0.9);
    auto came = predict(own_waveforms(back, options.threads), set.model, how);
    if (!came) return std::nullopt;
    keep_same(came->nc, meant->nc);
    keep_same(came->oc, meant->oc);
    rank_again(*came);
    return BothSides{*std::move(meant), *std::move(came)};
}

// PM of pairs from their NC and OC, on the scale of the intended set.
std::vector<double> pm_among(const Prediction& meant, std::span<const double> nc,
                             std::span<const double> oc) {
    const std::vector<double> nc_ranks = ranks_among(nc, meant.nc.condensed);
    const std::vector<double> oc_ranks = ranks_among(oc, meant.oc.condensed);
    std::vector<double> pm;
    for (std::size_t k = 0; k < nc.size(); ++k) {
        pm.push_back(
            pm_of(nc_ranks[k], oc_ranks[k], meant.params.nc_weight, meant.params.oc_weight));
    }
    return pm;
}

// How far each pattern is from itself.
std::vector<std::optional<double>> moved_by(const BothSides& sides,
                                            const ExportLossOptions& options) {
    const std::size_t count = sides.meant.codes.size();
    std::vector<std::optional<double>> moved(count);
    if (count < 2) return moved;
    PredictOptions how;
    how.threads = options.threads;
    std::vector<double> nc;
    std::vector<double> oc;
    for (std::size_t k = 0; k < count; ++k) {
        if (options.stop.stop_requested()) return moved;
        const std::vector both{sides.meant.codes[k], sides.back.codes[k]};
        nc.push_back(nc_matrix(both, sides.meant.params, how).condensed.front());
        oc.push_back(oc_matrix(both, sides.meant.params, how).condensed.front());
    }
    const std::vector<double> pm = pm_among(sides.meant, nc, oc);
    for (std::size_t k = 0; k < count; ++k) {
        const bool same = nc[k] <= same_of(sides.meant.nc) && oc[k] <= same_of(sides.meant.oc);
        moved[k] = same ? 0.0 : pm[k];
    }
    return moved;
}

std::vector<PatternLoss> losses_of(const PatternSet& set, const ExportedSet& exported,
                                   const BothSides& sides,
                                   const std::vector<std::optional<double>>& moved) {
    std::vector<PatternLoss> losses;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        PatternLoss loss{
            set.vibrations[k].name, !exported.patterns[k], {}, 0.0, {}, moved[k], false, {}};
        if (exported.patterns[k]) loss.remarks = exported.patterns[k]->remarks;
        if (exported.patterns[k]) loss.error = exported.patterns[k]->error;
        loss.silenced = is_felt(*sides.meant.codes[k]) && !is_felt(*sides.back.codes[k]);
        const bool said = !loss.remarks.empty() && loss.remarks.back() == kSilenced;
        if (loss.silenced && !said) loss.remarks.emplace_back(kSilenced);
        const Waveform meant = coded_waveform(*sides.meant.codes[k]);
        loss.rms_error_g = rms_error_g(meant, coded_waveform(*sides.back.codes[k]));
        const double peak = peak_g(meant);
        if (loss.rms_error_g > 0.0 && peak > 0.0) {
            loss.psnr_db = 20.0 * portable::log10(peak / loss.rms_error_g);
        }
        losses.push_back(std::move(loss));
    }
    return losses;
}

std::optional<ConfusablePair> closest_of(const Dissimilarity& pm) {
    if (pm.condensed.empty()) return std::nullopt;
    const auto least = std::ranges::min_element(pm.condensed);
    const auto place = static_cast<std::size_t>(least - pm.condensed.begin());
    const auto [a, b] = pair_at(pm.size, place);
    return ConfusablePair{a, b, *least};
}

std::vector<PairChange> most_moved(const Dissimilarity& before, const Dissimilarity& after,
                                   std::size_t most) {
    std::vector<PairChange> all;
    for (std::size_t k = 0; k < before.condensed.size(); ++k) {
        if (before.condensed[k] == after.condensed[k]) continue;
        const auto [a, b] = pair_at(before.size, k);
        all.push_back({a, b, before.condensed[k], after.condensed[k]});
    }
    const auto size = [](const PairChange& one) { return std::abs(one.after - one.before); };
    std::ranges::stable_sort(
        all, [&](const PairChange& x, const PairChange& y) { return size(x) > size(y); });
    all.resize(std::min(all.size(), most));
    return all;
}

// As many as can be picked at all, where nobody said how many.
std::size_t wanted_count(const SubsetProblem& problem, std::size_t objects, std::size_t asked) {
    if (asked > 0) return asked;
    const std::size_t most = objects - std::min(objects, problem.drop.size());
    const std::size_t least = std::max<std::size_t>(2, problem.keep.size());
    return std::clamp(usual_subset_count(objects), std::min(least, most), most);
}

void pick(ExportLoss& loss, const PatternSet& set, const BothSides& sides,
          const ExportLossOptions& options) {
    const std::size_t objects = set.vibrations.size();
    if (objects < 3) {
        loss.no_subset = "fewer than three patterns: there is nothing to choose";
        return;
    }
    // What nobody feels is left out, as wherever one picks.
    SubsetProblem problem = subset_problem(set, 0, options.objective, unfelt(sides.meant.codes));
    problem.count = wanted_count(problem, objects, options.subset_count);
    SubsetOptions how;
    how.time_limit_s = options.time_limit_s;
    how.threads = options.threads;
    how.stop = options.stop;
    const auto meant = most_distinct_subset(sides.meant.pm, problem, how);
    if (!meant) {
        loss.no_subset = meant.error().message;
        return;
    }
    const std::vector<std::size_t> silent = unfelt(sides.back.codes);
    SubsetProblem there = subset_problem(set, 0, options.objective, silent);
    there.count = problem.count;
    const auto best = most_distinct_subset(sides.back.pm, there, how);
    if (!best) {
        loss.no_subset = "too few patterns can be felt on the target: " + best.error().message;
        return;
    }
    SubsetChange change{problem, *meant, {}, *best, {}, true, {}};
    std::ranges::copy_if(silent, std::back_inserter(change.silenced),
                         [&](std::size_t k) { return is_felt(*sides.meant.codes[k]); });
    change.kept = subset_of(sides.back.pm, meant->best.members);
    const Subset after = subset_of(loss.after, meant->best.members);
    change.weakest = {after.weakest.first, after.weakest.second, after.weakest_dissimilarity};
    change.is_still_best = is_best_there(change);
    loss.subset = std::move(change);
}

void draw_maps(ExportLoss& loss, const BothSides& sides, const ExportLossOptions& options) {
    const std::size_t objects = loss.patterns.size();
    if (objects < 3) return;
    MdsParams params = standard_mds_params(objects, options.dimensions);
    params.threads = options.threads;
    const PerceptualSpace before = nonmetric_mds(sides.meant.pm, params, options.stop);
    const PerceptualSpace after = nonmetric_mds(sides.back.pm, params, options.stop);
    const ProcrustesFit fit = procrustes(after.points, before.points);
    loss.map =
        MapChange{before.points, fit.aligned, before.stress1, after.stress1, fit.correlation};
}

}  // namespace

bool is_best_there(const SubsetChange& change) {
    const Subset& best = change.best.best;
    if (change.kept.members == best.members) return true;
    const bool one_is_silenced = std::ranges::any_of(change.silenced, [&](std::size_t k) {
        return std::ranges::binary_search(change.kept.members, k) &&
               !std::ranges::binary_search(best.members, k);
    });
    return !one_is_silenced && change.kept.weakest_dissimilarity == best.weakest_dissimilarity &&
           change.kept.sum == best.sum;
}

std::vector<std::size_t> best_for_target(const ExportLoss& loss) {
    if (!loss.subset) return {};
    const SubsetChange& change = *loss.subset;
    return change.is_still_best ? change.kept.members : change.best.best.members;
}

std::size_t usual_subset_count(std::size_t patterns) {
    if (patterns < 3) return 0;
    return std::clamp<std::size_t>(patterns / 2, 2, 8);
}

std::optional<ExportLoss> export_loss(const PatternSet& set, const ExportTarget& target,
                                      const ExportLossOptions& options) {
    const auto exported = exported_set(set, target, options.threads, options.stop, options.date);
    if (!exported) return std::nullopt;
    const auto sides = both_sides(set, exported->back, options);
    if (!sides) return std::nullopt;
    ExportLoss loss{
        exported->target, {}, {}, {}, sides->meant.pm, sides->back.pm, {}, {}, {}, {}, {}, {}};
    loss.patterns = losses_of(set, *exported, *sides, moved_by(*sides, options));
    for (const auto& pattern : exported->patterns) {
        loss.files.push_back(pattern ? pattern->text : std::string());
        loss.beside.push_back(pattern ? pattern->beside : std::string());
    }
    loss.after.condensed =
        pm_among(sides->meant, sides->back.nc.condensed, sides->back.oc.condensed);
    loss.closest_before = closest_of(loss.before);
    loss.closest_after = closest_of(loss.after);
    loss.most_moved = most_moved(loss.before, loss.after, options.most_pairs);
    pick(loss, set, *sides, options);
    draw_maps(loss, *sides, options);
    if (options.stop.stop_requested()) return std::nullopt;
    if (options.progress) options.progress(1.0);
    return loss;
}

}  // namespace tact
