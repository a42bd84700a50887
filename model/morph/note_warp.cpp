#include "model/morph/note_warp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tact {

namespace {

constexpr double kFadeCost = 0.1;
constexpr double kRounding = 1e-12;

struct Span01 {
    double begin = 0.0;
    double end = 0.0;
};

std::vector<Span01> shares_of(const std::vector<Note>& notes, double duration_s) {
    std::vector<Span01> shares;
    for (const Note& note : notes) {
        shares.push_back({note.onset_s / duration_s, (note.onset_s + note.length_s) / duration_s});
    }
    return shares;
}

// Notes of either side, up to these, that become each other; 0 on one side: they fade.
struct Group {
    std::size_t from = 0;
    std::size_t to = 0;
};

double ends_moved(const Span01& a, double begin, double end) {
    return std::abs(a.begin - begin) + std::abs(a.end - end);
}

// The cheapest groups, by what notes before them cost: rows of `from`, columns of `to`.
class Alignment {
  public:
    Alignment(const std::vector<Span01>& from, const std::vector<Span01>& to)
        : from_(from), to_(to), columns_(to.size() + 1) {
        cost_.assign((from.size() + 1) * columns_, std::numeric_limits<double>::infinity());
        best_.resize(cost_.size());
        cost_[0] = 0.0;
        for (std::size_t i = 0; i <= from.size(); ++i) {
            for (std::size_t j = 0; j <= to.size(); ++j) reach(i, j);
        }
    }

    // In order.
    std::vector<Group> groups() const {
        std::vector<Group> found;
        for (std::size_t i = from_.size(), j = to_.size(); i + j > 0;) {
            found.push_back(best_[i * columns_ + j]);
            i -= found.back().from;
            j -= found.back().to;
        }
        std::ranges::reverse(found);
        return found;
    }

  private:
    void offer(std::size_t i, std::size_t j, Group group, double cost) {
        const double all = cost_[(i - group.from) * columns_ + (j - group.to)] + cost;
        double& least = cost_[i * columns_ + j];
        // Equal but for rounding: the first stays.
        if (!(all < least - kRounding)) return;
        least = all;
        best_[i * columns_ + j] = group;
    }

    void reach(std::size_t i, std::size_t j) {
        if (i > 0 && from_.size() > to_.size()) offer(i, j, {1, 0}, fade_cost(from_[i - 1]));
        if (j > 0 && to_.size() > from_.size()) offer(i, j, {0, 1}, fade_cost(to_[j - 1]));
        if (i == 0 || j == 0) return;
        split(from_[i - 1], to_, j, 1, [&](std::size_t m, double cost) {
            offer(i, j, {1, m}, cost);
        });
        split(to_[j - 1], from_, i, 2, [&](std::size_t m, double cost) {
            offer(i, j, {m, 1}, cost);
        });
    }

    // One note as the last `least` and more of those before `last`; their gaps add up on the way.
    template <class Take>
    static void split(const Span01& one, const std::vector<Span01>& many, std::size_t last,
                      std::size_t least, Take take) {
        double gaps = 0.0;
        for (std::size_t m = 1; m <= last; ++m) {
            const std::size_t first = last - m;
            if (m > 1) gaps += many[first + 1].begin - many[first].end;
            if (m < least) continue;
            take(m, ends_moved(one, many[first].begin, many[last - 1].end) + gaps);
        }
    }

    static double fade_cost(const Span01& note) { return note.end - note.begin + kFadeCost; }

    const std::vector<Span01>& from_;
    const std::vector<Span01>& to_;
    std::size_t columns_;
    std::vector<double> cost_;
    std::vector<Group> best_;
};

double end_of(const Note& note) { return note.onset_s + note.length_s; }

NoteSide all_of(const Note& note) { return {note.onset_s, end_of(note), note}; }

// The parts of one note that become the others, cut where the middles of their gaps fall.
std::vector<NoteSide> parts_of(const Note& one, const Note* others, std::size_t count) {
    const double low = others[0].onset_s;
    const double extent = end_of(others[count - 1]) - low;
    std::vector<NoteSide> parts;
    double cut_s = one.onset_s;
    for (std::size_t k = 0; k < count; ++k) {
        double next_s = end_of(one);
        if (k + 1 < count && extent > 0.0) {
            const double middle = 0.5 * (end_of(others[k]) + others[k + 1].onset_s);
            next_s = one.onset_s + one.length_s * (middle - low) / extent;
        }
        parts.push_back({cut_s, next_s, one});
        cut_s = next_s;
    }
    return parts;
}

void add_group(std::vector<WarpedNote>& warped, const Note* from, const Note* to, Group group) {
    if (group.from == 0) warped.push_back({{}, all_of(*to)});
    if (group.to == 0) warped.push_back({all_of(*from), {}});
    if (group.from == 0 || group.to == 0) return;
    if (group.from == 1) {
        const std::vector<NoteSide> parts = parts_of(*from, to, group.to);
        for (std::size_t k = 0; k < parts.size(); ++k) {
            warped.push_back({parts[k], all_of(to[k])});
        }
        return;
    }
    const std::vector<NoteSide> parts = parts_of(*to, from, group.from);
    for (std::size_t k = 0; k < parts.size(); ++k) warped.push_back({all_of(from[k]), parts[k]});
}

// Where a note that fades is on the side that has it not: as far between its neighbours.
void place_faded(std::vector<WarpedNote>& warped, NoteSide WarpedNote::*has,
                 NoteSide WarpedNote::*misses, double has_s, double misses_s) {
    for (std::size_t k = 0; k < warped.size(); ++k) {
        if ((warped[k].*misses).whole) continue;
        std::size_t last = k;
        while (last < warped.size() && !(warped[last].*misses).whole) ++last;
        const Span01 here{k == 0 ? 0.0 : (warped[k - 1].*has).end_s,
                          last == warped.size() ? has_s : (warped[last].*has).begin_s};
        const Span01 there{k == 0 ? 0.0 : (warped[k - 1].*misses).end_s,
                           last == warped.size() ? misses_s : (warped[last].*misses).begin_s};
        const double scale =
            here.end > here.begin ? (there.end - there.begin) / (here.end - here.begin) : 0.0;
        for (; k < last; ++k) {
            const NoteSide& side = warped[k].*has;
            (warped[k].*misses).begin_s = there.begin + scale * (side.begin_s - here.begin);
            (warped[k].*misses).end_s = there.begin + scale * (side.end_s - here.begin);
        }
    }
}

}  // namespace

std::optional<std::vector<WarpedNote>> warped_notes(const std::vector<Note>& from,
                                                    double from_duration_s,
                                                    const std::vector<Note>& to,
                                                    double to_duration_s) {
    if (std::max(from.size(), to.size()) > kMostWarpedNotes) return std::nullopt;
    const std::vector<Span01> before = shares_of(from, from_duration_s);
    const std::vector<Span01> after = shares_of(to, to_duration_s);
    std::vector<WarpedNote> warped;
    std::size_t i = 0;
    std::size_t j = 0;
    for (const Group& group : Alignment(before, after).groups()) {
        add_group(warped, from.data() + i, to.data() + j, group);
        i += group.from;
        j += group.to;
    }
    place_faded(warped, &WarpedNote::from, &WarpedNote::to, from_duration_s, to_duration_s);
    place_faded(warped, &WarpedNote::to, &WarpedNote::from, to_duration_s, from_duration_s);
    return warped;
}

}  // namespace tact
