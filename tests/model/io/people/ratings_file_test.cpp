#include "model/io/people/ratings_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/io/set/set_file.h"
#include "model/set/set_ratings.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace ratings_file_test {

using namespace tact;

namespace {

LoadedRatings parsed(const std::string& text, RatingScale scale = RatingScale::dissimilarity) {
    auto loaded = parse_ratings(text, "r.csv", scale);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    return *std::move(loaded);
}

std::string fault(const std::string& text, RatingScale scale = RatingScale::dissimilarity) {
    const auto loaded = parse_ratings(text, "r.csv", scale);
    REQUIRE_FALSE(loaded);
    return loaded.error().message;
}

using Values = std::vector<double>;
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("ratings file: all forms of the same ratings say the same") {
    const Values expected{30, 55, 20};
    const LoadedRatings named = parsed(",a,b,c\na,0,30,55\nb,30,0,20\nc,55,20,0\n");
    CHECK(named.study.labels == Names{"a", "b", "c"});
    CHECK(named.study.is_named);
    CHECK(named.study.judgements == std::vector<Judgement>{{"r", expected}});
    CHECK(named.remarks.empty());
    for (const std::string text :
         {"0 30 55\n30 0 20\n55 20 0\n", "0,30,55\r\n30,0,20\r\n55,20,0\r\n", "30,55,20\n",
          "30\n55\n20\n", "\n  30 55  20"}) {
        CAPTURE(text);
        const LoadedRatings bare = parsed(text);
        CHECK_FALSE(bare.study.is_named);
        CHECK(bare.study.labels == Names{"1", "2", "3"});
        CHECK(bare.study.judgements == std::vector<Judgement>{{"r", expected}});
    }
    const LoadedRatings lines = parsed("a,b,rating\nx,y,30\nz,x,55\n\"y\",z,20\n");
    CHECK(lines.study.labels == Names{"x", "y", "z"});
    CHECK(lines.study.judgements == std::vector<Judgement>{{"r", expected}});
}

TEST_CASE("ratings file: a line a rating, of several people, in any order of the columns") {
    const LoadedRatings loaded = parsed(
        "rating,participant,b,a,comment\n1,P1,y,x,\n2,P2,y,x,odd\n3,P1,x,y,again\n4,P2,z,x,\n");
    CHECK(loaded.study.labels == Names{"x", "y", "z"});
    REQUIRE(loaded.study.judgements.size() == 3);
    CHECK(loaded.study.judgements[0].participant == "P1");
    CHECK(loaded.study.judgements[0].condensed[0] == 1.0);
    CHECK(loaded.study.judgements[1].participant == "P1");
    CHECK(loaded.study.judgements[1].condensed[0] == 3.0);
    CHECK(loaded.study.judgements[2].condensed[1] == 4.0);
    CHECK(std::isnan(loaded.study.judgements[2].condensed[2]));
}

TEST_CASE("ratings file: a row a participant") {
    const LoadedRatings loaded = parsed("1,2,3,4,5,6\n6,5,4,3,2,NaN\n");
    CHECK(loaded.study.labels.size() == 4);
    REQUIRE(loaded.study.judgements.size() == 2);
    CHECK(loaded.study.judgements[1].participant == "2");
    CHECK(std::isnan(loaded.study.judgements[1].condensed[5]));
}

TEST_CASE("ratings file: cells without a rating are unknown, one triangle is enough") {
    const LoadedRatings loaded = parsed(",a,b,c\na,,30,NaN\nb,,,20\nc,55,-,\n");
    CHECK(loaded.study.judgements[0].condensed == Values{30, 55, 20});
    CHECK(std::isnan(parsed(",a,b\na,0,NA\nb,,0\n").study.judgements[0].condensed[0]));
}

TEST_CASE("ratings file: of two orders of a pair, the mean, and a remark") {
    const LoadedRatings loaded = parsed(",a,b,c\na,0,30,5\nb,40,0,7\nc,5,7,0\n");
    CHECK(loaded.study.judgements[0].condensed == Values{35, 5, 7});
    CHECK(loaded.remarks ==
          Names{"r.csv: the mean is taken of 1 pair with another rating in either order"});
}

TEST_CASE("ratings file: which way the numbers run is told, or guessed from identical pairs") {
    const std::string similar = ",a,b,c\na,100,70,45\nb,70,100,80\nc,45,80,100\n";
    const Values expected{30, 55, 20};
    CHECK(parsed(similar, RatingScale::similarity).study.judgements[0].condensed == expected);
    CHECK(parsed(similar, RatingScale::similarity).remarks.empty());
    const LoadedRatings guessed = parsed(similar, RatingScale::guess);
    CHECK(guessed.study.judgements[0].condensed == expected);
    CHECK(guessed.remarks == Names{"r.csv: taken as similarities from 0 to 100, as identical "
                                   "patterns are rated 100, others 65 on average"});
    const std::string unlike = "0 30 55\n30 0 20\n55 20 0\n";
    CHECK(parsed(unlike, RatingScale::guess).study.judgements[0].condensed == expected);
    CHECK(parsed("30 55 20", RatingScale::guess).study.judgements[0].condensed == expected);
    CHECK(parsed("30 55 20", RatingScale::guess).remarks ==
          Names{"r.csv: taken as dissimilarities, as no rating of identical patterns tells which "
                "they are"});
    const std::string with_catch = "a,b,rating\nx,y,70\nx,x,95\nx,z,45\ny,z,80\n";
    CHECK(parsed(with_catch, RatingScale::guess).study.judgements[0].condensed == expected);
}

TEST_CASE("ratings file: what breaks the rules is named, with its place") {
    CHECK(fault("") == "r.csv:1: expected ratings, got an empty file");
    CHECK(fault(",a,a\na,0,1\na,1,0\n") == "r.csv:1: expected names that differ, got \"a\" twice");
    CHECK(fault(",a,b\nc,0,1\na,1,0\n") == "r.csv:2: expected the row of \"a\", got \"c\"");
    CHECK(fault(",a,b\na,0,1\na,1,0\n") == "r.csv:3: expected the row of \"b\", got \"a\"");
    CHECK(fault(",a,b\na,0,1\nb,1\n") == "r.csv:3: expected 2 ratings, got 1");
    CHECK(fault(",a,b\na,0,1\n") == "r.csv:2: expected 2 rows, as there are columns, got 1");
    CHECK(fault(",a,b\na,0,1\nb,1,0\nc,1,0\n") ==
          "r.csv:4: expected as many rows as columns, got more");
    CHECK(fault(",a,b\na,0,much\nb,1,0\n") ==
          "r.csv:2: expected a rating, or an empty cell, got \"much\"");
    CHECK(fault("1,2,3\n1,2\n") == "r.csv:2: expected 3 ratings, as in the first row, got 2");
    CHECK(fault("1,2,3,4\n") ==
          "r.csv:1: expected a square, or the n(n-1)/2 pairs of n patterns in every row, got 1 "
          "rows of 4");
    CHECK(fault("a,b,c,rating\n") == "r.csv: expected ratings of at least two patterns");
    CHECK(fault("a,rating\nx,3\n") ==
          "r.csv:1: expected the columns a, b and rating, and participant where there are several");
    CHECK(fault("a,b,rating\nx,y\n") == "r.csv:2: expected 3 fields, got 2");
    CHECK(fault("a,b,rating\nx,,3\n") == "r.csv:2: expected the names of two patterns");
    CHECK(fault("1 2 -3") ==
          "r.csv: expected dissimilarities that are not negative, got -3 for \"2\" and \"3\"");
    CHECK(fault("1 2 101", RatingScale::similarity) ==
          "r.csv: expected similarities from 0 to 100, got 101 for \"2\" and \"3\"");
    CHECK(fault(",a,\"b\na,0,1\n") == "r.csv:1: expected a closing quote");
}

TEST_CASE("ratings file: who is excluded, or felt nothing, does not count, and is named") {
    const std::string text =
        "participant,a,b,rating,attention,excluded,rehearsal,whole,why\n"
        "P1,x,y,70,0,0,0,1,\nP1,x,z,45,0,FALSE,0,1,\nP1,y,z,80,0,0,0,0,\n"
        "P2,x,y,10,0,1,0,1,too low\nP2,x,z,20,0,1,0,1,too low\n"
        "P3,x,y,50,0,1,1,1,\n";
    const LoadedRatings loaded = parsed(text, RatingScale::guess);
    REQUIRE(loaded.study.judgements.size() == 1);
    CHECK(loaded.study.judgements[0].condensed[0] == 30.0);
    CHECK(std::isnan(loaded.study.judgements[0].condensed[2]));  // not felt whole
    CHECK(loaded.left_out ==
          std::vector<LeftOutParticipant>{{"P2", "too low"}, {"P3", kNothingFelt}});
    CHECK(loaded.remarks == Names{"P1: 1 of 3 answers are left out, as they are marked so",
                                  "P2 is not counted: too low",
                                  std::string("P3 is not counted: ") + kNothingFelt});
    const auto with = parse_ratings(text, "r.csv", RatingScale::guess, {{"P2"}, {}});
    REQUIRE(with);
    CHECK(with->study.judgements[1].participant == "P2");
    CHECK(with->study.judgements[1].condensed[1] == 80.0);
    CHECK(contains(fault("participant,a,b,rating,excluded\nP,x,y,1,maybe\n"),
                   "r.csv:2: expected 0 or 1 in the column excluded, got \"maybe\""));
    CHECK(contains(fault("participant,a,b,rating,excluded\nP,x,y,1,1\n"),
                   "r.csv: expected a participant who counts, got none: P is not counted: "));
}

TEST_CASE("ratings file: a misspelt column that says who counts is refused by name") {
    const std::string kRated = "\n1,x,y,70\n0,x,z,45\n1,y,z,80\n";
    const std::string kSorted = "\n1,1,1,x\n0,1,1,y\n1,1,2,z\n";
    for (const auto& [wrong, right] :
         std::vector<std::pair<std::string, std::string>>{{"partcipant", "participant"},
                                                          {"Participants", "participant"},
                                                          {"synthtic", "synthetic"},
                                                          {"Synthetic", "synthetic"},
                                                          {"exclude", "excluded"},
                                                          {"rehersal", "rehearsal"},
                                                          {"wole", "whole"},
                                                          {"fingerpint", "fingerprint"},
                                                          {"atention", "attention"}}) {
        const std::string expected = "r.csv:1: does not know the column \"" + wrong +
                                     "\"; the nearest column is \"" + right + "\"";
        CHECK(fault(wrong + ",a,b,rating" + kRated) == expected);
        CHECK(fault(wrong + ",round,group,pattern" + kSorted) == expected);
        // Beside the right one it is a column of its own.
        CHECK_FALSE(
            contains(fault("a,b,rating," + wrong + "," + right + "\nx,x,no,,\n"), "does not know"));
    }
    CHECK(parsed("a,b,rating,age,comment" + std::string("\nx,y,1,20,a\nx,z,2,20,b\ny,z,3,20,c\n"))
              .remarks.empty());
}

TEST_CASE("ratings file: so many repetitions as a study can have, and no more, in no time") {
    std::string lines = "participant,a,b,rating\n";
    for (int k = 0; k < 100; ++k) lines += "P,x,y," + std::to_string(k) + "\n";
    const LoadedRatings loaded = parsed(lines);
    CHECK(loaded.study.judgements.size() == 100);
    CHECK(loaded.study.judgements[99].condensed == Values{99});
    CHECK(fault(lines + "P,y,x,1\n") ==
          "r.csv:102: expected at most 100 ratings of a pair by a participant");
    std::string many = "participant,a,b,rating\n";
    for (int k = 0; k < 1001; ++k) many += "P" + std::to_string(k) + ",x,y,1\n";
    CHECK(fault(many) == "r.csv:1002: expected at most 1,000 participants");
}

TEST_CASE("ratings file: several files, or a folder of them, are one study") {
    const TemporaryFolder folder;
    const auto first = folder.write("P2.csv", ",a,b,c\na,100,70,45\nb,70,100,80\nc,45,80,100\n");
    const auto second = folder.write("P10.csv", ",c,b,a\nc,100,60,50\nb,60,100,90\na,50,90,100\n");
    folder.write("notes.md", "not ratings");
    const std::vector<std::filesystem::path> files{first, second};
    const auto loaded = read_ratings(files, RatingScale::guess);
    REQUIRE(loaded);
    CHECK(loaded->study.labels == Names{"a", "b", "c"});
    CHECK(loaded->study.judgements ==
          std::vector<Judgement>{{"P2", {30, 55, 20}}, {"P10", {10, 50, 40}}});
    CHECK(loaded->remarks.size() == 1);
    const std::vector<std::filesystem::path> whole{folder.path};
    CHECK(read_ratings(whole, RatingScale::guess)->study == loaded->study);

    folder.write("P11.csv", ",a,b,d\na,0,1,2\nb,1,0,3\nd,2,3,0\n");
    const auto odd = read_ratings(whole, RatingScale::guess);
    REQUIRE_FALSE(odd);
    CHECK(odd.error().message == (folder.path / "P11.csv").string() +
                                     ": expected names of patterns of the set, got \"d\", as in " +
                                     first.string());
    folder.write("P11.csv", "1,2,3\n");
    CHECK(contains(read_ratings(whole, RatingScale::guess).error().message,
                   "P11.csv: expected names of patterns, as in "));
    const std::vector<std::filesystem::path> gone{folder.path / "gone.csv"};
    CHECK(contains(read_ratings(gone, RatingScale::guess).error().message,
                   "gone.csv: there is no such file"));
    const std::vector<std::filesystem::path> empty{folder.path / "empty"};
    std::filesystem::create_directory(empty[0]);
    CHECK(contains(read_ratings(empty, RatingScale::guess).error().message,
                   "empty: expected .csv or .txt files of ratings, got none"));
}

namespace {

// One of the forms that ratings come in.
std::string any_ratings(std::mt19937& random) {
    static const std::vector<std::string> kForms{
        ",a,\"b,\"\"\",c\na,0,30,55\n\"b,\"\"\",30,0,\nc,55,NaN,0\n",
        "0 30 55.5\n30 0 1e-300\n55.5 1e-300 0\n",
        "a,b,rating\nx,y,30\nz,x,-\n\"y\",z,20\nx,y,40\n",
        "participant,a,b,rating\nP1,low,high,80\nP1,low,mid,45\nP2,mid,high,0.125\nP1,low,mid,5\n",
        "30,55,20\n25,60,15\n",
        "participant,a,b,rating,excluded,synthetic,rehearsal\nP1,x,y,1,no,yes,no\n"
        "P1,x,z,2,no,yes,no\nP2,x,y,3,yes,no,no\nP2,y,z,3,yes,no,no\nP1,y,z,9,no,yes,no\n"};
    return kForms[any_below(random, kForms.size())];
}

}  // namespace

TEST_CASE("ratings file: after an accident it is refused, or kept with its set as it was read") {
    std::size_t accepted = 0;
    std::size_t usable = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string text = after_mishaps(any_ratings(random), random);
        const auto loaded = parse_ratings(text, "r.csv", RatingScale::dissimilarity);
        if (!loaded) {
            CHECK(contains(loaded.error().message, "r.csv"));
            CHECK_FALSE(contains(loaded.error().message, "\n"));
            continue;
        }
        const Names& names = loaded->study.labels;
        if (std::ranges::count(names, "") > 0) continue;  // no pattern has no name
        ++accepted;
        PatternSet set;
        for (const std::string& name : names) {
            set.vibrations.emplace_back().name = name;
        }
        set.ratings = kept_ratings(loaded->study, "r.csv");
        const auto again = parse_set(print_set(set), "again.json", {});
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == set);
        const auto before = study_of(set);
        const auto after = study_of(*again);
        REQUIRE(before.operator bool() == after.operator bool());
        if (!after) continue;
        ++usable;
        REQUIRE(after->judgements.size() == loaded->study.judgements.size());
        for (std::size_t k = 0; k < after->judgements.size(); ++k) {
            const Judgement& read = loaded->study.judgements[k];
            CHECK(after->judgements[k].participant == read.participant);
            for (std::size_t n = 0; n < read.condensed.size(); ++n) {
                const double value = after->judgements[k].condensed[n];
                CHECK((value == read.condensed[n] ||
                       (std::isnan(value) && std::isnan(read.condensed[n]))));
            }
        }
        CHECK(is_partly_synthetic(*after) == is_partly_synthetic(loaded->study));
    }
    CHECK(accepted > 200);
    CHECK(usable > 100);
}

}  // namespace ratings_file_test
