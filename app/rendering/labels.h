// What goes with every result of a set: who plays it, which side of it that is, and what of it
// nobody felt or measured.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/rendering.h"
#include "model/export/export_target.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"

namespace tact {

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

}  // namespace tact
