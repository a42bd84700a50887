// A table looked at in the background: what its columns are taken for, and what would come of it.
//
// Input     a file, and what somebody says of it
// Output    a TableAnswer; the words that were taken are remembered for tables with the same names
//           of columns
#pragma once

#include <span>
#include <string_view>

#include "app/document/workspace.h"
#include "app/measured/import_follow.h"
#include "app/tables/table_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

// Rows of a table that the dialog shows.
inline constexpr std::size_t kShownTableRows = 12;

TableAnswer answer_on(const TableRequest& request);

// The uses that a column of this kind of table can have, as the dialog names them.
std::span<const char* const> table_uses(TableKind kind);

// Says that a column has this use, and no other column; empty: none of its own. The other columns
// are said to be what they were taken for. A column goes by its name in the first row, or by its
// number where that is blank or there twice.
void use_column(TableWords& words, const TableAnswer& answer, std::size_t column,
                std::string_view use);

// Chooses a file, then shows the dialog on it. `kind`: what it is known to hold.
void open_table_dialog(Ui& ui, const Workspace& work);
void open_table(Ui& ui, const Workspace& work, TableState& table, const std::filesystem::path& file,
                std::optional<TableKind> kind = {});

// Asks again, after the words have changed.
void look_at_table(const Ui& ui, const Workspace& work, TableState& table);

// Reads files in the background, then follow_tables() takes them: as ratings; as recordings, if
// they may be such; otherwise the dialog asks about a single one.
void read_tables(Ui& ui, const Workspace& work, TableState& table,
                 const std::vector<std::filesystem::path>& files, bool may_be_recordings = false);

// The newest answer on the table that is looked at, and on files that are read.
void follow_tables(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                   ImportState& importing);

// Ratings into the document; what was said of the table is remembered.
void take_table(Ui& ui, Workspace& work, Layout& layout, TableState& table, ImportState& importing);

void draw_table_dialog(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                       ImportState& importing);

}  // namespace tact
