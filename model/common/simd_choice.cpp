#include "model/common/simd_choice.h"

#include <cstdlib>

namespace tact {

std::string_view simd_wish() {
    static const std::string_view wish = [] {
        const char* name = std::getenv("TACTSPACE_SIMD");  // NOLINT(concurrency-mt-unsafe)
        return name == nullptr ? std::string_view{} : std::string_view{name};
    }();
    return wish;
}

}  // namespace tact
