// Which arrangement of the panes is on screen, how the others were left, and a person's own.
#pragma once

#include <map>
#include <string>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"

namespace tact {

struct Workspaces {
    std::map<Arrangement, Layout> left;  // as they were left, but for the one on screen
    std::map<std::string, Layout> own;   // saved by name
    std::string shown;                   // of these the one that was chosen last; empty: none
    std::string typed;                   // the name in the dialog
};

// The layout until somebody moves a bar.
Layout first_layout(Arrangement arrangement);

// Keeps what is on screen for when it comes back.
void show_arrangement(Arrangement arrangement, Layout& layout, Workspaces& workspaces);
void show_own(const std::string& name, Layout& layout, Workspaces& workspaces);

// Over to the end of the program and back: numbers by name, the tab as a name of its own
// ("shown/bench why"). Without any, the first design.
void keep_workspaces(const Layout& layout, const Workspaces& workspaces,
                     std::map<std::string, double>& kept);
void restore_workspaces(const std::map<std::string, double>& kept, Layout& layout,
                        Workspaces& workspaces);

// The dialog that names a workspace.
void open_workspace_dialog(Ui& ui, Workspaces& workspaces);
inline constexpr Dialog kWorkspaceDialog{.title = "Save workspace as"};
void draw_workspace_dialog(Ui& ui, const Layout& layout, Workspaces& workspaces);

}  // namespace tact
