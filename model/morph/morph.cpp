#include "model/morph/morph.h"

#include <cassert>

#include "model/morph/morph_parts.h"

namespace tact {

namespace {

std::optional<std::vector<WarpedNote>> notes_on_the_way(const Pattern& from, const Pattern& to) {
    return warped_notes(notes(from.rhythm, from.duration_s), from.duration_s,
                        notes(to.rhythm, to.duration_s), to.duration_s);
}

bool has_same_rhythm(const Pattern& from, const Pattern& to) {
    return from.rhythm.text == to.rhythm.text && from.rhythm.kinds == to.rhythm.kinds;
}

void set_tone(Pattern& pattern, const Pattern& from, const Pattern& to, double share) {
    const Pattern& near = share < 0.5 ? from : to;
    const MorphedTone tone =
        tone_between(from, to, share).value_or(MorphedTone{near.carriers, near.modulation});
    pattern.carriers = tone.carriers;
    pattern.modulation = tone.modulation;
}

}  // namespace

Morph::Morph(const Pattern& from, const Pattern& to)
    : ends_{from, to}, from_(from), to_(to), same_rhythm_(has_same_rhythm(from, to)) {
    if (same_rhythm_) return;
    from_ = with_drawn_pitches(from);
    to_ = with_drawn_pitches(to);
    notes_ = notes_on_the_way(from, to);
}

void Morph::set_rhythm(Pattern& pattern, double share) const {
    if (same_rhythm_) {
        pattern.rhythm = from_.rhythm;
        pattern.rhythm.unit_s =
            between(from_.rhythm.unit_s, to_.rhythm.unit_s, share, BlendBy::ratio);
        pattern.attack_s = between(from_.attack_s, to_.attack_s, share, BlendBy::difference);
        pattern.release_s = between(from_.release_s, to_.release_s, share, BlendBy::difference);
        pattern.amplitude_curve = amplitude_between(from_, to_, share);
        return;
    }
    if (notes_) {
        pattern.rhythm = {};
        pattern.attack_s = 0.0;
        pattern.release_s = 0.0;
        pattern.amplitude_curve = notes_between(from_, to_, *notes_, share);
        return;
    }
    const Pattern& near = share < 0.5 ? from_ : to_;
    pattern.rhythm = near.rhythm;
    pattern.attack_s = near.attack_s;
    pattern.release_s = near.release_s;
    pattern.amplitude_curve = near.amplitude_curve;
}

Pattern Morph::at(double share) const {
    if (share <= 0.0) return ends_[0];
    if (share >= 1.0) return ends_[1];
    Pattern pattern;
    pattern.amplitude_g = between(from_.amplitude_g, to_.amplitude_g, share, BlendBy::ratio);
    pattern.duration_s = between(from_.duration_s, to_.duration_s, share, BlendBy::difference);
    set_tone(pattern, from_, to_, share);
    set_rhythm(pattern, share);
    pattern.frequency_curve = frequency_between(from_, to_, share);
    pattern.transients = transients_between(from_, to_, share);
    return clamped(std::move(pattern));
}

Pattern morphed(const Pattern& from, const Pattern& to, double share) {
    return Morph(from, to).at(share);
}

std::vector<std::string> morph_jumps(const Pattern& from, const Pattern& to) {
    std::vector<std::string> jumps;
    if (!tone_between(from, to, 0.5)) jumps.emplace_back("the modulation");
    if (!has_same_rhythm(from, to) && !notes_on_the_way(from, to)) {
        jumps.emplace_back("the rhythm");
    }
    return jumps;
}

Pattern mixed_among(const std::vector<Pattern>& corners, double right, double down) {
    assert(!corners.empty() && corners.size() <= kMostCorners && "a pad has one to four corners");
    const Pattern upper = corners.size() > 1 ? morphed(corners[0], corners[1], right) : corners[0];
    if (corners.size() < 3) return upper;
    const Pattern lower = corners.size() > 3 ? morphed(corners[2], corners[3], right) : corners[2];
    return morphed(upper, lower, down);
}

}  // namespace tact
