#include "model/morph/morph.h"

#include "model/morph/blend.h"
#include "model/morph/morph_parts.h"

namespace tact {

namespace {

std::optional<std::vector<WarpedNote>> notes_on_the_way(const Pattern& from, const Pattern& to) {
    return warped_notes(notes(from.rhythm, from.duration_s), from.duration_s,
                        notes(to.rhythm, to.duration_s), to.duration_s);
}

void set_tone(Pattern& pattern, const Pattern& from, const Pattern& to, double share) {
    const Pattern& near = share < 0.5 ? from : to;
    const MorphedTone tone =
        tone_between(from, to, share).value_or(MorphedTone{near.carriers, near.modulation});
    pattern.carriers = tone.carriers;
    pattern.modulation = tone.modulation;
}

void set_rhythm(Pattern& pattern, const Pattern& from, const Pattern& to, double share) {
    if (from.rhythm.text == to.rhythm.text) {
        pattern.rhythm = from.rhythm;
        pattern.rhythm.unit_s =
            between(from.rhythm.unit_s, to.rhythm.unit_s, share, BlendBy::ratio);
        pattern.attack_s = between(from.attack_s, to.attack_s, share, BlendBy::difference);
        pattern.release_s = between(from.release_s, to.release_s, share, BlendBy::difference);
        pattern.amplitude_curve = amplitude_between(from, to, share);
        return;
    }
    if (const auto notes = notes_on_the_way(from, to)) {
        pattern.rhythm = {};
        pattern.attack_s = 0.0;
        pattern.release_s = 0.0;
        pattern.amplitude_curve = notes_between(from, to, *notes, share);
        return;
    }
    const Pattern& near = share < 0.5 ? from : to;
    pattern.rhythm = near.rhythm;
    pattern.attack_s = near.attack_s;
    pattern.release_s = near.release_s;
    pattern.amplitude_curve = near.amplitude_curve;
}

}  // namespace

Pattern morphed(const Pattern& from, const Pattern& to, double share) {
    if (share <= 0.0) return from;
    if (share >= 1.0) return to;
    Pattern pattern;
    pattern.amplitude_g = between(from.amplitude_g, to.amplitude_g, share, BlendBy::ratio);
    pattern.duration_s = between(from.duration_s, to.duration_s, share, BlendBy::difference);
    set_tone(pattern, from, to, share);
    set_rhythm(pattern, from, to, share);
    pattern.frequency_curve = frequency_between(from, to, share);
    pattern.transients = transients_between(from, to, share);
    return clamped(std::move(pattern));
}

std::vector<std::string> morph_jumps(const Pattern& from, const Pattern& to) {
    std::vector<std::string> jumps;
    if (!tone_between(from, to, 0.5)) jumps.emplace_back("the modulation");
    if (from.rhythm.text != to.rhythm.text && !notes_on_the_way(from, to)) {
        jumps.emplace_back("the rhythm");
    }
    return jumps;
}

}  // namespace tact
