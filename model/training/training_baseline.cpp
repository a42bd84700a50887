#include "model/training/training_counts.h"

namespace tact {

extern const TrainingKernel kTrainingBaseline;
constinit const TrainingKernel kTrainingBaseline = kernel_named("baseline");

}  // namespace tact
