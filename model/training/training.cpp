#include "model/training/training.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/common/distributions.h"
#include "model/dissimilarity/correlation.h"
#include "model/training/prepared_training.h"

namespace tact {

namespace {

// Seconds of one core, roughly: a mixture of two pairs, a pattern's code, a pair's time warping.
constexpr double kMixtureS = 1.8e-11;
constexpr double kCodeS = 1.5e-3;
constexpr double kWarpS = 8e-3;

// The listed class nearest to the model before; ties: the first.
PerceptualModelParams chosen(const TrainingGrid& grid, const SearchOptimum& optimum,
                             const PerceptualModelParams& before) {
    PerceptualModelParams nearest = before;
    double least = std::numeric_limits<double>::infinity();
    for (const GridPoint& point : optimum.points) {
        const PerceptualModelParams model = nearest_model(grid, point, before);
        const double steps = parameter_steps(model, before, grid.units);
        if (steps >= least - 1e-9) continue;
        least = steps;
        nearest = model;
    }
    return nearest;
}

// A model that the search chose may keep layers of before, beyond the grid, if OC alone decides.
double rho_of(const PreparedTraining& prepared, std::size_t s, const PerceptualModelParams& model,
              std::span<const double> ratings) {
    if (model == prepared.before[s].params) {
        return spearman(prepared.before[s].pm.condensed, ratings);
    }
    return rho_at(prepared.problem.sets[s], model, ratings);
}

LeftOut fitted_without(const Training& training, const SearchOptimum& optimum) {
    LeftOut left_out;
    left_out.model = chosen(training.grid, optimum, training.before);
    left_out.value = optimum.value;
    left_out.combinations = optimum.combinations;
    return left_out;
}

void add_sets(Training& training, const PreparedTraining& prepared, const SearchResult& found,
              std::span<const TrainingSet> sets) {
    std::vector<double> before;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const std::vector<double>& ratings = prepared.ratings[s].condensed;
        TrainedSet set;
        set.name = sets[s].name;
        set.patterns = sets[s].waveforms.size();
        set.rated_pairs = static_cast<std::size_t>(
            std::ranges::count_if(ratings, [](double value) { return std::isfinite(value); }));
        set.rho_before = rho_of(prepared, s, training.before, ratings);
        set.rho_after = rho_of(prepared, s, training.model, ratings);
        const bool absolute = training.objective == TrainingObjective::mean_absolute_rho;
        before.push_back(absolute ? std::abs(set.rho_before) : set.rho_before);
        training.sets.push_back(set);
        if (sets.size() == 1) continue;
        LeftOut left_out = fitted_without(training, found.optima[1 + s]);
        left_out.name = set.name;
        left_out.rho_before = set.rho_before;
        left_out.rho_after = rho_of(prepared, s, left_out.model, ratings);
        training.without_set.push_back(left_out);
    }
    training.value_before = mean_known(before);
}

std::vector<LeftOut> fitted_without_each(const std::vector<LeftOutRatings>& all,
                                         const Training& training, const PreparedTraining& prepared,
                                         const SearchResult& found) {
    std::vector<LeftOut> fitted;
    for (const LeftOutRatings& one : all) {
        LeftOut left_out = fitted_without(training, found.optima[one.objective]);
        left_out.name = one.name;
        std::vector<double> before;
        std::vector<double> after;
        for (std::size_t s = 0; s < one.ratings.size(); ++s) {
            if (one.ratings[s].empty()) continue;
            before.push_back(rho_of(prepared, s, training.before, one.ratings[s]));
            after.push_back(rho_of(prepared, s, left_out.model, one.ratings[s]));
        }
        left_out.rho_before = mean_known(before);
        left_out.rho_after = mean_known(after);
        fitted.push_back(left_out);
    }
    return fitted;
}

void raise(double& best, double value) {
    if (value > best) best = value;
}

// From the best of each class of proportional weights to that of each weight.
void add_marginals(Training& training, const SearchResult& found) {
    const TrainingGrid& grid = found.grid;
    auto& best_of = training.best_of;
    const auto steps = static_cast<std::size_t>(grid.units) + 1;
    constexpr double kNothing = -std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        best_of[p].assign(p < 2 ? kMostTrainedLayers + 1 : steps, kNothing);
    }
    for (std::size_t l = 0; l < found.best_of_layers.size(); ++l) {
        const auto [excitatory, inhibitory] = layers_at(l);
        raise(best_of[0][static_cast<std::size_t>(excitatory)], found.best_of_layers[l]);
        raise(best_of[1][static_cast<std::size_t>(inhibitory)], found.best_of_layers[l]);
    }
    const auto raise_weight = [&](std::size_t p, int weight, int times, double value) {
        raise(best_of[p][static_cast<std::size_t>(weight * times)], value);
    };
    for (std::size_t k = 0; k < grid.channels.size(); ++k) {
        for (int times = 1; times <= static_cast<int>(grid.channel_multiples[k]); ++times) {
            for (std::size_t c = 0; c < kReceptorCount; ++c) {
                raise_weight(2 + c, grid.channels[k][c], times, found.best_of_channel[k]);
            }
        }
    }
    for (std::size_t k = 0; k < grid.mixes.size(); ++k) {
        for (int times = 1; times <= static_cast<int>(grid.mix_multiples[k]); ++times) {
            raise_weight(6, grid.mixes[k].nc, times, found.best_of_mix[k]);
            raise_weight(7, grid.mixes[k].oc, times, found.best_of_mix[k]);
        }
    }
}

double cost_of_codes_s(std::size_t patterns) {
    return static_cast<double>(patterns * kTrainedLayers) * kCodeS +
           static_cast<double>(pair_count(patterns)) * kWarpS;
}

}  // namespace

std::array<double, kTrainedParameters> trained_values(const PerceptualModelParams& model) {
    const auto& w = model.channel_weight;
    return {static_cast<double>(model.coding.excitatory_layers),
            static_cast<double>(model.coding.inhibitory_layers),
            w[0],
            w[1],
            w[2],
            w[3],
            model.nc_weight,
            model.oc_weight};
}

Expected<Done> can_train(std::span<const TrainingSet> sets, const TrainingParams& params) {
    if (sets.empty()) return Error{"expected a set with ratings, got none"};
    for (const TrainingSet& set : sets) {
        if (set.waveforms.size() < 3) {
            return Error{set.name + ": expected at least three patterns, got " +
                         std::to_string(set.waveforms.size())};
        }
        const std::size_t rated = set.study.labels.size() - unrated_patterns(set.study).size();
        if (rated < 3) {
            return Error{set.name + ": expected ratings of at least three patterns, got those of " +
                         std::to_string(rated)};
        }
        const Dissimilarity mean = mean_ratings(set.study);
        if (std::isnan(spearman(mean.condensed, mean.condensed))) {
            return Error{set.name + ": expected ratings that differ, got the same for every pair"};
        }
    }
    if (params.leave_out_participants && participants_of(sets).size() < 2) {
        return Error{"expected ratings of several participants to leave one out, got those of one"};
    }
    return Done{};
}

std::optional<Training> train(std::span<const TrainingSet> sets, const TrainingParams& params) {
    assert(can_train(sets, params) && "there is nothing to fit to");
    std::vector<std::size_t> patterns;
    double codes_s = 0.0;
    for (const TrainingSet& set : sets) {
        patterns.push_back(set.waveforms.size());
        codes_s += cost_of_codes_s(set.waveforms.size());
    }
    const double all_s = training_cost(patterns, params.units).one_core_s;
    const double share_of_codes = codes_s / all_s;
    const auto progress = [&](double share) {
        if (params.progress) params.progress(share);
    };
    const auto ready =
        prepared_training(sets, params, [&](double share) { progress(share_of_codes * share); });
    if (!ready) return std::nullopt;
    SearchParams search_params{params.units,  params.objective, params.threads,
                               params.kernel, params.stop,      {}};
    search_params.progress = [&](double share) {
        progress(share_of_codes + (1.0 - share_of_codes) * share);
    };
    std::optional<SearchResult> found = search(ready->problem, search_params);
    if (!found) return std::nullopt;
    Training training;
    training.objective = params.objective;
    training.before = params.model;
    training.best = found->optima.front();
    training.grid = found->grid;
    training.model = chosen(found->grid, training.best, params.model);
    training.share_near_best = share_near_best(*found, kNearBest);
    add_sets(training, *ready, *found, sets);
    training.without_participant =
        fitted_without_each(ready->participants, training, *ready, *found);
    training.without_pattern = fitted_without_each(ready->patterns, training, *ready, *found);
    add_marginals(training, *found);
    return training;
}

LeftOutMean mean_of(std::span<const LeftOut> left_out) {
    std::vector<double> before;
    std::vector<double> after;
    for (const LeftOut& one : left_out) {
        if (std::isnan(one.rho_before) || std::isnan(one.rho_after)) continue;
        before.push_back(one.rho_before);
        after.push_back(one.rho_after);
    }
    return {mean_known(before), mean_known(after)};
}

TrainingCost training_cost(std::span<const std::size_t> patterns_of_sets, int units) {
    const TrainingGrid grid = training_grid(units);
    TrainingCost cost;
    cost.combinations = combination_count(units);
    cost.different = kTrainedLayers * grid.channels.size() * grid.mixes.size();
    for (const std::size_t patterns : patterns_of_sets) {
        const auto pairs = static_cast<double>(pair_count(patterns));
        cost.one_core_s += cost_of_codes_s(patterns);
        cost.one_core_s +=
            kMixtureS * static_cast<double>(cost.different) * (pairs * (pairs - 1.0) / 2.0 + 1000);
    }
    return cost;
}

}  // namespace tact
