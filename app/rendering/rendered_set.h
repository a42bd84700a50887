// A set as a device plays it: every vibration is a recording of what the actuator makes of it.
//
// Left out  the document itself, which does not change.
// Exact     same set, same bits, on any number of threads.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "devices/calibration/rendering.h"
#include "model/set/pattern_set.h"

namespace tact {

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

}  // namespace tact
