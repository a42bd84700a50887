// Actuators: playing on them, how strong they are, and recordings of what they did.
#include "app/command_line/options.h"

#include <map>

#include "model/io/effects/actuator_map.h"
#include "model/sound/from_sound.h"

namespace tact {

namespace {

constexpr const char* kDeviceHelp =
    "id or name of the device, or a part of its name that no other has; see tactspace devices. "
    "Another one is never played on: where an output of a sound server goes, the pattern ends with "
    "it";

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
        ->check(within(range));
}

// How a recording of accelerations is read; `full_scale` is the name, or names, of that option.
void add_recording_options(CLI::App& sub, AccelerationOptions& options, const char* full_scale) {
    const std::map<std::string, AccelerationUnit> units{{"g", AccelerationUnit::g},
                                                        {"m/s2", AccelerationUnit::m_per_s2},
                                                        {"V", AccelerationUnit::volt}};
    sub.add_option_function<std::string>(
           "--unit", [&options, units](const std::string& unit) { options.unit = units.at(unit); },
           "g, m/s2 or V; default: what the table's first line says")
        ->check(CLI::IsMember({"g", "m/s2", "V"}));
    sub.add_option("--sensitivity", options.sensitivity_v_per_g, "of the sensor, V/g")
        ->check(within(limits::kSensitivityVPerG));
    sub.add_option("--offset", options.offset_v, "of the sensor at 0 g, V")
        ->check(within(limits::kOffsetV));
    sub.add_option_function<std::string>(
           "--axis",
           [&options](const std::string& axis) {
               options.axis = axis == "all" ? 0 : static_cast<std::size_t>(axis[0] - '0');
           },
           "1, 2, 3, or all: three axes made one by DFT321")
        ->check(CLI::IsMember({"1", "2", "3", "all"}));
    add_optional(sub, "--rate", options.rate_hz, {100.0, 1e7},
                 "of tables without a time column, Hz");
    AccelerationTableOptions& table = options.table;
    sub.add_option_function<std::string>(
        "--columns",
        [&table](const std::string& text) {
            Expected<AccelerationColumns> columns = acceleration_columns(text);
            if (!columns) throw CLI::ValidationError("--columns", columns.error().message);
            table.columns = *std::move(columns);
        },
        "which columns of a table hold what, by name, or by number where they have none: "
        "time=t,x=ax,y=ay,z=az");
    std::map<std::string, TimeUnit> time_units;
    for (const char* name : kTimeUnits) {
        time_units.emplace(name, static_cast<TimeUnit>(time_units.size()));
    }
    sub.add_option_function<std::string>(
           "--time-unit",
           [&table, time_units](const std::string& unit) { table.time_unit = time_units.at(unit); },
           "s, ms, us or ns; default: what the name of the column says")
        ->check(CLI::IsMember(time_units));
    add_table_hints(sub, table.written);
    add_optional(sub, full_scale, options.full_scale, limits::kScaleG,
                 "of .wav files, in the unit");
}

}  // namespace

void add_devices_command(CLI::App& app, DevicesCommand& command, Chosen& chosen) {
    CLI::App& devices = *app.add_subcommand("devices", "what there is to play on");
    devices.add_flag("--json", command.json, "JSON instead of text");
    devices.callback([&] { chosen = [&command] { return run(command); }; });
}

void add_phones_command(CLI::App& app, PhonesCommand& options, Chosen& chosen) {
    CLI::App& phones = add_command(
        app, "phones", "a page for the phones in the room, to feel, tell apart and rate", options,
        chosen);
    phones.add_option("--host", options.host,
                      "address of this computer in the phones' network; default: the first private "
                      "one");
    phones.add_option("--port", options.port, "default: any that is free")
        ->check(within(0, 65'535));
    auto* rate = phones.add_option("--rate", options.rate,
                                   "a folder: every phone rates all pairs of the set's study, ten "
                                   "patterns at most, in an order of its own; \"tactspace study\" "
                                   "reads it");
    phones
        .add_option("--repetitions", options.repetitions,
                    "how often each pair is rated; default: 1")
        ->check(within(limits::kRepetitions))
        ->needs(rate);
    auto* trials = phones
                       .add_option("--trials", options.trials,
                                   "on each phone, this many trials of three plays, one of "
                                   "which is another pattern: which pairs are told apart there")
                       ->check(within(limits::kFewestOddTrials, limits::kMostOddTrials))
                       ->excludes(rate);
    phones.add_option("--seed", options.seed, "of the order of the trials; default: 1")
        ->check(within(limits::kStudySeed))
        ->needs(trials);
    phones
        .add_option("--out", options.out,
                    "set file with what was told apart, as measured on one person each")
        ->needs(trials);
}

void add_play_command(CLI::App& app, PlayCommand& options, Chosen& chosen) {
    CLI::App& play =
        add_command(app, "play", "patterns on an actuator, to be felt", options, chosen);
    auto* pattern = play.add_option("--pattern", options.pattern, "name of the pattern");
    play.add_flag("--all", options.all, "every pattern instead, one after the other")
        ->excludes(pattern);
    play.add_option("--gap", options.gap_s, "silence between two of them, s")
        ->check(within(0.0, 60.0));
    play.add_option("--device", options.device, kDeviceHelp);
    play.add_option("--channel", options.channel, "number from 1, or name; default: the first");
    play.add_option("--channels", options.of_channels,
                    "how many the output behind a sound server has, where the server does not say; "
                    "PULSE_SINK says which output of PulseAudio's")
        ->check(within(1, 8));
    play.add_option("--level", options.level, "how strong, 0-1; default: 0.1")
        ->check(within(0.0, 1.0));
    play.add_option("--full-scale", options.full_scale_g,
                    "acceleration that full scale stands for without a calibration, g; default: 1")
        ->check(within(1e-3, 1e3));
    play.add_option("--calibration", options.calibration,
                    "of this device and channel, as tactspace calibrate makes it: strengths are "
                    "then true at --level 1, and all of a pattern is turned down that is more than "
                    "the actuator bears");
    play.add_flag("--no-protection", options.no_protection,
                  "without a calibration: also what is slower than 16 Hz, of which less than a "
                  "quarter passes below 10 Hz, without the ramps of 5 ms at both ends, and for "
                  "however long; an actuator may be harmed");
    play.add_option("--longest", options.longest_s,
                    "that a pattern or a loop may play on end, s; default: 60, and no limit with "
                    "--no-protection or a calibration that has an rms limit. Patterns in "
                    "turn count as one, less the rests between them, against 60 s or more")
        ->check(within(0.1, 86'400.0));
    play.add_option(
            "--buffer", options.buffer_ms,
            "of sound rendered ahead, ms; default: 100. Less follows --level sooner and has "
            "gaps on a busy computer. A stop by Ctrl+C is a fade of 5 ms; on a card without a "
            "sound server it is a cut with more than 10")
        ->check(within(5.0, 2000.0));
    play.add_flag("--loop", options.loop, "until Ctrl+C");
    play.callback([&options, &chosen] {
        if (options.pattern.empty() && !options.all) {
            throw CLI::RequiredError("--pattern NAME or --all");
        }
        chosen = [&options] { return run(options); };
    });
}

void add_calibrate_command(CLI::App& app, CalibrateCommand& options, Chosen& chosen) {
    CLI::App& calibrate = *app.add_subcommand(
        "calibrate", "how strong an actuator is: the signal to play, and what its recording says");
    auto* signal = calibrate.add_option("--signal", options.signal,
                                        "WAV file to write, to be played at full level");
    auto* recording = calibrate.add_option(
        "--recording", options.recording,
        "what the sensor recorded meanwhile (.csv, .txt, .wav), begun before it");
    signal->excludes(recording);
    add_recording_options(calibrate, options.how, "--full-scale,--scale");
    calibrate.add_flag("--sweep", options.sweep,
                       "three sweeps of 18 s, each stronger, instead of tones of 0.6 s");
    calibrate.add_option("--low", options.low_hz, "lowest frequency, Hz; default: 20")
        ->check(within(1.0, 2000.0));
    calibrate.add_option("--high", options.high_hz, "highest frequency, Hz; default: 500")
        ->check(within(1.0, 2000.0));
    Calibration& about = options.about;
    calibrate.add_option("--device", about.device, "its id; see tactspace devices");
    calibrate.add_option("--channel", about.channel, "number from 1")->check(within(1, 256));
    calibrate.add_option("--actuator", about.actuator, "its name");
    calibrate.add_option("--mounting", about.mounting, "how it is held or fixed");
    calibrate.add_option("--gain-note", about.gain_note, "settings of amplifier and mixer");
    calibrate.add_option("--sensor", about.sensor, "what it was recorded with");
    calibrate.add_option("--date", about.date, "of the measurement, YYYY-MM-DD");
    calibrate.add_option("--load-mass", about.load_mass_g, "that it moves, g")
        ->check(within(0.0, 1e5));
    calibrate.add_option("--excursion-limit", about.excursion_limit_mm, "peak, mm")
        ->check(within(0.0, 100.0));
    calibrate.add_option("--rms-limit", about.rms_limit, "of the drive over a second, 0-1")
        ->check(within(0.0, 1.0));
    calibrate.add_option("--out", options.out, "calibration file for the table")->excludes(signal);
    calibrate.add_flag("--json", options.json, "JSON instead of text on standard output");
    calibrate.callback([&options, &chosen] {
        if (options.signal.empty() && options.recording.empty()) {
            throw CLI::RequiredError("--signal FILE or --recording FILE");
        }
        chosen = [&options] { return run(options); };
    });
}

void add_import_command(CLI::App& app, ImportCommand& command, Chosen& chosen) {
    CLI::App& sub = *app.add_subcommand(
        "import", "recordings of patterns by an accelerometer, each behind its pattern");
    add_measured_options(sub, command.set, command.out, command.json);
    sub.add_option("RECORDING", command.recordings,
                   "tables (.csv, .txt) with or without a time column, or .wav; one or three axes")
        ->required();
    sub.add_option(
        "--pattern", command.pattern,
        "the pattern that all of them measure; default: the one that a file is named after");
    add_recording_options(sub, command.options, "--full-scale");
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

void add_measure_command(CLI::App& app, MeasureCommand& command, Chosen& chosen) {
    CLI::App& sub =
        *app.add_subcommand("measure", "simulated measurements of patterns, labelled synthetic");
    add_measured_options(sub, command.set, command.out, command.json);
    sub.add_flag("--simulate", command.simulate,
                 "by a resonant actuator and a noisy sensor: it is no recording, and says so")
        ->required();
    sub.add_option("--pattern", command.pattern, "only this one");
    const auto number = [&sub](const char* name, double& target, Range range, const char* help) {
        sub.add_option(name, target, help)->check(within(range))->capture_default_str();
    };
    ActuatorParams& actuator = command.actuator;
    number("--resonance", actuator.resonance_hz, limits::kResonanceHz, "of the actuator, Hz");
    number("--q", actuator.q, limits::kResonanceQ, "quality: gain there against far above");
    number("--gain", actuator.gain, limits::kActuatorGain, "far above the resonance");
    number("--onset", actuator.onset_s, limits::kOnsetS, "delay of the motion, s");
    number("--noise", actuator.noise_g, limits::kSensorNoiseG, "of the sensor, g rms");
    sub.add_option("--seed", actuator.seed, "of the noise")
        ->check(within(limits::kSeed))
        ->capture_default_str();
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

void add_from_sound_command(CLI::App& app, FromSoundCommand& command, Chosen& chosen) {
    CLI::App& sub = *app.add_subcommand(
        "from-sound", "sounds as patterns: envelope, frequency and accents in an actuator's band");
    sub.add_option(
           "SOUND", command.sounds,
           "WAV, FLAC, Ogg, MP3, AIFF and what else libsndfile reads, of at most 60 s; or a "
           "recording; a pattern each")
        ->required();
    sub.add_option("--out", command.out, "set file for the patterns")->required();
    sub.add_option("--actuator", command.actuator,
                   "whose band and g at full scale count: a file (.acf or .json) or one of " +
                       actuator_names() + "; default: " + kUsualActuator);
    sub.add_flag("--no-accents", command.no_accents,
                 "what lasts less than 60 ms stays in the envelope");
    add_optional(
        sub, "--full-scale", command.full_scale_g, limits::kScaleG,
        "g that full scale of the sound stands for; default: as its .json beside it says, or "
        "the actuator's");
    sub.add_flag("--without-loss", command.without_loss,
                 "without PM between the pattern and the sound");
    add_threads(sub, command.threads);
    sub.add_flag("--json", command.json, "JSON instead of text on standard output");
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

void add_library_command(CLI::App& app, LibraryCommand& command, Chosen& chosen) {
    CLI::App& sub = *app.add_subcommand(
        "library", "a folder of effects: list it, search it, find what feels like one of them");
    sub.add_option("FOLDER", command.folder,
                   "with effects, recordings and sets in it and in its folders; what is found is "
                   "kept there, in .tactspace-library.json")
        ->required();
    sub.add_option("--search", command.words,
                   "words that all of name, description, tags, path, format and licence have");
    auto* shape = sub.add_option("--shape", command.shape,
                                 "by strength over time: two strengths or more at equal steps from "
                                 "beginning to end, such as 0 1 0.2 0; to be given last")
                      ->check(within(0.0, 1e6));
    auto* like = sub.add_option("--like", command.like,
                                "by how alike they feel, the nearest first: to the one effect or "
                                "recording of a file, or to the one of a name in the library");
    like->excludes(shape);
    sub.add_option("--for", command.target,
                   "what could take its place on another device: each as it comes back from "
                   "FORMAT[:ACTUATOR], one of the formats of \"export\"")
        ->needs(like);
    sub.add_option("--model", command.model,
                   "parameters of PM from this file; default: the trained ones")
        ->needs(like);
    sub.add_option("-n,--most", command.most, "how many are listed; default: all")
        ->check(within(1.0, 1e6));
    sub.add_option("--out", command.out, "set file for those that are listed");
    sub.add_flag("--no-index", command.without_index,
                 "all files are read, and nothing is kept in the folder");
    add_threads(sub, command.threads);
    sub.add_flag("--json", command.json, "JSON instead of text on standard output");
    sub.callback([&] { chosen = [&command] { return run(command); }; });
}

}  // namespace tact
