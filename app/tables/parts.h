// What somebody said of a table, as text that the settings keep.
//
// Output    JSON; text that is damaged, or from a later version, says nothing
#pragma once

#include <string>
#include <string_view>

#include "app/session/session.h"
#include "app/tables/tables.h"

namespace tact {

std::string text_of(const TableWords& words);
TableWords words_in(std::string_view text);

// By the names of the columns, whatever their case.
TableWords remembered_words(const Session& session, const TableHead& head);
void remember_words(Session& session, const TableHead& head, const TableWords& words);

}  // namespace tact
