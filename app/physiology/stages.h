// The stages of the model's way from the skin to the two signals that it compares, and what there
// is to say about each.
//
// Source    Lim & Park 2023, sections 3-5; of what is said of the body, `source`. The sentences are
//           ours. Held against their abstracts: Bolanowski et al. 1988 (four channels with bands of
//           their own), Saal & Bensmaia 2014 (most cortical neurons get convergent input),
//           Johansson & Vallbo 1979 (densities), Mountcastle et al. 1967 (two sets of fibres),
//           Freeman & Johnson 1982 (impulses in step with the cycle),
//           Barrett-Snyder et al. 2021 (the Pacinian capsule as a filter).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tact {

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

}  // namespace tact
