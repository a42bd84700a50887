// The pictures of the publication for one's own sets: the physiology of a pattern (Figures 4 to 7),
// and maps of people and metrics turned onto each other (Figures 8 to 10).
//
//     figure-4   how a receptor fires          figure-6a, -6b  receptors, flat and tilted
//     figure-5   slopes and thresholds         figure-7        relay networks
//     maps-1     the maps of the first set, one legend; 1-people, 1-pm .. each of them, named
//
// Exact     same input, same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line/agreement/compared_sets.h"
#include "app/command_line/commands.h"

namespace tact {

// Into a folder that is there, each as SVG and PNG; sections of a page with all of them.
Expected<std::string> write_paper_figures(const PaperCommand& command,
                                          const std::vector<ComparedSet>& sets,
                                          const std::filesystem::path& folder);

}  // namespace tact
