#include "model/dtw/dtw_batches.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "model/common/parallel.h"

namespace tact {

namespace {

// A pair alone costs this many times its share of a full register: 1.2 (baseline), 1.3 (AVX-512)
// and 1.6 (AVX2) were measured on Zen 4. It decides who computes a pair, never the result.
constexpr double kCostOfOne = 1.4;

// Fewer pairs than this are sorted sooner than another thread begins.
constexpr std::size_t kFewPairs = 10'000;

// With more batches than this for each thread, balance is good without any care.
constexpr std::size_t kManyBatches = 16;

struct Shape {
    std::size_t rows = 0;
    std::size_t columns = 0;
    bool operator==(const Shape&) const = default;
};

Shape shape(const TrimmedPair& pair) { return {pair.signals.rows(), pair.signals.columns()}; }

Shape around(Shape a, Shape b) {
    return {std::max(a.rows, b.rows), std::max(a.columns, b.columns)};
}

// Cells that a sweep visits: strips are filled up, and each begins and ends by and by.
double cost_of(const DtwSweep& sweep, Shape shape) {
    const std::size_t margin = sweep.rows - 1;
    const std::size_t rows = (shape.rows + margin) / sweep.rows * sweep.rows;
    const double lanes = sweep.pairs == 1 ? kCostOfOne : static_cast<double>(sweep.pairs);
    return lanes * static_cast<double>(rows) * static_cast<double>(shape.columns + margin);
}

// Zeros at the ends of a signal, which may be all of it.
struct Silence {
    std::size_t before = 0;
    std::size_t behind = 0;
};

Silence silence_of(std::span<const double> values) {
    const auto sounds = [](double value) { return value != 0.0; };
    const auto first = std::ranges::find_if(values, sounds);
    const auto last = std::find_if(values.rbegin(), values.rend(), sounds);
    return {static_cast<std::size_t>(first - values.begin()),
            static_cast<std::size_t>(last - values.rbegin())};
}

// Values, and the samples that they and the zeros behind them make.
struct Signal {
    std::span<const double> values;
    std::size_t samples = 0;
};

// The silence of a whole signal, from that of its values.
Silence with_zeros(Silence silence, const Signal& signal) {
    const std::size_t zeros = signal.samples - signal.values.size();
    if (silence.before == signal.values.size()) silence.before += zeros;
    silence.behind += zeros;
    return silence;
}

// One zero stays at each end that is cut; of a signal of zeros alone, one.
Signal without(Signal signal, Silence silence, bool before, bool behind) {
    if (behind) signal.samples -= silence.behind - 1;
    if (before) {
        const std::size_t cut = std::min(silence.before, signal.samples) - 1;
        signal.samples -= cut;
        signal.values = signal.values.subspan(std::min(cut, signal.values.size()));
    }
    signal.values = signal.values.first(std::min(signal.values.size(), signal.samples));
    return signal;
}

TrimmedPair trimmed(Signal a, Signal b, Silence of_a, Silence of_b) {
    const bool before = of_a.before > 0 && of_b.before > 0;
    const bool behind = of_a.behind > 0 && of_b.behind > 0;
    a = without(a, of_a, before, behind);
    b = without(b, of_b, before, behind);
    if (a.samples < b.samples) std::swap(a, b);
    return {{a.values, b.values, a.samples, b.samples}, behind};
}

// Rows to the first four binary digits: pairs of nearly as many rows may share a register. What it
// counts rises with the rows.
std::uint64_t coarse(std::size_t rows) {
    constexpr std::size_t kStepsPerOctave = 8;
    if (rows < kStepsPerOctave) return rows;
    const auto octave = static_cast<std::uint64_t>(std::bit_width(rows));
    const std::size_t step = std::bit_floor(rows) / kStepsPerOctave;
    return octave * kStepsPerOctave + rows / step - kStepsPerOctave;
}

// Pairs are ordered by one number each: of millions, comparing them field by field, wherever they
// lie, took longer than computing their distances.
std::uint64_t shape_key(const TrimmedPair& pair) {
    constexpr unsigned kLengthBits = 24;  // 1,000 s at 10 kHz
    constexpr std::uint64_t kMost = (1U << kLengthBits) - 1;
    const Shape its = shape(pair);
    const std::uint64_t rows = std::min<std::uint64_t>(its.rows, kMost);
    const std::uint64_t columns = std::min<std::uint64_t>(its.columns, kMost);
    if (!pair.may_be_padded) return rows << kLengthBits | columns;
    const std::uint64_t padded = std::uint64_t{1} << 63U;
    return padded | coarse(rows) << 2 * kLengthBits | columns << kLengthBits | rows;
}

// Pairs that may share a register, side by side.
std::vector<std::size_t> by_shape(std::span<const TrimmedPair> pairs, std::size_t threads) {
    std::vector<std::pair<std::uint64_t, std::size_t>> keyed(pairs.size());
    const auto middle = keyed.begin() + static_cast<std::ptrdiff_t>(keyed.size() / 2);
    const int sorters = pairs.size() < kFewPairs ? 1 : static_cast<int>(threads);
    // The largest first, equal ones as they stand.
    parallel_for(2, sorters, {}, [&](std::size_t half) {
        const auto begin = half == 0 ? keyed.begin() : middle;
        const auto end = half == 0 ? middle : keyed.end();
        auto k = static_cast<std::size_t>(begin - keyed.begin());
        for (auto one = begin; one != end; ++one, ++k) *one = {~shape_key(pairs[k]), k};
        std::sort(begin, end);
    });
    std::inplace_merge(keyed.begin(), middle, keyed.end());
    std::vector<std::size_t> order(pairs.size());
    std::ranges::transform(keyed, order.begin(), [](const auto& one) { return one.second; });
    return order;
}

bool may_share(const TrimmedPair& a, const TrimmedPair& b) {
    return (a.may_be_padded && b.may_be_padded) || shape(a) == shape(b);
}

DtwBatch alone(std::size_t place, const TrimmedPair& pair, const DtwKernel& kernel) {
    return {place, 1, false, cost_of(kernel.one_pair, shape(pair))};
}

// The register that begins at a place, if it costs less than its pairs one by one; otherwise that
// pair.
DtwBatch batch_at(std::size_t first, std::span<const TrimmedPair> pairs,
                  std::span<const std::size_t> order, const DtwKernel& kernel) {
    const TrimmedPair& leader = pairs[order[first]];
    Shape whole = shape(leader);
    double one_by_one = 0.0;
    std::size_t end = first;
    while (end < order.size() && end - first < kernel.many_pairs.pairs &&
           may_share(leader, pairs[order[end]])) {
        whole = around(whole, shape(pairs[order[end]]));
        one_by_one += cost_of(kernel.one_pair, shape(pairs[order[end]]));
        ++end;
    }
    const double together = cost_of(kernel.many_pairs, whole);
    if (together > one_by_one) return alone(first, leader, kernel);
    return {first, end - first, true, together};
}

void sort_by_cost(std::vector<DtwBatch>& batches) {
    std::ranges::stable_sort(batches, std::greater{}, &DtwBatch::cost);
}

// When the last thread is done if each takes the next batch as soon as it is free.
double time_taken(std::span<const DtwBatch> batches, std::size_t threads) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (std::size_t k = 0; k < threads; ++k) free_at.push(0.0);
    double last = 0.0;
    for (const DtwBatch& batch : batches) {
        const double end = free_at.top() + batch.cost;
        free_at.pop();
        free_at.push(end);
        last = std::max(last, end);
    }
    return last;
}

// The same batches with the pairs of some registers one by one.
template <class Chosen>
std::vector<DtwBatch> with_some_apart(std::span<const DtwBatch> batches, const Chosen& chosen,
                                      std::span<const TrimmedPair> pairs,
                                      std::span<const std::size_t> order, const DtwKernel& kernel) {
    std::vector<DtwBatch> all;
    for (std::size_t k = 0; k < batches.size(); ++k) {
        if (!batches[k].side_by_side || !chosen(k)) {
            all.push_back(batches[k]);
            continue;
        }
        for (std::size_t p = batches[k].first; p < batches[k].first + batches[k].count; ++p) {
            all.push_back(alone(p, pairs[order[p]], kernel));
        }
    }
    sort_by_cost(all);
    return all;
}

// A register keeps one thread busy for long: with few of them, some are better taken apart.
std::vector<DtwBatch> balanced(std::vector<DtwBatch> batches, std::span<const TrimmedPair> pairs,
                               std::span<const std::size_t> order, const DtwKernel& kernel,
                               std::size_t threads) {
    if (threads < 2 || batches.size() > kManyBatches * threads) return batches;
    std::vector<DtwBatch> best = batches;
    double least = time_taken(best, threads);
    const std::size_t most = std::min(batches.size(), 2 * threads);
    for (std::size_t apart = 1; apart <= most; ++apart) {
        const auto last = [&](std::size_t k) { return k + apart >= batches.size(); };
        const auto first = [&](std::size_t k) { return k < apart; };
        for (auto trial : {with_some_apart(batches, last, pairs, order, kernel),
                           with_some_apart(batches, first, pairs, order, kernel)}) {
            const double time = time_taken(trial, threads);
            if (time >= least) continue;
            least = time;
            best = std::move(trial);
        }
    }
    return best;
}

}  // namespace

TrimmedPair trimmed(const SignalPair& pair, double waiting_cost) {
    return trimmed(std::span(&pair, 1), waiting_cost).front();
}

std::vector<TrimmedPair> trimmed(std::span<const SignalPair> pairs, double waiting_cost) {
    // By the address of the first value; of signals that begin at the same one, the last.
    std::unordered_map<const double*, std::pair<std::size_t, Silence>> known;
    const auto silence = [&](const Signal& signal) {
        if (waiting_cost > 0.0) return Silence{};  // every zero counts
        const auto [place, is_new] = known.try_emplace(signal.values.data());
        auto& [count, own] = place->second;
        if (is_new || count != signal.values.size()) {
            count = signal.values.size();
            own = silence_of(signal.values);
        }
        return with_zeros(own, signal);
    };
    std::vector<TrimmedPair> all;
    all.reserve(pairs.size());
    for (const SignalPair& pair : pairs) {
        const Signal a{pair.a, pair.rows()};
        const Signal b{pair.b, pair.columns()};
        all.push_back(trimmed(a, b, silence(a), silence(b)));
    }
    return all;
}

DtwBatches dtw_batches(std::span<const TrimmedPair> pairs, const DtwKernel& kernel,
                       std::size_t threads) {
    DtwBatches batches{by_shape(pairs, threads), {}};
    for (std::size_t first = 0; first < pairs.size();) {
        batches.all.push_back(batch_at(first, pairs, batches.order, kernel));
        first += batches.all.back().count;
    }
    sort_by_cost(batches.all);
    batches.all = balanced(std::move(batches.all), pairs, batches.order, kernel, threads);
    return batches;
}

}  // namespace tact
