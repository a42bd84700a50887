// Whether some objects, all of them alike distant enough, can be found: a clique of given size.
//
// Source    bit-parallel branch and bound with a colour bound: San Segundo, Rodriguez-Losada &
//           Jimenez 2011 (BBMC); Tomita & Kameda 2007; smallest-last order: Matula & Beck 1983.
// Exact     same graph, same clique.
// Left out  the largest clique: one of the wanted size is enough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/subset/search_limit.h"
#include "model/subset/whole_distances.h"

namespace tact {

// Which pairs of objects may stand together; a row of bits for each object.
struct Graph {
    std::size_t size = 0;
    std::size_t words = 0;  // of 64 bits in a row
    std::vector<std::uint64_t> bits;

    explicit Graph(std::size_t objects)
        : size(objects), words((objects + 63) / 64), bits(objects * words) {}

    bool has(std::size_t i, std::size_t j) const {
        return (bits[i * words + j / 64] >> (j % 64) & 1U) != 0;
    }
    void set(std::size_t i, std::size_t j) { bits[i * words + j / 64] |= bit(j); }
    void clear(std::size_t i, std::size_t j) { bits[i * words + j / 64] &= ~bit(j); }
    const std::uint64_t* row(std::size_t i) const { return bits.data() + i * words; }

    static std::uint64_t bit(std::size_t j) { return std::uint64_t{1} << (j % 64); }
};

// Pairs that are at least so far apart.
Graph graph_of(const WholeDistances& distances, Units least);

enum class CliqueVerdict { found, none, unknown };  // unknown: the limit was reached

struct CliqueSearch {
    CliqueVerdict verdict = CliqueVerdict::none;
    std::vector<std::size_t> members;  // of the clique, in no order
};

// A clique of `count` among the candidates.
CliqueSearch find_clique(const Graph& graph, std::span<const std::size_t> candidates,
                         std::size_t count, const SearchLimit& limit);

// Colours of the vertices, 0, 1, .. in the order given: each gets the first that no neighbour has.
// A clique has at most one vertex of a colour.
std::vector<std::size_t> greedy_colours(const Graph& graph, std::span<const std::size_t> vertices);

}  // namespace tact
