// Which of several kernels, one per instruction set, is in use.
//
// A kernel has a `name`: avx512, avx2 or baseline, as the environment variable TACTSPACE_SIMD has
// it.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace tact {

// What TACTSPACE_SIMD names, or nothing. It is read once.
std::string_view simd_wish();

// The kernel of that name; default: the first, which is the fastest.
template <class Kernel>
const Kernel& kernel_of(std::span<const Kernel> kernels, std::string_view name) {
    const auto named = std::ranges::find(kernels, name, &Kernel::name);
    return named == kernels.end() ? kernels.front() : *named;
}

}  // namespace tact
