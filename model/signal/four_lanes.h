// Four doubles side by side, each computed as it would be alone.
//
// A function whose body is inlined into one for a wider instruction set takes one register for
// them, otherwise two. Pass them by reference: by value their place depends on the instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tact {

inline constexpr std::size_t kLanes = 4;

// Aligned as every allocation is, whatever the allocator knows of wider types.
using FourLanes = double __attribute__((vector_size(32), aligned(16)));
// In a container: without the struct, templates drop the alignment.
struct FourValues {
    FourLanes lanes{};
};

using FourChoices = std::int64_t __attribute__((vector_size(32), aligned(16)));  // -1: yes, 0: no

}  // namespace tact
