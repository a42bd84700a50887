#include "model/subset/clique.h"

#include <algorithm>
#include <bit>

namespace tact {

namespace {

using Word = std::uint64_t;

// The candidates that have `count` - 1 neighbours among themselves, each least connected one last:
// others in the way of a clique are gone, and few colours are needed.
std::vector<std::size_t> core_order(const Graph& graph, std::span<const std::size_t> candidates,
                                    std::size_t count) {
    std::vector<std::size_t> left(candidates.begin(), candidates.end());
    std::vector<std::size_t> degree(graph.size, 0);
    for (const std::size_t i : left) {
        for (const std::size_t j : left) degree[i] += i != j && graph.has(i, j) ? 1 : 0;
    }
    std::vector<std::size_t> order;
    while (!left.empty()) {
        const auto least =
            std::ranges::min_element(left, {}, [&](std::size_t i) { return degree[i]; });
        const std::size_t taken = *least;
        *least = left.back();
        left.pop_back();
        if (degree[taken] + 1 >= count || !order.empty()) order.push_back(taken);
        for (const std::size_t i : left) degree[i] -= graph.has(i, taken) ? 1 : 0;
    }
    std::ranges::reverse(order);
    return order;
}

Graph renumbered(const Graph& graph, std::span<const std::size_t> order) {
    Graph result(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = 0; j < order.size(); ++j) {
            if (i != j && graph.has(order[i], order[j])) result.set(i, j);
        }
    }
    return result;
}

class CliqueWalk {
  public:
    CliqueWalk(const Graph& graph, std::size_t count, const SearchLimit& limit)
        : graph_(graph), limit_(limit), levels_(count + 1) {
        for (Level& level : levels_) {
            level.candidates.assign(graph.words, 0);
            level.uncoloured.assign(graph.words, 0);
            level.colour.assign(graph.words, 0);
        }
    }

    CliqueSearch run() {
        for (std::size_t i = 0; i < graph_.size; ++i) {
            levels_[0].candidates[i / 64] |= Graph::bit(i);
        }
        CliqueSearch result;
        const bool found = extend(0);
        result.verdict = found         ? CliqueVerdict::found
                         : is_cut_off_ ? CliqueVerdict::unknown
                                       : CliqueVerdict::none;
        if (found) result.members = members_;
        return result;
    }

  private:
    struct Level {
        std::vector<Word> candidates;
        std::vector<Word> uncoloured;
        std::vector<Word> colour;
        std::vector<std::size_t> branches;  // in the order they are coloured
    };

    // Colours the candidates so that no two of a colour are neighbours: a clique has at most one of
    // each. Those of the first need - 1 colours alone hold no clique of `need`; the others are the
    // branches.
    void colour(Level& level, std::size_t need) {
        level.branches.clear();
        level.uncoloured = level.candidates;
        for (std::size_t colours = 1; any(level.uncoloured); ++colours) {
            level.colour = level.uncoloured;
            for (std::size_t w = 0; w < graph_.words; ++w) {
                while (level.colour[w] != 0) {
                    const auto bit = static_cast<std::size_t>(std::countr_zero(level.colour[w]));
                    const std::size_t vertex = 64 * w + bit;
                    level.uncoloured[w] &= ~Graph::bit(vertex);
                    level.colour[w] &= ~Graph::bit(vertex);
                    const Word* row = graph_.row(vertex);
                    for (std::size_t v = w; v < graph_.words; ++v) level.colour[v] &= ~row[v];
                    if (colours >= need) level.branches.push_back(vertex);
                }
            }
        }
    }

    static bool any(const std::vector<Word>& words) {
        return std::ranges::any_of(words, [](Word word) { return word != 0; });
    }

    // The last coloured first: removing it leaves fewer colours to the others.
    bool extend(std::size_t depth) {
        const std::size_t need = levels_.size() - 1 - depth;
        if (need == 0) return true;
        if (limit_.reached()) is_cut_off_ = true;
        if (is_cut_off_) return false;
        Level& level = levels_[depth];
        colour(level, need);
        Level& next = levels_[depth + 1];
        for (std::size_t k = level.branches.size(); k > 0; --k) {
            const std::size_t vertex = level.branches[k - 1];
            const Word* row = graph_.row(vertex);
            for (std::size_t w = 0; w < graph_.words; ++w) {
                next.candidates[w] = level.candidates[w] & row[w];
            }
            members_.push_back(vertex);
            if (extend(depth + 1)) return true;
            members_.pop_back();
            if (is_cut_off_) return false;
            level.candidates[vertex / 64] &= ~Graph::bit(vertex);
        }
        return false;
    }

    const Graph& graph_;
    const SearchLimit& limit_;
    std::vector<Level> levels_;
    std::vector<std::size_t> members_;
    bool is_cut_off_ = false;
};

}  // namespace

Graph graph_of(const WholeDistances& distances, Units least) {
    Graph graph(distances.size);
    for (std::size_t i = 0; i < distances.size; ++i) {
        const Units* row = distances.row(i);
        Word* bits = graph.bits.data() + i * graph.words;
        for (std::size_t j = 0; j < distances.size; ++j) {
            bits[j / 64] |= static_cast<Word>(row[j] >= least && i != j) << (j % 64);
        }
    }
    return graph;
}

std::vector<std::size_t> greedy_colours(const Graph& graph, std::span<const std::size_t> vertices) {
    std::vector<std::vector<std::size_t>> of_colour;
    std::vector<std::size_t> colours;
    for (const std::size_t v : vertices) {
        const auto fits = [&](const std::vector<std::size_t>& others) {
            return std::ranges::none_of(others, [&](std::size_t u) { return graph.has(u, v); });
        };
        auto found = std::ranges::find_if(of_colour, fits);
        if (found == of_colour.end()) found = of_colour.emplace(found);
        found->push_back(v);
        colours.push_back(static_cast<std::size_t>(found - of_colour.begin()));
    }
    return colours;
}

CliqueSearch find_clique(const Graph& graph, std::span<const std::size_t> candidates,
                         std::size_t count, const SearchLimit& limit) {
    if (count == 0) return {CliqueVerdict::found, {}};
    const std::vector<std::size_t> order = core_order(graph, candidates, count);
    if (order.size() < count) return {};
    const Graph core = renumbered(graph, order);
    CliqueSearch result = CliqueWalk(core, count, limit).run();
    for (std::size_t& member : result.members) member = order[member];
    return result;
}

}  // namespace tact
