#include "model/dtw/dtw_kernel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

namespace dtw_kernel_test {

using namespace tact;

TEST_CASE("dtw kernel: every processor runs the baseline, and any before it is faster") {
    const auto kernels = dtw_kernels();
    REQUIRE_FALSE(kernels.empty());
    CHECK(std::string_view(kernels.back().name) == "baseline");
    for (std::size_t k = 0; k + 1 < kernels.size(); ++k) {
        CHECK(kernels[k].many_pairs.pairs > kernels[k + 1].many_pairs.pairs);
    }
}

TEST_CASE("dtw kernel: each is found by its name") {
    for (const DtwKernel& kernel : dtw_kernels()) CHECK(&dtw_kernel(kernel.name) == &kernel);
}

TEST_CASE("dtw kernel: a name that means nothing here stands for the fastest") {
    const DtwKernel* fastest = &dtw_kernels().front();
    CHECK(&dtw_kernel("") == fastest);
    CHECK(&dtw_kernel("avx1024") == fastest);
    CHECK(&dtw_kernel("AVX2") == fastest);
}

TEST_CASE("dtw kernel: the environment chooses the one in use") {
    const char* wish = std::getenv("TACTSPACE_SIMD");
    CHECK(&dtw_kernel() == &dtw_kernel(wish == nullptr ? "" : wish));
}

}  // namespace dtw_kernel_test
