#include "app/document/shown_side.h"

#include <algorithm>

#include "app/document/editing.h"

namespace tact {

Side shown_side(const App& app) { return app.side; }

void show_side(App& app, Side side) {
    if (shown_side(app) == side) return;
    app.side = side;
    document_changed(app);
}

PatternSet shown_set(const App& app) { return one_side(app.document.set, shown_side(app)); }

std::string shown_patterns_text(const App& app) {
    const std::size_t all = app.document.set.vibrations.size();
    const Side side = shown_side(app);
    if (side == Side::both) return std::to_string(all);
    const auto count =
        std::ranges::count_if(app.document.set.vibrations, [side](const Vibration& vibration) {
            return measures_another(vibration) == (side == Side::measured);
        });
    return std::to_string(count) + " " + kSideNames[static_cast<std::size_t>(side)] + " of " +
           std::to_string(all);
}

}  // namespace tact
