// Parts that the files of this room share.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/document/workspace.h"
#include "app/model_bench/model_bench.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

// What every field of the bench leaves free at its right, so that all end alike.
float beside_field_px(const Ui& ui);
// In that room, on the line of the entry of the field drawn last, as a group. True when pressed.
bool link_beside_field(Ui& ui, const Item& item);

// The least change of each number that people are taken to feel: rows of the model bench.

void draw_felt_step_fields(Ui& ui, Workspace& work);

// Every parameter of PM that the model bench shows: a field and where it is kept.

using ModelNumber = DescribedField<PerceptualModelParams>;

// One of a few ways to do something.
struct ModelChoice {
    const char* id;
    const char* label;
    const char* help;
    std::array<const char*, 2> options;
    int (*get)(const PerceptualModelParams&);
    void (*set)(PerceptualModelParams&, int);
};

std::span<const ModelNumber> trained_rows();  // those that the paper gives
std::span<const ModelChoice> choice_rows();   // where it leaves one open
std::span<const ModelNumber> number_rows();   // the others

// Knobs that mean something: how deaf a receptor type is, as a shift of its threshold, and what a
// glove or age might do.
//
// Source    no preset has a figure in dB that we could cite: each is a guess, and says so.
//           That the Pacinian channel loses most with age: Gescheider, Bolanowski & Verrillo 2004,
//           Some characteristics of tactile channels, Behav. Brain Res. 148, 35 (its abstract)
// Input     the tables now, and the program's
// Output    the tables with a shift in dB of displacement; a type that is removed answers to
//           nothing
// Left out  shifts that depend on frequency: those are edited knot by knot

inline constexpr Range kThresholdShiftDb{-40.0, 60.0};

// How far the curve lies above the one it was, dB; none: not by the same everywhere.
std::optional<double> shift_db(const Curve& curve, const Curve& original);

// The original curve, moved up by `db`; a curve that was edited by hand is moved itself.
Curve shifted(const Curve& curve, const Curve& original, double db);

// No vibration reaches it.
Curve removed(const Curve& original);
bool is_removed(const Curve& curve);

struct ThresholdPreset {
    const char* name;
    const char* words;       // where it is from
    PerReceptor<double> db;  // of each type
};

inline constexpr std::array<ThresholdPreset, 3> kThresholdPresets{{
    {"Cold finger", "A guess: Pacinian corpuscles suffer most from cold", {3.0, 12.0, 3.0, 3.0}},
    {"Glove", "A guess: a layer takes something of everything", {10.0, 6.0, 12.0, 10.0}},
    {"Older skin",
     "A guess in dB; that Pacinian corpuscles lose most with age: Gescheider, Bolanowski & "
     "Verrillo 2004, Behav. Brain Res. 148, 35",
     {6.0, 15.0, 4.0, 4.0}},
}};

// Parts of the view that trains the model.

// What was found, with what can be done with it.
void draw_training_result(Ui& ui, Workspace& work, ModelBench& model_bench,
                          const FoundTraining& found);

}  // namespace tact
