// How a recording of accelerations is to be read: the fields that every dialog on one shows.
#pragma once

#include "app/ui/ui.h"
#include "model/common/range.h"
#include "model/io/recordings/acceleration_file.h"

namespace tact {

struct RecordingFields {
    AccelerationOptions options;
    double rate_hz = 0.0;     // 0: from the time column
    double full_scale = 0.0;  // of WAV files; 0: the sidecar's
};

// The options with what the fields say.
AccelerationOptions options_of(const RecordingFields& fields);

// True when one of them was changed. `has_wave`: full scale is asked for as well.
bool draw_recording_fields(Ui& ui, RecordingFields& fields, bool has_wave);

// A number with its label, its default and its unit.
struct NumberRow {
    const char* id;  // also its name for tests
    const char* label;
    double normal;
    Range range;
    const char* unit;  // and what else is to be said of it
};

// True when another one was taken.
bool draw_number_row(Ui& ui, const NumberRow& row, double& value);

}  // namespace tact
