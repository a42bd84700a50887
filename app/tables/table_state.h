// What the window knows of a table of another program that somebody looks at before it is read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/io/people/ratings_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/pattern_set.h"
#include "model/table/table_head.h"

namespace tact {

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

}  // namespace tact
