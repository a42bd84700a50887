// How the table of candidates is sorted, and its rows, kept while nothing they depend on changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/map/live_map.h"
#include "model/pattern/pattern.h"

namespace tact {

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

// The closest other pattern of a set, for each row of a map.
struct NearestOnes {
    std::shared_ptr<const LiveMap> of;
    std::vector<double> pm;
    std::vector<std::size_t> row;
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
    NearestOnes nearest;
    std::optional<CandidatesAsked> asked;
    std::vector<CandidateRow> rows;
    DrawnByName drawn;  // of the rows
};

}  // namespace tact
