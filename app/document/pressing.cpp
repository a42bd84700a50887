#include "app/document/pressing.h"

#include <imgui.h>

namespace tact {

void note_pressed(Workspace& work, const Vibration& vibration) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_drag = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >=
                         io.MouseDragThreshold * io.MouseDragThreshold;
    if (!io.MouseDown[ImGuiMouseButton_Left] || is_drag) return;
    work.selection.pressed = vibration;
}

}  // namespace tact
