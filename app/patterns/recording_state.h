// The cut of the recording in the editor, and the pattern traced from it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "app/jobs/query.h"
#include "model/pattern/traced.h"
#include "model/set/pattern_set.h"

namespace tact {

// Settings relative to the recording as it came into the editor.
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

    bool operator==(const TraceRequest&) const = default;  // the same recording, not only an equal
                                                           // one
};

struct TraceAnswer {
    TraceRequest request;
    TracedPattern traced;
};

struct RecordingEditor {
    std::string name;                       // the recording that all below belongs to
    Measurement before;                     // the cut recording ...
    std::string note_before;                // ... and its description
    std::shared_ptr<const Waveform> after;  // the version in the set
    RecordingCut cut;
    std::size_t most_points = TraceParams{}.most_points;
    Query<TraceRequest, TraceAnswer> job;
};

}  // namespace tact
