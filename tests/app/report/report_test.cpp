#include "app/report/report.h"

#include <doctest/doctest.h>

#include <memory>

#include "model/common/random.h"
#include "tests/support/mixed_set.h"
#include "tests/support/times_in.h"

namespace report_test {

using namespace tact;

namespace {

std::string section(const std::string& page, const std::string& id) {
    const std::size_t begin = page.find("<section id=\"" + id + "\">");
    REQUIRE(begin != std::string::npos);
    return page.substr(begin, page.find("</section>", begin) - begin);
}

// Two within a felt step, one that differs from them by less than two, and two far away.
struct Five {
    PatternSet set;
    Dissimilarity apart{5, {1.0, 3.0, 9.0, 9.5, 2.5, 8.0, 8.5, 7.0, 7.5, 4.0}};
    PerceptualSpace space;

    Five() {
        set.name = "Five & more";
        for (const char* name : {"one", "two", "<three>", "four", "five"}) {
            Pattern pattern;
            pattern.duration_s = 0.05;
            constexpr double kHz[] = {60.0, 65.0, 80.0, 180.0, 300.0};
            pattern.carriers[0].frequency_hz = kHz[set.vibrations.size()];
            Vibration vibration;
            vibration.name = name;
            vibration.source = pattern;
            set.vibrations.push_back(vibration);
        }
        space.points.resize(5, 3);
        space.points << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 5.0, 5.0, 1.0, 6.0, 7.0, 2.0;
    }

    Report report(std::size_t count = 3) const {
        const SubsetAnswer answer = *most_distinct_subset(apart, {.count = count});
        return {.set = set,
                .felt = set,
                .dissimilarity = apart,
                .answer = answer,
                .space = space,
                .alike = {groups_within_a_step(set, apart),
                          groups_below(apart, answer.best.weakest_dissimilarity),
                          {}},
                .closer_than = closer_than_picked(answer),
                .program = "tactspace 1.2.3",
                .date = "2026-11-22"};
    }
};

}  // namespace

TEST_CASE("report: a page alone, of all its parts, the same each time, and no name breaks it") {
    const Five five;
    const std::string page = report_page(five.report());
    CHECK(page == report_page(five.report()));
    for (const char* id : {"map", "groups", "closer", "subset", "patterns", "matrix", "assumed"}) {
        CHECK_FALSE(section(page, id).empty());
    }
    CHECK(times_in(page, "<title>Five &amp; more</title>") == 1);
    CHECK(times_in(page, "<three>") == 0);
    CHECK(times_in(page, "&lt;three&gt;") > 3);
    for (const char* way_out : {"http://", "https://", "<script", "@import", "src=\"/"}) {
        CHECK(times_in(page, way_out) == 0);
    }
    CHECK(times_in(page, "src=\"") == times_in(page, "src=\"data:audio/wav;base64,"));
    CHECK(times_in(page, "tactspace 1.2.3, 2026-11-22") == 1);
}

TEST_CASE(
    "report: only what is within a felt step feels the same; what is closer than your 3 is so") {
    const Five five;
    const Report report = five.report();
    REQUIRE((report.answer.best.members == std::vector<std::size_t>{0, 3, 4}));  // weakest 4
    const std::string page = report_page(report);
    const std::string groups = section(page, "groups");
    CHECK(times_in(groups, "an amplitude by 19 %, a carrier by 20 %") == 1);
    CHECK(times_in(groups, "<tr><td>") == 1);
    CHECK(times_in(groups, ">one<") >= 1);
    CHECK(times_in(groups, ">two<") >= 1);
    CHECK(times_in(groups, ">&lt;three&gt;<") == 0);  // closer than the picked, and over a step
    CHECK(times_in(page, "<b>2</b>of them in 1 group that feel the same") == 1);
    CHECK(times_in(page, "<b>3</b>of 10 pairs closer than your 3") == 1);
    const std::string closer = section(page, "closer");
    CHECK(times_in(closer, "<h2>Closer than your 3</h2>") == 1);
    CHECK(times_in(closer,
                   "3 of 10 pairs have a PM below <b>4</b>, as far apart as the weakest pair of "
                   "the 3 most distinct, proven.") == 1);
    CHECK(times_in(closer,
                   "Were each group one, 3 would be left of 5 patterns; at half the threshold (PM "
                   "2) 4, at a quarter (PM 1) 5.") == 1);
    CHECK(times_in(closer, ">&lt;three&gt;<") >= 1);
    CHECK(times_in(closer, "onfuse") == 1);  // "no sign that people confuse them"
    const std::string patterns = section(page, "patterns");
    // Once each in the sentence on them, then of a pattern each.
    CHECK(times_in(patterns, "verdict same") == 1 + 2);
    CHECK(times_in(patterns, "verdict hard") == 1 + 1);
    CHECK(times_in(patterns, "verdict clear") == 1 + 2);
    CHECK(times_in(patterns, "<audio") == 5);
    CHECK(times_in(patterns, "class=\"wave\"") == 5);
    CHECK(times_in(section(page, "subset"), "Proven optimal") == 1);
    CHECK(times_in(section(page, "assumed"), "Nobody has measured at which PM") == 1);
    CHECK(times_in(section(page, "assumed"), "no probability of a confusion") == 1);
    // The word is in no cell of the matrix, either.
    CHECK(times_in(section(page, "matrix"), "onfuse") == 0);
}

TEST_CASE("report: the matrix has a cell for each ordered pair, with names and value on hover") {
    const Five five;
    const std::string matrix = section(report_page(five.report()), "matrix");
    CHECK(times_in(matrix, "<td") == 25);
    CHECK(times_in(matrix, "title=\"one \u2013 two: 1\"") == 1);
    CHECK(times_in(matrix, "title=\"two \u2013 one: 1\"") == 1);
    CHECK(times_in(matrix, " x\" title=") ==
          2 * 3);  // closer than the three: three pairs, both ways
    const Five many;
    Report large = many.report();
    PatternSet set = many.set;
    while (set.vibrations.size() <= kMostMatrixRows) set.vibrations.push_back(set.vibrations[0]);
    const Dissimilarity apart{set.vibrations.size(),
                              std::vector<double>(pair_count(set.vibrations.size()), 1.0)};
    PerceptualSpace none;
    none.verdict = MdsVerdict::constant;
    const Report thinned{.set = set,
                         .felt = set,
                         .dissimilarity = apart,
                         .answer = large.answer,
                         .space = none,
                         .alike = {{}, groups_below(apart, 0.5), {}}};
    const std::string page = report_page(thinned);
    CHECK(times_in(section(page, "matrix"), "<img class=\"pairs\"") == 1);
    CHECK(times_in(section(page, "matrix"), "<td") == 0);
    CHECK(times_in(section(page, "map"), "any map fits") == 1);
    CHECK(times_in(section(page, "groups"), "There are no two such patterns") == 1);
}

TEST_CASE("report: of a thousand patterns it stays below 5 MB, cuts its lists and says so" *
          doctest::test_suite("long")) {
    const PatternSet set = mixed_set(1000);
    RandomStream random{5};
    Dissimilarity apart{1000, std::vector<double>(pair_count(1000))};
    for (double& value : apart.condensed) value = next_even(random);
    apart.condensed = average_ranks(apart.condensed);
    const std::vector<std::size_t> unfelt{7, 11};
    SubsetProblem problem{.count = 8};
    problem.drop = unfelt;
    const SubsetAnswer answer = *most_distinct_subset(apart, problem, {.time_limit_s = 2.0});
    PerceptualSpace none;
    none.verdict = MdsVerdict::constant;
    const Report report{
        .set = set,
        .felt = set,
        .dissimilarity = apart,
        .answer = answer,
        .space = none,
        .alike = alike_patterns(set, {apart, unfelt}, answer.best.weakest_dissimilarity, 8),
        .unfelt = unfelt,
        .closer_than = closer_than_picked(answer)};
    const std::string page = report_page(report);
    CHECK(page.size() < 5'000'000);
    // Who is picked can be felt, whatever else has room.
    const std::string patterns = section(page, "patterns");
    for (const std::size_t member : answer.best.members) {
        CHECK(times_in(patterns, "aria-label=\"" + set.vibrations[member].name + "\"") == 1);
    }
    CHECK(times_in(patterns, "preload=\"metadata\"") <= 50);  // browsers refuse more
    CHECK(times_in(patterns, "Players of ") == 1);
    CHECK(times_in(patterns, ">not felt<") == unfelt.size());
    CHECK(times_in(section(page, "unfelt"), "2 patterns") == 1);
    CHECK(times_in(section(page, "alike"), "<tr><td>") == 8);
    CHECK(times_in(section(page, "alike"), "e+") == 0);  // half a million is written out
    CHECK(times_in(section(page, "closer"), " more pairs.") == 1);
    CHECK(times_in(section(page, "closer"), "</span> and ") >= 1);  // the names of a large group
    CHECK(times_in(section(page, "closer"), ">" + set.vibrations[7].name + "<") == 0);
}

TEST_CASE("report: marks travel with the numbers: synthetic, device, trained model, labels") {
    Five five;
    five.set.model_origin.trained_on = "Trained on nobody.";
    Measurement computed;
    computed.waveform = std::make_shared<const Waveform>(render(Pattern{}));
    computed.synthetic = true;
    five.set.vibrations[1].source = computed;
    five.set.vibrations[2].note = "From a.ahap (AHAP). Actuator map quest: g is guessed.";
    five.set.vibrations[3].note = "From b.ahap (AHAP). Actuator map quest: g is guessed.";
    Report report = five.report();
    report.by = RenderedBy{};
    report.labels = {"SYNTHETIC: some"};
    const std::string page = report_page(report);
    CHECK(times_in(page, "<p class=\"warning\">SYNTHETIC: some</p>") == 1);
    CHECK(times_in(section(page, "patterns"), "<b>synthetic</b>") == 1);
    CHECK(times_in(section(page, "patterns"), "From a.ahap (AHAP).") == 1);
    const std::string assumed = section(page, "assumed");
    CHECK(times_in(assumed, "1 SYNTHETIC: measured by nobody") == 1);
    CHECK(times_in(assumed, "Trained on nobody.") == 1);
    CHECK(times_in(assumed, "uncalibrated") == 1);
    CHECK(times_in(assumed, "<dt>2 patterns</dt><dd>Actuator map quest: g is guessed.</dd>") == 1);
}

TEST_CASE(
    "report: a search that ran out of time is not called proven, an alternative not the best") {
    const Five five;
    Report report = five.report();
    report.answer.proof = SubsetProof::open;
    report.answer.bound = 7.25;
    report.closer_than = closer_than_picked(report.answer);
    std::string page = report_page(report);
    CHECK(times_in(page, "roven") == 0);
    CHECK(times_in(section(page, "subset"), "No weakest pair is above 7.25") == 1);
    report.answer.proof = SubsetProof::optimal;
    report.best_worth = 5.5;
    page = report_page(report);
    CHECK(times_in(section(page, "subset"),
                   "taken instead of the best one, whose weakest pair has 5.5") == 1);
    CHECK(times_in(section(page, "subset"), "Proven optimal") == 0);
}

TEST_CASE("report: how sure is there only where it was asked, with a share of draws for each") {
    const Five five;
    Report report = five.report();
    CHECK(times_in(report_page(report), "How sure") == 0);
    Stability sure;
    sure.draws = 20;
    sure.share_picked = {1.0, 0.25, 0.0, 0.75, 1.0};
    sure.share_same = 0.5;
    sure.subset = report.answer.best;
    report.stability = &sure;
    const std::string subset = section(report_page(report), "subset");
    CHECK(times_in(subset, "In 20 draws") == 1);
    CHECK(times_in(subset, "<b>50 %</b>") == 1);
    CHECK(times_in(subset, "25 %") == 1);
    CHECK(times_in(subset, "&lt;three&gt;") == 0);  // never picked
}

}  // namespace report_test
