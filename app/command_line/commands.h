// The subcommands of the program: what each is asked for, and the work.
//
// Results go to standard output (or --out), remarks and progress to standard error. Every function
// gives an Error whose sentence is all that the user needs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/calibration.h"
#include "model/algebra/set_edits.h"
#include "model/common/expected.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/measured_twin.h"
#include "model/study/who_counts.h"

namespace tact {

struct CommonOptions {
    std::vector<std::filesystem::path> sets;  // merged in order
    std::string actuator{};  // effects by this map (model/io/effects); empty: by their formats' own
    int threads = 0;         // 0: all cores
    bool json = false;
    std::string exported_as{};  // FORMAT[:ACTUATOR] (model/export): as they come back from it
    std::string
        rendered_by{};  // a key of devices/rumble/actuator_kind.h: patterns as it plays them
    double full_scale_g = 1.0;                     // that its full scale stands for
    double rendered_level = 1.0;                   // at which it plays them
    std::filesystem::path rendered_calibration{};  // in its place, of a voice coil; empty: none
    Side only = Side::both;                        // of the merged set
    bool strict = false;          // a file of a folder that cannot be read is an Error
    std::filesystem::path model;  // a file of parameters (model_file.h) instead of the set's own
};

// What people said of the sets of a command.
struct RatingFiles {
    std::vector<std::filesystem::path> files;  // all for one set, or one file or folder per set
    std::string scale = "guess";               // guess, similarity, dissimilarity
    std::string columns;                       // "a=stimA,b=stimB,.."; empty: the usual ones
    TableHints written;                        // of matrices beside them, too
    CountRule who;                             // participants by name
};

struct PredictCommand {
    CommonOptions common;
    std::string metric = "pm";  // a key of model/evaluation/metric.h
    std::filesystem::path out;  // empty: standard output
    std::filesystem::path image;
    bool resume = false;  // with the tiles that a stopped run left in OUT.tiles
    std::string part;     // "3/16": the tiles of one of 16 runs, which are kept and no matrix
    bool join = false;    // the matrix of what such runs have kept
    // For directional metrics: the earlier pattern of a pair is the reference.
    bool first_as_reference = false;
};
Expected<Done> run(const PredictCommand& command);

struct SpaceCommand {
    CommonOptions common;
    std::string metric = "pm";       // a key of model/evaluation/metric.h, or instead ...
    bool people = false;             // ... of what people said, by the set file ...
    RatingFiles ratings;             // ... or by these; or ...
    std::filesystem::path matrix;    // ... of this matrix
    std::filesystem::path align_to;  // turned onto this map, coordinates; empty: as it is
    int dimensions = 3;
    int starts = -1;  // random ones; -1: by the number of patterns
    std::filesystem::path out;
    std::filesystem::path image;
};
Expected<Done> run(const SpaceCommand& command);

struct StagesCommand {
    CommonOptions common;
    std::string pattern;
    std::filesystem::path out;  // a folder
};
Expected<Done> run(const StagesCommand& command);

struct LessonCommand {
    std::string language;           // by its code; empty: the first
    bool hand_on = false;           // the .html is for another teacher
    std::string lesson;             // a file, or the name of one that comes with the program
    std::filesystem::path out;      // .html: a student sheet; a lesson file; empty: text
    std::filesystem::path answers;  // the table of what students answered goes there
};
Expected<Done> run(const LessonCommand& command);

struct RenderCommand {
    CommonOptions common;
    std::string format = "wav";  // wav, txt, csv
    std::filesystem::path out;   // a folder
};
Expected<Done> run(const RenderCommand& command);

struct ExportCommand {
    CommonOptions common;
    std::string format;                 // a key of model/io/formats/write_effect.h
    std::vector<std::string> patterns;  // by name; empty: all
    std::string onto;                   // an actuator map, its name or file; empty: the format's
    std::optional<double> rate_hz;      // of WAV and CSV; none: the format's
    std::string bits;                   // of WAV: "16", "24", "float"; empty: 24
    int count = 0;                      // of the subset that is held against it; 0: usual
    bool without_loss = false;          // nothing is predicted
    std::filesystem::path out;          // a folder
    bool overwrite = false;
};
Expected<Done> run(const ExportCommand& command);

struct SnapshotCommand {
    CommonOptions common;
    std::string view = "window";   // also physiology, wave, spectrum, firing, tables, matrix, space
    std::string pattern;           // but for tables, matrix, space; empty: the first
    std::string with;              // for window and physiology: compared with this one ...
    std::string stage;             // ... at this stage, large; a key of app/physiology/physiology.h
    std::optional<double> at_s;    // ... with the playhead there
    bool tilted = false;           // ... and the receptors
    bool textbook = false;         // measured facts over the stages
    int frames = 0;                // of a film, or of a sequence in a folder; 0: a single picture
    std::optional<double> slower;  // the same by how much slower than life it goes
    bool figures = false;          // every stage as an SVG in the folder `out`
    std::optional<double> from_s;
    std::optional<double> to_s;
    std::string theme = "dark";
    int width = 1600;
    int height = 1000;
    double scale = 1.0;
    std::filesystem::path out;
};
Expected<Done> run(const SnapshotCommand& command);

struct ManualCommand {
    std::filesystem::path out;  // a page, .html
};
Expected<Done> run(const ManualCommand& command);

struct CompareCommand {
    CommonOptions common;  // sets are not merged: each has its own ratings
    RatingFiles ratings;
    std::vector<std::string> metrics;       // empty: all
    std::vector<std::string> metrics_from;  // files of matrices, or functions in Python
    std::vector<std::string> given;         // duration, level, or files of matrices
    int dimensions = 3;                     // of the maps
    bool paper_mode = false;                // Table 2's digits and averages
    bool methods = false;                   // and a paragraph on how
    // Tables for other programs; empty: none.
    std::filesystem::path csv;              // a row a metric
    std::filesystem::path people_csv;       // a row a participant and metric
    std::filesystem::path differences_csv;  // a row a difference
    std::filesystem::path out;              // empty: standard output
};
Expected<Done> run(const CompareCommand& command);

struct GenerateCommand {
    std::filesystem::path spec;  // a generator, or a set file that has one
    std::filesystem::path out;   // a set file; empty: only counted
    bool count = false;          // how many patterns it would be, and nothing else
    bool json = false;
};
Expected<Done> run(const GenerateCommand& command);

// The tables and figures of the publication, of one's own sets.
struct PaperCommand {
    CommonOptions common;  // sets are not merged: each has its own ratings
    RatingFiles ratings;
    std::vector<std::string> metrics_from;  // as in CompareCommand
    std::string along;          // a parameter that the maps are joined along; empty: by the set
    std::filesystem::path out;  // a folder
};
Expected<Done> run(const PaperCommand& command);

// A study that is not run yet: how many people, which patterns.
struct PlanCommand {
    CommonOptions common;
    std::string people = "5..40";  // A..B, or numbers with commas between
    std::string pairs = "all";     // that each person rates, or a number
    std::string rival = "msm";     // a key of model/evaluation/metric.h
    RatingFiles pilot;             // what is assumed is as these people have it
    std::optional<double> rho;     // or as it is stated
    std::optional<double> reliability;
    int studies = 200;  // simulated, of each number of people
    int seed = 12;
    int decide = 0;             // patterns on which the two disagree most; 0: all
    std::filesystem::path out;  // a set of these
    std::filesystem::path csv;
    std::filesystem::path preregister;  // a folder: the plan frozen, and a page
};
Expected<Done> run(const PlanCommand& command);

struct StudyCommand {
    CommonOptions common;
    int simulate = 0;                           // number of simulated participants ...
    std::filesystem::path collect;              // ... or what is in this folder
    std::string pack;                           // ... or this program is to ask: jspsych, psychopy
    int participants = 40;                      // that a pack has trials for
    std::vector<std::filesystem::path> unpack;  // ... or its answers become participants
    std::filesystem::path out;                  // folder for participants, or file for ratings
    bool sorting = false;                       // into groups, instead of rating pairs
    // In place of the design in the set.
    std::optional<int> seed;
    std::optional<int> repetitions;
    std::optional<int> attention_pairs;
    bool adaptive = false;
    // How participants are simulated.
    double noise = 10.0;
    double bias = 0.0;
    double lapses = 0.0;
    double inattentive = 0.0;  // share of the participants who answer blindly
    std::filesystem::path from_map;
    std::filesystem::path from_matrix;
    TableHints written;  // of that matrix
    // Options of what is collected.
    std::optional<double> attention_above;
    std::optional<int> failures_allowed;
    bool unfinished = false;
    bool everyone = false;
    CountRule who;                 // participants by name
    std::string scaling = "none";  // none, min-max, standard
    std::filesystem::path matrix;
    std::optional<int> weights;      // of each participant, in a map of this many dimensions
    std::filesystem::path report;    // a folder of tables, a page and scripts
    std::filesystem::path planned;   // its preregistration: what departs from it is marked
    std::filesystem::path psych_ds;  // a folder: a dataset for an archive
    std::filesystem::path rdms;      // .npz: each person's matrix
};
Expected<Done> run(const StudyCommand& command);

struct ImportCommand {
    std::filesystem::path set;
    std::vector<std::filesystem::path> recordings;
    std::string pattern;  // that all of them measure; empty: by their names
    AccelerationOptions options;
    std::filesystem::path out;  // a set file
    bool json = false;
};
Expected<Done> run(const ImportCommand& command);

struct FromSoundCommand {
    std::vector<std::filesystem::path> sounds;
    std::string actuator;                // a bundled one or a file; empty: the usual one
    bool no_accents = false;             // what is short stays in the envelope
    std::optional<double> full_scale_g;  // default: the sidecar's, then the actuator's
    bool without_loss = false;           // nothing is predicted
    std::filesystem::path out;           // a set file
    int threads = 0;                     // 0: all cores
    bool json = false;
};
Expected<Done> run(const FromSoundCommand& command);

struct LibraryCommand {
    std::filesystem::path folder;
    std::string words;            // that all have; empty: all
    std::vector<double> shape;    // strengths at equal steps; empty: none is asked for
    std::string like;             // a file with one vibration, or the name of an entry; or empty
    std::string target;           // FORMAT[:ACTUATOR]: compared as they come back from it
    std::filesystem::path model;  // a file of parameters; empty: the trained ones
    std::size_t most = 0;         // entries that are listed; 0: all
    std::filesystem::path out;    // a set file of those that are listed; empty: none
    bool without_index = false;
    int threads = 0;  // 0: all cores
    bool json = false;
};
Expected<Done> run(const LibraryCommand& command);

struct MeasureCommand {
    std::filesystem::path set;
    bool simulate = false;  // has to be said: nothing else is possible
    std::string pattern;    // empty: all that measure nothing themselves
    ActuatorParams actuator;
    std::filesystem::path out;  // a set file
    bool json = false;
};
Expected<Done> run(const MeasureCommand& command);

struct TrainCommand {
    CommonOptions common;  // sets are not merged: each has its own ratings
    RatingFiles ratings;
    std::string objective = "mean-rho";  // mean-rho, mean-abs-rho
    double step = 0.1;                   // of a weight
    std::string leave_out;               // empty, sets, participants, patterns
    std::filesystem::path csv;           // a row a set, and what was left out
    std::filesystem::path out;           // for the parameters
};
Expected<Done> run(const TrainCommand& command);

// Empty where weights from 0 to 1 have whole steps of this.
std::string fault_of_step(const std::string& text);

struct SubsetCommand {
    CommonOptions common;
    int count = 8;
    std::string objective = "max-min";  // or max-sum
    std::vector<std::string> keep;      // besides the locked patterns
    std::vector<std::string> drop;      // besides those dropped in the set
    std::string metric = "pm";
    std::filesystem::path matrix;  // instead of a metric
    std::vector<std::filesystem::path> ratings;
    std::string columns;  // of the ratings
    TableHints written;   // of the matrix or the ratings
    double time_limit_s = 60.0;
    int alternatives = 0;
    bool curve = false;
    int draws = 0;                 // of uncertain models; 0: none
    bool include_unfelt = false;   // may be picked, too
    std::filesystem::path out;     // a set file for the subset
    std::filesystem::path report;  // a folder for the set, a page and the map
};
Expected<Done> run(const SubsetCommand& command);

struct ReportCommand {
    CommonOptions common;
    std::optional<int> count;     // of the most distinct; none: 8, or half of a small set
    std::string confused_at;      // a number, or "A,B"; empty: the weakest pair of those
    int draws = 0;                // of uncertain models: how sure; 0: none
    double time_limit_s = 60.0;   // of the search
    bool include_unfelt = false;  // may be picked, too
    std::filesystem::path out;    // a page, .html
};
Expected<Done> run(const ReportCommand& command);

struct GroupsCommand {
    CommonOptions common;
    std::optional<int> count;      // of groups ...
    std::optional<double> cut;     // ... or where the tree is cut, PM; neither: a usual count
    std::filesystem::path matrix;  // instead of PM
    TableHints written;
    std::filesystem::path out;      // a table, .csv
    std::filesystem::path central;  // a set file for the patterns that stand for the groups
};
Expected<Done> run(const GroupsCommand& command);

struct SeparateCommand {
    CommonOptions common;
    std::string pair;                 // "A,B"
    std::string change;               // one of the two; empty: either, unless it is locked
    std::vector<std::string> among;   // others that count; empty: all
    double percent = 5.0;             // of the pairs are too close ...
    std::optional<double> threshold;  // ... or those up to this PM
    double time_limit_s = 120.0;      // of the search, for each of the two
    std::filesystem::path out;        // empty: standard output
};
Expected<Done> run(const SeparateCommand& command);

struct StepsCommand {
    CommonOptions common;
    std::string from;
    std::string to;
    int count = 5;              // with both ends
    std::string parameter;      // along this number of `from` alone; empty: along all
    std::string metric = "pm";  // before ranks, or nc or oc
    std::filesystem::path out;  // a set file
};
Expected<Done> run(const StepsCommand& command);

struct EditCommand {
    CommonOptions common;
    std::vector<std::string> patterns;  // by name; empty: all that are not locked
    std::vector<NamedEdit> edits;       // in the order in which they were given
    std::string as;  // the result is a new pattern of this name; empty: it takes the place
    std::filesystem::path out;  // a set file
};
Expected<Done> run(const EditCommand& command);

struct FindingsCommand {
    int threads = 0;
    bool json = false;
    bool morse = false;         // instead: the metrics against what people heard
    bool variants = false;      // instead: what changes of the model do to both
    std::filesystem::path csv;  // the same as a table
};
Expected<Done> run(const FindingsCommand& command);

struct DevicesCommand {
    bool json = false;
};
Expected<Done> run(const DevicesCommand& command);

// Either the signal or the recording of it.
struct CalibrateCommand {
    std::filesystem::path signal;
    std::filesystem::path recording;
    AccelerationOptions how;  // it is read
    bool sweep = false;
    double low_hz = 20.0;
    double high_hz = 500.0;
    Calibration about;          // without its points
    std::filesystem::path out;  // empty: only the table
    bool json = false;
};
Expected<Done> run(const CalibrateCommand& command);

struct PhonesCommand {
    CommonOptions common;
    std::string host;            // address of the interface; empty: the first private one
    int port = 0;                // 0: any that is free
    std::filesystem::path rate;  // a folder: the phones rate all pairs together
    int repetitions = 1;         // of every pair
    int trials = 0;              // odd-one-out trials on each phone; 0: none
    std::uint64_t seed = 1;      // of the trials' order
    std::filesystem::path out;   // a set file: what was told apart is kept there with the set
};
Expected<Done> run(const PhonesCommand& command);

struct PlayCommand {
    CommonOptions common;
    std::string pattern;
    bool all = false;                   // instead, one after the other
    std::string device;                 // empty: the only one
    std::string channel;                // number or name; empty: the first
    int of_channels = 0;                // of a sound server; 0: what it says, or 2, or enough
    double level = 0.1;                 // of full scale
    double full_scale_g = 1.0;          // that full scale stands for
    std::filesystem::path calibration;  // in its place; empty: none
    double gap_s = 0.5;                 // between patterns
    double buffer_ms = 100.0;           // of an output
    bool no_protection = false;         // of an actuator without a calibration
    std::optional<double> longest_s;    // that one plays on end
    bool loop = false;
};
Expected<Done> run(const PlayCommand& command);

}  // namespace tact
