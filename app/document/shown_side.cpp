#include "app/document/shown_side.h"

#include <algorithm>

#include "app/document/editing.h"
#include "model/text/numbers.h"

namespace tact {

Side shown_side(const Workspace& work) { return work.side; }

void show_side(Workspace& work, Side side) {
    if (shown_side(work) == side) return;
    work.side = side;
    document_changed(work);
}

PatternSet shown_set(const Workspace& work) {
    return one_side(work.document.set, shown_side(work));
}

std::string patterns_text(std::size_t count) { return counted(count, "pattern", "patterns"); }

std::string shown_patterns_text(const Workspace& work) {
    const std::size_t all = work.document.set.vibrations.size();
    const Side side = shown_side(work);
    if (side == Side::both && !work.selection.search.empty())
        return grouped_digits(listed_indices(work).size()) + " of " + grouped_digits(all);
    if (side == Side::both) return grouped_digits(all);
    const auto count =
        std::ranges::count_if(work.document.set.vibrations, [side](const Vibration& vibration) {
            return measures_another(vibration) == (side == Side::measured);
        });
    return std::to_string(count) + " " + kSideNames[static_cast<std::size_t>(side)] + " of " +
           std::to_string(all);
}

}  // namespace tact
