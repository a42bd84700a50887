// Tables of other programs: encoding, separator and decimal sign, columns by name.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/text/csv.h"

namespace tact {

// How a table of another program is written: its encoding, what separates its cells, its decimal
// sign, what stands before its first row.
//
//     a,b        "a";"b"        a<TAB>b        "a" "b"        # made by R
//     0.5,1      0,5;1          0.5<TAB>1      0.5 1          sep=;
//
// Source    RFC 4180; R's write.csv, write.csv2 and write.table; Excel's "sep=" and Unicode text
// Input     the bytes of a file
// Output    its text in UTF-8, and what it was found to be, with words for remarks
// Valid     UTF-8, UTF-16 with a mark or mostly of ASCII, otherwise Windows-1252; lines that end by
//           LF, CR LF or CR; comments that begin with # or %, before the first row
// Left out  cells of fixed width; thousands with a sign between them, which are refused as doubtful

enum class TableEncoding { utf8, utf16, windows_1252 };

struct TableText {
    std::string text;  // UTF-8 without a mark; CR alone has become LF
    TableEncoding encoding = TableEncoding::utf8;
};

TableText table_text(std::string bytes);

struct TableDialect {
    char separator = ',';  // ' ': any run of blanks
    char decimal = '.';
    std::size_t skipped_lines = 0;  // comments, and a line "sep=;"
    // Numbers such as 1,234 alone speak for the decimal sign: they may be thousands.
    bool is_doubtful = false;

    bool operator==(const TableDialect&) const = default;
};

// What somebody says of a table; what is not said is found.
struct TableHints {
    std::optional<char> separator;
    std::optional<char> decimal;

    bool operator==(const TableHints&) const = default;
};

// Whether a trimmed line is a comment, which begins with # or %.
bool is_table_comment(std::string_view line);

// The dialect of a text's first lines, which is taken for that of the whole.
TableDialect dialect_of(std::string_view text, const TableHints& hints = {});

// Records from the first row on; lines count from the head of the text.
CsvReader reader_of(std::string_view text, const TableDialect& dialect);

inline constexpr const char* kDoubtfulNumbers =
    "expected numbers of which one decimal sign can be told, got commas before three digits, which "
    "may be thousands";

// A cell as a number, by the decimal sign of its table; "1.5" is one in every table whose sign is a
// comma, too.
std::optional<double> number_in(std::string_view cell, const TableDialect& dialect);

// Whether a cell says that its number is not known: blank, "NA", "NaN" or "-".
bool says_unknown(std::string_view cell);

// "semicolons between cells, decimal commas, Windows-1252"; empty: as a CSV file is written.
std::string words_on(const TableDialect& dialect, TableEncoding encoding);

// The file of another program that a cell names, as a pattern of a set would be called: without the
// ending of a sound.
std::string_view without_sound_ending(std::string_view name);

// The columns of a table that somebody names: "a=stimA,b=stimB", "time=t,x=ax".
//
// Input     ROLE=COLUMN with commas between, each role at most once; a column goes by its name, or
//           by its number from 1 where no column has that name
// Left out  names of columns that hold a comma

struct ColumnRole {
    const char* role;
    std::string* column;  // empty: the column goes by its usual names
};

// Fills the columns of the roles; what is wrong, or empty. All of them are empty before.
std::string take_column_roles(std::string_view text, std::initializer_list<ColumnRole> roles);

// The place of a column from 0; an Error names the columns there are.
Expected<std::size_t> place_of_column(std::span<const std::string> head, std::string_view column);

// The names of columns, for a sentence: "rt, stimulus, response".
std::string column_names(std::span<const std::string> head);

// The first rows of a table, as they are understood, for people to look at before it is read.
//
// Input     the bytes of a file, and what somebody says of them
// Output    cells as they are written, in UTF-8; the first row often names the columns
// Left out  rows beyond those asked for; what the numbers mean

struct TableHead {
    TableDialect dialect;
    TableEncoding encoding = TableEncoding::utf8;
    std::vector<std::vector<std::string>> rows;
};

// `first_line`, from 1, is that of the first row; comments and blank lines are no rows.
TableHead head_of_table(std::string bytes, const TableHints& hints, std::size_t rows,
                        std::size_t first_line = 1);

}  // namespace tact
