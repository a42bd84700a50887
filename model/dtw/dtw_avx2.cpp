#include "model/dtw/dtw_sweep.h"

namespace tact {

extern const DtwKernel kDtwAvx2;
constinit const DtwKernel kDtwAvx2 = kernel_named("avx2");

}  // namespace tact
