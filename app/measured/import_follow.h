// Measurements in the window: recordings and simulations become twins of the set's patterns.
//
// Left out  drawing: app/measured/import_dialogs.cpp.
#pragma once

#include <filesystem>
#include <vector>

#include "app/measured/import_state.h"
#include "app/window/app.h"

namespace tact {

std::shared_ptr<ImportState> make_import();
void stop_import(App& app);

// Takes what was read or simulated; what was to go into the set does, as one step, unless another
// set is open by then.
void follow_import(App& app);
bool is_taking(const App& app);  // something is still to go into the set

// Choosing recordings, then the dialog on them.
void import_recordings_dialog(App& app);
void import_recordings(App& app, const std::vector<std::filesystem::path>& paths);

// Whether these are tables of accelerations rather than of ratings.
bool are_accelerations(const std::vector<std::filesystem::path>& paths);

void simulate_measurement_dialog(App& app);

// What the dialogs ask for: a look, or twins in the set.
void look_at_recordings(App& app);
void take_recordings(App& app);
void look_at_simulation(App& app);
void take_simulation(App& app);

void draw_import_dialogs(App& app);

}  // namespace tact
