// Numbered pictures of a view that moves, in a folder: what films are made of.
//
// Input     a stretch of the pattern's time and a count of frames
// Output    frame_0001.png and so on. Each stands for a share of the stretch, which it shows the
//           begin of: the end is that of the last one, so that a film of them can go round.
// Left out  films themselves: film.h; film_command() says what other program makes one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "model/common/expected.h"

namespace tact {

inline constexpr int kMostFrames = 9999;
inline constexpr double kFilmFramesPerS = 30.0;  // of the film that film_command() makes

struct FrameSequence {
    std::filesystem::path folder;
    double from_s = 0.0;  // of the pattern
    double to_s = 1.0;
    int frames = 60;  // 1..kMostFrames
};

// `k` from 0 to frames - 1.
double time_of_frame_s(const FrameSequence& sequence, int k);
std::filesystem::path path_of_frame(const FrameSequence& sequence, int k);

// How a film of them goes: "20 times slower than life".
std::string film_speed(const FrameSequence& sequence, double frames_per_s = kFilmFramesPerS);

// Makes the folder. Frames of the same numbers will be replaced; an Error if there are others, as a
// film would run on into them.
Expected<Done> open_sequence(const FrameSequence& sequence);

// A word for the shell, quoted where it would take it apart.
std::string shell_word(const std::string& text);

// A line for the shell that makes a film of the folder's frames, `width` by `height` pixels.
std::string film_command(const std::filesystem::path& folder, int width, int height);

}  // namespace tact
