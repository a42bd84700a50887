// The only file that includes CLI11, which takes seconds to compile.
#include "app/command_line/command_line.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/frame_sequence.h"
#include "app/main_window.h"
#include "app/stages.h"
#include "devices/rendering.h"
#include "model/metric.h"
#include "model/study_design.h"

namespace tact {

namespace {

constexpr const char* kSetHelp =
    "a .tactspace.json file, a folder of .txt or .wav files, or single .txt and .wav files";

void add_threads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "threads to use; 0: all cores")
        ->check(CLI::Range(0, 1024));
}

void add_common(CLI::App& command, CommonOptions& options) {
    command.add_option("SET", options.sets, kSetHelp)->required();
    add_threads(command, options.threads);
    command.add_flag("--json", options.json, "JSON instead of CSV on standard output");
    command.add_option("--model", options.model,
                       "file of model parameters, as train writes it, instead of the set's own");
}

void add_ratings(CLI::App& command, RatingFiles& ratings) {
    command.add_option("--ratings", ratings.files,
                       "files of ratings, one a participant, or a folder of them; for several "
                       "sets a file or folder each. Without it, the ratings in the set file");
    command
        .add_option("--scale", ratings.scale,
                    "what a high rating means: similarity (0-100), dissimilarity, or guess")
        ->check(CLI::IsMember({"guess", "similarity", "dissimilarity"}));
}

// The patterns as a device plays them, in the place of what was meant.
void add_rendering(CLI::App& command, CommonOptions& options) {
    std::vector<std::string> keys;
    for (const ActuatorKind kind : kActuatorKinds) keys.emplace_back(traits(kind).key);
    command
        .add_option("--rendered-by", options.rendered_by,
                    "the patterns as this kind of device plays them")
        ->check(CLI::IsMember(keys));
    command
        .add_option("--full-scale", options.full_scale_g,
                    "acceleration that the device's full scale stands for, g; else 1")
        ->check(CLI::Range(kFullScaleRangeG.low, kFullScaleRangeG.high));
}

// Registers a subcommand whose options live in `command`; `chosen` is set to its work.
template <class Command>
CLI::App& add_command(CLI::App& app, const char* name, const char* help, Command& command,
                      std::function<Expected<Done>()>& chosen) {
    CLI::App& sub = *app.add_subcommand(name, help);
    add_common(sub, command.common);
    sub.callback([&] { chosen = [&command] { return run(command); }; });
    return sub;
}

// For the commands whose answer two sides of a set can be compared by.
void add_only(CLI::App& command, CommonOptions& options) {
    command
        .add_option_function<std::string>(
            "--only",
            [&options](const std::string& side) {
                options.only = side == "measured" ? Side::measured : Side::intended;
            },
            "intended or measured: leaves out the measured twins, or all else; compare holds a "
            "twin against the ratings of the pattern that it measures")
        ->check(CLI::IsMember({"intended", "measured"}));
}

struct Commands {
    PredictCommand predict;
    SpaceCommand space;
    StagesCommand stages;
    RenderCommand render;
    SnapshotCommand snapshot;
    CompareCommand compare;
    StudyCommand study;
    TrainCommand train;
    SubsetCommand subset;
    SeparateCommand separate;
    FindingsCommand findings;
    DevicesCommand devices;
    PlayCommand play;
    CalibrateCommand calibrate;
    GenerateCommand generate;
    ImportCommand import;
    MeasureCommand measure;
};

// Empty where there is such a metric, as CLI11 wants it.
std::string fault_of_metric(const std::string& key) {
    const Expected<Metric> metric = metric_named(key);
    return metric ? "" : metric.error().message;
}

std::string list_of_metrics() {
    std::string list = "Metrics:";
    for (const Metric metric : kMetrics) {
        const MetricTraits& about = traits(metric);
        const std::string key = about.key;
        list += "\n  " + key + std::string(15 - key.size(), ' ') + about.description;
        if (about.is_reference) list += " (a reference, not from the paper)";
    }
    return list;
}

void add_prediction_commands(CLI::App& app, Commands& commands,
                             std::function<Expected<Done>()>& chosen) {
    CLI::App& predict = add_command(
        app, "predict", "dissimilarity matrix of a set, as labelled CSV", commands.predict, chosen);
    add_rendering(predict, commands.predict.common);
    predict.add_option("--metric", commands.predict.metric, "pm unless another of those below")
        ->check(fault_of_metric);
    predict.add_option("--out", commands.predict.out, "file for the matrix");
    predict.add_option("--image", commands.predict.image, "picture of the matrix, .png or .svg");
    predict.add_flag("--resume", commands.predict.resume,
                     "go on where a stopped run with the same --out left off: pm, nc and oc");
    predict.add_flag("--first-as-reference", commands.predict.first_as_reference,
                     "st-sim and spqi: the earlier pattern of a pair is the reference, instead of "
                     "the mean of both ways");
    add_only(predict, commands.predict.common);
    predict.footer(list_of_metrics());

    CLI::App& space = add_command(app, "space", "coordinates of the perceptual space, as CSV",
                                  commands.space, chosen);
    add_rendering(space, commands.space.common);
    space.add_option("--dim", commands.space.dimensions, "2 or 3")->check(CLI::IsMember({2, 3}));
    add_only(space, commands.space.common);
    space.add_option("--starts", commands.space.starts, "random starts besides Torgerson's")
        ->check(CLI::Range(0, 100'000));
    space.add_option("--out", commands.space.out, "file for the coordinates");
    space.add_option("--image", commands.space.image, "picture of the space, .png or .svg");
}

void add_pattern_commands(CLI::App& app, Commands& commands,
                          std::function<Expected<Done>()>& chosen) {
    CLI::App& stages = add_command(app, "stages", "every stage of neural coding, as CSV files",
                                   commands.stages, chosen);
    add_rendering(stages, commands.stages.common);
    stages.add_option("--pattern", commands.stages.pattern, "name of the pattern")->required();
    stages.add_option("--out", commands.stages.out, "folder for the files")->required();

    CLI::App& render = add_command(app, "render", "waveforms of all patterns, a file each",
                                   commands.render, chosen);
    add_rendering(render, commands.render.common);
    render.add_option("--format", commands.render.format, "wav, txt or csv")
        ->check(CLI::IsMember({"wav", "txt", "csv"}));
    render.add_option("--out", commands.render.out, "folder for the files")->required();
}

constexpr const char* kDeviceHelp =
    "id or name of the device, or a part of its name that no other has; see tactspace devices. "
    "Another one is never played on";

void add_play_commands(CLI::App& app, Commands& commands, std::function<Expected<Done>()>& chosen) {
    CLI::App& devices = *app.add_subcommand("devices", "what there is to play on");
    devices.add_flag("--json", commands.devices.json, "JSON instead of text");
    devices.callback([&] { chosen = [&found = commands.devices] { return run(found); }; });

    PlayCommand& options = commands.play;
    CLI::App& play =
        add_command(app, "play", "patterns on an actuator, to be felt", options, chosen);
    play.add_option("--pattern", options.pattern, "name of the pattern");
    play.add_flag("--all", options.all, "every pattern instead, one after the other");
    play.add_option("--gap", options.gap_s, "silence between two of them, s")
        ->check(CLI::Range(0.0, 60.0));
    play.add_option("--device", options.device, kDeviceHelp);
    play.add_option("--channel", options.channel, "number from 1, or name; else the first");
    play.add_option("--channels", options.of_channels,
                    "how many the outputs behind a sound server have")
        ->check(CLI::Range(1, 8));
    play.add_option("--level", options.level, "how strong, 0-1; else 0.1")
        ->check(CLI::Range(0.0, 1.0));
    play.add_option("--full-scale", options.full_scale_g,
                    "acceleration that full scale stands for without a calibration, g; else 1")
        ->check(CLI::Range(1e-3, 1e3));
    play.add_option("--calibration", options.calibration,
                    "of this device and channel, as tactspace calibrate makes it: strengths are "
                    "then true at --level 1");
    play.add_flag("--loop", options.loop, "until Ctrl+C");
}

void add_calibrate_command(CLI::App& app, CalibrateCommand& options,
                           std::function<Expected<Done>()>& chosen) {
    CLI::App& calibrate = *app.add_subcommand(
        "calibrate", "how strong an actuator is: the signal to play, and what its recording says");
    auto* signal = calibrate.add_option("--signal", options.signal,
                                        "WAV file to write, to be played at full level");
    auto* recording =
        calibrate.add_option("--recording", options.recording,
                             "what the sensor recorded meanwhile, in g, begun before it");
    signal->excludes(recording);
    calibrate.add_option("--scale", options.scale_g, "g at full scale of a WAV recording, else 1")
        ->check(CLI::Range(1e-6, 1e6));
    calibrate.add_flag("--sweep", options.sweep, "a sweep of 20 s instead of tones of 0.6 s");
    calibrate.add_option("--low", options.low_hz, "lowest frequency, Hz; else 20")
        ->check(CLI::Range(1.0, 2000.0));
    calibrate.add_option("--high", options.high_hz, "highest frequency, Hz; else 500")
        ->check(CLI::Range(1.0, 2000.0));
    Calibration& about = options.about;
    calibrate.add_option("--device", about.device, "its id; see tactspace devices");
    calibrate.add_option("--channel", about.channel, "number from 1")->check(CLI::Range(1, 256));
    calibrate.add_option("--actuator", about.actuator, "its name");
    calibrate.add_option("--mounting", about.mounting, "how it is held or fixed");
    calibrate.add_option("--gain-note", about.gain_note, "settings of amplifier and mixer");
    calibrate.add_option("--sensor", about.sensor, "what it was recorded with");
    calibrate.add_option("--date", about.date, "of the measurement, YYYY-MM-DD");
    calibrate.add_option("--load-mass", about.load_mass_g, "that it moves, g")
        ->check(CLI::Range(0.0, 1e5));
    calibrate.add_option("--excursion-limit", about.excursion_limit_mm, "peak, mm")
        ->check(CLI::Range(0.0, 100.0));
    calibrate.add_option("--rms-limit", about.rms_limit, "of the drive over a second, 0-1")
        ->check(CLI::Range(0.0, 1.0));
    calibrate.add_option("--out", options.out, "calibration file for the table");
    calibrate.add_flag("--json", options.json, "JSON instead of text on standard output");
    calibrate.callback([&options, &chosen] {
        if (options.signal.empty() && options.recording.empty()) {
            throw CLI::RequiredError("--signal FILE or --recording FILE");
        }
        chosen = [&options] { return run(options); };
    });
}

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

void add_generate_command(CLI::App& app, GenerateCommand& command,
                          std::function<Expected<Done>()>& chosen) {
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

void add_measured_options(CLI::App& sub, std::filesystem::path& set, std::filesystem::path& out,
                          bool& json) {
    sub.add_option("SET", set, "the set with the intended patterns")->required();
    sub.add_option("--out", out, "set file; the waveforms go to measured/ beside it")->required();
    sub.add_flag("--json", json, "JSON instead of text on standard output");
}

// A number that is left to the file where the option is not given.
void add_optional(CLI::App& sub, const char* name, std::optional<double>& target, Range range,
                  const char* help) {
    sub.add_option_function<double>(
           name, [&target](double value) { target = value; }, help)
        ->check(CLI::Range(range.low, range.high));
}

void add_import_command(CLI::App& app, ImportCommand& command,
                        std::function<Expected<Done>()>& chosen) {
    CLI::App& sub = *app.add_subcommand(
        "import", "recordings of patterns by an accelerometer, each behind its pattern");
    add_measured_options(sub, command.set, command.out, command.json);
    sub.add_option("RECORDING", command.recordings,
                   "tables (.csv, .txt) with or without a time column, or .wav; one or three axes")
        ->required();
    sub.add_option("--pattern", command.pattern,
                   "what all of them measure; else the pattern that a file is named after");
    const std::map<std::string, AccelerationUnit> units{{"g", AccelerationUnit::g},
                                                        {"m/s2", AccelerationUnit::m_per_s2},
                                                        {"V", AccelerationUnit::volt}};
    sub.add_option_function<std::string>(
           "--unit",
           [&command, units](const std::string& unit) { command.options.unit = units.at(unit); },
           "g, m/s2 or V; else what the table's first line says")
        ->check(CLI::IsMember({"g", "m/s2", "V"}));
    const auto range = [](Range of) { return CLI::Range(of.low, of.high); };
    sub.add_option("--sensitivity", command.options.sensitivity_v_per_g, "of the sensor, V/g")
        ->check(range(limits::kSensitivityVPerG));
    sub.add_option("--offset", command.options.offset_v, "of the sensor at 0 g, V")
        ->check(range(limits::kOffsetV));
    sub.add_option_function<std::string>(
           "--axis",
           [&command](const std::string& axis) {
               command.options.axis = axis == "all" ? 0 : static_cast<std::size_t>(axis[0] - '0');
           },
           "1, 2, 3, or all: three axes made one by DFT321")
        ->check(CLI::IsMember({"1", "2", "3", "all"}));
    add_optional(sub, "--rate", command.options.rate_hz, {100.0, 1e7},
                 "of tables without a time column, Hz");
    add_optional(sub, "--full-scale", command.options.full_scale, limits::kScaleG,
                 "of .wav files, in the unit");
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

void add_measure_command(CLI::App& app, MeasureCommand& command,
                         std::function<Expected<Done>()>& chosen) {
    CLI::App& sub =
        *app.add_subcommand("measure", "simulated measurements of patterns, labelled synthetic");
    add_measured_options(sub, command.set, command.out, command.json);
    sub.add_flag("--simulate", command.simulate,
                 "by a resonant actuator and a noisy sensor: it is no recording, and says so")
        ->required();
    sub.add_option("--pattern", command.pattern, "only this one");
    const auto number = [&sub](const char* name, double& target, Range range, const char* help) {
        sub.add_option(name, target, help)
            ->check(CLI::Range(range.low, range.high))
            ->capture_default_str();
    };
    ActuatorParams& actuator = command.actuator;
    number("--resonance", actuator.resonance_hz, limits::kResonanceHz, "of the actuator, Hz");
    number("--q", actuator.q, limits::kResonanceQ, "quality: gain there against far above");
    number("--gain", actuator.gain, limits::kActuatorGain, "far above the resonance");
    number("--onset", actuator.onset_s, limits::kOnsetS, "delay of the motion, s");
    number("--noise", actuator.noise_g, limits::kSensorNoiseG, "of the sensor, g rms");
    sub.add_option("--seed", actuator.seed, "of the noise")
        ->check(CLI::Range(limits::kSeed.low, limits::kSeed.high))
        ->capture_default_str();
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

constexpr const char* kSnapshotHelp =
    "a view as a picture, without a window; with --frames, as many as make a film";

constexpr const char* kFilmHelp =
    "A film of a folder of frames:\n"
    "  ffmpeg -framerate 30 -i FOLDER/frame_%04d.png -pix_fmt yuv420p film.mp4";

void add_moment_options(CLI::App& snapshot, SnapshotCommand& command) {
    snapshot.add_option("--at", command.at_s, "where the playhead is, s; else 0");
    snapshot
        .add_option("--frames", command.frames,
                    "draws so many pictures over time into the folder --out: frame_0001.png ...")
        ->check(CLI::Range(1, kMostFrames));
    snapshot.add_option("--from", command.from_s, "time of the first frame, s; else 0");
    snapshot.add_option("--to", command.to_s,
                        "time at which the last frame ends, s; else the end of the pattern");
    snapshot.footer(kFilmHelp);
}

void add_snapshot_command(CLI::App& app, SnapshotCommand& command,
                          std::function<Expected<Done>()>& chosen) {
    CLI::App& snapshot = add_command(app, "snapshot", kSnapshotHelp, command, chosen);
    add_rendering(snapshot, command.common);
    snapshot
        .add_option("--view", command.view, "window, physiology, wave, spectrum, matrix or space")
        ->check(CLI::IsMember({"window", "physiology", "wave", "spectrum", "matrix", "space"}));
    snapshot.add_option("--pattern", command.pattern, "pattern to show; else the first");
    snapshot.add_option("--with", command.with, "another pattern to compare it with");
    std::vector<std::string> keys;
    for (const Stage stage : kStages) keys.emplace_back(text_of(stage).key);
    snapshot.add_option("--stage", command.stage, "the stage to show large; else all of them")
        ->check(CLI::IsMember(keys));
    snapshot.add_flag("--tilted", command.tilted, "the receptors seen from the side");
    add_moment_options(snapshot, command);
    snapshot.add_option("--theme", command.theme, "dark or light")
        ->check(CLI::IsMember({"dark", "light"}));
    snapshot.add_option("--width", command.width, "pixels")->check(CLI::Range(64, 8192));
    snapshot.add_option("--height", command.height, "pixels")->check(CLI::Range(64, 8192));
    snapshot.add_option("--scale", command.scale, "size of text and marks, 0.75-4")
        ->check(CLI::Range(0.75, 4.0));
    snapshot.add_option("--out", command.out, "file, .png or .svg; with --frames a folder")
        ->required();
}

void add_study_design(CLI::App& study, StudyCommand& command) {
    const auto range = [](Range limits) { return CLI::Range(limits.low, limits.high); };
    CLI::App& design = *study.add_option_group("Design", "in place of the design in the set");
    design.add_option("--seed", command.seed, "of orders, sides and simulated answers")
        ->check(range(limits::kStudySeed));
    design.add_option("--repetitions", command.repetitions, "of every pair; the publication: 4")
        ->check(range(limits::kRepetitions));
    design.add_option("--attention", command.attention_pairs, "pairs of identical patterns")
        ->check(range(limits::kAttentionPairs));
    design.add_flag("--adaptive", command.adaptive,
                    "pairs in an order that settles the map early; not the publication's design");
    design.add_flag("--sorting", command.sorting,
                    "patterns sorted into groups, not rated by pairs");
}

void add_study_command(CLI::App& app, StudyCommand& command,
                       std::function<Expected<Done>()>& chosen) {
    CLI::App& study = add_command(
        app, "study", "a rating study: simulate participants, or collect what they said", command,
        chosen);
    CLI::App& task = *study.add_option_group("Task");
    task.add_option("--simulate", command.simulate, "so many synthetic participants into --out DIR")
        ->check(CLI::Range(1, 1000));
    task.add_option("--collect", command.collect,
                    "a folder of participants' files: who counts, "
                    "how far they agree, and their mean matrix");
    task.require_option(1);
    study.add_option("--out", command.out,
                     "folder for simulated participants; file for collected ratings, .csv");
    add_study_design(study, command);
    CLI::App& crowd = *study.add_option_group("Simulated", "participants that are none");
    crowd.add_option("--noise", command.noise, "standard deviation of a rating, points of 100")
        ->check(CLI::Range(0.0, 100.0));
    crowd.add_option("--bias", command.bias, "points added to every similarity")
        ->check(CLI::Range(-100.0, 100.0));
    crowd.add_option("--lapses", command.lapses, "share of trials that each answers blindly")
        ->check(CLI::Range(0.0, 1.0));
    crowd
        .add_option("--inattentive", command.inattentive,
                    "share of participants who answer blindly throughout")
        ->check(CLI::Range(0.0, 1.0));
    auto* map = crowd.add_option("--from-map", command.from_map,
                                 "coordinates that they feel by, as of tactspace space");
    crowd.add_option("--from-matrix", command.from_matrix, "dissimilarities that they feel by")
        ->excludes(map);
    CLI::App& rule = *study.add_option_group("Collected", "who counts, and what is written");
    rule.add_option("--above", command.attention_above,
                    "similarity that identical patterns must exceed; the publication: 80")
        ->check(CLI::Range(0.0, 100.0));
    rule.add_option("--failures", command.failures_allowed, "identical pairs that may be missed")
        ->check(CLI::Range(0, 100));
    rule.add_flag("--unfinished", command.unfinished, "count who did not come to the end, too");
    rule.add_flag("--everyone", command.everyone, "write excluded participants as well, marked");
    rule.add_option("--scaling", command.scaling, "of each participant: none, min-max or standard")
        ->check(CLI::IsMember({"none", "min-max", "standard"}));
    rule.add_option("--matrix", command.matrix, "file for the mean matrix, .csv");
}

void add_train_command(CLI::App& app, TrainCommand& command,
                       std::function<Expected<Done>()>& chosen) {
    CLI::App& train = add_command(
        app, "train", "the parameters of the model that agree best with ratings", command, chosen);
    add_rendering(train, command.common);
    add_only(train, command.common);
    add_ratings(train, command.ratings);
    train
        .add_option("--objective", command.objective,
                    "mean over the sets of Spearman's rho, or of its size: mean-rho, mean-abs-rho")
        ->check(CLI::IsMember({"mean-rho", "mean-abs-rho"}));
    train.add_option("--step", command.step, "of the weights from 0 to 1; 0.1 as published")
        ->check(fault_of_step);
    train
        .add_option("--leave-out", command.leave_out,
                    "fit without each of them and try on it: sets or participants")
        ->check(CLI::IsMember({"sets", "participants"}));
    train.add_option("--out", command.out,
                     "file for the parameters, for --model of other commands and the model bench");
}

void add_subset_command(CLI::App& app, SubsetCommand& command,
                        std::function<Expected<Done>()>& chosen) {
    CLI::App& subset = add_command(app, "subset", "the k most distinct patterns of a set, proven",
                                   command, chosen);
    subset.add_option("-k,--count", command.count, "how many to pick")
        ->required()
        ->check(CLI::Range(2, 10'000));
    subset
        .add_option("--objective", command.objective,
                    "max-min: the weakest pair as far apart as can be; max-sum: all pairs together")
        ->check(CLI::IsMember({"max-min", "max-sum"}));
    subset.add_option("--keep", command.keep, "a pattern to pick, as are locked ones; repeatable")
        ->allow_extra_args(false);
    subset.add_option("--drop", command.drop, "a pattern not to pick; repeatable")
        ->allow_extra_args(false);
    CLI::Option* metric =
        subset.add_option("--metric", command.metric, "pm unless another of those below")
            ->check(fault_of_metric);
    CLI::Option* matrix =
        subset.add_option("--matrix", command.matrix, "dissimilarities from a CSV file, by names");
    CLI::Option* ratings =
        subset.add_option("--ratings", command.ratings, "dissimilarities as people rated them");
    matrix->excludes(metric)->excludes(ratings);
    ratings->excludes(metric);
    subset.add_option("--time-limit", command.time_limit_s, "s; else 60")
        ->check(CLI::NonNegativeNumber);
    subset.add_option("--alternatives", command.alternatives, "how many of the next best to list")
        ->check(CLI::Range(0, 1000));
    subset.add_flag("--curve", command.curve, "also the weakest pair for other counts");
    subset
        .add_option("--sensitivity", command.draws,
                    "draws of what is uncertain in the model: how often each pattern is picked")
        ->check(CLI::Range(0, 100'000));
    subset.add_option("--out", command.out, "a set file for the subset");
    subset.add_option("--report", command.report,
                      "a folder for the subset, a page about it and the map");
    subset.footer(list_of_metrics());
}

void add_separate_command(CLI::App& app, SeparateCommand& command,
                          std::function<Expected<Done>()>& chosen) {
    CLI::App& separate = add_command(
        app, "separate", "the smallest changes that part two patterns people may confuse", command,
        chosen);
    separate.add_option("--pair", command.pair, "names of the two, with a comma between")
        ->required();
    separate.add_option("--change", command.change,
                        "the one of them to change; else either that is not locked");
    separate
        .add_option("--among", command.among,
                    "a pattern to keep away from, such as one of a subset; repeatable; else all")
        ->allow_extra_args(false);
    CLI::Option* closest =
        separate
            .add_option("--closest", command.percent,
                        "%, else 5: a change must bring the pattern farther from all that count "
                        "than so many of the pairs are apart, and than the pair is")
            ->check(CLI::Range(0.0, 100.0));
    separate.add_option("--threshold", command.threshold, "instead farther than this PM")
        ->check(CLI::NonNegativeNumber)
        ->excludes(closest);
}

void add_study_commands(CLI::App& app, Commands& commands,
                        std::function<Expected<Done>()>& chosen) {
    CompareCommand& options = commands.compare;
    CLI::App& compare = add_command(
        app, "compare", "how well metrics agree with people: rho and K of each", options, chosen);
    add_rendering(compare, options.common);
    add_ratings(compare, options.ratings);
    compare.add_option("--metric", options.metrics, "only these of those below")
        ->check(fault_of_metric);
    add_only(compare, options.common);
    compare.footer(list_of_metrics());
    compare.add_flag("--paper-mode", options.paper_mode,
                     "digits and averages as in Table 2 of Lim & Park 2023");

    add_train_command(app, commands.train, chosen);

    CLI::App& findings =
        *app.add_subcommand("findings", "what the publication found, checked one by one");
    add_threads(findings, commands.findings.threads);
    findings.add_flag("--json", commands.findings.json, "JSON instead of text");
    findings.callback([&] { chosen = [&found = commands.findings] { return run(found); }; });
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    CLI::App app("Shape vibrations and see which ones people will tell apart.", "tactspace");
    app.set_version_flag("--version", TACT_VERSION);
    std::vector<std::filesystem::path> sets;
    app.add_option("SET", sets, std::string("opens the window on it: ") + kSetHelp);
    Commands commands;
    std::function<Expected<Done>()> chosen = [&sets] { return run_main_window(sets); };
    add_prediction_commands(app, commands, chosen);
    add_pattern_commands(app, commands, chosen);
    add_play_commands(app, commands, chosen);
    add_calibrate_command(app, commands.calibrate, chosen);
    add_subset_command(app, commands.subset, chosen);
    add_separate_command(app, commands.separate, chosen);
    add_study_commands(app, commands, chosen);
    add_generate_command(app, commands.generate, chosen);
    add_study_command(app, commands.study, chosen);
    add_import_command(app, commands.import, chosen);
    add_measure_command(app, commands.measure, chosen);
    add_snapshot_command(app, commands.snapshot, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return app.exit(fault) == 0 ? 0 : 2;
    }
    const Expected<Done> answer = chosen();
    if (answer) return 0;
    std::cerr << "tactspace: " << answer.error().message << "\n";
    const int interrupted = interrupted_exit_code();
    return interrupted != 0 ? interrupted : 1;
}

}  // namespace tact
