#include "app/window/map_marks.h"

#include "app/compare/bench_follow.h"
#include "app/subset/subset_marks.h"

namespace tact {

MapMarks map_marks(App& app) {
    MapMarks marks = subset_marks(app);
    if (app.show_people) marks.people = people_over_map(app);
    return marks;
}

}  // namespace tact
