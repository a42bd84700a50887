// A table looked at beside the window: what its columns are taken for, and what would come of it.
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

// The newest answer on the table.
void follow_table(TableState& table);

// Ratings into the document; what was said of the table is remembered.
void take_table(Ui& ui, Workspace& work, Layout& layout, TableState& table, ImportState& importing);

void draw_table_dialog(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                       ImportState& importing);

// Loads ratings, or shows the dialog where a single file of them cannot be read as it stands.
void load_ratings_or_ask(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                         const std::vector<std::filesystem::path>& paths);

}  // namespace tact
