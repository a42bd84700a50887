// Pictures of single views; the clipboard.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/physiology/neural_coding_params.h"
#include "model/set/pattern_set.h"
#include "viz/picture/apng.h"
#include "viz/picture/gif.h"
#include "viz/picture/picture.h"
#include "viz/space/space_view.h"

namespace tact {

// A picture on the clipboard of the desktop, by the program that the desktop has for it.
//
// Output    PNG; an Error that names the package where no such program is installed
// Left out  clipboards of our own: GLFW's hold text, and what a window owns is gone when it closes

Expected<Done> copy_to_clipboard(const Image& image);

// Patterns on the clipboard of the desktop, as text: a set file.
//
// What is copied here can be pasted into another window, a message or an editor; a set file that
// was copied there can be pasted here.

void copy_selected(Ui& ui, Workspace& work);

// What was copied last, here or as the text of a set file elsewhere; one step.
void paste(Ui& ui, Workspace& work);

// A moving picture as one file: GIF or APNG by the program itself, MP4 where ffmpeg is installed.
//
// Input     pictures of one size, one after the other; the format by the ending of the file's name
// Output    a whole file or none; kFilmFileFramesPerS, which GIF and APNG keep to the digit
// Left out  sound; other players' formats: a sequence of frames is for any program

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

// Numbered pictures of a view that moves, in a folder: what films are made of.
//
// Input     a stretch of the pattern's time and a count of frames
// Output    frame_0001.png and so on. Each stands for a share of the stretch, which it shows the
//           begin of: the end is that of the last one, so that a film of them can go round.
// Left out  films themselves: open_film(); film_command() says what other program makes one.

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

// Pictures of single views without a window: PNG or SVG.
//
// Exact     same input, same bytes.

enum class PictureFormat { png, svg };

struct PictureSize {
    int width = 1000;
    int height = 900;
    float scale = 1.0F;
    bool dark = true;
    PictureFormat format = PictureFormat::png;
    bool titled = true;     // above what is drawn: what it is
    std::string svg_ids{};  // as PictureOptions has them
};

struct Svg {
    std::string text;
};

using Picture = std::variant<Image, Svg>;  // by the format asked for

// What `draw` draws, in the format asked for.
Picture drawn(const PictureSize& size, const PictureOptions& options,
              const std::function<void(const Theme&)>& draw);

Picture matrix_picture(const std::vector<std::string>& labels, const Dissimilarity& matrix,
                       const std::string& quantity, const PictureSize& size,
                       const std::string& mark = {});

// What a space is drawn with besides its points.
struct SpaceMarks {
    std::span<const std::size_t> chosen{};              // a subset, ringed
    std::span<const SpaceLink> links{};                 // pairs that are too close
    std::span<const std::vector<std::size_t>> paths{};  // patterns to join, along a parameter
    const Eigen::MatrixXd* before = nullptr;  // where the points were, n x k: arrows from there
    std::string quantity = "PM";              // what the matrix is
    std::string source{};                     // where it is from; empty: predicted by that
    std::string mark{};                       // what has to be said of it; empty: nothing
};

Picture space_picture(const PatternSet& set, const Dissimilarity& pm, const PerceptualSpace& space,
                      const PictureSize& size, const SpaceMarks& marks = {});

// Several maps of one set beside each other, one legend for all of them.
struct MapPanel {
    const Dissimilarity* apart = nullptr;  // never null, nor is the other
    const PerceptualSpace* space = nullptr;
    SpaceMarks marks{};
};
Picture space_panels_picture(const PatternSet& set, std::span<const MapPanel> panels,
                             const std::string& title, const std::string& detail,
                             const PictureSize& size);
std::size_t panel_columns(std::size_t panels);  // that they stand in

Picture wave_picture(const Vibration& vibration, const PictureSize& size);

Picture spectrum_picture(const Vibration& vibration, const NeuralCodingParams& params,
                         const PictureSize& size);

// A failed write leaves an existing file as it was.
Expected<Done> write_picture(const std::filesystem::path& path, const Picture& picture);

// Pictures of the physiology for a page: what the model's tables say, and how one receptor fires.
//
// Exact     same input, same bytes.

// Slopes of the rate-intensity functions and absolute thresholds over frequency, of all four types.
Picture tables_picture(const PhysiologyTables& tables, const PictureSize& size);

// The receptor under the probe of the type that fires most: what it perceives, the energy against
// its threshold, its spikes.
Picture firing_picture(const Vibration& vibration, const NeuralCodingParams& params,
                       const PictureSize& size);

}  // namespace tact
