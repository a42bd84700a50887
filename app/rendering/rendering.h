// Patterns as a device plays them, and what is to be said of that.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "devices/calibration/rendering.h"
#include "model/export/export_target.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"

namespace tact {

// What goes with every result of a set: who plays it, which side of it that is, and what of it
// nobody felt or measured.

struct Labels {
    std::optional<RenderedBy> by{};          // none: the patterns as they are meant
    std::optional<ExportTarget> exported{};  // as they come back from its files, before any device
    Side only = Side::both;
    NumberMark mark{};                               // of the ratings, the model and the patterns
    std::vector<std::string> edited{};               // since they were felt, where that is known
    std::vector<std::string> gone{};                 // were rated, are not in the set, left out
    std::map<std::string, std::size_t> actuators{};  // maps by which patterns were read, how many
};

bool has_synthetic_patterns(const PatternSet& set);

// "the patterns as a Joy-Con plays them, uncalibrated: full scale stands for 1.00 g"
std::string sentence_on(const RenderedBy& by);

// "the patterns as AHAP for core-haptics holds them: 0 to 1 as 65 to 300 Hz, .."
std::string sentence_on(const ExportTarget& target);

// A sentence each, none where there is nothing to say; and as lines.
std::vector<std::string> lines_of(const Labels& labels);
std::string text_of(const Labels& labels);

// The mark in words, with the names of what was edited: for the corner of a table, or the title of
// a picture; empty where nothing is to be said. Everything that hands numbers on hands it on.
std::string corner_of(const Labels& labels);

// The mark of what a model says, and of what it says about the patterns of this set.
NumberMark mark_of(const ModelOrigin& origin);
NumberMark mark_of(const PatternSet& set);

// Keys of an object: synthetic_patterns and synthetic_model always; synthetic, rehearsal,
// people_left_out, rehearsals_left_out, changed_since_felt,
// edited_since_felt, gone_since_felt, only,
// exported_as with exported_onto and exported_onto_source or exported_rate_hz, and rendered_by with
// calibrated, full_scale_g and level, where they apply; actuators, of patterns that were read from
// effects of other programs.
void add_labels(nlohmann::json& json, const Labels& labels);

// A set as a device plays it: every vibration is a recording of what the actuator makes of it.
//
// Left out  the document itself, which does not change.
// Exact     same set, same bits, on any number of threads.

struct RenderedSet {
    PatternSet intended;
    RenderedBy by;
    PatternSet played;
};

// "as a Joy-Con plays them at a level of 30 %, uncalibrated": what results of it are labelled with.
// The whole level is not worth a word.
std::string words_on(const RenderedBy& by);

// "full scale stands for 1.00 g", "by the calibration of coil, 2026-11-21": where its strength is
// from.
std::string strength_words(const RenderedBy& by);

struct RenderSetOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
};

// Takes from `earlier`, where it is given, what has not changed since. Nothing when stopped.
std::optional<RenderedSet> rendered_set(const PatternSet& set, const RenderedBy& by,
                                        const RenderedSet* earlier = nullptr,
                                        const RenderSetOptions& options = {});

// What a kind of device makes of the patterns, computed in the background: its report on the
// current one, and whether all that is predicted is of what the device plays.

struct RenderingRequest {
    Vibration vibration;
    RenderedBy by;

    bool operator==(const RenderingRequest&) const = default;
};

struct LiveRendering {
    RenderingRequest request;
    Waveform intended;
    Rendering rendering;
};

struct RenderingState {
    bool on = false;  // maps, matrices and stages are of what the device plays
    RenderedBy by;
    bool at_bar_level = false;  // else as at full level
    Query<RenderingRequest, LiveRendering> job;
    RenderingRequest asked;
    std::shared_ptr<const LiveRendering> shown;  // of the current vibration, or of one before it
};

// Asks for the report on a vibration (may be null) unless it was asked for last.
void follow_rendering(const Ui& ui, RenderingState& state, const Vibration* vibration);

// Takes the newest report.
void take_rendering(RenderingState& state);

// None while predictions are of the patterns as they were meant.
std::optional<RenderedBy> rendered_by(const RenderingState& state);

// "as a Joy-Con plays them, uncalibrated"; empty while it is off.
std::string rendered_words(const RenderingState& state);

}  // namespace tact
