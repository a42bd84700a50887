#include "model/training/training_counts.h"

namespace tact {

extern const TrainingKernel kTrainingAvx512;
constinit const TrainingKernel kTrainingAvx512 = kernel_named("avx512");

}  // namespace tact
