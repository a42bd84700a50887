#include "model/dtw/dtw_sweep.h"

namespace tact {

extern const DtwKernel kDtwAvx512;
constinit const DtwKernel kDtwAvx512 = kernel_named("avx512");

}  // namespace tact
