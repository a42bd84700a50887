// Table 2 of Lim & Park 2023 for one's own sets: as text of CSV and HTML, and what it rests on.
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

#include "app/command_line/agreement/compared_sets.h"

namespace tact {

// The metrics of the paper's table, in its order.
std::span<const Metric> table2_metrics();

void write_table2_csv(std::ostream& stream, std::span<const ComparedSet> sets);
void write_table2_pairs_csv(std::ostream& stream, std::span<const ComparedSet> sets);
void write_table2_maps_csv(std::ostream& stream, std::span<const ComparedSet> sets);

// A row a metric, two columns a set; the averages by both bookkeepings.
std::string table2_html(std::span<const ComparedSet> sets);

}  // namespace tact
