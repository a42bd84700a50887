// The columns of a table of accelerations: which is the time, which are axes, in what units.
//
// Columns are told by names in the line before the first number ("time [ms]", "ax", "acc_y
// (m/s^2)", "Z", "voltage (V)"), or in the last comment there ("# x, y, z, time diff in ms": a time
// since the row before); without names by their number: 1 or 3 are axes, 2 or 4 a time and
// axes.
//
// Input     commas, semicolons, tabs or blanks between fields; decimal commas with any but commas,
//           or in a single column that the line before it names; lines that begin with "#" or "%",
//           names of columns and other lines before the first number. Where commas may be either
//           and nothing tells, the file is refused, as it is where points and commas occur
//           together.
// Output    errors as "FILE:LINE: expected .."
// Valid     1 sample and more of any number of axes, kMaxDecodedSamples in all (recording.h); NaN
//           is refused; so is an unknown unit in a name ("x (mg)", "gal"), for a time as for an
//           axis, and axes of different units
// Left out  more than one time column; text between the numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/table/table.h"

namespace tact {

enum class AccelerationUnit { g, m_per_s2, volt };
inline constexpr const char* kAccelerationUnits[] = {"g", "m/s2", "V"};

struct AccelerationTable {
    TableDialect dialect;
    std::vector<double> time;           // as it is written; empty: no column of it
    std::optional<double> time_unit_s;  // that its name says
    std::optional<double> rate_hz{};    // that a comment before the numbers says
    std::vector<std::vector<double>> axes;
    std::optional<AccelerationUnit> unit;     // that the names of the axes say ...
    std::string unit_column;                  // ... and the first of them that does
    std::vector<std::string> axis_names{};    // of the columns; empty: they have none
    std::optional<std::size_t> time_place{};  // of the columns, from 0
    std::vector<std::size_t> axis_places{};
    std::size_t first_line = 1;  // of the names, or of the numbers where they have none
};

inline constexpr std::size_t kMaxTableBytes = std::size_t{1} << 28;

// The columns that somebody named. Where an axis is named, those that are named are all there are;
// a time that is not named goes by its usual names.
struct AccelerationColumns {
    std::string time, x, y, z;

    bool operator==(const AccelerationColumns&) const = default;
};

// From "time=t,x=ax,y=ay,z=az": any of them, once.
Expected<AccelerationColumns> acceleration_columns(std::string_view text);

enum class TimeUnit { s, ms, us, ns };
inline constexpr const char* kTimeUnits[] = {"s", "ms", "us", "ns"};
inline constexpr double kTimeUnitsS[] = {1.0, 1e-3, 1e-6, 1e-9};

// What somebody says of a table; what the table says itself has to agree with it.
struct AccelerationTableOptions {
    AccelerationColumns columns;
    std::optional<TimeUnit> time_unit;
    TableHints written;

    bool operator==(const AccelerationTableOptions&) const = default;
};

// With `rising_time`, a time that is not later than the one before is an Error.
Expected<AccelerationTable> parse_acceleration_table(std::string_view text, const std::string& file,
                                                     bool rising_time,
                                                     const AccelerationTableOptions& options = {});

}  // namespace tact
