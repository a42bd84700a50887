// Records of comma-separated values, and what is wrong with a line of a file.
//
// Source    RFC 4180; also blanks as separators, for bare numbers and words in quotes
// Valid     kMaxCsvFields a record; what follows them stays together in the last one
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kMaxCsvFields = 1'000'000;  // each takes 32 bytes and more

struct CsvRecord {
    std::size_t line = 0;  // from 1; 0: there is no record left
    std::vector<std::string> fields;
    bool is_quote_open = false;  // the text ended within quotes
};

// Reads record by record; blank lines are passed over.
struct CsvReader {
    std::string_view rest;
    std::size_t line = 1;
    char separator = ',';  // ' ': any run of blanks
};

CsvRecord next_record(CsvReader& reader);

// Puts an apostrophe, by which spreadsheets tell text, before a text that one would run as a
// formula (it begins with = + - @, and is not a number); and takes it away. Every other text stays.
std::string guarded(std::string_view text);
std::string unguarded(std::string text);

// "FILE:LINE: FAULT"; lines count from 1.
inline Error at_line(const std::string& file, std::size_t line, const std::string& fault) {
    return Error{file + ":" + std::to_string(line) + ": " + fault};
}

}  // namespace tact
