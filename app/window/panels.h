// The panels: each draws one pane's content from the program's state and turns what the person does
// there into changes of it. Called inside the pane, cursor at its top left.
#pragma once

#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_set_panel(App& app);
void draw_editor_panel(App& app);
void draw_physiology_panel(App& app);
void draw_space_panel(App& app);
void draw_matrix_panel(App& app);
void draw_model_panel(App& app);
void draw_subset_panel(App& app);
void draw_compare_panel(App& app);
void draw_shepard_panel(App& app);
void draw_why_panel(App& app);
void draw_device_panel(App& app);

// Of the view of studies.
void draw_study_design(App& app);
void draw_study_people(App& app);
void draw_study_answers(App& app);

// Parts of the Compare tab.
void draw_findings(App& app, const Rect& area);

// The knots of the physiology tables, as a part of the model bench.
void draw_table_fields(App& app, const PhysiologyTables& original);

// The other parts of it: which parameters to have, and fitting them to ratings.
void draw_model_choice(App& app);
void draw_training(App& app);

// Over the window: which candidates to generate.
void draw_generate_dialog(App& app);

// The waveform of a vibration without axes, each to its own height.
void draw_thumbnail(App& app, const Rect& area, const Vibration& vibration, ImU32 colour);

// Windows of their own: the bar under the menus, and the text about a stage, beside its pane.
float transport_height(const App& app);
void draw_transport_bar(App& app, const Rect& area);
void draw_explain_window(App& app, const Rect& beside);

// Of the bar: device, level, meter, clip light; without `level` the device alone.
// Without `level` its controls, without `wide` most of the device's name is left out.
struct SoundParts {
    bool level = true;
    bool wide = true;
};
void draw_sound_controls(App& app, SoundParts parts);
float sound_controls_width(const App& app, SoundParts parts);

// The dialog of devices.
void draw_devices(App& app);
void draw_calibrate(App& app);

// Mark and colour of the pattern at a position: its own colour, else by position.
PatternLook look_of(const Theme& theme, const PatternSet& set, std::size_t index);
PatternLook look_of(const App& app, std::size_t index);

// What is left of the pane below the cursor.
Rect rest_of_pane();

}  // namespace tact
