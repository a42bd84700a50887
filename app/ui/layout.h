// The panes' shares of the window, and the shown panes.
#pragma once

#include <optional>

namespace tact {

// Tabs of the lower right pane.
enum class BenchTab { matrix, candidates, subset, compare, shepard, why, model, device, library };

enum class Pane {
    patterns,
    editor,
    physiology,
    space,
    matrix,
    study_design,  // these three only in the view of studies
    study_people,
    study_answers,
    start  // replaces map, answers and editor while the set is empty
};

// Arrangements of the window, by purpose.
enum class Arrangement { design, select, physiology };

// The stages: in the middle column, in one row below the map, or hidden. When folded, the map
// leads.
enum class Fold { open, row, closed };

struct Layout {
    float left = 0.21F;  // shares of the window's width
    float right = 0.34F;
    float left_split = 0.45F;  // shares of the column's height above the splitter
    float right_split = 0.58F;
    float band = 0.42F;  // share of the window's height for the editor below the map
    std::optional<Pane> maximised;
    BenchTab bench = BenchTab::matrix;
    Arrangement arrangement = Arrangement::design;
    Fold physiology = Fold::open;

    bool operator==(const Layout&) const = default;
};

}  // namespace tact
