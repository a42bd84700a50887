// A pattern as a file of another program, and in words what that loses.
//
// Pure: what is written depends on the arguments alone. Reading the text with the same actuator map
// (read_effects.h) gives what is left of the pattern. WAV and CSV hold samples, in g: they need no
// map, and hold recordings, too.
// How far off that is, in dB, is measured behind all writers: model/export/envelope_error.h.
//
// Source    each format's at the head of its source file, in its folder
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Output    UTF-8; a file that its owner takes: limits of points, times and steps are kept
// Left out  several patterns in one file, but in HJIF; sounds.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "model/io/effects_out/written_effect.h"

namespace tact {

std::span<const TargetTraits> target_formats();
const TargetTraits& traits(TargetFormat format);
std::optional<TargetFormat> target_format_of(std::string_view key);

// Samples: WAV or CSV.
bool is_sampled(TargetFormat format);

WrittenEffect write_effect(TargetFormat format, const Pattern& pattern, const EffectTarget& target);

}  // namespace tact
