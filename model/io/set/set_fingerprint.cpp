#include "model/io/set/set_fingerprint.h"

#include <span>

#include "model/common/fingerprint.h"
#include "model/io/set/set_file.h"

namespace tact {

namespace {

std::uint64_t mixed_text(std::uint64_t so_far, const PatternSet& set) {
    const std::string text = print_set(set);
    return mixed(so_far, std::span<const char>(text));
}

// Without what changes nothing that is felt: how steps are counted, and letters that no note has.
Pattern as_felt(Pattern pattern) {
    Rhythm& rhythm = pattern.rhythm;
    rhythm.meter = {};
    std::erase_if(rhythm.kinds, [&rhythm](const auto& kind) {
        return rhythm.text.find(kind.first) == std::string::npos;
    });
    return pattern;
}

}  // namespace

std::uint64_t vibrations_fingerprint(const PatternSet& set) {
    std::uint64_t number = 0;
    PatternSet bare;
    for (const Vibration& vibration : set.vibrations) {
        Vibration& kept = bare.vibrations.emplace_back();
        if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
            kept.source = as_felt(*pattern);
        } else {
            const Waveform waveform = waveform_of(vibration);
            number = mixed(number, std::uint64_t{bare.vibrations.size()});
            number = mixed(number, std::span<const double>(waveform.samples_g));
        }
    }
    return mixed_text(number, bare);
}

std::uint64_t model_fingerprint(const PatternSet& set) {
    PatternSet bare;
    bare.model = set.model;
    return mixed_text(0, bare);
}

}  // namespace tact
