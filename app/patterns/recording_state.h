// How the recording in the editor is cut, and what it is like as a pattern.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "app/jobs/query.h"
#include "model/pattern/traced.h"
#include "model/set/pattern_set.h"

namespace tact {

// Of the recording as it was when it came into the editor.
struct RecordingCut {
    double gain_db = 0.0;
    Range part_s{0.0, 0.0};
    double fade_in_s = 0.0;
    double fade_out_s = 0.0;

    bool operator==(const RecordingCut&) const = default;
};

struct TraceRequest {
    std::shared_ptr<const Waveform> recording;
    std::size_t most_points = 0;

    bool operator==(const TraceRequest&) const = default;  // the same recording, not an equal one
};

struct TraceAnswer {
    TraceRequest request;
    TracedPattern traced;
};

struct RecordingEditor {
    std::string name;                       // of the recording; all below is of it
    Measurement before;                     // what is cut ...
    std::string note_before;                // ... and was said of it
    std::shared_ptr<const Waveform> after;  // what is in the set
    RecordingCut cut;
    std::size_t most_points = TraceParams{}.most_points;
    Query<TraceRequest, TraceAnswer> job;
};

}  // namespace tact
