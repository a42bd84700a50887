// Measurements in the window: recordings and simulations become twins of the set's patterns.
//
// Left out  drawing: app/measured/import_dialogs.cpp.
#pragma once

#include <filesystem>
#include <vector>

#include "app/document/workspace.h"
#include "app/measured/import_state.h"
#include "app/ui/ui.h"

namespace tact {

// Takes what was read or simulated. Requested twins enter the set as one step of undo, unless
// another set is open by then.
void follow_import(Ui& ui, Workspace& work, ImportState& importing);
bool is_taking(const ImportState& importing);  // a request for the set is pending

// Opens the chooser for recordings, then their dialog.
void import_recordings_dialog(Ui& ui, const Workspace& work);
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

void draw_import_dialogs(Ui& ui, Workspace& work, ImportState& importing);

}  // namespace tact
