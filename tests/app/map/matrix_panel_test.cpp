// The Matrix tab in the program's real frames.
#include "app/document/editing.h"
#include "tests/support/program.h"

namespace matrix_panel_test {

using namespace tact;

TEST_CASE("matrix panel: all that are selected stand out, in whatever order the rows are") {
    Program program(short_patterns(6));
    program.compute_map();
    App& app = program.app;
    app.layout.bench = BenchTab::matrix;
    app.shown_map.clustered_matrix = false;
    select_only(app.work, 2);
    toggle_selected(app.work, 0);
    toggle_selected(app.work, 5);
    program.settle();
    CHECK(program.at("matrix selected").value == "p1|p3|p6|");
    app.shown_map.clustered_matrix = true;
    program.settle();
    std::string names = program.at("matrix selected").value;
    for (const char* name : {"p1|", "p3|", "p6|"}) {
        const auto at = names.find(name);
        REQUIRE(at != std::string::npos);
        names.erase(at, 3);
    }
    CHECK(names.empty());
}

}  // namespace matrix_panel_test
