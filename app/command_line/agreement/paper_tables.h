// Table 2 of Lim & Park 2023 for one's own sets: as what its CSV is written from, and as HTML.
//
// Exact     same input, same bytes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/command_line/agreement/compared_sets.h"
#include "model/io/people/table2.h"

namespace tact {

// The sets have to outlive these.
std::vector<Table2Set> table2_sets(std::span<const ComparedSet> sets);

// A row a metric, two columns a set; the averages by both bookkeepings.
std::string table2_html(std::span<const ComparedSet> sets);

}  // namespace tact
