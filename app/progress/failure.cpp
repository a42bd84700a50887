#include "app/progress/failure.h"

#include "app/ui/widgets.h"

namespace tact {

bool draw_failure(Ui& ui, const char* pane, const std::string& failure) {
    if (failure.empty()) return false;
    coloured_text(ui.theme.error, "This could not be computed: " + failure +
                                      ". The next change asks for it again.");
    note_item(ui.rects, std::string("failed:") + pane, failure);
    return true;
}

}  // namespace tact
