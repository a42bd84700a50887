// Actuator maps by which the open document's effects were read, and reading them by others.
//
// Input     files as they were opened or added; read again, they have to be what they were
// Output    a step that undo takes back; what was edited since, or is locked, stays and is counted
// Left out  maps from files, which the command line's --actuator takes; effects of a set that was
//           saved: its files are not known any more.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Effects of one format in the document.
struct MapInUse {
    std::string format;     // a key of model/io/effects/read_effects.h
    std::string actuators;  // "quest"; "core-haptics, quest" where there are several
    std::size_t patterns = 0;
    bool has_files = false;  // that can be read again
};

// Where any effect is, by format.
std::vector<MapInUse> maps_in_use(const Workspace& work);

// What was just read of these files, which are no set file, before anything of it is given another
// name or look.
void note_effect_files(Workspace& work, const std::vector<std::filesystem::path>& paths,
                       const std::vector<Vibration>& read);

// All effects of a format by a bundled map.
void read_by_map(Ui& ui, Workspace& work, const std::string& format, const std::string& actuator);

}  // namespace tact
