// The set as a table: sorted, filtered, locked and dropped together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/patterns/patterns.h"
#include "app/ui/ui.h"
#include "model/pattern/pattern.h"

namespace tact {

// How the table of candidates is sorted, and its rows, kept while nothing they depend on changes.

enum class CandidateColumn {
    picture,  // sorted by: the order of the set
    name,
    amplitude,
    carrier,
    modulation,
    rhythm,
    duration,
    nearest,
    picked
};

// One pattern, as the table says it. None: it has no such number.
struct CandidateRow {
    std::size_t place = 0;  // in the document
    std::optional<double> amplitude_g;
    std::optional<double> carrier_hz;  // the first one
    std::vector<double> further_hz;    // and those that are mixed with it
    std::optional<double> modulation_hz;
    std::optional<std::string> rhythm;
    double duration_s = 0.0;
    // For curves and transients, whose own amplitude and carrier say little: as drawn.
    std::optional<double> peak_g;
    std::optional<double> mean_hz;  // by strength
    std::size_t ticks = 0;
    std::optional<double> nearest_pm;
    std::string nearest_name;
    bool picked = false;
};

// What curves and transients of one pattern come to.
struct DrawnNumbers {
    Pattern of;
    double peak_g = 0.0;
    std::optional<double> mean_hz;  // by strength
};

using DrawnByName = std::map<std::string, DrawnNumbers>;

// What rows are of.
struct CandidatesAsked {
    std::uint64_t revision = 0;
    std::shared_ptr<const LiveMap> map;
    CandidateColumn by = CandidateColumn::picture;
    bool descending = false;
    std::string search;
    bool only_picked = false;
    std::set<std::string> picked;

    bool operator==(const CandidatesAsked&) const = default;
};

struct CandidatesState {
    CandidateColumn by = CandidateColumn::picture;
    bool descending = false;
    std::optional<CandidatesAsked> asked;
    std::vector<CandidateRow> rows;
    DrawnByName drawn;  // of the rows
};

// The rows of the table of candidates: what it says of each pattern, and in which order.

// What a column of numbers says of a pattern; none: it has no such number, or the column no number.
std::optional<double> number_in(const CandidateRow& row, CandidateColumn column);

// Those that the search finds, sorted; what a pattern has not comes last either way, and equal ones
// keep the order of the set.
const std::vector<CandidateRow>& candidate_rows(const Workspace& work, const ShownMap& shown_map,
                                                CandidatesState& state);

// All of it in CSV, a row for each with all digits.
std::string candidates_csv(const PatternSet& set, const std::vector<CandidateRow>& rows);

// The same column again turns the order round; numbers begin with the largest where that is what
// one looks for: how far the nearest is, and who is picked.
void sort_by(CandidatesState& state, CandidateColumn column);

// The set as a table: a row a pattern, its numbers side by side, sorted by any of them.

// A click selects as in the list, through the order of the table; what is selected is locked and
// dropped together.
PatternAction draw_candidates_panel(Ui& ui, Workspace& work, const ShownMap& shown_map,
                                    CandidatesState& state);

// Which columns a table of this width has, and where each begins and ends. The picture takes what
// is left over; in a narrow table the duration goes first, then it, the rhythm, the modulation.
// `nearest_px`: what the largest PM takes, at a scale of 1; it has that where the table has room.
struct ColumnSpan {
    CandidateColumn column;
    float begin_px = 0.0F;
    float end_px = 0.0F;
};
std::vector<ColumnSpan> column_places(float width_px, float scale, float nearest_px = 0.0F);

}  // namespace tact
