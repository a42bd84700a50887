#include "model/dtw/dtw_kernel.h"

#include <vector>

#include "model/common/processors.h"

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

const DtwKernel& dtw_kernel(std::string_view name) { return kernel_of(dtw_kernels(), name); }

const DtwKernel& dtw_kernel() {
    static const DtwKernel& chosen = dtw_kernel(simd_wish());
    return chosen;
}

}  // namespace tact
