#include "app/pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/pictures/parts.h"
#include "app/session/session.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

fs::path part_of(const fs::path& path) {
    fs::path part = path;
    part += ".part";
    return part;
}

std::string ffmpeg_line(const fs::path& path, FilmSize film) {
    const std::string size = std::to_string(film.width) + "x" + std::to_string(film.height);
    return "exec ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s " + size +
           " -framerate 25 -i - -pix_fmt yuv420p -f mp4 " + shell_word(part_of(path).string());
}

}  // namespace

std::optional<FilmFormat> film_format(const fs::path& path) {
    const std::string ending = extension_of(path);
    if (ending == ".gif") return FilmFormat::gif;
    if (ending == ".apng") return FilmFormat::apng;
    if (ending == ".mp4") return FilmFormat::mp4;
    return std::nullopt;
}

const char* ending_of(FilmFormat format) {
    return format == FilmFormat::gif ? ".gif" : format == FilmFormat::apng ? ".apng" : ".mp4";
}

int frames_of(double length_s, double slower, double frames_per_s) {
    return std::clamp(static_cast<int>(std::lround(length_s * slower * frames_per_s)), 1,
                      kMostFrames);
}

FilmSize film_size(FilmFormat format, FilmSize asked) {
    if (format != FilmFormat::mp4) return asked;
    return {asked.width + asked.width % 2, asked.height + asked.height % 2};
}

std::string film_size_words(FilmFormat format, FilmSize asked) {
    const FilmSize size = film_size(format, asked);
    if (size.width == asked.width && size.height == asked.height) return {};
    return std::to_string(size.width) + " \u00d7 " + std::to_string(size.height) +
           " pixels, as sides of an MP4 are even";
}

Film::~Film() {
    if (ffmpeg == nullptr) return;
    pclose(ffmpeg);
    std::error_code none;
    fs::remove(part_of(path), none);
}

Expected<std::shared_ptr<Film>> open_film(const fs::path& path, FilmSize size) {
    auto film = std::make_shared<Film>();
    film->path = path;
    film->format = film_format(path).value_or(FilmFormat::apng);
    film->apng.frame_s = 1.0 / kFilmFileFramesPerS;
    if (film->format != FilmFormat::mp4) return film;
    if (!is_installed("ffmpeg")) {
        return Error{
            path.string() +
            ": MP4 is made by ffmpeg, which is not installed; .gif and .apng need nothing"};
    }
    film->ffmpeg = popen(ffmpeg_line(path, size).c_str(), "w");
    if (film->ffmpeg == nullptr) return Error{path.string() + ": ffmpeg could not be started"};
    return film;
}

Expected<Done> add_frame(Film& film, const Image& image) {
    if (film.format == FilmFormat::gif) return add_frame(film.gif, image);
    if (film.format == FilmFormat::apng) {
        add_frame(film.apng, image);
        return Done{};
    }
    if (write_unharmed(film.ffmpeg, image.rgba.data(), image.rgba.size())) return Done{};
    return Error{film.path.string() + ": ffmpeg stopped; what it said is on the terminal"};
}

Expected<Done> finish(Film& film) {
    if (film.format == FilmFormat::apng) {
        return write_atomically(film.path, finished(film.apng));
    }
    if (film.format == FilmFormat::gif) {
        const Expected<std::string> bytes = finished(film.gif);
        if (!bytes) return bytes.error();
        return write_atomically(film.path, *bytes);
    }
    const int code = pclose(std::exchange(film.ffmpeg, nullptr));
    std::error_code fault;
    if (code == 0) fs::rename(part_of(film.path), film.path, fault);
    if (code == 0 && !fault) return Done{};
    fs::remove(part_of(film.path), fault);
    return Error{film.path.string() + ": ffmpeg failed; what it said is on the terminal"};
}

namespace {

namespace fs = std::filesystem;

// The number in "frame_0012.png"; 0 for any other name.
int number_in(const std::string& name) {
    int number = 0;
    int read = 0;
    if (std::sscanf(name.c_str(), "frame_%4d.png%n", &number, &read) != 1) return 0;
    return static_cast<std::size_t>(read) == name.size() ? number : 0;
}

}  // namespace

std::string shell_word(const std::string& text) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-%+,";
    if (text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string quoted = "'";
    for (const char sign : text) quoted += sign == '\'' ? "'\\''" : std::string(1, sign);
    return quoted + "'";
}

double time_of_frame_s(const FrameSequence& sequence, int k) {
    const double share = static_cast<double>(k) / static_cast<double>(sequence.frames);
    return sequence.from_s + share * (sequence.to_s - sequence.from_s);
}

fs::path path_of_frame(const FrameSequence& sequence, int k) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", k + 1);
    return sequence.folder / name;
}

std::string film_speed(const FrameSequence& sequence, double frames_per_s) {
    const double film_s = static_cast<double>(sequence.frames) / frames_per_s;
    const double slower = film_s / (sequence.to_s - sequence.from_s);
    if (std::abs(slower - 1.0) < 0.005) return "as fast as life";
    return slower > 1.0 ? significant(slower) + " times slower than life"
                        : significant(1.0 / slower) + " times faster than life";
}

Expected<Done> open_sequence(const FrameSequence& sequence) {
    if (const Expected<Done> made = make_folder(sequence.folder); !made) return made;
    std::error_code fault;
    for (fs::directory_iterator at(sequence.folder, fault), end; !fault && at != end;
         at.increment(fault)) {
        const std::string name = at->path().filename().string();
        if (number_in(name) <= sequence.frames) continue;
        return Error{sequence.folder.string() + ": holds " + name +
                     " of a longer sequence, which a film would run into; expected another "
                     "folder, or one without it"};
    }
    return Done{};
}

std::string film_command(const fs::path& folder, int width, int height) {
    // The pixels of most players come in squares of four.
    const bool odd = width % 2 != 0 || height % 2 != 0;
    return "ffmpeg -framerate 30 -i " + shell_word((folder / "frame_%04d.png").string()) +
           (odd ? " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2'" : "") + " -pix_fmt yuv420p film.mp4";
}

}  // namespace tact
