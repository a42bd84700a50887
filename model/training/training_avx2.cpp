#include "model/training/training_counts.h"

namespace tact {

extern const TrainingKernel kTrainingAvx2;
constinit const TrainingKernel kTrainingAvx2 = kernel_named("avx2");

}  // namespace tact
