// A set of named vibrations, parametric, measured or of layers, with what belongs to it: the
// document.
//
// Left out  where it is stored and how (model/io).
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/common/expected.h"
#include "model/design_space/design_space.h"
#include "model/dissimilarity/number_mark.h"
#include "model/pattern/felt_steps.h"
#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/signal/waveform.h"
#include "model/study/study_design.h"
#include "model/told_apart/told_apart.h"

namespace tact {

// A recorded waveform, already at the model's rate and in g.
struct Measurement {
    std::shared_ptr<const Waveform> waveform;  // never null; shared, so that copies are cheap
    std::string path;                          // of its file: absolute; relative in a set file
    double scale_g = 1.0;                      // g at the file's full scale
    std::string measures;                      // name of the intended pattern, or empty
    bool synthetic = false;                    // computed, not recorded: shown as such everywhere
    std::string measures_version{};            // of that pattern when it was (felt_versions.h)

    bool operator==(const Measurement&) const;  // compares the samples, not the pointers
};

// Origin of a pattern that was read from an effect of another program (model/io/formats).
struct EffectOrigin {
    std::string format;    // "ahap"; empty: it was not
    std::string actuator;  // name of the map by which its 0 to 1 became Hz and g

    bool operator==(const EffectOrigin&) const = default;
};

// One of the vibrations that a layered pattern is the sum of.
struct Layer {
    std::string name;
    std::variant<Pattern, Measurement> source;
    double gain = 1.0;      // factor of its amplitude
    double offset_s = 0.0;  // from 0 s of the whole to 0 s of its own
    bool mute = false;
    bool solo = false;  // where any is, those alone sound

    bool operator==(const Layer&) const = default;
};

// One to four vibrations at once (model/set/layers.h).
struct LayeredPattern {
    std::vector<Layer> layers;

    bool operator==(const LayeredPattern&) const = default;
};

using VibrationSource = std::variant<Pattern, Measurement, LayeredPattern>;

struct Vibration {
    std::string name;  // unique in its set
    VibrationSource source;
    bool locked = false;  // not to be edited; picked in every subset
    std::string colour;   // "#RRGGBB"; empty: not given yet
    std::string note;
    std::string unknown_json;  // keys of the file that this version does not know, kept on save
    bool dropped = false;      // from every subset; never together with `locked`
    bool generated = false;    // from the set's design space, and not changed by hand since
    bool ring = false;         // its mark, in its colour: a ring, or a disc
    EffectOrigin effect{};

    bool operator==(const Vibration&) const = default;
};

// One voice among those who said how unlike the patterns feel: a person's pass through the pairs,
// or the mean of many.
struct Ratings {
    std::string name;  // of the participant, the same for repetitions; or of the study
    std::vector<std::string> labels;
    std::vector<double> condensed;  // (1,2),(1,3)..(2,3).. dissimilarities; kUnrated: not rated
    std::string unknown_json;
    std::string file{};  // they were read from, without its folder
    // Versions of the patterns when they were felt, by label (felt_versions.h); empty: not
    // recorded.
    std::vector<std::string> versions{};
    NumberMark mark{};  // synthetic, and who of the study is left out

    bool operator==(const Ratings&) const = default;
};

// No NaN, which would make two equal sets differ.
inline constexpr double kUnrated = std::numeric_limits<double>::infinity();

// Origin of trained parameters of the model.
struct ModelOrigin {
    std::string trained_on;        // a sentence; empty: they were not
    bool synthetic = false;        // nobody was asked, for some of the ratings at least
    bool changed_by_hand = false;  // since

    bool operator==(const ModelOrigin&) const = default;
};

// Where the points of a set's map were when it was saved, by name: the next map is turned onto
// them. No part of what the set is: two sets are equal wherever they lie.
struct MapPlaces {
    std::map<std::string, std::vector<double>> at;  // 2 or 3 coordinates each

    bool operator==(const MapPlaces&) const { return true; }
};

struct PatternSet {
    std::string name;
    double duration_s = 1.0;  // of every new pattern
    std::vector<Vibration> vibrations;
    std::vector<Ratings> ratings;
    PerceptualModelParams model;
    ModelOrigin model_origin{};
    StudyDesign study;  // how people are asked
    FeltSteps felt_steps{};
    MapPlaces map_places{};
    std::string unknown_json;
    std::optional<DesignSpace> generator;  // that candidates were made by last
    std::vector<ToldApart> told_apart{};   // each measured on one person, on one device

    bool operator==(const PatternSet&) const = default;
};

// The samples of one vibration at the model's rate, unpadded; and at any other rate.
Waveform waveform_of(const Vibration& vibration);
Waveform waveform_of(const Vibration& vibration, double rate_hz);

// The samples of all, zero-padded at the end to the longest: what the model compares.
std::vector<Waveform> model_waveforms(const PatternSet& set);

// The longest vibration, in samples at the model's rate; 0 for an empty set.
std::size_t longest_samples(const PatternSet& set);
double longest_s(const PatternSet& set);

// How long a vibration lasts by itself, before it is filled up to the longest of its set.
double own_duration_s(const Vibration& vibration);

// Names of all vibrations, in their order.
std::vector<std::string> names_of(const PatternSet& set);

// How many patterns were read by each actuator map, by its name.
std::map<std::string, std::size_t> actuators_of(const PatternSet& set);

// Place of the vibration of a name, if there is one.
std::optional<std::size_t> place_named(const PatternSet& set, const std::string& name);

// `wanted`, or `wanted 2`, `wanted 3`, ... whichever no vibration of the set has yet.
std::string unused_name(const PatternSet& set, const std::string& wanted);

// The waveforms of a set, rendered by many threads.

// Each at its own length, which is what PM and every metric take. One clip of a minute does not
// make all others a minute long. threads = 0: all cores.
std::vector<Waveform> own_waveforms(const PatternSet& set, int threads = 0);

// Vibrations of a set by the name that a person gives.
//
// Output    a position, or a sentence that names some that there are

Expected<std::size_t> place_of(const PatternSet& set, const std::string& name);

// The same of a pattern made of parameters: a recording and layers are refused.
Expected<std::size_t> pattern_place_of(const PatternSet& set, const std::string& name);

// The pattern itself, or null: no vibration has that name, or it is no such pattern.
const Pattern* pattern_named(const PatternSet& set, const std::string& name);

}  // namespace tact
