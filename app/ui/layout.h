// How the panes share the window, and which of them is shown.
#pragma once

#include <optional>

namespace tact {

// What the lower right pane shows.
enum class BenchTab { matrix, candidates, subset, compare, shepard, why, model, device, library };

enum class Pane {
    patterns,
    editor,
    physiology,
    space,
    matrix,
    study_design,  // these three in the view of studies
    study_people,
    study_answers,
    start  // in the place of map, answers and editor while the set is empty
};

// What the window is arranged for.
enum class Arrangement { design, select, physiology };

// The stages: in the middle column, in one row below the map, or away. Folded, the map leads.
enum class Fold { open, row, closed };

struct Layout {
    float left = 0.21F;  // share of the window's width
    float right = 0.34F;
    float left_split = 0.45F;  // share of the column's height above the splitter
    float right_split = 0.58F;
    float band = 0.42F;  // of the window's height, of the editor below the map
    std::optional<Pane> maximised;
    BenchTab bench = BenchTab::matrix;
    Arrangement arrangement = Arrangement::design;
    Fold physiology = Fold::open;

    bool operator==(const Layout&) const = default;
};

}  // namespace tact
