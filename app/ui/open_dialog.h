// What may lie over the panes, and what a chosen path is for.
#pragma once

namespace tact {

enum class Dialog {
    none,
    about,
    keys,
    devices,
    effect_maps,
    calibrate,
    export_view,
    export_animation,
    export_effects,
    generate,
    import_recordings,
    simulate_measurement,
    steps,
    tap_rhythm,
    pad,
    leave_out,
    save_workspace,
    conduct_rules
};

// What a chosen path is for.
enum class ChooserPurpose {
    open_document,
    add_to_set,
    save_document,
    load_tables,
    load_ratings,
    load_calibration,
    load_model,
    save_model,
    add_training_set,
    save_calibration_signal,
    open_calibration_recording,
    import_recordings,
    study_folder,
    export_study,
    export_view,
    export_subset,
    export_report,
    export_effects,
    export_stages,
    export_animation,
    open_lesson,
    save_lesson,
    lesson_sheet
};

}  // namespace tact
