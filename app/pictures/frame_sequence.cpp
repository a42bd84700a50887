#include "app/pictures/frame_sequence.h"

#include <cmath>
#include <cstdio>
#include <string_view>

#include "app/session/folders.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

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
