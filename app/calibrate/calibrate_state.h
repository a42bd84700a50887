// What the window knows of an actuator that is being measured: what is played, what was recorded,
// and what that says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/measured/recording_fields.h"
#include "devices/calibration/calibration_run.h"

namespace tact {

struct ResponseQuestion {
    std::uint64_t number = 0;
    CalibrationParams params;
    std::filesystem::path recording;
    AccelerationOptions options;
};

struct ResponseAnswer {
    ResponseQuestion question;
    std::vector<std::string> remarks;
    std::string fault;  // why there is no result
    CalibrationResult result;
};

struct CalibrateState {
    CalibrationParams params;
    std::filesystem::path recording;  // empty: none yet
    RecordingFields fields;
    Calibration about;  // all but the table
    bool is_playing = false;
    bool comes_back = false;  // the dialog, when a file is chosen or not
    std::uint64_t asked = 0;
    Query<ResponseQuestion, ResponseAnswer> job;
    std::shared_ptr<const ResponseAnswer> answer;  // of what was asked last, or before
};

}  // namespace tact
