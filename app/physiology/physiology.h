// The stages of the model, live: signals, files, what is opened.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/rendering/rendering.h"
#include "app/ui/ui.h"
#include "devices/calibration/rendering.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"
#include "model/set/pattern_set.h"
#include "model/textbook/textbook_beside.h"

namespace tact {

// The stages of the model's way from the skin to the two signals that it compares, and what there
// is to say about each.
//
// Source    Lim & Park 2023, sections 3-5; of what is said of the body, `source`. The sentences are
//           ours. Held against their abstracts: Bolanowski et al. 1988 (four channels with bands of
//           their own), Saal & Bensmaia 2014 (most cortical neurons get convergent input),
//           Johansson & Vallbo 1979 (densities), Mountcastle et al. 1967 (two sets of fibres),
//           Freeman & Johnson 1982 (impulses in step with the cycle),
//           Barrett-Snyder et al. 2021 (the Pacinian capsule as a filter).

enum class Stage {
    vibration,
    spectrum,
    filtered,
    receptors,
    spikes,
    networks,
    central,
    brain,
    envelope
};

inline constexpr std::array<Stage, 9> kStages{Stage::vibration, Stage::spectrum, Stage::filtered,
                                              Stage::receptors, Stage::spikes,   Stage::networks,
                                              Stage::central,   Stage::brain,    Stage::envelope};

constexpr std::size_t index_of(Stage stage) { return static_cast<std::size_t>(stage); }

struct StageText {
    const char* key;         // on the command line and in file names: "brain"
    const char* name;        // "Brain waveform"
    const char* short_name;  // in the strip
    const char* detail;      // what is plotted
    const char* in_body;     // what happens there
    const char* in_model;    // what the model does
    const char* equation;    // and where it stands
    const char* left_out;
    const char* ours;    // constants and choices that the paper does not give
    const char* source;  // of what is said of the body
};

const StageText& text_of(Stage stage);

std::optional<Stage> stage_named(std::string_view key);

// All stages of the one vibration that is shown large, computed in the background.
//
// It does not wait for the map: a very large set has no map, and a drag moves on before its
// exact one is there.

inline constexpr double kStepRateHz = kModelRateHz / static_cast<double>(kStepSamples);

struct LiveStagesRequest {
    Vibration vibration;
    std::size_t samples = 0;  // of the longest in its set: what it is padded to
    PerceptualModelParams model;
    std::optional<RenderedBy> rendered_by{};  // the vibration as a device plays it

    bool operator==(const LiveStagesRequest&) const = default;
};

LiveStagesRequest stages_request(const PatternSet& set, std::size_t index,
                                 const std::optional<RenderedBy>& rendered_by = {});

// One answer: a snapshot that panels draw as long as they like.
struct LiveStages {
    LiveStagesRequest request;
    Waveform waveform;          // padded, at 10 kHz
    NeuralCodingStages neural;  // without the layers, which are made for the step on screen
    PerReceptor<bool> only_leaks{};
    PerReceptor<Firing> firing{};
    PerReceptor<double> impulses_a_cycle{};
    PerReceptor<std::vector<char>> silent_steps;
    PerReceptor<SilentFiring> silent_firing{};
    std::array<std::vector<BesideFact>, kStages.size()> beside;  // of the textbook, by stage
    PerReceptor<std::vector<double>> population_hz;     // impulses/s of all receptors, per step
    PerReceptor<std::vector<double>> central_count;     // spikes per step
    PerReceptor<std::vector<double>> central_spikes;    // 0 or 1 per sample
    PerReceptor<std::vector<std::size_t>> by_distance;  // receptors, nearest first
    std::vector<double> brain_waveform;
    std::vector<double> envelope;
};

std::optional<LiveStages> compute_live_stages(const LiveStagesRequest& request,
                                              std::stop_token stop, std::atomic<float>& progress);

// The signals over time that make up a stage, for drawing, comparing and exporting them alike.
//
// Left out  grids and layers: those are no signals over time.

struct StageSignal {
    std::string id{};                    // "filtered FA1", "brain"
    std::optional<Receptor> receptor{};  // of which channel; none: of all
    std::span<const double> samples{};
    double rate_hz = kModelRateHz;
    bool is_signed = false;
    double largest = 0.0;  // of its scale; 0: its own largest sample
    const char* unit = "";
};

// Views into `live`. Empty for stages that are no signals.
std::vector<StageSignal> signals_of(const LiveStages& live, Stage stage);

// How far two patterns are apart at each stage, 0 the same to 1 nothing in common
// (model/signal/waveform.h); none where a stage has no measure of its own.
using StageDifferences = std::array<std::optional<double>, kStages.size()>;
StageDifferences stage_differences(const LiveStages& a, const LiveStages& b);

// a - b, sample by sample, for each signal of a stage.
std::vector<std::vector<double>> signal_differences(const LiveStages& a, const LiveStages& b,
                                                    Stage stage);

// What is opened, pointed at and compared in the stages of the model.

// One receptor of one type: its place in the grid of the shown pattern.
struct ReceptorPlace {
    Receptor type = Receptor::pacinian;
    std::size_t index = 0;

    bool operator==(const ReceptorPlace&) const = default;
};

// The layers on screen, kept while neither the pattern nor the step changes.
struct ShownLayers {
    std::shared_ptr<const LiveStages> of;
    std::size_t step = 0;
    PerReceptor<std::vector<RelayLayer>> layers;
};

// Where two patterns part, kept while both stay what they are.
struct ShownDifference {
    std::shared_ptr<const LiveStages> a;
    std::shared_ptr<const LiveStages> b;
    StageDifferences stages;
    std::array<std::vector<std::vector<double>>, kStages.size()> signals;  // a - b
    double nc = 0.0;
};

// A threshold that is moved in the spectrum, in this frame.
struct ThresholdMove {
    Receptor type = Receptor::pacinian;
    double db = 0.0;
    bool is_last = false;
};

struct PhysiologyState {
    std::optional<Stage> open;              // fills the pane; none: all of them, small
    std::optional<Stage> explained;         // its text is open beside it
    Receptor network = Receptor::pacinian;  // whose layers the overview shows
    bool network_chosen = false;            // by the person; otherwise the strongest one
    bool textbook = false;                  // what was measured is laid over the stages
    bool tilted = false;
    double tilt_since_s = -10.0;
    std::optional<ReceptorPlace> hovered;  // in this frame, in any view
    std::optional<ReceptorPlace> hovered_last;
    std::optional<ReceptorPlace> selected;
    ShownLayers layers;
    ShownLayers pinned_layers;
    ShownDifference difference;
    std::optional<ThresholdMove> threshold_move;
    std::optional<double> pair_oc;  // of the two patterns on screen, where the map knows it
};

struct Physiology {
    Query<LiveStagesRequest, LiveStages> stages_job;
    std::shared_ptr<const LiveStages> stages;  // of the current vibration, or of one before it
    bool put_off = false;                      // newer ones, to the next frame
    Query<LiveStagesRequest, LiveStages> pinned_job;
    std::shared_ptr<const LiveStages> pinned_stages;
    PhysiologyState view;
};

// Keeping the stages on screen in step with the current and the pinned pattern.

void take_stages(Physiology& physiology);

// Asks for the stages of the current and of the pinned vibration where they are not those that were
// asked for last.
void follow_current(const Ui& ui, Workspace& work, const RenderingState& rendered,
                    Physiology& physiology);

// How far the rhythms of the two are apart, as the map beside them has it.
void follow_pair(const Workspace& work, const ShownMap& shown_map, Physiology& physiology);

// Everything a pattern goes through as CSV texts, for the window and the command line alike.
//
// Input     the pattern's waveform, padded as in its set: the stages are those behind its numbers
// Output    numbers in the shortest form that reads back the same; in files of many cells or steps
//           those at zero are left out

// What all files of a pattern are made from.
struct StageValues {
    Waveform waveform;
    PerceptualModelParams model;
    NeuralCodingStages neural;  // without layers
};

// `waveform` at 10 kHz.
StageValues stage_values(const Waveform& waveform, const PerceptualModelParams& model);

struct CsvFile {
    std::string name;  // "brain_waveform.csv"
    std::string text;
};

std::vector<std::string> stage_csv_names(Stage stage);

// The files of one stage: one, or two where it has two kinds of rows.
std::vector<CsvFile> stage_csv(const StageValues& values, Stage stage);

}  // namespace tact
