// Components over thresholds; in the large spectrum the thresholds can be moved.

#include "app/stages/stage_pictures.h"
#include "app/stages/textbook_overlay.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/spectrum_view.h"

namespace tact {

void draw_spectrum_stage(Ui& ui, Physiology& physiology, const ShownStages& shown, const Rect& area,
                         bool large) {
    SpectrumScene scene;
    scene.components = shown.live->neural.components;
    scene.thresholds = &shown.live->request.model.coding.tables.threshold;
    scene.ghosts = &default_tables().threshold;
    scene.colour = ui.theme.text;
    scene.stale = shown.stale;
    scene.curves_move = large && !shown.pinned && !ui.as_picture;
    const MeasuredSpectrum measured = measured_spectrum(physiology);
    scene.felt_db = measured.felt_db;
    scene.bands = measured.bands;
    const char* id = shown.pinned ? "spectrum pinned" : "spectrum";
    const SpectrumAction action = draw_spectrum(id, ui.theme, area, scene);
    note_rect(ui.rects, std::string("plot:") + id, area.min, area.max);
    if (action.taken) {
        physiology.view.threshold_move = {*action.taken, action.moved_db, action.released};
    }
    if (!action.hovered) return;
    const Component& component = scene.components[*action.hovered];
    const std::string text =
        shortest_digits(component.frequency_hz) + " " + shortest_digits(component.skin_um);
    note_rect(ui.rects, std::string("under the mouse:") + id, area.min, area.max, text);
}

}  // namespace tact
