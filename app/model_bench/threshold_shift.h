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
#pragma once

#include <array>
#include <optional>

#include "model/physiology/mechanoreceptor.h"

namespace tact {

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

}  // namespace tact
