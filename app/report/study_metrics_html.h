// The parts of a study's page on how well metrics agree with people, and on how that was computed;
// and how the page writes numbers.
//
// Input     what was computed of the study elsewhere; nothing here decides
// Output    HTML (html.h)
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "app/report/study_report.h"
#include "model/common/quantile.h"

namespace tact {

// Agreement, intervals, differences from PM, partial correlations, single people.
std::string metrics_section(const StudyReport& report);

// A paragraph for a paper and the list of what it cites, of lines as methods_text() has them.
std::string methods_html(const std::string& text);
std::string methods_section(const StudyReport& report);

// With `decimals` digits after the point, aligned in a column; with a true minus.
std::string shown(double value, int decimals = 3);
std::string shown(const Interval& interval);
std::string probability(double p);

// A list of sentences, which are text.
std::string items(const std::vector<std::string>& sentences);

}  // namespace tact
