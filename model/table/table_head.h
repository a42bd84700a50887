// The first rows of a table, as they are understood, for people to look at before it is read.
//
// Input     the bytes of a file, and what somebody says of them
// Output    cells as they are written, in UTF-8; the first row often names the columns
// Left out  rows beyond those asked for; what the numbers mean
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/table/dialect.h"

namespace tact {

struct TableHead {
    TableDialect dialect;
    TableEncoding encoding = TableEncoding::utf8;
    std::vector<std::vector<std::string>> rows;
};

// `first_line`, from 1, is that of the first row; comments and blank lines are no rows.
TableHead head_of_table(std::string bytes, const TableHints& hints, std::size_t rows,
                        std::size_t first_line = 1);

}  // namespace tact
