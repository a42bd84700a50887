// Counts against shares that people type: 0.29 of 100 is 29, though 0.29 * 100 is less in binary.
#pragma once

#include <cstddef>

namespace tact {

// Of a count: by so much a product of a share may be off.
inline constexpr double kShareSpare = 1e-9;

// Whether `count` of `all` is no more than the share.
inline bool is_at_most_share(std::size_t count, double share, std::size_t all) {
    return static_cast<double>(count) <= share * static_cast<double>(all) + kShareSpare;
}

}  // namespace tact
