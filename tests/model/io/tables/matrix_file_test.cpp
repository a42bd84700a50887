#include "model/io/tables/matrix_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>
#include <string>

#include "model/text/numbers.h"
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
    CHECK(contains(fault(",a,b\na,0,nan\nb,nan,0\n"), "expected a finite number for \"a\""));
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
    CHECK(contains(fault(""), "m.csv:1: expected a matrix, got an empty file"));
    CHECK(contains(fault("\n\n"), "expected a matrix, got an empty file"));
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
    CHECK(contains(fault(names + "\n"),
                   "expected 10000 rows, as there are columns, got too few numbers"));
    CHECK(contains(fault(names + ",more\n"), "at most 10,000 columns"));
}

TEST_CASE("matrix file: whichever way a table is written, it is the same matrix") {
    const std::vector<std::string> names{"a", "b", "c", "d"};
    const std::vector<double> values{1.5, 2, 3, 4.25, 5, 6};
    const auto check = [&](const std::string& text, const std::string& remark) {
        CAPTURE(text);
        const auto read = parse_matrix(text, "m.csv");
        REQUIRE_MESSAGE(read, read.error().message);
        Dissimilarity ordered{4, {}};
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                const auto place = [&](std::size_t k) {
                    return static_cast<std::size_t>(std::ranges::find(read->labels, names[k]) -
                                                    read->labels.begin());
                };
                ordered.condensed.push_back(read->dissimilarity(place(i), place(j)));
            }
        }
        CHECK(ordered.condensed == values);
        std::string remarks;
        for (const std::string& one : read->remarks) remarks += one + "; ";
        CHECK(contains(remarks, remark));
    };
    check(",a,b,c,d\na,0,1.5,2,3\nb,1.5,0,4.25,5\nc,2,4.25,0,6\nd,3,5,6,0\n", "");
    check("\xEF\xBB\xBF,a,b,c,d\r\na,0,1.5,2,3\r\nb,1.5,0,4.25,5\r\nc,2,4.25,0,6\r\nd,3,5,6,0\r\n",
          "");
    // pandas without its index, R without row names
    check("a,b,c,d\n0,1.5,2,3\n1.5,0,4.25,5\n2,4.25,0,6\n3,5,6,0\n", "");
    // R's write.csv, write.csv2, write.table, and how it prints distances
    check(
        "\"\",\"a\",\"b\",\"c\",\"d\"\n\"a\",NA,1.5,2,3\n\"b\",1.5,NA,4.25,5\n\"c\",2,4.25,NA,6\n"
        "\"d\",3,5,6,NA\n",
        "");
    check(
        "\"\";\"a\";\"b\";\"c\";\"d\"\n\"a\";0;1,5;2;3\n\"b\";1,5;0;4,25;5\n\"c\";2;4,25;0;"
        "6\n\"d\";3;5;6;0\n",
        "semicolons between cells, decimal commas");
    check(
        "\"a\" \"b\" \"c\" \"d\"\n\"a\" 0 1.5 2 3\n\"b\" 1.5 0 4.25 5\n\"c\" 2 4.25 0 6\n\"d\" 3 5 "
        "6 0\n",
        "blanks between cells");
    check("  a    b    c\nb 1.5\nc 2 4.25\nd 3 5 6\n", "only the numbers below");
    // rows in another order, triangles, a tab, comments, the mark of a spreadsheet
    check(",b,a,d,c\nb,0,1.5,5,4.25\na,1.5,0,3,2\nd,5,3,0,6\nc,4.25,2,6,0\n", "");
    check(",a,b,c,d\nd,3,5,6,0\na,0,1.5,2,3\nc,2,4.25,0,6\nb,1.5,0,4.25,5\n", "in another order");
    check(",a,b,c,d\na,,,,\nb,1.5,,,\nc,2,4.25,,\nd,3,5,6,\n", "only the numbers below");
    check(",a,b,c,d\na,0,1.5,2,3\nb,,0,4.25,5\nc,,,0,6\nd,,,,0\n", "only the numbers above");
    check("\ta\tb\tc\td\na\t0\t1.5\t2\t3\nb\t1.5\t0\t4.25\t5\nc\t2\t4.25\t0\t6\nd\t3\t5\t6\t0\n",
          "tabs");
    check("# made by hand\n\n,a,b,c,d,\na,0,1.5,2,3,\nb,1.5,0,4.25,5,\nc,2,4.25,0,6,\nd,3,5,6,0,\n",
          "");
    check("sep=;\n;a;b;c;d\na;0;1.5;2;3\nb;1.5;0;4.25;5\nc;2;4.25;0;6\nd;3;5;6;0\n", "semicolons");
    check(",a,b,c,d\ra,0,1.5,2,3\rb,1.5,0,4.25,5\rc,2,4.25,0,6\rd,3,5,6,0", "");
    // what is like itself by 7
    check(",a,b,c,d\na,7,5.5,5,4\nb,5.5,7,2.75,2\nc,5,2.75,7,1\nd,4,2,1,7\n",
          "taken as similarities from 0 to 7");
}

namespace {

// A matrix as some program might write it.
struct Writing {
    char separator = ',';
    bool has_decimal_commas = false;
    bool has_corner = true;
    bool has_names_beside = true;
    bool is_lower = false;
    bool has_quotes = false;
    bool is_shuffled = false;
    const char* line_end = "\n";
    const char* diagonal = "0";
};

std::string written(const LabelledMatrix& matrix, const Writing& how, std::mt19937& random) {
    const std::size_t n = matrix.labels.size();
    const auto name = [&how](const std::string& plain) {
        return how.has_quotes ? "\"" + plain + "\"" : plain;
    };
    const auto number = [&how](double value) {
        std::string text = shortest_digits(value);
        if (how.has_decimal_commas) std::ranges::replace(text, '.', ',');
        return text;
    };
    std::string text = how.has_corner && how.has_names_beside ? name("") + how.separator : "";
    for (std::size_t k = 0; k < n; ++k) {
        text += (k == 0 ? "" : std::string(1, how.separator)) + name(matrix.labels[k]);
    }
    text += how.line_end;
    std::vector<std::size_t> rows(n);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    if (how.is_shuffled) std::shuffle(rows.begin(), rows.end(), random);
    for (const std::size_t i : rows) {
        std::string row = how.has_names_beside ? name(matrix.labels[i]) : "";
        for (std::size_t j = 0; j < n; ++j) {
            if (j > 0 || how.has_names_beside) row += how.separator;
            if (i == j) row += how.diagonal;
            if (i != j && !(how.is_lower && j > i)) row += number(matrix.dissimilarity(i, j));
        }
        text += row + how.line_end;
    }
    return text;
}

}  // namespace

TEST_CASE("matrix file: a random matrix in any writing is read back equal") {
    std::mt19937 random(7);
    const auto one_of = [&random](std::size_t count) { return random() % count; };
    for (int k = 0; k < 400; ++k) {
        CAPTURE(k);
        LabelledMatrix matrix;
        const std::size_t n = 3 + one_of(8);
        for (std::size_t i = 0; i < n; ++i) matrix.labels.push_back("p" + std::to_string(i + 1));
        matrix.dissimilarity.size = n;
        for (std::size_t p = 0; p < pair_count(n); ++p) {
            matrix.dissimilarity.condensed.push_back(static_cast<double>(1 + one_of(100'000)) /
                                                     (one_of(2) == 0 ? 10000.0 : 16.0));
        }
        Writing how;
        how.separator = ",;\t "[one_of(4)];
        how.has_decimal_commas = how.separator != ',' && one_of(2) == 0;
        how.has_corner = how.separator != ' ' && one_of(2) == 0;
        how.has_names_beside = how.has_corner || one_of(2) == 0;
        how.is_lower = how.separator != ' ' && one_of(3) == 0;
        how.has_quotes = one_of(2) == 0;
        how.is_shuffled = how.has_names_beside && one_of(2) == 0;
        how.line_end = std::array{"\n", "\r\n", "\r"}[one_of(3)];
        how.diagonal = std::array{"0", "NA", "NaN"}[one_of(3)];
        const std::string text = written(matrix, how, random);
        CAPTURE(text);
        const auto read = parse_matrix(one_of(3) == 0 ? "\xEF\xBB\xBF" + text : text, "m.csv");
        REQUIRE_MESSAGE(read, read.error().message);
        CHECK(read->labels == matrix.labels);
        CHECK(read->dissimilarity.condensed == matrix.dissimilarity.condensed);
    }
}

TEST_CASE("matrix file: numbers in reverse may be rounded to the digits that are written") {
    const LabelledMatrix rounded = parsed(",a,b\na,0,.333333\nb,.33333,0\n");
    CHECK(rounded.dissimilarity.condensed[0] == 0.333333);
    CHECK(rounded.remarks.size() == 1);
    CHECK(contains(fault(",a,b\na,0,.333333\nb,.33334,0\n"), "expected a symmetric matrix"));
    CHECK(contains(fault(",a,b\na,0,.33\nb,.3,0\n"), "expected a symmetric matrix"));
}

TEST_CASE("matrix file: what may be thousands is refused, and half a number is no other one") {
    CHECK(contains(fault(";a;b\na;0;1,234\nb;1,234;0\n"), "may be thousands"));
    CHECK(parsed(";a;b\na;0;1,2345\nb;1,2345;0\n").dissimilarity.condensed[0] == 1.2345);
    CHECK(contains(fault(",a,b\na,1,0.5\nb,0.5,0.9\n"), "expected 0 on the diagonal"));
    CHECK(
        contains(fault(",a,b,c\na,0,1,2\nb,1,0\nc,2,3,0\n"), "m.csv:3: expected 3 numbers, got 2"));
}

}  // namespace matrix_file_test
