#include "viz/drawing/body_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "model/common/fingerprint.h"

namespace tact {
namespace {

constexpr std::size_t kMostKept = 256;

// Four chains side by side: one waits for its own product only.
std::uint64_t fingerprint_of(std::span<const double> samples) {
    constexpr std::size_t kLanes = 4;
    std::array<std::uint64_t, kLanes> lanes{};
    const std::size_t whole = samples.size() - samples.size() % kLanes;
    for (std::size_t i = 0; i < whole; i += kLanes) {
        for (std::size_t k = 0; k < kLanes; ++k) {
            lanes[k] = mixed(lanes[k], std::bit_cast<std::uint64_t>(samples[i + k]));
        }
    }
    const std::uint64_t rest = mixed<double>(0, samples.subspan(whole));
    return mixed<std::uint64_t>(rest, lanes);
}

// The samples that columns of [first, last) may look at.
std::span<const double> in_reach(std::span<const double> samples, double first, double last,
                                 double beyond) {
    const double count = static_cast<double>(samples.size());
    const auto begin = static_cast<std::size_t>(std::clamp(first - beyond - 4.0, 0.0, count));
    const auto end = static_cast<std::size_t>(std::clamp(last + beyond + 4.0, 0.0, count));
    return samples.subspan(begin, end - begin);
}

void forget_undrawn(BodyCache& cache, int frame) {
    if (cache.kept.size() < kMostKept) return;
    std::erase_if(cache.kept, [&](const auto& entry) { return entry.second.frame < frame - 1; });
}

}  // namespace

std::shared_ptr<const WaveBody> kept_body(BodyCache& cache, int frame,
                                          std::span<const double> samples, double first,
                                          double last, std::size_t columns,
                                          const BodyScale& scale) {
    const std::array view{first,        last,        static_cast<double>(columns),
                          scale.widest, scale.least, static_cast<double>(samples.size())};
    const double beyond = reach_beyond(first, last, columns, scale);
    const std::uint64_t key =
        mixed<double>(fingerprint_of(in_reach(samples, first, last, beyond)), view);
    const auto found = cache.kept.find(key);
    if (found != cache.kept.end()) {
        found->second.frame = frame;
        return found->second.body;
    }
    forget_undrawn(cache, frame);
    auto made = std::make_shared<const WaveBody>(wave_body(samples, first, last, columns, scale));
    cache.kept[key] = {made, frame};
    return made;
}

}  // namespace tact
