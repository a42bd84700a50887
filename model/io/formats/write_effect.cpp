#include "model/io/formats/write_effect.h"

#include <algorithm>
#include <array>

#include "model/io/formats/formats.h"

namespace tact {

namespace {

constexpr std::size_t count_of_targets() {
    std::size_t count = 0;
    for (const FormatFolder& folder : kFormatFolders) count += folder.written.size();
    return count;
}

constexpr auto targets_of_all() {
    std::array<TargetTraits, count_of_targets()> all;
    auto next = all.begin();
    for (const FormatFolder& folder : kFormatFolders) {
        next = std::ranges::copy(folder.written, next).out;
    }
    return all;
}

constexpr std::array kTargets = targets_of_all();

// Whether the formats stand in the order of their enumeration.
constexpr bool are_in_order() {
    for (std::size_t k = 0; k < kTargets.size(); ++k) {
        if (static_cast<std::size_t>(kTargets[k].format) != k) return false;
    }
    return true;
}
static_assert(are_in_order());

}  // namespace

std::span<const TargetTraits> target_formats() { return kTargets; }

const TargetTraits& traits(TargetFormat format) {
    return kTargets[static_cast<std::size_t>(format)];
}

std::optional<TargetFormat> target_format_of(std::string_view key) {
    const auto found = std::ranges::find(kTargets, key, &TargetTraits::key);
    if (found == kTargets.end()) return std::nullopt;
    return static_cast<TargetFormat>(found - kTargets.begin());
}

bool is_sampled(TargetFormat format) { return traits(format).write_samples != nullptr; }

WrittenEffect write_effect(TargetFormat format, const Pattern& own, const EffectTarget& target) {
    const Pattern pattern = with_drawn_pitches(own);
    const TargetTraits& about = traits(format);
    if (about.write != nullptr) return about.write(pattern, target);
    return about.write_samples(render(pattern, target.sampled.rate_hz), target);
}

}  // namespace tact
