// The options of the subcommands: what each adds to the command line, and what several share.
//
// Included by the files named *_options.cpp, by command_line.cpp and by one test alone, as CLI11
// takes seconds to compile. What an option sets lives in the command; `chosen` becomes the work of
// the one that is given.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/command_line/commands.h"
#include "model/common/units.h"

namespace tact {

using Chosen = std::function<Expected<Done>()>;

inline constexpr const char* kSetHelp =
    "a .tactspace.json file, a folder or zip file of .txt, .wav or effect files, or single ones; "
    "effects are "
    "AHAP, .haptic, HJIF, .haps, .he, .hla, Pulsar presets, Android's XML or timings as JSON, "
    "on-off times of browsers as JSON";

// For every option that is a number, in the place of CLI::Range: that one lets NaN through, and all
// that strtod and strtol take, such as 0x10, 1e999 and the octal 010.
CLI::Validator within(double low, double high);
CLI::Validator within(Range range);

void add_threads(CLI::App& command, int& threads);
void add_common(CLI::App& command, CommonOptions& options);
void add_ratings(CLI::App& command, RatingFiles& ratings);

inline constexpr const char* kAnswerColumnsHelp =
    "which columns of --ratings hold what, where they go by other names than usual: "
    "a=stimA,b=stimB,rating=slider.response,participant=pid";

// --separator and --decimal, of the tables that the command reads.
void add_table_hints(CLI::App& command, TableHints& written);
void add_who_counts(CLI::App& command, CountRule& who);

// The patterns as a device plays them, in the place of what was meant.
void add_rendering(CLI::App& command, CommonOptions& options);
void add_exporting(CLI::App& command, CommonOptions& options);

// For the commands whose answer two sides of a set can be compared by.
void add_only(CLI::App& command, CommonOptions& options);

// Empty where there is such a metric, as CLI11 wants it.
std::string fault_of_metric(const std::string& key);
std::string list_of_metrics();

// Registers a subcommand whose options live in `command`; `chosen` is set to its work.
template <class Command>
CLI::App& add_command(CLI::App& app, const char* name, const char* help, Command& command,
                      Chosen& chosen) {
    CLI::App& sub = *app.add_subcommand(name, help);
    add_common(sub, command.common);
    sub.callback([&] { chosen = [&command] { return run(command); }; });
    return sub;
}

// model_options.cpp
void add_predict_command(CLI::App& app, PredictCommand& command, Chosen& chosen);
void add_space_command(CLI::App& app, SpaceCommand& command, Chosen& chosen);
void add_subset_command(CLI::App& app, SubsetCommand& command, Chosen& chosen);
void add_report_command(CLI::App& app, ReportCommand& command, Chosen& chosen);
void add_groups_command(CLI::App& app, GroupsCommand& command, Chosen& chosen);
void add_separate_command(CLI::App& app, SeparateCommand& command, Chosen& chosen);
void add_steps_command(CLI::App& app, StepsCommand& command, Chosen& chosen);
void add_findings_command(CLI::App& app, FindingsCommand& command, Chosen& chosen);

// pattern_options.cpp
void add_stages_command(CLI::App& app, StagesCommand& command, Chosen& chosen);
void add_lesson_command(CLI::App& app, LessonCommand& command, Chosen& chosen);
void add_render_command(CLI::App& app, RenderCommand& command, Chosen& chosen);
void add_export_command(CLI::App& app, ExportCommand& command, Chosen& chosen);
void add_generate_command(CLI::App& app, GenerateCommand& command, Chosen& chosen);
void add_edit_command(CLI::App& app, EditCommand& command, Chosen& chosen);
void add_snapshot_command(CLI::App& app, SnapshotCommand& command, Chosen& chosen);
void add_manual_command(CLI::App& app, ManualCommand& command, Chosen& chosen);

// actuator_options.cpp
void add_devices_command(CLI::App& app, DevicesCommand& command, Chosen& chosen);
void add_phones_command(CLI::App& app, PhonesCommand& options, Chosen& chosen);
void add_play_command(CLI::App& app, PlayCommand& options, Chosen& chosen);
void add_calibrate_command(CLI::App& app, CalibrateCommand& options, Chosen& chosen);
void add_import_command(CLI::App& app, ImportCommand& command, Chosen& chosen);
void add_measure_command(CLI::App& app, MeasureCommand& command, Chosen& chosen);
void add_from_sound_command(CLI::App& app, FromSoundCommand& command, Chosen& chosen);
void add_library_command(CLI::App& app, LibraryCommand& command, Chosen& chosen);

// people_options.cpp
void add_paper_command(CLI::App& app, PaperCommand& command, Chosen& chosen);
void add_plan_command(CLI::App& app, PlanCommand& command, Chosen& chosen);
void add_compare_command(CLI::App& app, CompareCommand& options, Chosen& chosen);
void add_study_command(CLI::App& app, StudyCommand& command, Chosen& chosen);
void add_train_command(CLI::App& app, TrainCommand& command, Chosen& chosen);

// command_line.cpp: what is asked of each subcommand, and all of them on a command line.
struct Commands {
    PredictCommand predict;
    SpaceCommand space;
    StagesCommand stages;
    LessonCommand lesson;
    RenderCommand render;
    ExportCommand exported;
    SnapshotCommand snapshot;
    CompareCommand compare;
    StudyCommand study;
    TrainCommand train;
    SubsetCommand subset;
    ReportCommand report;
    GroupsCommand groups;
    SeparateCommand separate;
    StepsCommand steps;
    PlanCommand plan;
    PaperCommand paper;
    EditCommand edit;
    FindingsCommand findings;
    DevicesCommand devices;
    PlayCommand play;
    PhonesCommand phones;
    CalibrateCommand calibrate;
    GenerateCommand generate;
    ImportCommand import;
    MeasureCommand measure;
    FromSoundCommand from_sound;
    LibraryCommand library;
    ManualCommand manual;
};
void add_commands(CLI::App& app, Commands& commands, Chosen& chosen);

}  // namespace tact
