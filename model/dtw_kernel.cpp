#include "model/dtw_kernel.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace tact {

#ifdef __x86_64__
extern const DtwKernel kDtwAvx512;
extern const DtwKernel kDtwAvx2;
#endif
extern const DtwKernel kDtwBaseline;

std::span<const DtwKernel> dtw_kernels() {
    static const std::vector<DtwKernel> kernels = [] {
        std::vector<DtwKernel> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx512f")) usable.push_back(kDtwAvx512);
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            usable.push_back(kDtwAvx2);
#endif
        usable.push_back(kDtwBaseline);
        return usable;
    }();
    return kernels;
}

const DtwKernel& dtw_kernel(std::string_view name) {
    const auto kernels = dtw_kernels();
    const auto named = std::ranges::find(kernels, name, &DtwKernel::name);
    return named == kernels.end() ? kernels.front() : *named;
}

const DtwKernel& dtw_kernel() {
    static const DtwKernel& chosen = [&]() -> const DtwKernel& {
        const char* name = std::getenv("TACTSPACE_SIMD");  // NOLINT(concurrency-mt-unsafe)
        return dtw_kernel(name == nullptr ? std::string_view{} : name);
    }();
    return chosen;
}

}  // namespace tact
