// The columns of a table that somebody names: "a=stimA,b=stimB", "time=t,x=ax".
//
// Input     ROLE=COLUMN with commas between, each role at most once; a column goes by its name, or
//           by its number from 1 where no column has that name
// Left out  names of columns that hold a comma
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

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

}  // namespace tact
