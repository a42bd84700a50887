#include "model/training/training_search.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

#include "model/common/parallel.h"
#include "model/dissimilarity/correlation.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/system/pauses.h"
#include "model/training/training_plan.h"
#include "model/training/training_tally.h"

namespace tact {

namespace {

constexpr std::size_t kChannelsAtOnce = 128;

// Twice the ranks about their mean.
std::vector<std::int32_t> excesses(std::span<const double> values) {
    std::vector<std::int32_t> result;
    const double middle = static_cast<double>(values.size()) + 1.0;
    for (const double rank : average_ranks(values)) {
        result.push_back(static_cast<std::int32_t>(2.0 * rank - middle));
    }
    return result;
}

PerReceptor<double> weights_of(const ChannelUnits& channel, int units) {
    PerReceptor<double> weights{};
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        weights[c] = static_cast<double>(channel[c]) / units;
    }
    return weights;
}

std::vector<double> nc_values(const SearchSet& set, std::size_t layers,
                              const PerReceptor<double>& weight) {
    std::vector<double> nc(set.oc_rank.size());
    std::ranges::transform(set.forms[layers], nc.begin(), [&](const SpikeForm& form) {
        return nc_dissimilarity(form, set.samples, weight);
    });
    return nc;
}

// Ranks of NC for the channel weights from `first` on, as many as stand side by side.
void rank_channels(const Plan& plan, std::size_t layers, std::size_t first,
                   std::vector<SetRoom>& rooms) {
    const std::size_t width = plan.kernel->weights;
    std::vector<Line> lines(lines_of(kFormTerms * width * sizeof(std::int32_t)));
    auto* products = reinterpret_cast<std::int32_t*>(lines.data());
    for (std::size_t v = 0; v < width; ++v) {
        const ChannelUnits& w =
            plan.grid.channels[std::min(first + v, plan.grid.channels.size() - 1)];
        std::size_t term = 0;
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            for (std::size_t d = c; d < kReceptorCount; ++d, ++term) {
                products[term * width + v] = w[c] * w[d] * (c == d ? 1 : 2);
            }
        }
    }
    for (std::size_t s = 0; s < rooms.size(); ++s) {
        const PlannedSet& planned = plan.sets[s];
        if (planned.terms.empty()) continue;
        plan.kernel->rank_forms({.pairs = planned.set->oc_rank.size(),
                                 .form = planned.terms[layers].data(),
                                 .products = products,
                                 .value = rooms[s].value,
                                 .rank = rooms[s].rank});
    }
}

// One of those ranked side by side, or, where they are not whole enough, ranked as the model does.
void take_ranks(const Plan& plan, std::size_t s, SetRoom& room, GridPoint at, std::size_t lane) {
    if (!plan.sets[s].terms.empty()) {
        const std::size_t width = plan.kernel->weights;
        for (std::size_t k = 0; k < room.nc.size(); ++k) room.nc[k] = room.rank[k * width + lane];
        return;
    }
    const auto weights = weights_of(plan.grid.channels[at.channel], plan.grid.units);
    const auto ranks = average_ranks(nc_values(*plan.sets[s].set, at.layers, weights));
    std::ranges::transform(ranks, room.nc.begin(),
                           [](double rank) { return static_cast<std::int32_t>(2.0 * rank); });
}

// To the sums of kMixes mixtures what each has of one column.
void add_rho(double* sums, const double* rho, bool absolute) {
    for (std::size_t l = 0; l < kMixes; ++l) sums[l] += absolute ? std::abs(rho[l]) : rho[l];
}

// The objectives of all mixtures of one order of NC.
void tally_mixes(const Plan& plan, const std::vector<SetRoom>& rooms, GridPoint at,
                 SearchTally& tally) {
    const bool absolute = plan.params->objective == TrainingObjective::mean_absolute_rho;
    for (std::size_t block = 0; block < plan.blocks; ++block) {
        const std::size_t used = std::min(kMixes, plan.mixes - block * kMixes);
        at.mix = static_cast<std::uint32_t>(1 + block * kMixes);
        for (std::size_t o = 0; o < plan.problem->objectives.size(); ++o) {
            const auto& places = plan.problem->objectives[o];
            double value[kMixes] = {};
            for (const ColumnPlace& place : places) {
                const PlannedSet& planned = plan.sets[place.set];
                const std::size_t column = block * planned.columns +
                                           planned.rated[place.rated].first_column + place.column;
                add_rho(value, rooms[place.set].rho + column * kMixes, absolute);
            }
            for (double& sum : value) sum /= static_cast<double>(places.size());
            take_values(tally, plan.grid, o, at, std::span(value).first(used));
        }
    }
}

// OC alone orders the pairs in the same way for all of NC's parameters.
void tally_oc(const Plan& plan, SearchTally& tally) {
    const bool absolute = plan.params->objective == TrainingObjective::mean_absolute_rho;
    for (std::size_t o = 0; o < plan.problem->objectives.size(); ++o) {
        const auto& places = plan.problem->objectives[o];
        double value = 0.0;
        for (const ColumnPlace& place : places) {
            const SearchSet& set = plan.problem->sets[place.set];
            const RatedPairs& rated = set.rated[place.rated];
            std::vector<double> oc;
            for (const std::size_t pair : rated.pairs) oc.push_back(set.oc_rank[pair]);
            const auto a = excesses(oc);
            const auto& b = rated.column[place.column];
            const double rho =
                std::clamp(product(a, b) / std::sqrt(product(a, a) * product(b, b)), -1.0, 1.0);
            value += absolute ? std::abs(rho) : rho;
        }
        value /= static_cast<double>(places.size());
        take_values(tally, plan.grid, o, {}, std::span(&value, 1));
    }
}

// One pair of layer counts, some channel weights after one another.
void search_some(const Plan& plan, std::size_t task, std::vector<SetRoom>& rooms,
                 SearchTally& tally) {
    const std::size_t layers = task % kTrainedLayers;
    const std::size_t begin = task / kTrainedLayers * kChannelsAtOnce;
    const std::size_t end = std::min(begin + kChannelsAtOnce, plan.grid.channels.size());
    const std::size_t width = plan.kernel->weights;
    for (std::size_t channel = begin; channel < end; ++channel) {
        const std::size_t lane = (channel - begin) % width;
        if (lane == 0) rank_channels(plan, layers, channel, rooms);
        const GridPoint at{static_cast<std::uint32_t>(layers), static_cast<std::uint32_t>(channel),
                           0};
        for (std::size_t s = 0; s < rooms.size(); ++s) {
            take_ranks(plan, s, rooms[s], at, lane);
            find_rhos(plan, plan.sets[s], rooms[s]);
        }
        tally_mixes(plan, rooms, at, tally);
    }
}

}  // namespace

std::optional<ColumnPlace> add_ratings(SearchProblem& problem, std::size_t set,
                                       std::span<const double> condensed) {
    SearchSet& of = problem.sets[set];
    assert(condensed.size() == of.oc_rank.size() && "ratings of the pairs of the set");
    std::vector<std::size_t> pairs;
    for (std::size_t k = 0; k < condensed.size(); ++k) {
        if (std::isfinite(condensed[k])) pairs.push_back(k);
    }
    std::ranges::stable_sort(pairs, {}, [&](std::size_t pair) { return of.oc_rank[pair]; });
    std::vector<double> known;
    for (const std::size_t pair : pairs) known.push_back(condensed[pair]);
    std::vector<std::int32_t> column = excesses(known);
    if (std::ranges::all_of(column, [](std::int32_t rank) { return rank == 0; })) return {};
    auto rated = std::ranges::find(of.rated, pairs, &RatedPairs::pairs);
    if (rated == of.rated.end()) rated = of.rated.insert(rated, {std::move(pairs), {}});
    rated->column.push_back(std::move(column));
    return ColumnPlace{set, static_cast<std::size_t>(rated - of.rated.begin()),
                       rated->column.size() - 1};
}

std::optional<SearchResult> search(const SearchProblem& problem, const SearchParams& params) {
    const Plan plan = planned(problem, params);
    const std::size_t chunks = (plan.grid.channels.size() + kChannelsAtOnce - 1) / kChannelsAtOnce;
    const std::size_t tasks = chunks * kTrainedLayers;
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    SearchTally all = empty_tally(plan.grid, problem.objectives.size());
    tally_oc(plan, all);
    std::mutex mutex;
    const auto workers = static_cast<std::size_t>(thread_count(params.threads));
    parallel_for(workers, params.threads, params.stop, [&](std::size_t) {
        std::vector<SetRoom> rooms;
        for (const PlannedSet& set : plan.sets) rooms.push_back(room_for(set, plan));
        SearchTally own = empty_tally(plan.grid, problem.objectives.size());
        while (!params.stop.stop_requested()) {
            const std::size_t task = next.fetch_add(1);
            if (task >= tasks) break;
            search_some(plan, task, rooms, own);
            const auto share =
                static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(tasks);
            if (params.progress) params.progress(share);
            pause_if_due();
        }
        const std::scoped_lock lock(mutex);
        merge_into(all, std::move(own));
    });
    if (done != tasks) return std::nullopt;
    return result_of(plan.grid, std::move(all));
}

double rho_at(const SearchSet& set, const PerceptualModelParams& model,
              std::span<const double> condensed) {
    // Without NC a model may keep layers from outside the grid.
    const int index =
        model.coding.excitatory_layers * (kMostTrainedLayers + 1) + model.coding.inhibitory_layers;
    const auto layers = model.nc_weight == 0.0 ? 0 : static_cast<std::size_t>(index);
    assert(layers < set.forms.size() && "layers outside the grid");
    std::vector<double> pm = average_ranks(nc_values(set, layers, model.channel_weight));
    for (std::size_t k = 0; k < pm.size(); ++k) {
        pm[k] = pm_of(pm[k], set.oc_rank[k], model.nc_weight, model.oc_weight);
    }
    return spearman(pm, condensed);
}

}  // namespace tact
