#include "model/table/table.h"

#include <doctest/doctest.h>

#include <string>

namespace dialect_test {

using namespace tact;

namespace {

std::string utf16(const std::string& ascii, bool is_big_endian, bool has_mark) {
    std::string bytes = !has_mark ? "" : is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char one : ascii) {
        bytes += is_big_endian ? std::string{'\0', one} : std::string{one, '\0'};
    }
    return bytes;
}

TableDialect found(char separator, char decimal, std::size_t skipped = 0, bool doubtful = false) {
    return {separator, decimal, skipped, doubtful};
}

}  // namespace

TEST_CASE("table: whatever the encoding, the text is the same") {
    const std::string text = "a,b\n1,2\n";
    for (const bool is_big_endian : {true, false}) {
        for (const bool has_mark : {true, false}) {
            const TableText read = table_text(utf16(text, is_big_endian, has_mark));
            CHECK(read.text == text);
            CHECK(read.encoding == TableEncoding::utf16);
        }
    }
    CHECK(table_text("\xEF\xBB\xBF" + text).text == text);
    CHECK(table_text("a,b\r1,2\r").text == text);
    CHECK(table_text("a,b\r\n").text == "a,b\r\n");
    const TableText windows = table_text("M\xFCller,5 \x80");
    CHECK(windows.text == "M\u00fcller,5 \u20ac");
    CHECK(windows.encoding == TableEncoding::windows_1252);
    CHECK(table_text("M\u00fcller").encoding == TableEncoding::utf8);
    CHECK(table_text(std::string("\xFF\xFE\x3D\xD8\x00\xDE", 6)).text == "\U0001F600");
    CHECK(table_text("").text.empty());
}

TEST_CASE("table: separator and decimal sign are told by the rows") {
    CHECK(dialect_of("a,b\n0.5,1\n") == found(',', '.'));
    CHECK(dialect_of("a;b\n0,5;1\n") == found(';', ','));
    CHECK(dialect_of("a;b\n0.5;1\n") == found(';', '.'));
    CHECK(dialect_of("a\tb\n0,5\t1\n") == found('\t', ','));
    CHECK(dialect_of("0.5 1\n1 0\n") == found(' ', '.'));
    CHECK(dialect_of("0,5 1,5\n1,5 0\n") == found(' ', ','));
    CHECK(dialect_of("a,b\n\"0,5\",\"1\"\n") == found(',', ','));
    CHECK(dialect_of("a;b\n1,234;2,500\n") == found(';', '.', 0, true));
    CHECK(dialect_of("a;b\n1,234;0,5\n") == found(';', ','));
    CHECK(dialect_of("sep=;\na,b;c\n") == found(';', '.', 1));
    CHECK(dialect_of("# said\n\n% too\na;b\n1;2\n") == found(';', '.', 3));
    CHECK(dialect_of("").separator == ' ');
}

TEST_CASE("table: lines count from the head of the file, whatever is passed over") {
    const std::string text = "# said\n\nsep=;\na;b\n";
    CsvReader reader = reader_of(text, dialect_of(text));
    const CsvRecord record = next_record(reader);
    CHECK(record.line == 4);
    CHECK(record.fields == std::vector<std::string>{"a", "b"});
}

TEST_CASE("table: a number is one by the sign of its table") {
    const TableDialect comma = found(';', ',');
    CHECK(number_in(" 0,25 ", comma) == 0.25);
    CHECK(number_in("0.25", comma) == 0.25);
    CHECK(number_in("-1,5e3", comma) == -1500.0);
    CHECK_FALSE(number_in("1,2,3", comma));
    CHECK_FALSE(number_in("1.234,5", comma));
    CHECK_FALSE(number_in("0,25", found(';', '.')));
    CHECK_FALSE(number_in("", comma));
}

TEST_CASE("table: a file of a sound goes by the name of its pattern") {
    CHECK(without_sound_ending("a.wav") == "a");
    CHECK(without_sound_ending("dir/a.WAV") == "dir/a");
    CHECK(without_sound_ending("a.b") == "a.b");
    CHECK(without_sound_ending(".wav") == ".wav");
}

}  // namespace dialect_test
