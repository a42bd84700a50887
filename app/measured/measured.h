// Recordings as twins of patterns.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/common/units.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/measured_twin.h"
#include "model/signal/waveform.h"

namespace tact {

// Fields for reading a recording of accelerations, shared by every dialog on recordings.

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

// State of measurements on their way into the set, and the side of the set that is shown.

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

// Measurements in the window: recordings and simulations become twins of the set's patterns.

// Takes what was read or simulated. Requested twins enter the set as one step of undo, unless
// another set is open by then.
void follow_import(Ui& ui, Workspace& work, ImportState& importing);
bool is_taking(const ImportState& importing);  // a request for the set is pending

// Opens the chooser for recordings, then their dialog.
void import_recordings_dialog(Ui& ui, const Workspace& work, ImportState& importing);
// `told`: what the person said about these files.
void import_recordings(Ui& ui, const Workspace& work, ImportState& importing,
                       const std::vector<std::filesystem::path>& paths,
                       const AccelerationOptions& told = {});

// Whether these are tables of accelerations, not of ratings.
bool are_accelerations(const std::vector<std::filesystem::path>& paths);

void simulate_measurement_dialog(Ui& ui, const Workspace& work, ImportState& importing);

// Requests of the dialogs: a look, or twins in the set.
void look_at_recordings(const Ui& ui, const Workspace& work, ImportState& importing);
void take_recordings(Ui& ui, const Workspace& work, ImportState& importing);
void look_at_simulation(const Ui& ui, const Workspace& work, ImportState& importing);
void take_simulation(Ui& ui, const Workspace& work, ImportState& importing);

inline constexpr Dialog kImportDialog{.title = "Import recordings", .is_of_document = true};
inline constexpr Dialog kSimulationDialog{.title = "Simulate measurement", .is_of_document = true};
void draw_import_dialogs(Ui& ui, Workspace& work, ImportState& importing);

// Two signals on one scale: the measured or heard signal, and its pattern.

struct Overlay {
    const char* rect;  // name for tests
    const Waveform& filled;
    const char* filled_name;
    const Waveform& dashed;  // draws only the envelope of this one
    const char* dashed_name;
};

void draw_overlay(Ui& ui, const Overlay& overlay);

// Reserves the same room while there is nothing to draw.
void draw_empty_overlay(const Ui& ui, const char* title, const std::string& reason);

}  // namespace tact
