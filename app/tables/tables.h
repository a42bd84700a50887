// Tables of other programs, looked at before they are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/measured/measured.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/people/ratings_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/pattern_set.h"
#include "model/table/table.h"

namespace tact {

// What the window knows of a table of another program that somebody looks at before it is read.

enum class TableKind { ratings, recording };

// What somebody says of the table.
struct TableWords {
    TableKind kind = TableKind::ratings;
    TableHints written;
    AnswerColumns answers;  // of ratings ...
    RatingScale scale = RatingScale::guess;
    AccelerationColumns axes;  // ... and of a recording
    std::optional<TimeUnit> time_unit;
    std::optional<AccelerationUnit> unit;

    bool operator==(const TableWords&) const = default;
};

struct TableRequest {
    std::uint64_t document = 0;  // App::document_number
    std::filesystem::path file;
    // Words of somebody's own, or those for this shape of header that were remembered.
    TableWords words;
    std::shared_ptr<const PatternSet> set;
};

// The table as these words make it: its first rows, the use of each column, what would come of it.
struct TableAnswer {
    TableRequest request;
    std::string fault;  // why it cannot be read as it stands
    TableHead head;
    std::vector<std::string> uses;  // "pattern A", "x" ..; empty: a column that is not read
    std::string outcome;            // a sentence
    std::vector<std::string> remarks;
    std::optional<LoadedRatings> ratings;  // where they were read
};

// Files that are dropped or chosen as tables: ratings, if they read as such, or recordings.
struct TablesRequest {
    std::uint64_t number = 0;
    std::uint64_t document = 0;
    std::vector<std::filesystem::path> files;
    bool may_be_recordings = false;
};

struct TablesAnswer {
    TablesRequest request;
    std::optional<LoadedRatings> ratings;
    std::string fault;  // why they are no ratings
    bool are_recordings = false;
};

struct TableState {
    std::filesystem::path file;
    TableHead names;  // the first row as it was found, by which words are remembered
    TableWords words;
    Query<TableRequest, TableAnswer> job;
    std::shared_ptr<const TableAnswer> answer;
    Query<TablesRequest, TablesAnswer> reading_job;
    std::uint64_t asked = 0;  // the number of the last request ...
    std::uint64_t taken = 0;  // ... and of the last one that came to its end
};

// A table looked at in the background: what its columns are taken for, and what would come of it.
//
// Input     a file, and what somebody says of it
// Output    a TableAnswer; the words that were taken are remembered for tables with the same names
//           of columns

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
void open_table_dialog(Ui& ui, const Workspace& work, TableState& table);
void open_table(Ui& ui, const Workspace& work, TableState& table, const std::filesystem::path& file,
                std::optional<TableKind> kind = {});

// Asks again, after the words have changed.
void look_at_table(const Ui& ui, const Workspace& work, TableState& table);

// Asks for ratings: a table, or a folder of tables.
void load_ratings_dialog(Ui& ui, const Workspace& work, TableState& table);

// Reads files in the background, then follow_tables() takes them: as ratings; as recordings, if
// they may be such; otherwise the dialog asks about a single one.
void read_tables(Ui& ui, const Workspace& work, TableState& table,
                 const std::vector<std::filesystem::path>& files, bool may_be_recordings = false);

// The newest answer on the table that is looked at, and on files that are read.
void follow_tables(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                   ImportState& importing);

// Ratings into the document; what was said of the table is remembered.
void take_table(Ui& ui, Workspace& work, Layout& layout, TableState& table, ImportState& importing);

inline constexpr Dialog kTableDialog{.title = "Open table", .is_of_document = true};
void draw_table_dialog(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                       ImportState& importing);

}  // namespace tact
