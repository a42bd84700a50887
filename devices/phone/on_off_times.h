// On-off times as navigator.vibrate takes them: what is left of them at a moment, and how long
// they are.
//
// Valid     on, off, on, .. in whole milliseconds, none below 0; a first 0 if they begin with off
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tact {

// Whether anything of them is felt.
bool is_ever_on(std::span<const int> ms);

std::int64_t length_ms(std::span<const int> ms);

// What is left at `from_ms`; of a loop: the same loop, beginning there.
std::vector<int> on_off_from(std::span<const int> ms, std::int64_t from_ms, bool loop);

// With silence at the end until it is as long as that; empty if it is never on.
std::vector<int> padded_on_off(std::vector<int> ms, std::int64_t to_ms);

}  // namespace tact
