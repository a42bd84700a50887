#include "viz/drawing/wave_body.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tact {
namespace {

constexpr double kSlicesPerColumn = 16.0;  // finer than that a wave is body anyhow
constexpr double kUneven = 1.75;           // of neighbouring periods, to be one oscillation
constexpr double kRim = 1.2;               // periods from an end to its first crest

// The upper edge of a wave, or its lower edge upside down; times are in samples.
struct Vertex {
    double at;
    double value;
    bool bridged;  // the way here from the vertex before it is a straight line over a valley
};

using Edge = std::vector<Vertex>;

// The crest between samples, by the parabola through three of them, if sample i is the highest of a
// smooth hill. Beside a step or a click a parabola would overshoot.
double crest_value(std::span<const double> samples, std::size_t i, double sign) {
    const double top = sign * samples[i];
    if (i < 1 || i + 1 >= samples.size()) return top;
    const auto value = [&](std::size_t k) { return sign * samples[k]; };
    const auto bend = [&](std::size_t k) { return 2.0 * value(k) - value(k - 1) - value(k + 1); };
    const double middle = bend(i);
    const auto like = [&](double other) { return other > 0.5 * middle && other < 2.0 * middle; };
    if (value(i - 1) > top || value(i + 1) > top || !(middle > 0.0)) return top;
    if (i > 1 && !like(bend(i - 1))) return top;
    if (i + 2 < samples.size() && !like(bend(i + 1))) return top;
    const double tilt = value(i + 1) - value(i - 1);
    return top + tilt * tilt / (8.0 * middle);
}

struct Edges {
    Edge upper;
    Edge lower;  // upside down
};

// Edges of samples [begin, end]: each sample, or the most and the least of each slice.
Edges edges_of(std::span<const double> samples, std::size_t begin, std::size_t end,
               std::size_t slices) {
    const std::size_t count = end - begin + 1;
    slices = std::min(slices, count);
    Edges edges;
    edges.upper.reserve(slices);
    edges.lower.reserve(slices);
    const auto add = [&](Edge& edge, std::size_t i, double sign) {
        edge.push_back({static_cast<double>(i), crest_value(samples, i, sign), false});
    };
    for (std::size_t k = 0; k < slices; ++k) {
        const std::size_t first = begin + k * count / slices;
        const auto slice = samples.subspan(first, begin + (k + 1) * count / slices - first);
        const auto [least, most] = std::ranges::minmax_element(slice);
        add(edges.upper, first + static_cast<std::size_t>(most - slice.begin()), 1.0);
        add(edges.lower, first + static_cast<std::size_t>(least - slice.begin()), -1.0);
    }
    return edges;
}

// A top between two valleys: its first and its last vertex that are about as high as the highest,
// and the middle between them.
struct Crest {
    std::size_t begin;
    std::size_t end;
    double at;
};

Crest crest_at(const Edge& edge, std::size_t top, double least) {
    Crest crest{top, top, 0.0};
    const double floor = edge[top].value - least;
    while (crest.begin > 0 && edge[crest.begin - 1].value >= floor) --crest.begin;
    while (crest.end + 1 < edge.size() && edge[crest.end + 1].value >= floor) ++crest.end;
    crest.at = 0.5 * (edge[crest.begin].at + edge[crest.end].at);
    return crest;
}

// Crests with deeper valleys than `least` on both sides; the ends of the edge do not count.
std::vector<Crest> crests_of(const Edge& edge, double least) {
    std::vector<Crest> crests;
    bool is_rising = false;
    std::size_t top = 0;
    double bottom = edge.front().value;
    for (std::size_t i = 1; i < edge.size(); ++i) {
        const double value = edge[i].value;
        if (!is_rising) {
            bottom = std::min(bottom, value);
            is_rising = value > bottom + least;
            if (is_rising) top = i;
        } else if (value > edge[top].value) {
            top = i;
        } else if (value < edge[top].value - least) {
            crests.push_back(crest_at(edge, top, least));
            is_rising = false;
            bottom = value;
        }
    }
    return crests;
}

double period_after(std::span<const Crest> crests, std::size_t k) {
    return crests[k + 1].at - crests[k].at;
}

// Neighbours of valley k about as wide as it, with it: what may be one oscillation.
struct Alike {
    std::size_t begin;
    std::size_t end;
    double mean;    // period
    double widest;  // of the others
};

Alike alike_around(std::span<const Crest> crests, std::size_t k) {
    constexpr std::size_t kReach = 4;
    const std::size_t count = crests.size() - 1;
    const double own = period_after(crests, k);
    const auto is_like = [&](std::size_t other) {
        const double period = period_after(crests, other);
        return period <= kUneven * own && own <= kUneven * period;
    };
    Alike alike{k, k + 1, 0.0, 0.0};
    while (alike.begin > 0 && k - alike.begin < kReach && is_like(alike.begin - 1)) --alike.begin;
    while (alike.end < count && alike.end - k <= kReach && is_like(alike.end)) ++alike.end;
    for (std::size_t other = alike.begin; other < alike.end; ++other) {
        if (other != k) alike.widest = std::max(alike.widest, period_after(crests, other));
    }
    alike.mean = (crests[alike.end].at - crests[alike.begin].at) /
                 static_cast<double>(alike.end - alike.begin);
    return alike;
}

// Which valleys follow each other so closely that none is seen. All valleys of one oscillation,
// however uneven, are narrow or none: by its mean period, and if that is about `widest`, as those
// beside. A pause in it does not count.
std::vector<bool> narrow_valleys(std::span<const Crest> crests, double widest) {
    constexpr double kSteady = 1.25;
    constexpr double kAbout = 1.1;
    const std::size_t count = crests.size() - 1;
    std::vector<bool> narrow(count);
    std::vector<bool> undecided(count);
    const auto like = [&](std::size_t k, std::size_t other) {
        const double beside = period_after(crests, other);
        return beside <= kSteady * widest && period_after(crests, k) <= kUneven * beside;
    };
    for (std::size_t k = 0; k < count; ++k) {
        const double own = period_after(crests, k);
        const Alike alike = alike_around(crests, k);
        if (alike.end - alike.begin >= 3 && own <= kSteady * alike.widest) {
            narrow[k] = alike.mean <= widest;
            undecided[k] = !narrow[k] && alike.mean <= kAbout * widest;
            continue;
        }
        narrow[k] =
            own <= widest && ((k > 0 && like(k, k - 1)) || (k + 1 < count && like(k, k + 1)));
    }
    for (std::size_t k = 1; k < count; ++k) {
        if (undecided[k] && narrow[k - 1]) narrow[k] = true;
    }
    for (std::size_t k = count; k-- > 1;) {
        if (undecided[k - 1] && narrow[k]) narrow[k - 1] = true;
    }
    return narrow;
}

// Fills the narrow valleys once; false if nothing is left to fill. Before the first crest and after
// the last there is no other to go to: for about a period (a crest at the very end does not count)
// the edge stays level.
bool bridge(Edge& edge, double widest, double least) {
    const std::vector<Crest> crests = crests_of(edge, least);
    if (crests.size() < 3) return false;
    const std::vector<bool> narrow = narrow_valleys(crests, widest);
    bool any = false;
    Edge filled;
    const auto keep = [&](std::size_t begin, std::size_t end) {
        const auto at = [&](std::size_t k) {
            return edge.begin() + static_cast<std::ptrdiff_t>(k);
        };
        filled.insert(filled.end(), at(begin), at(end));
    };
    const Crest& head = crests.front();
    const Crest& tail = crests.back();
    if (head.begin > 0 && narrow.front() &&
        head.at - edge.front().at <= kRim * period_after(crests, 0)) {
        filled.push_back({edge.front().at, edge[head.begin].value, false});
        edge[head.begin].bridged = true;
    } else {
        keep(0, head.begin);
    }
    for (std::size_t k = 0; k + 1 < crests.size(); ++k) {
        keep(crests[k].begin, crests[k].end + 1);
        if (!narrow[k]) {
            keep(crests[k].end + 1, crests[k + 1].begin);
            continue;
        }
        edge[crests[k + 1].begin].bridged = true;
        any = true;
    }
    keep(tail.begin, tail.end + 1);
    if (tail.end + 1 < edge.size() && narrow.back() &&
        edge.back().at - tail.at <= kRim * period_after(crests, crests.size() - 2)) {
        filled.push_back({edge.back().at, edge[tail.end].value, true});
    } else {
        keep(tail.end + 1, edge.size());
    }
    if (any) edge = std::move(filled);
    return any;
}

// Raises each column to the crests within it: those of slices lie between samples.
template <class Raise>
void raise_to_crests(const Edge& edge, double first, double step, std::size_t columns,
                     Raise raise) {
    for (const Vertex& vertex : edge) {
        const double column = std::floor((vertex.at - first) / step);
        if (column < 0.0 || column >= static_cast<double>(columns)) continue;
        raise(static_cast<std::size_t>(column), vertex.value);
    }
}

// Raises each column to the highest bridge within it.
template <class Raise>
void raise_to_bridges(const Edge& edge, double first, double step, std::size_t columns,
                      Raise raise) {
    for (std::size_t i = 1; i < edge.size(); ++i) {
        if (!edge[i].bridged) continue;
        const Vertex& a = edge[i - 1];
        const Vertex& b = edge[i];
        const double last_column = static_cast<double>(columns) - 1.0;
        const double from = std::max(0.0, std::floor((a.at - first) / step));
        const double to = std::min(last_column, std::floor((b.at - first) / step));
        const double slope = b.at > a.at ? (b.value - a.value) / (b.at - a.at) : 0.0;
        for (double c = from; c <= to; c += 1.0) {
            const double left = std::max(a.at, first + c * step);
            const double right = std::min(b.at, first + (c + 1.0) * step);
            const double highest = std::max(slope * (left - a.at), slope * (right - a.at));
            raise(static_cast<std::size_t>(c), a.value + highest);
        }
    }
}

// From crest to crest of a filled edge: what the samples have there, and what a tone as high as the
// edge would have, both as sums of squares.
struct Period {
    double begin;
    double end;
    double own = 0.0;
    double tone = 0.0;
};

// Half of the first sample and of the last one: of whole periods the sum is exact.
double sum_of_squares(std::span<const double> samples, double begin, double end) {
    const auto last_index = static_cast<double>(samples.size()) - 1.0;
    const auto first = static_cast<std::size_t>(std::clamp(std::round(begin), 0.0, last_index));
    const auto last = static_cast<std::size_t>(std::clamp(std::round(end), 0.0, last_index));
    double sum = 0.5 * (samples[last] * samples[last] - samples[first] * samples[first]);
    for (std::size_t i = first; i < last; ++i) sum += samples[i] * samples[i];
    return last > first ? sum * (end - begin) / static_cast<double>(last - first) : 0.0;
}

// Flat crests are shared by the periods beside them; what is left of one at either end of the edge
// belongs to the period next to it.
std::vector<Period> periods_of(const Edge& edge, std::span<const double> samples, double widest) {
    std::vector<Period> periods;
    bool is_rest = false;  // the last one is but the beginning of a period
    for (std::size_t i = 1; i < edge.size(); ++i) {
        if (!edge[i].bridged) continue;
        const Vertex& a = edge[i - 1];
        const Vertex& b = edge[i];
        Period period{a.at, b.at};
        period.tone =
            (a.value * a.value + a.value * b.value + b.value * b.value) / 6.0 * (b.at - a.at);
        const bool goes_on = !periods.empty() && a.at - periods.back().end <= widest;
        if (goes_on) {
            const double flat = a.at - periods.back().end;
            periods.back().end += 0.5 * flat;
            period.begin -= 0.5 * flat;
            periods.back().tone += 0.25 * flat * edge[i - 1].value * edge[i - 1].value;
            period.tone += 0.25 * flat * a.value * a.value;
        }
        if (goes_on && (is_rest || i + 1 == edge.size())) {
            periods.back().end = period.end;
            periods.back().tone += period.tone;
        } else {
            periods.push_back(period);
        }
        is_rest = i == 1 && periods.size() == 1;
    }
    for (Period& period : periods) {
        period.own = sum_of_squares(samples, period.begin, period.end);
    }
    return periods;
}

// What the periods of each column have.
struct Strengths {
    std::vector<double> own;
    std::vector<double> tone;
};

void add(Strengths& strengths, std::span<const Period> periods, double first, double step) {
    const double last_column = static_cast<double>(strengths.own.size()) - 1.0;
    for (const Period& period : periods) {
        const double from = std::max(0.0, std::floor((period.begin - first) / step));
        const double to = std::min(last_column, std::floor((period.end - first) / step));
        for (double c = from; c <= to; c += 1.0) {
            strengths.own[static_cast<std::size_t>(c)] += period.own;
            strengths.tone[static_cast<std::size_t>(c)] += period.tone;
        }
    }
}

// Shares of the columns that have periods, each with its neighbours as far as a period may be wide.
std::vector<double> by_steady_tones(const Strengths& strengths, double widest) {
    const std::size_t columns = strengths.own.size();
    const auto reach = static_cast<std::size_t>(std::max(0.0, widest / 2.0));
    std::vector<double> shares(columns, 1.0);
    for (std::size_t c = 0; c < columns; ++c) {
        if (strengths.tone[c] <= 0.0) continue;
        double own = 0.0;
        double tone = 0.0;
        for (std::size_t k = c - std::min(c, reach); k < std::min(columns, c + reach + 1); ++k) {
            own += strengths.own[k];
            tone += strengths.tone[k];
        }
        shares[c] = std::min(1.0, std::sqrt(own / tone));
    }
    return shares;
}

}  // namespace

double body_tone(double strength) {
    constexpr double kLightest = 0.25;
    constexpr double kWeak = 0.65;
    constexpr double kSteady = 0.9;  // two tones may be, and how crests lie between samples
    return std::lerp(kLightest, 1.0, std::clamp((strength - kWeak) / (kSteady - kWeak), 0.0, 1.0));
}

double reach_beyond(double first, double last, std::size_t columns, const BodyScale& scale) {
    return 4.0 * scale.widest * (last - first) / static_cast<double>(columns);
}

WaveBody wave_body(std::span<const double> samples, double first, double last, std::size_t columns,
                   const BodyScale& scale) {
    WaveBody body{extremes(samples, first, last, columns), {}, {}};
    std::vector<Extremes>& result = body.columns;
    if (result.empty()) return body;
    const double step = (last - first) / static_cast<double>(columns);
    const double beyond = reach_beyond(first, last, columns, scale);
    const double last_index = static_cast<double>(samples.size()) - 1.0;
    const auto begin =
        static_cast<std::size_t>(std::clamp(std::floor(first - beyond), 0.0, last_index));
    const auto end =
        static_cast<std::size_t>(std::clamp(std::ceil(last + beyond), 0.0, last_index));
    const auto slices = static_cast<std::size_t>(
        kSlicesPerColumn * (static_cast<double>(columns) + 8.0 * scale.widest));
    Edges edges = edges_of(samples, begin, end, slices);
    Strengths strengths{std::vector<double>(columns, 0.0), std::vector<double>(columns, 0.0)};
    for (const double sign : {1.0, -1.0}) {
        const auto raise = [&](std::size_t c, double value) {
            Extremes& column = result[c];
            if (sign > 0.0) column.high = std::max(column.high, value);
            if (sign < 0.0) column.low = std::min(column.low, -value);
        };
        Edge& edge = sign > 0.0 ? edges.upper : edges.lower;
        if (edge.size() == slices) raise_to_crests(edge, first, step, columns, raise);
        while (bridge(edge, scale.widest * step, scale.least)) {
        }
        raise_to_bridges(edge, first, step, columns, raise);
        add(strengths, periods_of(edge, samples, scale.widest * step), first, step);
    }
    std::ranges::transform(strengths.tone, std::back_inserter(body.filled),
                           [](double tone) { return tone > 0.0; });
    body.strength = by_steady_tones(strengths, scale.widest);
    return body;
}

std::vector<Extremes> body_columns(std::span<const double> samples, double first, double last,
                                   std::size_t columns, const BodyScale& scale) {
    return wave_body(samples, first, last, columns, scale).columns;
}

}  // namespace tact
