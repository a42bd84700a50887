// Table 2 of Lim & Park 2023 for one's own sets, and what it rests on, as CSV: of the command paper
// and of Python.
//
//     table2.csv   set,metric,rho,K,signed_rho,best_K,participants,synthetic,left_out
//                  a line a set and metric, then of each metric the average: as the publication has
//                  it in rho and K (of |rho|, an undefined one as 0, a failed map as K = 1), with
//                  its sign and over the best maps in the others
//     pairs.csv    set,a,b,people,<a column a metric>
//     maps.csv     set,map,pattern,x,y,z: by the publication's procedure, of people and metrics
//
// Output    "NA" where there is no number; the shortest digits that read back as the same
// Exact     same input, same bytes.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "model/evaluation/metric_comparison.h"
#include "model/set/pattern_set.h"

namespace tact {

// The metrics of the paper's table, in its order.
std::span<const Metric> table2_metrics();

// How metrics agree with the people of one set. The two have to outlive it.
struct Table2Set {
    std::string name;
    std::vector<std::string> patterns;  // that were rated, in the order of maps and matrices
    std::vector<std::string> keys;      // of the table's metrics
    const RatedPeople& people;
    const MetricTable& table;
};

// `foreign`: keys of what stands in the table behind its metrics.
Table2Set table2_set(const PatternSet& set, const RatedPeople& people, const MetricTable& table,
                     const std::vector<std::string>& foreign = {});

void write_table2_csv(std::ostream& stream, std::span<const Table2Set> sets);
void write_table2_pairs_csv(std::ostream& stream, std::span<const Table2Set> sets);
void write_table2_maps_csv(std::ostream& stream, std::span<const Table2Set> sets);

}  // namespace tact
