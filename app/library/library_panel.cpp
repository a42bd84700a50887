#include "app/library/library.h"

#include <imgui.h>

#include "app/library/parts.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

void draw_library_panel(Ui& ui, Workspace& work, Layout& layout, LibraryState& state) {
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) state.held.reset();
    if (!ui.as_picture) draw_library_folder(ui, work, layout, state);
    if (state.reader.busy()) {
        if (draw_progress(ui, {"Reading", state.reader.progress(), "reading"}))
            state.reader.cancel();
    }
    if (draw_failure(ui, "library", state.reader.failure())) return;
    if (!state.library) {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "No library is open",
                   "A folder of effects, recordings and sets is listed here, to be searched and "
                   "taken from.");
        return;
    }
    if (!ui.as_picture) draw_library_search(ui, work, state);
    draw_library_order(ui, work, state);
    draw_library_list(ui, work, state);
}

}  // namespace tact
