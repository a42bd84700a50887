// The sets that come with the program, as its menu lists them.
#pragma once

#include <array>

namespace tact {

struct ExampleSet {
    const char* path;  // below assets/
    const char* name;  // that the set has itself
};

inline constexpr std::array<ExampleSet, 13> kExampleSets{{
    {"sets/pm_2023_twelve.tactspace.json", "PM 2023, twelve patterns"},
    {"library/library.tactspace.json", "Library, forty patterns (our own, not from a study)"},
    {"library/notes_accents_layers.tactspace.json",
     "Notes, accents and layers (our own, not from a study)"},
    {"sets/rhythms_tactspace.tactspace.json", "tactspace rhythms (our own, not from a study)"},
    {"sets/park_choi_2011_am_4hz.tactspace.json",
     "Park & Choi 2011, eight AM patterns (4 Hz: paper\u2019s caption)"},
    {"sets/park_choi_2011_am_5hz.tactspace.json",
     "Park & Choi 2011, eight AM patterns (5 Hz: authors\u2019 files)"},
    {"sets/morse_rothkopf_1957.tactspace.json",
     "Morse, 36 signals (Rothkopf 1957: rated by ear, not by touch)"},
    {"sets/template_abou_chahine_2022.tactspace.json",
     "Abou Chahine 2022, 14 rhythms (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_low_high.tactspace.json",
     "Hwang 2017, Exp. I low-high, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_low_mid.tactspace.json",
     "Hwang 2017, Exp. I low-mid, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_mid_high.tactspace.json",
     "Hwang 2017, Exp. I mid-high, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp2.tactspace.json",
     "Hwang 2017, Exp. II, 15 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_choi_2010.tactspace.json",
     "Hwang & Choi 2010, 14 vibrations (template, unconfirmed)"},
}};

}  // namespace tact
