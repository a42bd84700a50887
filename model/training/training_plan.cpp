#include "model/training/training_plan.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>

namespace tact {

namespace {

// Different whole NC^2 up to here have different ranks in the model: roots of q and q + 1 are at
// least 1 / (2 q) of the largest apart, 2.5 of its 1e9 quanta.
constexpr double kMostSquaredNc = 2e8;

std::vector<std::int32_t> flat(std::span<const SpikeForm> forms) {
    std::vector<std::int32_t> terms;
    terms.reserve(forms.size() * kFormTerms);
    for (const SpikeForm& form : forms) {
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            for (std::size_t d = c; d < kReceptorCount; ++d) {
                terms.push_back(static_cast<std::int32_t>(form[c][d]));
            }
        }
    }
    return terms;
}

PlannedSet planned(const SearchSet& set, int units) {
    PlannedSet plan;
    plan.set = &set;
    const double largest = 4.0 * units;
    if (static_cast<double>(set.samples) * largest * largest <= kMostSquaredNc) {
        for (const auto& forms : set.forms) plan.terms.push_back(flat(forms));
    }
    for (const RatedPairs& rated : set.rated) {
        PlannedColumns columns;
        columns.first_column = plan.columns;
        plan.columns += rated.column.size();
        for (const std::size_t pair : rated.pairs) {
            columns.oc.push_back(static_cast<std::int32_t>(2.0 * set.oc_rank[pair]));
        }
        for (const auto& column : rated.column) {
            columns.ratings.insert(columns.ratings.end(), column.begin(), column.end());
            columns.squares.push_back(product(column, column));
        }
        plan.rated.push_back(std::move(columns));
    }
    plan.is_narrow = fits_narrow_mixes(set.oc_rank.size(), units);
    return plan;
}

// Finds for each rated pair, in the order of OC, the later ones whose NC is not above its own.
void find_mixed(SetRoom& room, std::size_t all_pairs) {
    const std::size_t pairs = room.rated_nc.size();
    const std::size_t words = (pairs + 63) / 64;
    room.below.assign((2 * all_pairs + 1) * words, 0);
    for (std::size_t k = 0; k < pairs; ++k) {
        const auto rank = static_cast<std::size_t>(room.rated_nc[k]);
        room.below[rank * words + k / 64] |= std::uint64_t{1} << k % 64;
    }
    for (std::size_t k = words; k < room.below.size(); ++k) room.below[k] |= room.below[k - words];
    room.mixed.resize(pairs * words);
    for (std::size_t k = 0; k < pairs; ++k) {
        const auto rank = static_cast<std::size_t>(room.rated_nc[k]);
        for (std::size_t w = k / 64; w < words; ++w) {
            room.mixed[k * words + w] = room.below[rank * words + w];
        }
        room.mixed[k * words + k / 64] &= ~std::uint64_t{1} << k % 64;
    }
}

// Fills `rho` with those of all mixtures and columns for the order of NC in room.nc.
void correlate(const Plan& plan, const PlannedSet& planned, SetRoom& room, double* rho) {
    for (std::size_t r = 0; r < planned.rated.size(); ++r) {
        const RatedPairs& rated = planned.set->rated[r];
        const PlannedColumns& columns = planned.rated[r];
        room.rated_nc.clear();
        for (const std::size_t pair : rated.pairs) room.rated_nc.push_back(room.nc[pair]);
        find_mixed(room, room.nc.size());
        MixBatch batch;
        batch.pairs = rated.pairs.size();
        batch.nc_rank = room.rated_nc.data();
        batch.oc_rank = columns.oc.data();
        batch.mixed = room.mixed.data();
        batch.words = (batch.pairs + 63) / 64;
        batch.value = room.mixes.data();
        batch.excess = room.mixes.data() + room.mixes.size() / 2;
        batch.columns = columns.squares.size();
        batch.ratings = columns.ratings.data();
        batch.squares = columns.squares.data();
        for (std::size_t block = 0; block < plan.blocks; ++block) {
            batch.nc_weight = plan.nc_weight.data() + block * kMixes;
            batch.oc_weight = plan.oc_weight.data() + block * kMixes;
            batch.rho = rho + (block * planned.columns + columns.first_column) * kMixes;
            (planned.is_narrow ? plan.kernel->rank_mixes : plan.kernel->rank_wide_mixes)(batch);
        }
    }
}

std::size_t hash_of(std::span<const std::int32_t> ranks) {
    std::uint64_t hash = 0;
    for (const std::int32_t rank : ranks) {
        hash = (std::rotl(hash, 7) ^ static_cast<std::uint64_t>(rank)) * 0x9e3779b97f4a7c15U;
    }
    return hash >> 32U;
}

}  // namespace

double product(std::span<const std::int32_t> a, std::span<const std::int32_t> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>{},
                              [](double x, double y) { return x * y; });
}

Plan planned(const SearchProblem& problem, const SearchParams& params) {
    Plan plan;
    plan.problem = &problem;
    plan.params = &params;
    plan.kernel = params.kernel == nullptr ? &training_kernel() : params.kernel;
    plan.grid = training_grid(params.units);
    plan.mixes = plan.grid.mixes.size() - 1;
    plan.blocks = (plan.mixes + kMixes - 1) / kMixes;
    for (std::size_t k = 0; k < plan.blocks * kMixes; ++k) {
        const MixUnits& mix = plan.grid.mixes[1 + std::min(k, plan.mixes - 1)];
        plan.nc_weight.push_back(mix.nc);
        plan.oc_weight.push_back(mix.oc);
    }
    for (const SearchSet& set : problem.sets) plan.sets.push_back(planned(set, params.units));
    return plan;
}

std::size_t lines_of(std::size_t bytes) { return bytes / sizeof(Line) + 1; }

SetRoom room_for(const PlannedSet& planned, const Plan& plan) {
    SetRoom room;
    const std::size_t pairs = planned.set->oc_rank.size();
    const std::size_t lines = lines_of(pairs * plan.kernel->weights * sizeof(std::int32_t));
    room.lines.resize(2 * lines);
    room.value = reinterpret_cast<std::int32_t*>(room.lines.data());
    room.rank = reinterpret_cast<std::int32_t*>(room.lines.data() + lines);
    room.nc.resize(pairs);
    room.mixes.resize(2 * lines_of(pairs * kMixes * sizeof(std::int32_t)));
    const std::size_t rhos = planned.columns * plan.blocks * kMixes;
    constexpr std::size_t kMostKept = std::size_t{1} << 18;  // of numbers
    room.slots = std::bit_floor(std::clamp<std::size_t>(kMostKept / (rhos + pairs), 8, 2048));
    room.kept_rank.resize(room.slots * pairs);
    room.kept_rho.resize(room.slots * rhos);
    return room;
}

void find_rhos(const Plan& plan, const PlannedSet& planned, SetRoom& room) {
    const std::size_t pairs = room.nc.size();
    const std::size_t rhos = planned.columns * plan.blocks * kMixes;
    const std::size_t slot = hash_of(room.nc) & (room.slots - 1);
    std::int32_t* kept = room.kept_rank.data() + slot * pairs;
    double* rho = room.kept_rho.data() + slot * rhos;
    room.rho = rho;
    if (std::equal(room.nc.begin(), room.nc.end(), kept)) return;
    correlate(plan, planned, room, rho);
    std::ranges::copy(room.nc, kept);
}

}  // namespace tact
