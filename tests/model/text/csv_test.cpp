#include "model/text/csv.h"

#include <doctest/doctest.h>

#include <string>

#include "model/text/numbers.h"

namespace csv_test {

using namespace tact;

namespace {

using Records = std::vector<std::vector<std::string>>;

Records all(std::string_view text, char separator = ',') {
    CsvReader reader{text, 1, separator};
    Records records;
    for (CsvRecord record = next_record(reader); record.line != 0; record = next_record(reader)) {
        records.push_back(record.fields);
    }
    return records;
}

}  // namespace

TEST_CASE("csv: fields, empty ones too, with either line end") {
    const Records expected{{"", "a", "b c"}, {"1", "", " 2 "}};
    CHECK(all(",a,b c\n1,, 2 \n") == expected);
    CHECK(all(",a,b c\r\n\r\n1,, 2 ") == expected);
    CHECK(all("").empty());
    CHECK(all("\n \n").empty());
}

TEST_CASE("csv: within quotes, commas, quotes and line ends are text") {
    CHECK(all("\"a,b\",\"say \"\"x\"\"\"\n") == Records{{"a,b", "say \"x\""}});
    CHECK(all("\"two\nlines\",x\ny,z\n") == Records{{"two\nlines", "x"}, {"y", "z"}});
    CHECK(all("\"two\r\nlines\",x\r\n") == Records{{"two\r\nlines", "x"}});
    CHECK(all("a\"b,c\n") == Records{{"a\"b", "c"}});
}

TEST_CASE("csv: lines are counted through quotes, and an open quote is noticed") {
    CsvReader reader{"a\n\"1\n2\n3\",b\n\nc\n\"open\n", 1, ','};
    CHECK(next_record(reader).line == 1);
    CHECK(next_record(reader).line == 2);
    CHECK(next_record(reader).line == 6);
    const CsvRecord open = next_record(reader);
    CHECK(open.line == 7);
    CHECK(open.is_quote_open);
    CHECK(next_record(reader).line == 0);
}

TEST_CASE("csv: what a spreadsheet would run is written as text, and reads back as it was") {
    for (const char* text :
         {"=cmd|A1",  "+x",      "-x",       "@sum",  "'=x",  "''=x",      "=",
          "-",        "'",       "",         "x=1",   "-5",   "+0.5",      "-1e3",
          "'quoted'", "\tx",     "\rx",      "\nx",   "'\tx", "\uff1dcmd", "\uff0bx",
          "\uff0dx",  "\uff20x", "'\uff1dx", "\uff1d"}) {
        CAPTURE(text);
        const std::string written = guarded(text);
        CHECK(unguarded(written) == text);
        CHECK(all("\"" + written + "\",x\n")[0][0] == text);
        CHECK(guarded(unguarded(written)) == written);
        const bool is_run =
            written.size() > 1 && std::string("=+-@").find(written[0]) != std::string::npos;
        CHECK((!is_run || finite_number_in(written)));
    }
    CHECK(guarded("=cmd|A1") == "'=cmd|A1");
    CHECK(guarded("-0.31") == "-0.31");  // numbers stay numbers
}

TEST_CASE("csv: runs of blanks separate bare numbers") {
    CHECK(all("  0 1.5\t2 \r\n1 0 3\n", ' ') == Records{{"0", "1.5", "2"}, {"1", "0", "3"}});
}

TEST_CASE("csv: a line of more fields than memory likes has the rest of it in the last one") {
    for (const char separator : {',', ' '}) {
        std::string line = "0";
        for (std::size_t k = 1; k < kMaxCsvFields + 2; ++k) line += std::string(1, separator) + "1";
        CsvReader reader{line, 1, separator};
        const CsvRecord record = next_record(reader);
        REQUIRE(record.fields.size() == kMaxCsvFields);
        CHECK(record.fields[0] == "0");
        CHECK(record.fields.back() ==
              "1" + std::string(1, separator) + "1" + std::string(1, separator) + "1");
    }
}

}  // namespace csv_test
