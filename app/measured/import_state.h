// State of measurements on their way into the set, and the side of the set that is shown.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/measured/recording_fields.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/measured_twin.h"

namespace tact {

// Recordings to be read and laid over their patterns.
struct ImportRequest {
    std::uint64_t number = 0;
    std::uint64_t document = 0;  // App::document_number at the time of the request
    std::vector<std::filesystem::path> files;
    std::vector<std::string> patterns;  // the measured pattern's name; empty: not known
    AccelerationOptions options;
    std::shared_ptr<const PatternSet> set;
    std::filesystem::path keep_in;  // a folder for their waveforms; empty: only a look
};

// A recording with its pattern, or the reason why it has no pattern.
struct ImportedFile {
    std::string fault;
    std::vector<std::string> remarks;
    std::optional<Twin> twin;
};

struct ImportAnswer {
    ImportRequest request;
    std::vector<ImportedFile> files;  // as many as in the request
};

struct SimulationRequest {
    std::uint64_t number = 0;
    std::uint64_t document = 0;
    std::vector<std::size_t> places;
    ActuatorParams actuator;
    std::shared_ptr<const PatternSet> set;
    std::filesystem::path keep_in;
};

struct SimulationAnswer {
    SimulationRequest request;
    std::vector<Twin> twins;
    std::string fault;  // the error of writing them
};

// Requests for twins, worked on one after the other. A newer look may supersede the last one; a
// request for the set is never dropped, so it waits for the one before it.
template <class Request, class Answer>
struct Takes {
    std::deque<Request> waiting;  // the first is the current one
    Query<Request, Answer> job;
};

struct ImportState {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> patterns;
    std::size_t shown = 0;  // the file whose signals are drawn
    RecordingFields fields;
    bool adding = false;               // the chooser adds files to these
    std::filesystem::path columns_of;  // the table whose columns are to be named; empty: no table
    ActuatorParams actuator;
    bool simulate_all = true;                       // all patterns, not only the selected ones
    std::uint64_t asked = 0;                        // number of the last request of either kind
    Query<ImportRequest, ImportAnswer> import_job;  // looks
    Query<SimulationRequest, SimulationAnswer> simulation_job;
    Takes<ImportRequest, ImportAnswer> import_takes;  // twins for the set
    Takes<SimulationRequest, SimulationAnswer> simulation_takes;
    std::shared_ptr<const ImportAnswer> answer;
    std::shared_ptr<const SimulationAnswer> simulated;
};

}  // namespace tact
