// The Compare, Shepard and Why tabs, through the program's real frames.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/measured/measured.h"
#include "app/tables/tables.h"
#include "model/io/set/set_file.h"
#include "tests/support/compare_bench.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace compare_panel_test {

using namespace tact;

namespace {

std::vector<double> numbers_in(const std::string& text) {
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string word; stream >> word;) numbers.push_back(std::stod(word));
    return numbers;
}

// null stands for NaN.
double number(const nlohmann::json& value) {
    return value.is_null() ? std::nan("") : value.get<double>();
}

}  // namespace

TEST_CASE("compare tab: without ratings it says what to load, and compares with PM meanwhile") {
    CompareBench bench;
    bench.program.click("tab:Compare");
    bench.wait_for_comparison();
    CHECK(bench.program.shows("button:load ratings"));
    CHECK_FALSE(bench.program.shows("link:load ratings"));  // once is enough
    CHECK_FALSE(bench.program.shows("compare:people"));
    const double pm = std::stod(bench.program.at("metric:pm").value);
    CHECK(pm == 1.0);
    CHECK(bench.program.shows("metric:no-physiology"));
    bench.program.click("button:load ratings");
    CHECK(bench.program.app.ui.chooser.is_open);
    CHECK(bench.program.app.ui.chooser.title ==
          "Load ratings: a table, or a folder with one for each participant");
}

TEST_CASE("compare tab: its numbers are those of the command line, to the last bit" *
          doctest::test_suite("long")) {
    CompareBench bench;
    bench.load(square_csv());
    CHECK(bench.program.app.layout.bench == BenchTab::compare);
    bench.wait_for_comparison();
    const auto set = (bench.folder.path / "set.tactspace.json").string();
    REQUIRE(write_set_file(set, bench.program.app.work.document.set));
    const auto rows = nlohmann::json::parse(output_of({"compare", set, "--json"}));
    REQUIRE(rows.size() >= 3);
    for (const auto& row : rows) {
        const auto key = row.at("metric").get<std::string>();
        const std::vector<double> shown = numbers_in(bench.program.at("metric:" + key).value);
        REQUIRE(shown.size() == 6);
        std::size_t column = 0;
        for (const char* name : {"rho", "rho_low", "rho_high", "p", "K", "K_p"}) {
            const double expected = number(row.at(name));
            const double got = shown[column++];
            CHECK_MESSAGE((got == expected || (std::isnan(got) && std::isnan(expected))),
                          key << " " << name << ": " << got << " is not " << expected);
        }
    }
    CHECK(bench.program.shows("link:load ratings"));
    CHECK(bench.program.shows("ours:no-physiology"));
    const std::string people = bench.program.at("compare:people").value;
    CHECK(contains(people, "people.csv: 1 participant, 15 of 15 pairs"));
    CHECK(contains(bench.program.at("compare:ceiling").value, "Noise ceiling unknown"));
}

TEST_CASE("compare tab: loading ratings is one step, kept with the set and renamed with it") {
    CompareBench bench;
    bench.load(square_csv());
    App& app = bench.program.app;
    REQUIRE(app.work.document.set.ratings.size() == 1);
    CHECK_FALSE(app.ui.status.is_error);
    rename_vibration(app.ui, app.work, 0, "tap");
    CHECK(app.work.document.set.ratings[0].labels[0] == "tap");
    bench.wait_for_comparison();
    CHECK(bench.program.shows("compare:people"));
    undo(app.ui, app.work);
    undo(app.ui, app.work);
    CHECK(app.work.document.set.ratings.empty());
    bench.wait_for_comparison();
    CHECK(bench.program.shows("button:load ratings"));
    redo(app.ui, app.work);
    CHECK(app.work.document.set.ratings.size() == 1);
}

TEST_CASE("compare tab: a file that does not fit is refused in words and changes nothing") {
    CompareBench bench;
    App& app = bench.program.app;
    bench.load(",p1,x\np1,0,1\nx,1,0\n");
    CHECK(app.ui.status.is_error);
    CHECK(contains(app.ui.status.text,
                   "people.csv: expected names of patterns of the set, got \"x\""));
    bench.load("a,b\n1,two,3\n", "odd.csv");
    CHECK(app.ui.status.is_error);
    CHECK(contains(app.ui.status.text, "odd.csv"));
    read_tables(app.ui, app.work, app.table, {bench.folder.path / "none.csv"});
    bench.wait_until([&app] { return app.table.taken == app.table.asked; });
    CHECK(app.ui.status.is_error);
    CHECK(contains(app.ui.status.text, "none.csv"));
    CHECK(app.work.document.set.ratings.empty());
    CHECK(app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("compare tab: of a pattern that is gone the ratings are left out, and it says so") {
    CompareBench bench;
    bench.load(square_csv());
    bench.program.press_key(key::kDelete);
    bench.wait_for_comparison();
    CHECK(bench.program.shows("compare:people"));
    CHECK(contains(bench.program.at("compare:gone").value, "left out: \"p1\""));
    CHECK_FALSE(bench.program.shows("compare:fault"));
    CHECK_FALSE(bench.program.shows("compare:edited"));
    undo(bench.program.app.ui, bench.program.app.work);
    bench.wait_for_comparison();
    CHECK(bench.program.shows("compare:people"));
    CHECK_FALSE(bench.program.shows("compare:gone"));
}

TEST_CASE("compare tab: ratings of a pattern that was edited since are stale, at every number") {
    CompareBench bench;
    bench.load(square_csv());
    App& app = bench.program.app;
    bench.wait_for_comparison();
    CHECK(bench.program.at("compare:head rho").value == "rho");
    CHECK_FALSE(bench.program.shows("compare:unrecorded"));
    edit_patterns(app.work, [](Pattern& pattern) { pattern.amplitude_g *= 0.5; });
    commit_step(app.ui, app.work, "amplitude of p1");
    bench.wait_for_comparison();
    CHECK(bench.program.at("compare:head rho").value == "stale rho");
    CHECK(contains(bench.program.at("compare:edited").value, "rated: \"p1\""));
    CHECK(bench.program.at("strength:p1").value == "edited");
    CHECK(bench.program.at("strength:p2").value != "edited");
    undo(app.ui, app.work);
    bench.wait_for_comparison();
    CHECK(bench.program.at("compare:head rho").value == "rho");
    CHECK(bench.program.at("strength:p1").value != "edited");
    // Older files do not say what was felt.
    for (Ratings& one : app.work.document.edit().ratings) one.versions.clear();
    document_changed(app.work);
    commit_step(app.ui, app.work, "as before");
    bench.wait_for_comparison();
    CHECK(bench.program.shows("compare:unrecorded"));
}

TEST_CASE("compare tab: two participants make a noise ceiling; unrated pairs are left out") {
    CompareBench bench;
    std::string lines = "participant,a,b,rating\n";
    for (int person = 1; person <= 2; ++person) {
        for (int i = 1; i <= 6; ++i) {
            for (int j = i + 1; j <= 6; ++j) {
                if (i == 1 && j == 2) continue;
                lines += "P" + std::to_string(person) + ",p" + std::to_string(i) + ",p" +
                         std::to_string(j) + "," + std::to_string(10 * i + j + person * (i % 2)) +
                         "\n";
            }
        }
    }
    bench.load(lines);
    bench.wait_for_comparison();
    const std::string people = bench.program.at("compare:people").value;
    CHECK(contains(people, "2 participants, 14 of 15 pairs"));
    CHECK(contains(bench.program.at("compare:ceiling").value, "reaches"));
    bench.program.click("compare:Pairs");
    CHECK(bench.program.shows("view:Pairs"));
}

TEST_CASE("compare tab: a row chooses the metric of the pairs and of the Shepard diagram") {
    CompareBench bench;
    bench.load(square_csv());
    bench.wait_for_comparison();
    bench.program.click("metric:mtm");
    CHECK(bench.program.app.comparing.panel.metric == "mtm");
    bench.program.click("compare:Pairs");
    CHECK(bench.program.at("combo:metric").value == "Mtm");
    bench.program.click("tab:Shepard");
    CHECK(bench.program.at("combo:metric").value == "Mtm");
    bench.program.click("combo:metric");
    bench.program.click("choose:ratings");
    CHECK(bench.program.at("combo:metric").value == "Ratings");
    CHECK(contains(bench.program.at("view:Shepard").value, "stress-1"));
    bench.program.click("combo:metric");
    bench.program.click("choose:pm");
    char stress[32];
    std::snprintf(stress, sizeof stress, "stress-1 %.3f,",
                  bench.program.app.shown_map.transition.shown->space.stress1);
    CHECK(contains(bench.program.at("view:Shepard").value, stress));
}

TEST_CASE("compare tab: a point of the scatter selects its pair, a listed pair opens its Why") {
    CompareBench bench;
    bench.load(square_csv());
    bench.wait_for_comparison();
    bench.program.click("compare:Pairs");
    const App& app = bench.program.app;
    bench.program.click("pair point:" + std::to_string(pair_index(kRatedPatterns, 2, 4)));
    auto pair = chosen_pair(app.work, app.shown_map);
    REQUIRE(pair);
    // Another pair may have the same index; the choice is then that one.
    CHECK(pair->kind == PartnerKind::chosen);
    const auto& people = app.comparing.comparison->people->said.rated.people.dissimilarity;
    CHECK(people(pair->current, pair->partner) == people(2, 4));

    const auto worst = disagreements(app.comparing.comparison->metrics[0].matrix, people).front();
    const auto [i, j] = pair_at(kRatedPatterns, worst.pair);
    const std::string names = "p" + std::to_string(i + 1) + "|p" + std::to_string(j + 1);
    bench.program.click("disagreement:" + names);
    CHECK(app.layout.bench == BenchTab::why);
    CHECK(bench.program.at("why:pair").value == names);
}

TEST_CASE("compare tab: disagreement is the difference of ranks among the rated pairs") {
    const double none = std::nan("");
    const Dissimilarity metric{4, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}};
    const Dissimilarity ratings{4, {50.0, none, 10.0, 20.0, 20.0, 60.0}};
    const auto all = disagreements(metric, ratings);
    REQUIRE(all.size() == 5);
    CHECK(all[0].pair == 0);  // rank 1 of 5, felt as rank 4
    CHECK(all[0].metric_rank == 1.0);
    CHECK(all[0].ratings_rank == 4.0);
    CHECK(all[1].pair == 4);  // 4, and 2.5 for the one with the tie
    CHECK(all[1].ratings_rank == 2.5);
}

TEST_CASE("compare tab: cancelled, it waits for a word or the next edit") {
    CompareBench bench;
    bench.program.app.layout.bench = BenchTab::compare;
    bench.program.frame();
    cancel_comparison(bench.program.app.work, bench.program.app.comparing);
    bench.wait_until([&] { return !bench.program.app.comparing.comparison_job.busy(); });
    CHECK(bench.program.app.comparing.comparison == nullptr);
    for (int k = 0; k < 5; ++k) bench.program.frame();
    CHECK_FALSE(bench.program.app.comparing.comparison_job.busy());
    bench.program.click("button:compare metrics");
    bench.wait_for_comparison();
    CHECK(bench.program.shows("metric:pm"));
}

TEST_CASE("compare tab: silence and equal patterns have words, not numbers") {
    PatternSet set = short_patterns(4);
    for (Vibration& vibration : set.vibrations) {
        std::get<Pattern>(vibration.source).amplitude_g = 0.0;
    }
    CompareBench bench(set);
    bench.load(",p1,p2,p3,p4\np1,0,1,2,3\np2,1,0,4,5\np3,2,4,0,6\np4,3,5,6,0\n");
    bench.wait_for_comparison();
    const std::vector<double> pm = numbers_in(bench.program.at("metric:pm").value);
    CHECK(std::isnan(pm[0]));
    CHECK(contains(bench.program.at("compare:remarks").value, "PM: no rho"));
    bench.program.click("compare:Pairs");
    bench.program.click("tab:Shepard");
    bench.program.click("tab:Why");
    bench.wait_for_difference();
    CHECK(bench.program.app.comparing.difference->path.distance == 0.0);
    CHECK_FALSE(bench.program.shows("why:channel Pacinian"));
}

TEST_CASE("compare tab: no pattern or one has no pair, in every tab") {
    for (const std::size_t count : {0UL, 1UL}) {
        CompareBench bench(short_patterns(count));
        for (const char* tab : {"tab:Compare", "tab:Shepard", "tab:Why"}) bench.program.click(tab);
        CHECK_FALSE(bench.program.shows("why:pair"));
        bench.program.click("tab:Compare");
        for (const char* view : {"compare:Pairs", "compare:Findings", "compare:Table"}) {
            bench.program.click(view);
        }
        CHECK_FALSE(bench.program.shows("metric:pm"));
    }
}

TEST_CASE("overlay: the map of the ratings lies over the predicted one, and follows it into 2-D" *
          doctest::test_suite("long")) {
    CompareBench bench;
    App& app = bench.program.app;
    CHECK_FALSE(bench.program.shows("check:overlay ratings"));
    bench.load(square_csv());
    bench.wait_for_comparison();
    bench.program.click("check:overlay ratings");
    CHECK(bench.program.shows("overlay"));
    const auto over = people_over_map(app.shown_map, app.comparing);
    REQUIRE(over);
    CHECK(over->cols() == 3);
    // The maps are aligned: no shift is left, and no rotation or scale would bring them closer.
    CHECK((over->colwise().mean() - app.shown_map.transition.to.colwise().mean()).norm() <= 1e-9);
    const double apart = (*over - app.shown_map.transition.to).norm();
    CHECK((*over * 1.02 - app.shown_map.transition.to).norm() >= apart);
    CHECK((*over * 0.98 - app.shown_map.transition.to).norm() >= apart);
    bench.program.click("radio:2-D");
    bench.wait_for_comparison();
    CHECK(people_over_map(app.shown_map, app.comparing)->cols() == 2);
    CHECK(bench.program.shows("overlay"));
}

TEST_CASE("findings: they are checked on request, and can be cancelled") {
    CompareBench bench;
    bench.program.click("tab:Compare");
    bench.program.click("compare:Findings");
    CHECK(bench.program.app.comparing.findings == nullptr);
    bench.program.click("button:check findings");
    bench.program.click("link:cancel findings");
    bench.wait_until([&] { return !bench.program.app.comparing.findings_job.busy(); });
    CHECK(bench.program.app.comparing.findings == nullptr);
    CHECK(bench.program.shows("button:check findings"));
}

TEST_CASE("compare: ratings of the patterns alone can be held against either side of their twins" *
          doctest::test_suite("long")) {
    CompareBench bench(with_synthetic_twins(short_patterns(4), {}));
    bench.load(",p1,p2,p3,p4\np1,0,1,2,3\np2,1,0,4,5\np3,2,4,0,6\np4,3,5,6,0\n");
    bench.wait_for_comparison();
    REQUIRE(bench.program.app.comparing.comparison->people);
    CHECK(bench.program.app.comparing.comparison->people->said.unrated.size() == 4);  // the twins
    bench.program.click("button:measured only");
    CHECK(shown_side(bench.program.app.work) == Side::measured);
    bench.wait_for_comparison();
    REQUIRE(bench.program.app.comparing.comparison->people);
    CHECK_FALSE(bench.program.shows("compare:fault"));
    show_side(bench.program.app.work, Side::both);
    bench.wait_for_comparison();
    bench.program.click("button:intended only");
    bench.wait_for_comparison();
    CHECK(bench.program.app.comparing.comparison->people);
}

TEST_CASE("compare tab: a matrix of one's own is a row beside the others, marked as foreign" *
          doctest::test_suite("long")) {
    CompareBench bench;
    bench.load(square_csv());
    bench.program.click("tab:Compare");
    bench.wait_for_comparison();
    bench.program.click("link:add metric");
    CHECK(bench.program.app.ui.chooser.title ==
          "Add a metric of your own: a matrix, or a function in Python");
    bench.program.press_key(key::kEscape);
    // The matrix holds the ratings themselves, so no metric agrees better.
    Comparing& comparing = bench.program.app.comparing;
    add_metric(bench.program.app.ui, comparing, bench.folder.write("mine.csv", square_csv()));
    bench.wait_for_comparison();
    CHECK(numbers_in(bench.program.at("metric:mine (foreign)").value).at(0) == 1.0);
    CHECK(comparing.panel.metric == "mine (foreign)");
    const ComparedMetric& row = metric_of_key(*comparing.comparison, "mine (foreign)");
    CHECK_FALSE(row.metric);
    CHECK(row.space.points.rows() == static_cast<Eigen::Index>(kRatedPatterns));
    CHECK(contains(comparison_csv(*comparing.comparison), "mine (foreign)"));
    bench.program.click("tab:Why");
    CHECK(contains(bench.program.at("why:mine (foreign)").value, "of 15"));
    bench.program.click("tab:Compare");
    // A metric that fails says why, and the others stay.
    add_metric(bench.program.app.ui, comparing,
               bench.folder.write("other.csv", ",a,b\na,0,1\nb,1,0\n"));
    bench.wait_for_comparison();
    REQUIRE(comparing.comparison->failed.size() == 1);
    CHECK(contains(comparing.comparison->failed[0], "other.csv"));
    CHECK(bench.program.shows("metric:mine (foreign)"));
    bench.program.click("remove metric:other (foreign)");
    bench.wait_for_comparison();
    CHECK(comparing.comparison->failed.empty());
}

TEST_CASE("compare tab: a Python file with several functions is asked about, one without refused") {
    CompareBench bench;
    Comparing& comparing = bench.program.app.comparing;
    Ui& ui = bench.program.app.ui;
    add_metric(ui, comparing, bench.folder.write("none.py", "x = 1\n"));
    CHECK(ui.status.is_error);
    CHECK(comparing.foreign.empty());
    add_metric(ui, comparing,
               bench.folder.write("one.py", "def apart(a, b, rate_hz):\n    return 1\n"));
    REQUIRE(comparing.foreign.size() == 1);
    CHECK(comparing.foreign[0].key == "apart (foreign)");
    CHECK(comparing.panel.metric == "apart (foreign)");
    add_metric(ui, comparing,
               bench.folder.write("two.py",
                                  "def near(a, b, r):\n    return 1\n\n"
                                  "def _own():\n    pass\n\n"
                                  "def far(a, b, r):\n    return 2\n"));
    REQUIRE(ui.question);
    CHECK(ui.question->answers.size() == 3);  // two ratings, and none
    ui.question->answers[1].run();
    CHECK(comparing.foreign.back().key == "far (foreign)");
    remove_metric(comparing, "far (foreign)");
    CHECK(comparing.foreign.size() == 1);
    CHECK(comparing.panel.metric == "pm");
}

}  // namespace compare_panel_test
