// Parts that the files of this room share.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/command_line/agreement/agreement.h"
#include "app/command_line/commands.h"
#include "model/io/people/table2.h"

namespace tact {

// The pictures of the publication for one's own sets: the physiology of a pattern (Figures 4 to 7),
// and maps of people and metrics turned onto each other (Figures 8 to 10).
//
//     figure-4   how a receptor fires          figure-6a, -6b  receptors, flat and tilted
//     figure-5   slopes and thresholds         figure-7        relay networks
//     maps-1     the maps of the first set, one legend; 1-people, 1-pm .. each of them, named
//
// Exact     same input, same bytes.

// Into a folder that is there, each as SVG and PNG; sections of a page with all of them.
Expected<std::string> write_paper_figures(const PaperCommand& command,
                                          const std::vector<ComparedSet>& sets,
                                          const std::filesystem::path& folder);

// Table 2 of Lim & Park 2023 for one's own sets: as what its CSV is written from, and as HTML.
//
// Exact     same input, same bytes.

// The sets have to outlive these.
std::vector<Table2Set> table2_sets(std::span<const ComparedSet> sets);

// A row a metric, two columns a set; the averages by both bookkeepings.
std::string table2_html(std::span<const ComparedSet> sets);

}  // namespace tact
