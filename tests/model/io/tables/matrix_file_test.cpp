#include "model/io/tables/matrix_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace matrix_file_test {

using namespace tact;

namespace {

std::string printed(const LabelledMatrix& matrix) {
    std::ostringstream stream;
    write_matrix_csv(stream, matrix.labels, matrix.dissimilarity);
    return stream.str();
}

LabelledMatrix parsed(std::string_view text) {
    const auto matrix = parse_matrix(text, "m.csv");
    REQUIRE_MESSAGE(matrix, (matrix ? "" : matrix.error().message));
    return *matrix;
}

std::string fault(std::string_view text) {
    const auto matrix = parse_matrix(text, "m.csv");
    REQUIRE_FALSE(matrix);
    return matrix.error().message;
}

}  // namespace

TEST_CASE("matrix file: names head the columns and the rows") {
    const LabelledMatrix matrix{{"a", "b", "c"}, {3, {0.1, 2.0, 1e-20}}};
    CHECK(printed(matrix) == ",a,b,c\na,0,0.1,2\nb,0.1,0,1e-20\nc,2,1e-20,0\n");
}

TEST_CASE("matrix file: what is written is read back to the bit, whatever the names") {
    LabelledMatrix matrix;
    matrix.labels = {"L-4-full", "a,b", "say \"x\"", "two\nlines", "\u9707\u52a8", " blanks ",
                     "",         "1",   "r\r\nn",    "#",          "nan"};
    matrix.dissimilarity.size = matrix.labels.size();
    for (std::size_t k = 0; k < pair_count(matrix.labels.size()); ++k) {
        matrix.dissimilarity.condensed.push_back(std::sin(static_cast<double>(k)) / 3.0 + 1.0);
    }
    const LabelledMatrix back = parsed(printed(matrix));
    CHECK(back.labels == matrix.labels);
    CHECK(back.dissimilarity == matrix.dissimilarity);

    const TemporaryFolder folder;
    const auto file = folder.path / "m.csv";
    REQUIRE(write_matrix_file(file, matrix.labels, matrix.dissimilarity));
    CHECK(bytes_of(file) == printed(matrix));
    CHECK(read_matrix_file(file)->dissimilarity == matrix.dissimilarity);
}

TEST_CASE("matrix file: bare numbers get their positions as names") {
    const LabelledMatrix blanks = parsed("   0.0000e+00   2.5000e+00\r\n   2.5000e+00   0.0\r\n");
    CHECK(blanks.labels == std::vector<std::string>{"1", "2"});
    CHECK(blanks.dissimilarity.condensed == std::vector<double>{2.5});
    const LabelledMatrix commas = parsed(
        "\xEF\xBB\xBF"
        "0,2.5\n2.5,0\n");
    CHECK(commas.dissimilarity == blanks.dissimilarity);
    CHECK(parsed("0\n").dissimilarity.condensed.empty());
}

TEST_CASE("matrix file: rounding is no asymmetry, anything more is") {
    CHECK(parsed(",a,b\na,0,1\nb,1.0000000001,0\n").dissimilarity.condensed[0] == 1.0);
    CHECK(fault(",a,b\na,0,1\nb,1.00000001,0\n") ==
          "m.csv:3: expected a symmetric matrix, got other values for \"b\" and \"a\" than for the "
          "reverse");
}

TEST_CASE("matrix file: damage is refused with its line") {
    CHECK(fault(",a,b\na,0,x\nb,1,0\n") ==
          "m.csv:2: column \"b\": expected a finite number, got \"x\"");
    CHECK(contains(fault(",a,b\na,0,nan\nb,1,0\n"), "m.csv:2: "));
    CHECK(contains(fault(",a,b\na,0,inf\nb,inf,0\n"), "m.csv:2: "));
    CHECK(contains(fault(",a,b\na,0,1\nb,1,0.5\n"), "m.csv:3: expected 0 on the diagonal"));
    CHECK(contains(fault(",a,b\na,0,1\nc,1,0\n"), "m.csv:3: expected the row of \"b\", got \"c\""));
    CHECK(contains(fault(",a,a\na,0,1\na,1,0\n"), "m.csv:1: expected names that differ"));
    CHECK(contains(fault(",a,b\na,0,1\nb,1\n"), "m.csv:3: expected 2 numbers, got 1"));
    CHECK(contains(fault(",a,b\na,0,1\n"), "expected 2 rows, as there are columns, got 1"));
    CHECK(contains(fault(",a\na,0\nb,0\n"), "m.csv:3: expected as many rows as columns"));
    CHECK(contains(fault("0 1\n1 0\n0 1\n"), "m.csv:3: "));
    CHECK(contains(fault("hello\n"), "m.csv:1: "));
    CHECK(contains(fault(",\"a\na,0\n"), "m.csv:1: expected a closing quote"));
    CHECK(contains(fault(",a\xFF\n"), "m.csv:1: expected text in UTF-8"));
    CHECK(contains(fault(""), "got 0"));
    CHECK(contains(fault("\n\n"), "got 0"));
}

TEST_CASE("matrix file: a thousand patterns are no effort") {
    LabelledMatrix matrix;
    matrix.dissimilarity.size = 1000;
    matrix.dissimilarity.condensed.assign(pair_count(1000), 0.3333333333333333);
    for (int k = 0; k < 1000; ++k) matrix.labels.push_back("pattern " + std::to_string(k));
    const LabelledMatrix back = parsed(printed(matrix));
    CHECK(back.dissimilarity == matrix.dissimilarity);
}

TEST_CASE("matrix file: coordinates have a column for each dimension") {
    Eigen::MatrixXd points(2, 3);
    points << 0.1, -0.25, 0.0, 1.0, 2.0, 1e-17;
    const std::vector<std::string> labels{"a", "b,c"};
    std::ostringstream stream;
    write_coordinates_csv(stream, labels, points);
    CHECK(stream.str() == "name,D1,D2,D3\na,0.1,-0.25,0\n\"b,c\",1,2,1e-17\n");
}

TEST_CASE("matrix file: after an accident it is refused, or written and read again the same") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 1500; ++seed) {  // few stay symmetric
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string whole = seed % 2 == 0
                                      ? ",a,\"b,\"\"\",c\na,0,0.1,-0\n\"b,\"\"\",0.1,0,5e-324\n"
                                        "c,-0,5e-324,0\n"
                                      : "0 1 2\n1 0 3.5\n2 3.5 0\n";
        const auto matrix = parse_matrix(after_mishaps(whole, random), "m.csv");
        if (!matrix) {
            CHECK(contains(matrix.error().message, "m.csv:"));
            continue;
        }
        ++accepted;
        const LabelledMatrix again = parsed(printed(*matrix));
        CHECK(again.labels == matrix->labels);
        CHECK(again.dissimilarity.size == matrix->dissimilarity.size);
        CHECK(again.dissimilarity.condensed == matrix->dissimilarity.condensed);
    }
    CHECK(accepted > 20);
}

TEST_CASE("matrix file: as many names as one likes make no memory without their numbers") {
    std::string names;
    for (int k = 0; k < 10'000; ++k) names += "," + std::to_string(k) + "x";
    CHECK(contains(fault(names + "\n"), "expected 10000 rows, as there are columns, got 0"));
    CHECK(contains(fault(names + ",more\n"), "at most 10,000 columns"));
}

}  // namespace matrix_file_test
