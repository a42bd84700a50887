#include "app/tables/tables.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "app/document/editing.h"
#include "app/session/session.h"
#include "app/tables/parts.h"
#include "app/window/window.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace table_look_test {

using namespace tact;

namespace {

// Every pair of three patterns under names that nobody could guess.
constexpr const char* kAnswers =
    "code;one;other;how far;seen\nS1;p1;p2;10;1\nS1;p1;p3;35;1\nS1;p2;p3;70;1\n";

void wait_for_answer(Program& program) {
    wait_until(program, [&program] {
        const TableState& table = program.app.table;
        return table.answer && table.answer->request.words == table.words;
    });
    program.settle();
}

void choose_use(Program& program, int column, const std::string& use) {
    program.click("table:use " + std::to_string(column));
    program.click("table:offer " + use);
    wait_for_answer(program);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

std::string recording(const std::string& head) {
    std::string text = head + "\n";
    for (int n = 0; n < 1500; ++n) {
        text += std::to_string(n) + "," + std::to_string(n) + "," +
                std::to_string(0.4 * std::sin(0.05 * n)) + "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("open table: nothing is typed but what the columns hold, and that is remembered") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    const auto file = folder.write("answers.csv", kAnswers);
    read_tables(app.ui, app.work, app.table, {file});
    wait_until(program, [&app] { return app.ui.dialog != kNoDialog; });
    REQUIRE(app.ui.dialog == kTableDialog);
    wait_for_answer(program);
    CHECK(
        has(program.at("table:outcome").value, "the columns are code, one, other, how far, seen"));
    CHECK_FALSE(has(program.at("table:outcome").value, "--columns"));
    program.click("button:choose");  // it cannot be pressed
    CHECK(app.ui.dialog == kTableDialog);
    CHECK(app.work.document.set.ratings.empty());

    choose_use(program, 2, "pattern A");
    choose_use(program, 3, "pattern B");
    choose_use(program, 4, "rating");
    CHECK(program.at("table:use 2").value == "pattern A");
    CHECK(program.at("table:outcome").value ==
          "3 patterns of the set are rated, by 1 participant.");
    program.click("button:choose");
    CHECK(app.ui.dialog == kNoDialog);
    REQUIRE(app.work.document.set.ratings.size() == 1);
    undo(app.ui, app.work);
    CHECK(app.work.document.set.ratings.empty());

    // Another file of the same shape, its letters in another case.
    std::string more = kAnswers;
    more.replace(0, 4, "CODE");
    open_table(app.ui, app.work, app.table, folder.write("more.csv", more));
    wait_for_answer(program);
    CHECK(program.at("table:use 4").value == "rating");
    program.click("button:choose");
    CHECK(app.work.document.set.ratings.size() == 1);
}

TEST_CASE("open table: a use belongs to one column") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    open_table(app.ui, app.work, app.table,
               folder.write("a.csv", "a,b,rating,rating2\np1,p2,1,10\np1,p3,2,20\np2,p3,3,30\n"));
    wait_for_answer(program);
    CHECK(program.at("table:use 3").value == "rating");
    choose_use(program, 4, "rating");
    CHECK(program.at("table:use 3").value.empty());
    CHECK(program.at("table:use 4").value == "rating");
    CHECK(program.at("table:use 1").value == "pattern A");
    program.click("button:choose");
    REQUIRE(app.work.document.set.ratings.size() == 1);
    CHECK(app.work.document.set.ratings[0].condensed[0] == 10.0);
}

TEST_CASE("open table: a column without a name of its own goes by its number") {
    TableAnswer answer;
    answer.head.rows = {{"x", "x", " ", "y"}};
    answer.uses = {"", "", "", ""};
    TableWords words;
    words.kind = TableKind::recording;
    use_column(words, answer, 1, "x");
    CHECK(words.axes.x == "2");
    use_column(words, answer, 2, "x");
    CHECK(words.axes.x == "3");
    use_column(words, answer, 3, "time");
    CHECK(words.axes.time == "y");
}

TEST_CASE(
    "open table: what is dropped is read beside the window, and asks where nothing else does") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    const auto ratings = folder.write("fine.csv", "a,b,rating\np1,p2,10\np1,p3,35\np2,p3,70\n");
    drop_paths(app, {ratings});
    CHECK(app.work.document.set.ratings.empty());
    wait_until(program, [&app] { return app.table.taken == app.table.asked; });
    CHECK_FALSE(app.work.document.set.ratings.empty());
    CHECK(app.ui.dialog == kNoDialog);
    drop_paths(app, {folder.write("p1.csv", recording("time_ms,no,x"))});
    wait_until(program, [&app] { return app.ui.dialog == kImportDialog; });
    // A button would move when what is looked at in the background comes in.
    program.press_key(key::kEscape);
    wait_until(program, [&app] { return app.ui.dialog == kNoDialog; });
    drop_paths(app, {folder.write("answers.csv", kAnswers)});
    REQUIRE(app.table.taken < app.table.asked);
    app.ui.dialog = kAboutDialog;
    wait_until(program, [&app] {
        const auto read = app.table.reading_job.latest();
        return read && read->request.number == app.table.asked;
    });
    program.settle();
    CHECK(app.ui.dialog == kAboutDialog);
    program.press_key(key::kEscape);
    wait_until(program, [&app] { return app.ui.dialog == kTableDialog; });
    CHECK(app.ui.dialog == kTableDialog);
}

TEST_CASE("open table: ratings that were dropped for another set are not its own") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    read_tables(app.ui, app.work, app.table,
                {folder.write("fine.csv", "a,b,rating\np1,p2,10\np1,p3,35\np2,p3,70\n")});
    ++app.work.document_number;
    follow_tables(app.ui, app.work, app.layout, app.table, app.importing);
    const auto until = end_of_patience();
    while (app.table.taken != app.table.asked && std::chrono::steady_clock::now() < until) {
        follow_tables(app.ui, app.work, app.layout, app.table, app.importing);
    }
    CHECK(app.work.document.set.ratings.empty());
    CHECK(has(app.ui.status.text, "not open any more"));
}

TEST_CASE("open table: a separator that is said is taken, and a wrong one is told") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    open_table(app.ui, app.work, app.table,
               folder.write("a.csv", "a;b;rating\np1;p2;1,234\np1;p3;2,345\np2;p3;3,456\n"));
    wait_for_answer(program);
    CHECK(has(program.at("table:outcome").value, "may be thousands"));
    program.click("table:Decimals 0,5");
    wait_for_answer(program);
    CHECK(has(program.at("table:outcome").value, "3 patterns of the set"));
    program.click("table:Between cells tabs");
    wait_for_answer(program);
    CHECK_FALSE(has(program.at("table:outcome").value, "patterns of the set"));
}

TEST_CASE("open table: the columns of a recording are told from the dialog on it") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    import_recordings(app.ui, app.work, app.importing,
                      {folder.write("p1.csv", recording("no,tick,force"))});
    program.settle();
    program.click("button:columns");
    REQUIRE(app.ui.dialog == kTableDialog);
    wait_for_answer(program);
    choose_use(program, 2, "time");
    choose_use(program, 3, "x");
    choose_use(program, 1, "not read");
    program.click("table:Times in ms");
    wait_for_answer(program);
    CHECK(has(program.at("table:outcome").value, "A recording of 1.5 s"));
    program.click("button:choose");
    CHECK(app.ui.dialog == kImportDialog);
    wait_until(program, [&app] {
        const auto& answer = app.importing.answer;
        return answer && answer->request.options.table.columns.x == "force";
    });
    CHECK(app.importing.answer->files[0].fault.empty());
}

TEST_CASE("open table: columns without names go by their number, and a unit is said once") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    std::string text;
    for (int n = 0; n < 1500; ++n) {
        text += std::to_string(0.001 * n) + "," + std::to_string(n % 7) + "," +
                std::to_string(9.8 + 4.0 * std::sin(0.05 * n)) + "\n";
    }
    open_table(app.ui, app.work, app.table, folder.write("p1.csv", text), TableKind::recording);
    wait_for_answer(program);
    choose_use(program, 1, "time");
    choose_use(program, 3, "x");
    choose_use(program, 2, "not read");
    CHECK(app.table.words.axes.x == "3");
    CHECK(has(program.at("table:outcome").value, "gravity in m/s2"));
    program.click("table:Values in m/s\u00b2");
    wait_for_answer(program);
    CHECK(has(program.at("table:outcome").value, "A recording of 1.5 s, at most 0.4"));
    program.click("button:choose");
    wait_until(program, [&app] { return app.importing.answer != nullptr; });
    CHECK(app.importing.answer->request.options.unit == AccelerationUnit::m_per_s2);
    CHECK(app.importing.answer->files[0].fault.empty());
}

TEST_CASE("open table: what was said is kept with the settings, and damage says nothing") {
    TableWords words;
    words.kind = TableKind::recording;
    words.written = {'\t', ','};
    words.scale = RatingScale::similarity;
    words.answers = {"a\"1", "b", "", "who", {}};
    words.axes = {"t", "", "y", "z"};
    words.time_unit = TimeUnit::us;
    words.unit = AccelerationUnit::m_per_s2;
    CHECK(words_in(text_of(words)) == words);
    CHECK(words_in(text_of(TableWords{})) == TableWords{});
    for (const char* damaged :
         {"", "[]", "{", "{\"kind\": 7, \"scale\": -1, \"separator\": \"x\", \"columns\": 3}"}) {
        CAPTURE(damaged);
        CHECK(words_in(damaged) == TableWords{});
    }

    const TemporaryFolder folder;
    TableHead head;
    head.rows = {{"One", " two "}};
    Session session = open_session(folder.path);
    remember_words(session, head, words);
    REQUIRE(write_session(session));
    REQUIRE(close_session(session));
    session = {};
    head.rows = {{"one", "TWO"}};
    CHECK(remembered_words(open_session(folder.path), head) == words);
    head.rows = {{"one", "three"}};
    CHECK(remembered_words(open_session(folder.path), head) == TableWords{});
}

}  // namespace table_look_test
