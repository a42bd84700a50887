// Who holds a pattern by its name hears of a new one, of its undo, and of its redo.

#include "app/document/editing.h"

#include <doctest/doctest.h>

#include "app/measured/measured.h"
#include "app/pictures/pictures.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "model/set/set_ratings.h"
#include "tests/support/program.h"

namespace renaming_test {

using namespace tact;

namespace {

// Everything in the program that keeps "p2" by its name.
std::vector<std::string> names_kept(App& app) {
    const SubsetState& subset = app.picking;
    return {app.work.selection.partner,  app.work.selection.pinned, app.lesson.before.pinned,
            subset.reference_a,          subset.opened->first,      app.play.sounding->names.at(0),
            app.importing.patterns.at(0)};
}

}  // namespace

TEST_CASE("rename: a pattern stays in the study, in pairs, pinned, and among what sounds") {
    Program program(short_patterns(4));
    App& app = program.app;
    app.work.document.edit().study.patterns = {"p1", "p2", "p4"};
    app.work.document.edit().ratings = {{"P", {"p1", "p2", "p3", "p4"}, {1, 2, 3, 4, 5, 6}, {}}};
    ToldApart told;
    told.answers = {{{"p2", "p3", 9.0, 0, false}, 0, 1.0}};
    told.patterns = {"p2", "p3"};
    app.work.document.edit().told_apart = {told};
    commit_step(app.ui, app.work, "study");
    app.work.selection.partner = app.work.selection.pinned = app.lesson.before.pinned = "p2";
    app.picking.reference_a = "p2";
    app.picking.opened = {"p2", "p3"};
    app.play.sounding = Sounding{.names = {"p2", "p1"}};
    app.importing.patterns = {"p2"};
    const auto all = [](const char* name) { return std::vector<std::string>(7, name); };
    rename_vibration(app.ui, app.work, 1, "tap");
    follow_changes(app);
    CHECK(study_names(app.work) == std::vector<std::string>{"p1", "tap", "p4"});
    CHECK(app.work.document.set.ratings[0].labels[1] == "tap");
    CHECK(app.work.document.set.told_apart[0].answers[0].trial.a == "tap");
    CHECK(app.work.document.set.told_apart[0].patterns[0] == "tap");
    CHECK(names_kept(app) == all("tap"));
    undo(app.ui, app.work);
    follow_changes(app);
    CHECK(study_names(app.work) == std::vector<std::string>{"p1", "p2", "p4"});
    CHECK(app.work.document.set.told_apart == std::vector{told});
    CHECK(names_kept(app) == all("p2"));
    redo(app.ui, app.work);
    follow_changes(app);
    CHECK(names_kept(app) == all("tap"));
    app.play.sounding.reset();
}

TEST_CASE("rename: a copied measurement measures its pattern under the new name") {
    Program program(with_synthetic_twins(short_patterns(2), {}));
    App& app = program.app;
    app.work.selection.current = 1;
    const auto twin = [&app](std::size_t k) {
        return std::get<Measurement>(app.work.document.set.vibrations[k].source).measures;
    };
    REQUIRE(twin(1) == "p1");
    copy_selected(app.ui, app.work);
    rename_vibration(app.ui, app.work, 0, "tap");
    paste(app.ui, app.work);
    CHECK(twin(1) == "tap");
    CHECK(twin(2) == "tap");
}

TEST_CASE("rename: patterns that change places by an undo are no renames") {
    Program program(short_patterns(3));
    App& app = program.app;
    app.work.selection.pinned = "p1";
    move_vibration(app.ui, app.work, 0, 2);
    undo(app.ui, app.work);
    CHECK(app.work.selection.pinned == "p1");
}

}  // namespace renaming_test
