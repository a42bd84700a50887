#include "model/io/tables/coordinates_file.h"

#include <doctest/doctest.h>

#include <sstream>

#include "model/io/tables/matrix_file.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace coordinates_file_test {

using namespace tact;

namespace {

std::string printed(const LabelledPoints& points) {
    std::ostringstream stream;
    write_coordinates_csv(stream, points.labels, points.points);
    return stream.str();
}

std::string fault(std::string_view text) {
    const auto points = parse_coordinates(text, "p.csv");
    REQUIRE_FALSE(points);
    return points.error().message;
}

}  // namespace

TEST_CASE("coordinates file: a row is a name and its place") {
    const auto read =
        parse_coordinates("\xEF\xBB\xBFname,D1,D2\r\nlow,0.1,-2\r\n\"a,b\",3,5e-324\r\n", "p.csv");
    REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
    CHECK(read->labels == std::vector<std::string>{"low", "a,b"});
    REQUIRE(read->points.rows() == 2);
    REQUIRE(read->points.cols() == 2);
    CHECK(read->points(0, 1) == -2.0);
    CHECK(read->points(1, 0) == 3.0);
    CHECK(read->points(1, 1) == 5e-324);
    CHECK(printed(*read) == "name,D1,D2\nlow,0.1,-2\n\"a,b\",3,5e-324\n");
    CHECK(parse_coordinates("name,D1\n", "p.csv")->labels.empty());
}

TEST_CASE("coordinates file: a map that another program wrote is the same map") {
    const char* const written[] = {
        "name;D1;D2\nlow;0,125;-3\nh\u00e9;1,5;2\n",                  // a German spreadsheet
        "name\tD1\tD2\r\nlow\t0.125\t-3\r\nh\u00e9\t1.5\t2\r\n",      // tabs
        "\"D1\" \"D2\"\n\"low\" 0.125 -3\n\"h\u00e9\" 1.5 2\n",       // write.table
        "\"\";\"D1\";\"D2\"\n\"low\";0,125;-3\n\"h\u00e9\";1,5;2\n",  // write.csv2
        "# made by hand\nsep=;\nname;D1;D2\nlow;0.125;-3\nh\u00e9;1.5;2\n",
        "name,D1,D2\nlow,0.125,-3\nh\xE9,1.5,2\n"};  // Windows-1252
    for (const char* text : written) {
        CAPTURE(text);
        const auto read = parse_coordinates(text, "p.csv");
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(read->labels == std::vector<std::string>{"low", "h\u00e9"});
        REQUIRE(read->points.rows() == 2);
        REQUIRE(read->points.cols() == 2);
        CHECK(read->points(0, 0) == 0.125);
        CHECK(read->points(0, 1) == -3.0);
        CHECK(read->points(1, 0) == 1.5);
        CHECK(read->remarks.size() == 1);
    }
    TableHints tabs;
    tabs.separator = '\t';
    CHECK_FALSE(parse_coordinates(written[0], "p.csv", tabs));
}

TEST_CASE("coordinates file: names with semicolons are read back as they were written") {
    LabelledPoints points{{"a;b", "c;d", "e;f"}, Eigen::MatrixXd::Random(3, 2)};
    const auto again = parse_coordinates(printed(points), "p.csv");
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->labels == points.labels);
    CHECK(again->points == points.points);
}

TEST_CASE("coordinates file: what is no table of places is refused by its line") {
    CHECK(fault("") == "p.csv:1: expected a head such as name,D1,D2,D3");
    CHECK(fault("name\na\n") == "p.csv:1: expected a head such as name,D1,D2,D3");
    CHECK(fault("name,D1\na,1\nb,1,2\n") == "p.csv:3: expected 2 fields, got 3");
    CHECK(fault("name,D1\na,nan\n") == "p.csv:2: expected a number, got \"nan\"");
    CHECK(fault("name,D1\na,inf\n") == "p.csv:2: expected a number, got \"inf\"");
    CHECK(fault("name,D1\n\"a,1\n") == "p.csv:2: expected a closing quote");
    CHECK(fault("name,D1\na,1,234\nb,2,345\n") == "p.csv:2: expected 2 fields, got 3");
    CHECK_FALSE(read_coordinates_file("no/such.csv"));
}

TEST_CASE("coordinates file: after an accident it is refused, or written and read again the same") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string whole =
            "name,D1,D2\nlow,0.125,-3\n\"a \"\"b\"\"\",1e-300,-0\n\u00e9,7,8\n";
        const auto points = parse_coordinates(after_mishaps(whole, random), "p.csv");
        if (!points) {
            CHECK(contains(points.error().message, "p.csv:"));
            continue;
        }
        ++accepted;
        const auto again = parse_coordinates(printed(*points), "again.csv");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(again->labels == points->labels);
        CHECK(again->points == points->points);
    }
    CHECK(accepted > 20);
}

}  // namespace coordinates_file_test
