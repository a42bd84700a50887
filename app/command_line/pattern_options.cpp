// Patterns: their stages, waveforms, pictures, and candidates for more of them.
#include "app/command_line/options.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "app/physiology/physiology.h"
#include "app/pictures/pictures.h"
#include "model/export/exported_files.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/formats/write_effect.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr const char* kGenerateHelp =
    "SPEC, with any key left out taking its default:\n"
    "  {\"design\": \"factorial\", \"amplitude_g\": [0.5, 1],\n"
    "   \"carriers\": [{\"frequency_hz\": {\"from\": 60, \"to\": 240, \"steps\": 3, "
    "\"spacing\": \"log\"}}],\n"
    "   \"modulation\": {\"frequency_hz\": [0, 8]}, \"rhythm\": {\"texts\": [\"\", "
    "\"x=--x---\"]},\n"
    "   \"constraints\": {\"band_hz\": [40, 400], \"detectable_db\": 6}}\n"
    "A number is fixed, an array lists levels, an object is a range. The designs\n"
    "\"latin-hypercube\" and \"sobol\" take \"samples\" and \"seed\".";

constexpr const char* kSnapshotHelp =
    "a view as a picture, without a window; with --frames, as many as make a film";

constexpr const char* kFilmHelp =
    "A film of a folder of frames:\n"
    "  ffmpeg -framerate 30 -i FOLDER/frame_%04d.png -pix_fmt yuv420p film.mp4";

// Longer than any pattern: how long the one shown is, its command knows.
constexpr double kLongestS = 3600.0;

void add_moment_options(CLI::App& snapshot, SnapshotCommand& command) {
    snapshot.add_option("--at", command.at_s, "where the playhead is, s; default: 0")
        ->check(within(0.0, kLongestS));
    snapshot
        .add_option(
            "--frames", command.frames,
            "draws this many pictures over time: as a film, where --out is a .gif, .apng or "
            ".mp4 (by ffmpeg), otherwise into the folder --out: frame_0001.png ...")
        ->check(within(1, kMostFrames));
    snapshot
        .add_option(
            "--slower", command.slower,
            "instead of --frames: this many times slower than life, 25 frames a second in a "
            "film, 30 in a folder")
        ->check(within(0.01, 10'000.0));
    snapshot.add_option("--from", command.from_s, "time of the first frame, s; default: 0")
        ->check(within(0.0, kLongestS));
    snapshot
        .add_option("--to", command.to_s,
                    "time at which the last frame ends, s; default: the end of the pattern")
        ->check(within(0.0, kLongestS));
    snapshot.footer(kFilmHelp);
}

constexpr const char* kEditFooter =
    "Edits are applied in the order in which they are given, each as often as it is given:\n"
    "  tactspace edit SET --pattern buzz --stretch 1.2 --reverse --join tick --out F\n"
    "A rhythm stays a rhythm where its notes lie on the grid of the result; elsewhere they are\n"
    "drawn as an amplitude curve.";

// The values of an edit that is given several times.
struct GivenEdits {
    std::array<std::vector<double>, kEditKindCount> numbers;
    std::array<std::vector<std::string>, kEditKindCount> others;
    std::array<const CLI::Option*, kEditKindCount> options;
};

void add_edit_option(CLI::App& sub, GivenEdits& given, std::size_t k) {
    const EditTraits& about = traits(static_cast<EditKind>(k));
    const std::string option = std::string("--") + about.key;
    const std::string unit = about.unit;
    const std::string help = (unit.empty() || unit == "times" ? "" : unit + ": ") + about.help;
    if (about.needs == EditNeeds::nothing) {
        given.options[k] = sub.add_flag(option, help);
    } else if (about.needs == EditNeeds::pattern) {
        given.options[k] = sub.add_option(option, given.others[k], help)->allow_extra_args(false);
    } else {
        given.options[k] = sub.add_option(option, given.numbers[k], help)
                               ->check(within(about.range))
                               ->allow_extra_args(false);
    }
}

// In the order of the command line, which the lists of values do not have.
std::vector<NamedEdit> in_order(const CLI::App& sub, const GivenEdits& given) {
    std::vector<NamedEdit> edits;
    std::array<std::size_t, kEditKindCount> taken{};
    for (const CLI::Option* option : sub.parse_order()) {
        const auto* at = std::ranges::find(given.options, option);
        if (at == given.options.end()) continue;
        const auto k = static_cast<std::size_t>(at - given.options.begin());
        NamedEdit edit{static_cast<EditKind>(k)};
        if (taken[k] < given.numbers[k].size()) edit.number = given.numbers[k][taken[k]];
        if (taken[k] < given.others[k].size()) edit.other = given.others[k][taken[k]];
        ++taken[k];
        edits.push_back(std::move(edit));
    }
    return edits;
}

}  // namespace

void add_edit_command(CLI::App& app, EditCommand& command, Chosen& chosen) {
    CLI::App& sub = add_command(
        app, "edit", "patterns made of patterns: stretched, reversed, repeated, joined, faded",
        command, chosen);
    sub.add_option("--pattern", command.patterns,
                   "name of a pattern to edit; repeatable; default: all that are not locked")
        ->allow_extra_args(false);
    const auto given = std::make_shared<GivenEdits>();
    for (std::size_t k = 0; k < kEditKindCount; ++k) add_edit_option(sub, *given, k);
    sub.add_option("--as", command.as,
                   "the result is a new pattern of this name, right behind the one --pattern; "
                   "default: it takes its place");
    sub.add_option("--out", command.out, "a set file for all patterns of the set")->required();
    sub.footer(kEditFooter);
    sub.callback([&command, &chosen, &sub, given] {
        command.edits = in_order(sub, *given);
        if (command.edits.empty()) throw CLI::RequiredError("an edit, such as --reverse");
        if (!command.as.empty() && command.patterns.size() != 1) {
            throw CLI::ValidationError("--as: expected one --pattern, got " +
                                       std::to_string(command.patterns.size()));
        }
        chosen = [&command] { return run(command); };
    });
}

void add_stages_command(CLI::App& app, StagesCommand& command, Chosen& chosen) {
    CLI::App& stages =
        add_command(app, "stages", "every stage of neural coding, as CSV files", command, chosen);
    add_rendering(stages, command.common);
    stages.add_option("--pattern", command.pattern, "name of the pattern")->required();
    stages.add_option("--out", command.out, "folder for the files")->required();
}

void add_render_command(CLI::App& app, RenderCommand& command, Chosen& chosen) {
    CLI::App& render =
        add_command(app, "render", "waveforms of all patterns, a file each", command, chosen);
    add_rendering(render, command.common);
    render.add_option("--format", command.format, "wav, txt or csv")
        ->check(CLI::IsMember({"wav", "txt", "csv"}));
    render.add_option("--out", command.out, "folder for the files")->required();
}

void add_export_command(CLI::App& app, ExportCommand& command, Chosen& chosen) {
    CLI::App& sub =
        add_command(app, "export",
                    "patterns as files of phones and other programs, or as WAV or CSV, "
                    "a file each, with what each loses and what that costs in perception",
                    command, chosen);
    std::vector<std::string> keys;
    for (const TargetTraits& target : target_formats()) keys.emplace_back(target.key);
    sub.add_option("--format", command.format, "of the files")
        ->required()
        ->check(CLI::IsMember(keys));
    sub.add_option("--pattern", command.patterns, "names; default: all");
    sub.add_option(
        "--onto", command.onto,
        "the actuator that 0 to 1 are written for: a file (.acf, .json) or one of " +
            actuator_names() +
            "; default: the one that was chosen when the set's effects were read, or the "
            "format's own");
    std::vector<std::string> rates;
    for (const double rate_hz : kExportRatesHz) rates.push_back(shortest_digits(rate_hz));
    sub.add_option_function<std::string>(
           "--rate", [&command](const std::string& text) { command.rate_hz = std::stod(text); },
           "of WAV and CSV, Hz: 10000, 44100 or 48000; default: 48000 of WAV and 10000 of CSV")
        ->check(CLI::IsMember(rates));
    sub.add_option(
           "--bits", command.bits,
           "of WAV: 16, 24 or float; default: 24. Full scale is the loudest pattern's peak, "
           "which the .wav.json beside each file says in g")
        ->check(CLI::IsMember({"16", "24", "float"}));
    CLI::Option* count =
        sub.add_option("-k,--count", command.count,
                       "of the most distinct patterns, which are held against what the target "
                       "makes of them; default: half of them, at most 8")
            ->check(within(2, 10'000));
    sub.add_flag("--no-loss", command.without_loss,
                 "only write the files: what they cost takes two predictions of the set")
        ->excludes(count);
    sub.add_option("--out", command.out, "folder for the files")->required();
    sub.add_flag("--overwrite", command.overwrite, "files of the same names are replaced");
}

void add_generate_command(CLI::App& app, GenerateCommand& command, Chosen& chosen) {
    CLI::App& generate = *app.add_subcommand(
        "generate", "candidate patterns from levels and ranges of their parameters");
    generate
        .add_option("SPEC", command.spec,
                    "a .json file with a generator, or a set file that has one: its own patterns "
                    "stay, those generated before are replaced")
        ->required();
    generate.add_option("--out", command.out, "set file for the patterns");
    generate.add_flag("--count", command.count, "only say how many patterns it makes");
    generate.add_flag("--json", command.json, "JSON instead of text on standard output");
    generate.footer(kGenerateHelp);
    generate.callback([&] {
        if (command.out.empty() && !command.count) {
            throw CLI::RequiredError("--out SET or --count");
        }
        chosen = [&command] { return run(command); };
    });
}

void add_lesson_command(CLI::App& app, LessonCommand& command, Chosen& chosen) {
    CLI::App& lesson =
        *app.add_subcommand("lesson", "a lesson with its numbers, as text or as a student sheet");
    lesson
        .add_option("LESSON", command.lesson,
                    "a .tactlesson.json file, or one that comes with the program: tour, "
                    "thresholds, pacinian_meissner, twins, beats, gaps, why, pipeline, mds; or a "
                    "course, as .tactcourse.json or touch")
        ->required();
    lesson.add_option("--out", command.out,
                      "a .html for students, or a .tactlesson.json as the program writes it; "
                      "default: text on standard output");
    lesson.add_option("--language", command.language,
                      "in which language its texts are shown, by its code, as de; default: its "
                      "first one");
    lesson.add_flag("--hand-on", command.hand_on,
                    "the .html is for another teacher: with notes, answers, and the lesson in it");
    lesson.add_option("--answers", command.answers,
                      "the answers that students gave on this computer, to lessons of the course "
                      "or to this one, as a .csv");
    lesson.callback([&command, &chosen] { chosen = [&command] { return run(command); }; });
}

void add_snapshot_command(CLI::App& app, SnapshotCommand& command, Chosen& chosen) {
    CLI::App& snapshot = add_command(app, "snapshot", kSnapshotHelp, command, chosen);
    add_rendering(snapshot, command.common);
    snapshot
        .add_option("--view", command.view,
                    "window, physiology, wave, spectrum, firing (how one receptor fires), tables "
                    "(slopes and thresholds), matrix or space")
        ->check(CLI::IsMember(
            {"window", "physiology", "wave", "spectrum", "firing", "tables", "matrix", "space"}));
    snapshot.add_option("--pattern", command.pattern, "pattern to show; default: the first");
    snapshot.add_option("--with", command.with, "another pattern to compare it with");
    std::vector<std::string> keys;
    for (const Stage stage : kStages) keys.emplace_back(text_of(stage).key);
    snapshot.add_option("--stage", command.stage, "the stage to show large; default: all of them")
        ->check(CLI::IsMember(keys));
    snapshot.add_flag("--tilted", command.tilted, "the receptors seen from the side");
    snapshot.add_flag("--textbook", command.textbook,
                      "what was measured, laid over the stages with its sources");
    snapshot.add_flag("--figures", command.figures,
                      "every stage as an SVG of its own, into the folder --out");
    add_moment_options(snapshot, command);
    snapshot.add_option("--theme", command.theme, "dark or light")
        ->check(CLI::IsMember({"dark", "light"}));
    snapshot.add_option("--width", command.width, "pixels")->check(within(64, 8192));
    snapshot.add_option("--height", command.height, "pixels")->check(within(64, 8192));
    snapshot.add_option("--scale", command.scale, "size of text and marks, 0.75-4")
        ->check(within(0.75, 4.0));
    snapshot
        .add_option("--out", command.out,
                    "file, .png or .svg; with --frames or --slower .gif, .apng, .mp4 or a folder")
        ->required();
}

void add_manual_command(CLI::App& app, ManualCommand& command, Chosen& chosen) {
    CLI::App& manual = *app.add_subcommand(
        "manual", "the manual as one page that needs no network, as F1 in the window opens it");
    manual.add_option("--out", command.out, "file for the page, .html")->required();
    manual.callback([&] { chosen = [&command] { return run(command); }; });
}

}  // namespace tact
