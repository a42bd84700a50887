// The page about a rating study that goes with its tables: who took part and who counts, how alike
// they rate, how well metrics agree with them, the maps.
//
// Input     what was computed of the study elsewhere; nothing here decides
// Output    one HTML page that stands alone (html.h); every number of it is in the CSV files beside
//           it (model/io/people/study_tables.h)
// Valid     tables of participants and metrics of any length
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "model/io/people/study_tables.h"
#include "model/planning/preregistration.h"
#include "model/set/pattern_set.h"

namespace tact {

struct StudyReport {
    const StudyTables& tables;
    const PatternSet& set;  // the patterns that were rated, in the order of tables.labels
    std::string name{};     // of the whole set
    std::vector<std::string> labels{};   // sentences that every number is to be read with
    std::vector<std::string> remarks{};  // who is left out, which rules were on, who fell by them
    std::string methods{};               // a paragraph for a paper and its references, lines
    std::string planned_on{};            // of its preregistration; empty: none
    std::vector<PlannedAndDone> planned{};
    std::string program{};  // "tactspace 0.1.0"
    std::string date{};     // of the page
};

std::string study_report_page(const StudyReport& report);

}  // namespace tact
