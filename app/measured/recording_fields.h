// Fields for reading a recording of accelerations, shared by every dialog on recordings.
#pragma once

#include "app/ui/ui.h"
#include "model/common/range.h"
#include "model/io/recordings/acceleration_file.h"

namespace tact {

struct RecordingFields {
    AccelerationOptions options;
    double rate_hz = 0.0;     // 0: from the time column
    double full_scale = 0.0;  // full scale of WAV files; 0: the sidecar's
};

// The options with the values of the fields.
AccelerationOptions options_of(const RecordingFields& fields);

// True if a field changed. `has_wave`: also shows the field for full scale.
bool draw_recording_fields(Ui& ui, RecordingFields& fields, bool has_wave);

// A number with its label, its default and its unit.
struct NumberRow {
    const char* id;  // also the name for tests
    const char* label;
    double normal;
    Range range;
    const char* unit;  // and a remark
};

// True if another choice was made.
bool draw_number_row(Ui& ui, const NumberRow& row, double& value);

}  // namespace tact
