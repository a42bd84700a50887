#include "model/design_space/sobol.h"

#include <array>
#include <cassert>

namespace tact {

namespace {

constexpr std::size_t kBits = 32;
constexpr std::size_t kMostDegrees = 7;

// A primitive polynomial modulo 2 and the first direction numbers, as the published table has them.
struct Direction {
    std::size_t degree;                              // s
    std::uint32_t coefficients;                      // a: of x^(s-1) to x, highest first
    std::array<std::uint32_t, kMostDegrees> number;  // m_1 .. m_s
};

// From the second dimension on; the first is van der Corput's sequence.
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
}};

using Row = std::array<std::uint32_t, kBits>;

// The direction numbers of a dimension as binary fractions, by the recurrence of its polynomial.
constexpr Row row_of(std::size_t dimension) {
    Row row{};
    if (dimension == 0) {
        for (std::size_t k = 0; k < kBits; ++k) row[k] = 1U << (kBits - 1 - k);
        return row;
    }
    const Direction& direction = kDirections[dimension - 1];
    const std::size_t s = direction.degree;
    for (std::size_t k = 0; k < s; ++k) row[k] = direction.number[k] << (kBits - 1 - k);
    for (std::size_t k = s; k < kBits; ++k) {
        row[k] = row[k - s] ^ (row[k - s] >> s);
        for (std::size_t j = 1; j < s; ++j) {
            if (((direction.coefficients >> (s - 1 - j)) & 1U) != 0) row[k] ^= row[k - j];
        }
    }
    return row;
}

constexpr std::array<Row, kSobolDimensions> all_rows() {
    std::array<Row, kSobolDimensions> rows{};
    for (std::size_t d = 0; d < kSobolDimensions; ++d) rows[d] = row_of(d);
    return rows;
}

constexpr std::array<Row, kSobolDimensions> kRows = all_rows();

}  // namespace

double sobol_coordinate(std::uint32_t point, std::size_t dimension, std::uint32_t shift) {
    assert(dimension < kSobolDimensions && "more dimensions than there are direction numbers");
    std::uint32_t bits = shift;
    // Gray code: neighbours in the sequence differ by one direction number.
    std::uint32_t gray = point ^ (point >> 1U);
    for (std::size_t k = 0; gray != 0; ++k, gray >>= 1U) {
        if ((gray & 1U) != 0) bits ^= kRows[dimension][k];
    }
    return static_cast<double>(bits) * 0x1p-32;
}

}  // namespace tact
