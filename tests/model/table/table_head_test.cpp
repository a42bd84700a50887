#include "model/table/table.h"

#include <doctest/doctest.h>

namespace table_head_test {

using namespace tact;

TEST_CASE("table head: rows are as they are understood, without comments and blank lines") {
    const TableHead head = head_of_table("# made\nsep=;\na;b\n\n1,5;2\n;\n3;4\n5;6\n", {}, 3);
    CHECK(head.rows == std::vector<std::vector<std::string>>{{"a", "b"}, {"1,5", "2"}, {"3", "4"}});
    CHECK(head.dialect.separator == ';');
    const TableHead tabs = head_of_table("a;b\n1;2\n", {'\t', {}}, 3);
    CHECK(tabs.rows.front() == std::vector<std::string>{"a;b"});
    CHECK(head_of_table("x\n\na,b\n1,2\n", {}, 3, 2).rows.front() ==
          std::vector<std::string>{"a", "b"});
    CHECK(head_of_table("", {}, 3).rows.empty());
}

TEST_CASE("columns: a name goes before a number") {
    const std::vector<std::string> head{"2", " x ", "y"};
    CHECK(*place_of_column(head, "2") == 0);
    CHECK(*place_of_column(head, "3") == 2);
    CHECK(*place_of_column(head, "x") == 1);
    for (const char* none : {"0", "4", "z", "", "03", "1.0"}) {
        CAPTURE(none);
        CHECK_FALSE(place_of_column(head, none));
    }
}

}  // namespace table_head_test
