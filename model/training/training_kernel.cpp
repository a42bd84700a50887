#include "model/training/training_kernel.h"

#include <vector>

#include "model/common/processors.h"

namespace tact {

#ifdef __x86_64__
extern const TrainingKernel kTrainingAvx512;
extern const TrainingKernel kTrainingAvx2;
#endif
extern const TrainingKernel kTrainingBaseline;

std::span<const TrainingKernel> training_kernels() {
    static const std::vector<TrainingKernel> kernels = [] {
        std::vector<TrainingKernel> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("bmi"))
            usable.push_back(kTrainingAvx512);
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi"))
            usable.push_back(kTrainingAvx2);
#endif
        usable.push_back(kTrainingBaseline);
        return usable;
    }();
    return kernels;
}

const TrainingKernel& training_kernel() {
    static const TrainingKernel& chosen = kernel_of(training_kernels(), simd_wish());
    return chosen;
}

}  // namespace tact
