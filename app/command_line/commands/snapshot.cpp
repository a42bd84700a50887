// tactspace snapshot: a view as a picture, or as the frames of a film, without a window.

#include <iostream>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/pictures/pictures.h"
#include "app/session/session.h"
#include "app/window/window.h"
#include "model/evaluation/metric.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/load.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

bool shows_time(const SnapshotCommand& command) {
    return command.view == "window" || command.view == "physiology";
}

bool shows_pattern(const SnapshotCommand& command) {
    return shows_time(command) || command.view == "wave" || command.view == "spectrum" ||
           command.view == "firing";
}

bool is_moving(const SnapshotCommand& command) { return command.frames > 0 || command.slower; }

// What goes together; the numbers are looked at when the set's duration is known.
Expected<Done> check_options(const SnapshotCommand& command) {
    const auto needs = [](const char* option, const char* what) {
        return Error{std::string(option) + " needs " + what};
    };
    constexpr const char* kMoving = "--view physiology or window: the others have no such choice";
    if (!command.pattern.empty() && !shows_pattern(command)) {
        return needs("--pattern", "a view of one pattern, which tables, matrix and space are not");
    }
    if (!shows_time(command)) {
        if (!command.with.empty()) return needs("--with", kMoving);
        if (!command.stage.empty()) return needs("--stage", kMoving);
        if (command.tilted) return needs("--tilted", kMoving);
        if (command.textbook) return needs("--textbook", kMoving);
        if (command.at_s) return needs("--at", kMoving);
        if (is_moving(command)) {
            return needs(command.slower ? "--slower" : "--frames",
                         "a view that moves: physiology or window");
        }
    }
    if (command.figures && is_moving(command)) return Error{"--figures stand still; no --frames"};
    if (command.frames > 0 && command.slower) {
        return Error{"--slower says how many --frames there are; expected one of the two"};
    }
    if (!is_moving(command)) {
        if (film_format(command.out)) {
            return needs(extension_of(command.out).c_str(), "--slower or --frames");
        }
        if (command.from_s) return needs("--from", "--frames");
        if (command.to_s) return needs("--to", "--frames");
        return Done{};
    }
    if (command.at_s) return Error{"--at is for a single picture; --frames has --from and --to"};
    const std::string ending = extension_of(command.out);
    if (ending == ".png" || ending == ".svg") {
        return Error{command.out.string() + ": --frames fills a folder, and this names a picture"};
    }
    return Done{};
}

Expected<Picture> picture_of_set(const SnapshotCommand& command, const PatternSet& set,
                                 const PictureSize& size) {
    if (command.view == "tables") return tables_picture(set.model.coding.tables, size);
    if (const Expected<Done> pair = need_a_pair(set, command.common); !pair) return pair.error();
    PredictOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    const Prediction prediction = *predict(own_waveforms(set, options.threads), set.model, options);
    if (command.view == "matrix") {
        return matrix_picture(names_of(set), prediction.pm, traits(Metric::pm).name, size,
                              phrase_of(mark_of(set)));
    }
    MdsParams params = standard_mds_params(set.vibrations.size(), 3);
    params.threads = command.common.threads;
    return space_picture(set, prediction.pm, nonmetric_mds(prediction.pm, params), size);
}

// The pattern asked for, or the first.
Expected<std::size_t> pattern_place(const SnapshotCommand& command, const PatternSet& set) {
    const std::string first = set.vibrations.empty() ? "" : set.vibrations[0].name;
    return place_of(set, command.pattern.empty() ? first : command.pattern);
}

Expected<Picture> picture_of_pattern(const SnapshotCommand& command, const PatternSet& set,
                                     const PictureSize& size) {
    const Expected<std::size_t> place = pattern_place(command, set);
    if (!place) return place.error();
    const Vibration& vibration = set.vibrations[*place];
    if (command.view == "wave") return wave_picture(vibration, size);
    return command.view == "firing" ? firing_picture(vibration, set.model.coding, size)
                                    : spectrum_picture(vibration, set.model.coding, size);
}

Expected<ViewChoice> view_choice(const SnapshotCommand& command, const PatternSet& set) {
    ViewChoice choice;
    const Expected<std::optional<RenderedBy>> by = rendered_by(command.common);
    if (!by) return by.error();
    choice.rendered_by = *by;
    choice.view = command.view == "window" ? PictureView::window : PictureView::physiology;
    choice.tilted = command.tilted;
    choice.textbook = command.textbook;
    choice.threads = command.common.threads;
    choice.stage = stage_named(command.stage);
    // An empty set has its window, too.
    if (set.vibrations.empty() && command.pattern.empty() && command.with.empty()) return choice;
    const Expected<std::size_t> place = pattern_place(command, set);
    if (!place) return place.error();
    choice.pattern = *place;
    if (command.with.empty()) return choice;
    const Expected<std::size_t> pinned = place_of(set, command.with);
    if (!pinned) return pinned.error();
    if (*pinned == *place) {
        return Error{"--with " + command.with + ": is the pattern itself, expected another one"};
    }
    choice.pinned = *pinned;
    return choice;
}

std::string seconds_text(double seconds) { return tick_text(seconds) + " s"; }

Expected<Done> check_time(const char* option, double time_s, double whole_s) {
    if (time_s >= 0.0 && time_s <= whole_s) return Done{};
    return Error{std::string(option) + ": expected a time from 0 to " + seconds_text(whole_s) +
                 ", the duration of the set, got " + seconds_text(time_s)};
}

Expected<Picture> picture_of_view(const SnapshotCommand& command, const PatternSet& set,
                                  const PictureSize& size) {
    const Expected<ViewChoice> choice = view_choice(command, set);
    if (!choice) return choice.error();
    const double at_s = command.at_s.value_or(0.0);
    if (const auto within = check_time("--at", at_s, longest_s(set)); !within) {
        return within.error();
    }
    const auto view = opened_view(set, *choice);
    return view_picture(*view, choice->view, at_s, size);
}

double frames_per_s(const SnapshotCommand& command) {
    return film_format(command.out) ? kFilmFileFramesPerS : kFilmFramesPerS;
}

FrameSequence with_frames(const SnapshotCommand& command, FrameSequence sequence) {
    if (!command.slower) return sequence;
    sequence.frames =
        frames_of(sequence.to_s - sequence.from_s, *command.slower, frames_per_s(command));
    return sequence;
}

Expected<FrameSequence> sequence_of(const SnapshotCommand& command, double whole_s) {
    const FrameSequence sequence{command.out, command.from_s.value_or(0.0),
                                 command.to_s.value_or(whole_s), command.frames};
    if (const auto within = check_time("--from", sequence.from_s, whole_s); !within) {
        return within.error();
    }
    if (const auto within = check_time("--to", sequence.to_s, whole_s); !within) {
        return within.error();
    }
    if (sequence.from_s < sequence.to_s) return with_frames(command, sequence);
    return Error{"--to " + seconds_text(sequence.to_s) + ": expected a time after --from " +
                 seconds_text(sequence.from_s)};
}

// A file that is whole or not there.
Expected<Done> draw_film(const SnapshotCommand& command, const PatternSet& set,
                         const ViewChoice& choice, const FrameSequence& sequence, PictureSize size,
                         const Interrupt& interrupt) {
    const FilmFormat format = *film_format(command.out);
    const FilmSize asked{size.width, size.height};
    const FilmSize drawn = film_size(format, asked);
    const auto film = open_film(command.out, drawn);
    if (!film) return film.error();
    size.width = drawn.width;
    size.height = drawn.height;
    const auto view = opened_view(set, choice);
    const auto progress = progress_line("drawing frames");
    for (int k = 0; k < sequence.frames; ++k) {
        if (interrupt.token().stop_requested()) return Error{"stopped; no film was written"};
        const Picture picture =
            view_picture(*view, choice.view, time_of_frame_s(sequence, k), size);
        if (const auto added = add_frame(**film, std::get<Image>(picture)); !added) return added;
        progress(static_cast<double>(k + 1) / static_cast<double>(sequence.frames));
    }
    if (const Expected<Done> done = finish(**film); !done) return done;
    const std::string another_size = film_size_words(format, asked);
    std::cerr << "tactspace: wrote "
              << counted(static_cast<std::size_t>(sequence.frames), "frame", "frames") << ", "
              << film_speed(sequence, kFilmFileFramesPerS)
              << (another_size.empty() ? "" : ", " + another_size) << "\n";
    return Done{};
}

Expected<Done> draw_sequence(const SnapshotCommand& command, const PictureSize& size) {
    const Interrupt interrupt;  // first: threads inherit what it blocks
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const Expected<ViewChoice> choice = view_choice(command, *set);
    if (!choice) return choice.error();
    const Expected<FrameSequence> sequence = sequence_of(command, longest_s(*set));
    if (!sequence) return sequence.error();
    if (film_format(command.out)) {
        return draw_film(command, *set, *choice, *sequence, size, interrupt);
    }
    if (const Expected<Done> open = open_sequence(*sequence); !open) return open;
    const auto view = opened_view(*set, *choice);
    const auto progress = progress_line("drawing frames");
    for (int k = 0; k < sequence->frames; ++k) {
        if (interrupt.token().stop_requested()) {
            return Error{"stopped with " + std::to_string(k) + " of " +
                         std::to_string(sequence->frames) + " frames written, each of them whole"};
        }
        const Picture picture =
            view_picture(*view, choice->view, time_of_frame_s(*sequence, k), size);
        const auto written = write_picture(path_of_frame(*sequence, k), picture);
        if (!written) return written;
        progress(static_cast<double>(k + 1) / static_cast<double>(sequence->frames));
    }
    std::cerr << "tactspace: wrote "
              << counted(static_cast<std::size_t>(sequence->frames), "frame", "frames")
              << ", in a film " << film_speed(*sequence) << ": "
              << film_command(sequence->folder, size.width, size.height) << "\n";
    return Done{};
}

// For a paper: one stage a file, by the key of the stage.
Expected<Done> draw_figures(const SnapshotCommand& command, PictureSize size) {
    if (command.view != "physiology") return Error{"--figures needs --view physiology"};
    if (!command.stage.empty())
        return Error{"--figures are of every --stage; expected one of the two"};
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const double at_s = command.at_s.value_or(0.0);
    if (const auto within = check_time("--at", at_s, longest_s(*set)); !within) return within;
    Expected<ViewChoice> choice = view_choice(command, *set);
    if (!choice) return choice.error();
    if (const Expected<Done> made = make_folder(command.out); !made) return made;
    size.format = PictureFormat::svg;
    for (const Stage stage : kStages) {
        choice->stage = stage;
        const auto view = opened_view(*set, *choice);
        const Picture picture = view_picture(*view, choice->view, at_s, size);
        const auto path = command.out / (std::string(text_of(stage).key) + ".svg");
        if (const auto written = write_picture(path, picture); !written) return written;
        std::cerr << "tactspace: wrote " << path.string() << "\n";
    }
    return Done{};
}

}  // namespace

Expected<Done> run(const SnapshotCommand& command) {
    if (const Expected<Done> checked = check_options(command); !checked) return checked;
    PictureSize size;
    size.width = command.width;
    size.height = command.height;
    size.scale = static_cast<float>(command.scale);
    size.dark = command.theme == "dark";
    if (command.figures) return draw_figures(command, size);
    if (is_moving(command)) return draw_sequence(command, size);
    const Expected<PictureFormat> format = picture_format(command.out);
    if (!format) return format.error();
    size.format = *format;
    // The window says itself what its results are of.
    const Expected<PatternSet> set =
        shows_time(command) ? load_as_meant(command.common) : load_for(command.common);
    if (!set) return set.error();
    const Expected<Picture> picture = shows_time(command) ? picture_of_view(command, *set, size)
                                      : shows_pattern(command)
                                          ? picture_of_pattern(command, *set, size)
                                          : picture_of_set(command, *set, size);
    if (!picture) return picture.error();
    return write_picture(command.out, *picture);
}

}  // namespace tact
