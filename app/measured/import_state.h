// What the window knows of measurements on their way into the set, and which side of it is shown.
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
    std::uint64_t document = 0;  // App::document_number that it was asked for
    std::vector<std::filesystem::path> files;
    std::vector<std::string> patterns;  // that they measure, by name; empty: not known
    AccelerationOptions options;
    std::shared_ptr<const PatternSet> set;
    std::filesystem::path keep_in;  // a folder for their waveforms; empty: only looked at
};

// A recording with its pattern, or why there is none.
struct ImportedFile {
    std::string fault;
    std::vector<std::string> remarks;
    std::optional<Twin> twin;
};

struct ImportAnswer {
    ImportRequest request;
    std::vector<ImportedFile> files;  // as many as the request has
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
    std::string fault;  // why they could not be kept
};

// Twins on their way into the set, asked for one after the other. A look that is newer than the
// last may supersede it; a take is never lost, so that each waits for the one before it.
template <class Request, class Answer>
struct Takes {
    std::deque<Request> waiting;  // the first is being worked on
    Query<Request, Answer> job;
};

struct ImportState {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> patterns;
    std::size_t shown = 0;  // the file whose signals are drawn
    RecordingFields fields;
    bool adding = false;               // the chooser looks for more files
    std::filesystem::path columns_of;  // whose columns somebody wants to tell; empty: nobody
    ActuatorParams actuator;
    bool simulate_all = true;                       // patterns, not only the selected ones
    std::uint64_t asked = 0;                        // the number of the last request of either kind
    Query<ImportRequest, ImportAnswer> import_job;  // to look
    Query<SimulationRequest, SimulationAnswer> simulation_job;
    Takes<ImportRequest, ImportAnswer> import_takes;  // into the set
    Takes<SimulationRequest, SimulationAnswer> simulation_takes;
    std::shared_ptr<const ImportAnswer> answer;
    std::shared_ptr<const SimulationAnswer> simulated;
};

}  // namespace tact
