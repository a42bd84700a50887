#include "model/dtw/dtw_sweep.h"

namespace tact {

extern const DtwKernel kDtwBaseline;
constinit const DtwKernel kDtwBaseline = kernel_named("baseline");

}  // namespace tact
