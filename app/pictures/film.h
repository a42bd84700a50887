// A moving picture as one file: GIF or APNG by the program itself, MP4 where ffmpeg is installed.
//
// Input     pictures of one size, one after the other; the format by the ending of the file's name
// Output    a whole file or none; kFilmFileFramesPerS, which GIF and APNG keep to the digit
// Left out  sound; other players' formats (frame_sequence.h makes pictures for any program)
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "model/common/expected.h"
#include "viz/picture/apng.h"
#include "viz/picture/gif.h"

namespace tact {

enum class FilmFormat { gif, apng, mp4 };

inline constexpr double kFilmFileFramesPerS = 25.0;

// By ".gif", ".apng" and ".mp4"; none: it names no film.
std::optional<FilmFormat> film_format(const std::filesystem::path& path);

// ".gif"
const char* ending_of(FilmFormat format);

// How many frames show a stretch of a pattern `slower` times slower than life.
int frames_of(double length_s, double slower, double frames_per_s);

// In pixels. Colours of an MP4 stand for two by two of them: its sides are even.
struct FilmSize {
    int width = 0;
    int height = 0;
};

// What its pictures are to be drawn at.
FilmSize film_size(FilmFormat format, FilmSize asked);

// "1000 × 1002 pixels, as sides of an MP4 are even" if that is not what was asked; otherwise
// empty.
std::string film_size_words(FilmFormat format, FilmSize asked);

struct Film {
    std::filesystem::path path;
    FilmFormat format = FilmFormat::apng;
    ApngWriter apng{};
    GifWriter gif{1.0 / kFilmFileFramesPerS};
    std::FILE* ffmpeg = nullptr;  // takes pictures as they come, into path + ".part"

    Film() = default;
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;
    ~Film();  // unfinished: nothing is left of it
};

// Takes pictures of film_size(). Errors: ffmpeg is not there, or does not start.
Expected<std::shared_ptr<Film>> open_film(const std::filesystem::path& path, FilmSize size);
Expected<Done> add_frame(Film& film, const Image& image);
Expected<Done> finish(Film& film);

}  // namespace tact
