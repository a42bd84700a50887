#include "app/compare/reading_text.h"

#include <algorithm>
#include <sstream>

#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

void reading_text(ImU32 colour, const std::string& text) {
    constexpr float kWidestEm = 52.0F;
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = std::max(1.0F, std::min(room, kWidestEm * ImGui::GetFontSize()));
    std::string lines;
    std::istringstream paragraphs(shown_lines(text));
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        if (paragraph.empty()) lines += "\n";
        for (const std::string& line : wrapped(ImGui::GetFont(), paragraph, width)) {
            lines += line + "\n";
        }
    }
    if (!lines.empty()) lines.pop_back();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopStyleColor();
}

}  // namespace tact
