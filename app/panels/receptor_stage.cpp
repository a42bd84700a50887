#include "app/panels/receptor_stage.h"

namespace tact {

void draw_receptor_stage(App&, const ShownStages&, const Rect&, const StageSize&) {}
void draw_spike_stage(App&, const ShownStages&, const Rect&, const StageSize&) {}
void draw_network_stage(App&, const ShownStages&, const Rect&, const StageSize&) {}

}  // namespace tact
