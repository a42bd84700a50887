// Answers of other programs: whichever way they are written, the same ratings come of them.
#include "model/io/people/foreign_answers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "model/io/people/ratings_file.h"

namespace foreign_answers_test {

using namespace tact;

namespace {

const std::vector<std::string> kNames{"a", "b", "c", "d"};

struct Answer {
    const char* a;
    const char* b;
    const char* rating;
};
constexpr Answer kAnswers[] = {{"a", "b", "10"}, {"a", "c", "35"}, {"a", "d", "90.5"},
                               {"b", "c", "25"}, {"b", "d", "80"}, {"c", "d", "43"}};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

// A line an answer, as `line` writes it.
template <class Line>
std::string table(const std::string& head, const Line& line) {
    std::string text = head + "\n";
    for (const Answer& one : kAnswers) text += line(one) + "\n";
    return text;
}

void check(const std::string& text, const std::string& remark,
           const std::string& participant = "r.csv") {
    CAPTURE(text);
    const auto read = parse_ratings(text, "r.csv", RatingScale::dissimilarity);
    REQUIRE_MESSAGE(read, read.error().message);
    CHECK(read->study.labels == kNames);
    REQUIRE(read->study.judgements.size() == 1);
    CHECK(read->study.judgements[0].condensed == std::vector<double>{10, 35, 90.5, 25, 80, 43});
    if (participant != "r.csv") CHECK(read->study.judgements[0].participant == participant);
    std::string remarks;
    for (const std::string& one : read->remarks) remarks += one + "; ";
    CHECK_MESSAGE(contains(remarks, remark), remarks);
}

std::string with_comma(std::string number) {
    if (const auto point = number.find('.'); point != number.npos) number[point] = ',';
    return number;
}

std::string plain(const Answer& one, const char* gap) {
    return std::string("S1") + gap + one.a + gap + one.b + gap + one.rating;
}

}  // namespace

TEST_CASE("foreign answers: separators, decimal signs, encodings and blanks make no difference") {
    check(table("participant,a,b,rating", [](const Answer& one) { return plain(one, ","); }), "",
          "S1");
    check(table("participant;a;b;rating", [](const Answer& one) { return plain(one, ";"); }),
          "semicolons between cells", "S1");
    check(table("participant\ta\tb\trating", [](const Answer& one) { return plain(one, "\t"); }),
          "tabs between cells", "S1");
    check(table("participant;a;b;rating",
                [](const Answer& one) { return with_comma(plain(one, ";")); }),
          "decimal commas", "S1");
    check(table("participant,a,b,rating",
                [](const Answer& one) {
                    return std::string("S1,") + one.a + "," + one.b + ",\"" +
                           with_comma(one.rating) + "\"";
                }),
          "decimal commas", "S1");
    check(table("participant,a,b,rating,,",
                [](const Answer& one) { return plain(one, ",") + ",,"; }) +
              ",,,,,\n",
          "", "S1");
    check(table("participant,a,b,rating",
                [](const Answer& one) { return "M\xFCller" + plain(one, ",").substr(2); }),
          "Windows-1252", "M\u00fcller");
}

TEST_CASE("foreign answers: columns go by the names that experiments give them") {
    check(table("Participant,A,B,Rating", [](const Answer& one) { return plain(one, ","); }),
          "columns read: a = A, b = B, rating = Rating, participant = Participant", "S1");
    check(table("participant,pattern_a,pattern_b,rating",
                [](const Answer& one) { return plain(one, ","); }),
          "a = pattern_a", "S1");
    check(table("id1,id2,dissimilarity,similarity",
                [](const Answer& one) {
                    return std::string(one.a) + "," + one.b + "," + one.rating + ",7";
                }),
          "rating = dissimilarity");
    // PsychoPy: routines without a pair have rows, too.
    check(table("stimA,stimB,slider.response,slider.rt,participant\n,,,,p01",
                [](const Answer& one) {
                    return std::string(one.a) + ".wav," + one.b + ".wav," + one.rating + ",1.2,p01";
                }),
          "1 row without a pair is passed over", "p01");
    // jsPsych: instructions first, then an array of two sounds.
    check(table("\"rt\",\"stimulus\",\"response\",\"trial_type\"\n\"900\",\"<p>Feel "
                "both</p>\",\"\",\"html\"",
                [](const Answer& one) {
                    return std::string("\"901\",\"[\"\"snd/") + one.a + ".wav\"\",\"\"snd/" +
                           one.b + ".wav\"\"]\",\"" + one.rating + "\",\"audio\"";
                }),
          "without their endings");
    check("participant,a-b,a-c,a-d,b-c,b-d,c-d\nS1,10,35,90.5,25,80,43\n", "a column for each pair",
          "S1");
}

TEST_CASE("foreign answers: squares as other programs write them") {
    check(",a,b,c,d\na,0,10,35,90.5\nb,10,0,25,80\nc,35,25,0,43\nd,90.5,80,43,0\n", "");
    check("a,b,c,d\n0,10,35,90.5\n10,0,25,80\n35,25,0,43\n90.5,80,43,0\n", "");
    check(
        "\"a\" \"b\" \"c\" \"d\"\n\"a\" 0 10 35 90.5\n\"b\" 10 0 25 80\n\"c\" 35 25 0 43\n"
        "\"d\" 90.5 80 43 0\n",
        "");
    check(
        "\"\";\"a\";\"b\";\"c\";\"d\"\n\"a\";0;10;35;90,5\n\"b\";10;0;25;80\n\"c\";35;25;0;43\n"
        "\"d\";90,5;80;43;0\n",
        "decimal commas");
    check(",a,b,c,d\nd,90.5,80,43,0\na,0,10,35,90.5\nc,35,25,0,43\nb,10,0,25,80\n",
          "in another order");
    check(",a,b,c,d\na,,,,\nb,10,,,\nc,35,25,,\nd,90.5,80,43,\n", "");
}

TEST_CASE("foreign answers: what is no rating is refused by its words, names of own files stay") {
    const auto likert = parse_ratings("first,second,rating\na,b,very similar\n", "r.csv",
                                      RatingScale::dissimilarity);
    REQUIRE_FALSE(likert);
    CHECK(contains(likert.error().message, "r.csv:2: expected a rating"));
    CHECK(contains(likert.error().message, "very similar"));
    const auto doubtful =
        parse_ratings("a;b;rating\nx;y;1,234\n", "r.csv", RatingScale::dissimilarity);
    REQUIRE_FALSE(doubtful);
    CHECK(contains(doubtful.error().message, "may be thousands"));
    // One name is that of a file, the others are not: all stay unchanged.
    const auto mixed =
        parse_ratings("a,b,rating\nx.wav,y,3\n", "r.csv", RatingScale::dissimilarity);
    REQUIRE(mixed);
    CHECK(mixed->study.labels == std::vector<std::string>{"x.wav", "y"});
}

TEST_CASE("foreign answers: columns under any name are read where they are named") {
    const auto columns =
        answer_columns("a = Left one, b=Right one,rating=how far, participant=code");
    REQUIRE(columns);
    CHECK(columns->a == "Left one");
    const std::string text = table("code,a,Left one,Right one,how far", [](const Answer& one) {
        return std::string("S1,x,") + one.a + "," + one.b + "," + one.rating;
    });
    const auto read = parse_ratings(text, "r.csv", RatingScale::dissimilarity, {}, *columns);
    REQUIRE_MESSAGE(read, read.error().message);
    CHECK(read->study.labels == kNames);
    CHECK(read->study.judgements[0].participant == "S1");
    CHECK(read->study.judgements[0].condensed == std::vector<double>{10, 35, 90.5, 25, 80, 43});

    AnswerColumns nobody;
    nobody.a = "Nobody";
    const auto unknown = parse_ratings(text, "r.csv", RatingScale::guess, {}, nobody);
    REQUIRE_FALSE(unknown);
    CHECK(unknown.error().message ==
          "r.csv:1: expected a column \"Nobody\", the columns are code, a, Left one, Right one, "
          "how far");
    const auto foreign = parse_ratings("one,other,how far\nx,y,3\n", "r.csv", RatingScale::guess);
    REQUIRE_FALSE(foreign);
    CHECK(contains(foreign.error().message, "the columns are one, other, how far"));
    CHECK(answer_columns("c=x").error().message ==
          "expected a, b, rating and participant, each once as ROLE=COLUMN, got \"c=x\"");
    for (const char* wrong : {"a", "a=", "c=x", "a=x,a=y", "=x"}) {
        CAPTURE(wrong);
        CHECK_FALSE(answer_columns(wrong));
    }
    CHECK(*answer_columns("") == AnswerColumns{});
}

TEST_CASE("foreign answers: thousands or decimals, as somebody says") {
    const std::string text = "a;b;rating\nx;y;1,234\nx;z;2,345\ny;z;1,500\n";
    CHECK_FALSE(parse_ratings(text, "r.csv", RatingScale::dissimilarity));
    AnswerColumns told;
    told.written.decimal = ',';
    const auto read = parse_ratings(text, "r.csv", RatingScale::dissimilarity, {}, told);
    REQUIRE_MESSAGE(read, read.error().message);
    CHECK(read->study.judgements[0].condensed == std::vector<double>{1.234, 2.345, 1.5});
    // What somebody says wrongly is refused, and nothing is guessed behind it.
    told.written = {'\t', {}};
    CHECK_FALSE(parse_ratings(text, "r.csv", RatingScale::dissimilarity, {}, told));
}

TEST_CASE("foreign answers: a column of similarities says which way its numbers run") {
    const auto read =
        parse_ratings("stim1,stim2,similarity\na,b,90\na,c,20\n", "r.csv", RatingScale::guess);
    REQUIRE(read);
    CHECK(read->study.judgements[0].condensed[0] == 10.0);
    CHECK(read->study.judgements[0].condensed[1] == 80.0);
}

}  // namespace foreign_answers_test
