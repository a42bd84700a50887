#include "app/subset/alternatives.h"

#include <algorithm>

#include "app/subset/subset_follow.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// What another subset has that the best has not, and what it has not.
struct Exchange {
    std::string in;
    std::string out;
};

Exchange exchange_of(const Pick& pick, const Subset& other) {
    const Subset& best = pick.answer.best;
    std::string out;
    std::string in;
    for (const std::size_t member : best.members) {
        if (!std::ranges::binary_search(other.members, member)) {
            out += (out.empty() ? "" : ", ") + name_of(pick, member);
        }
    }
    for (const std::size_t member : other.members) {
        if (!std::ranges::binary_search(best.members, member)) {
            in += (in.empty() ? "" : ", ") + name_of(pick, member);
        }
    }
    return {in, out};
}

// Both sides of it are seen: what one does not need of its half the other has.
std::string exchange_text(const ImFont* font, const Exchange& exchange, float room_px) {
    constexpr const char* kFor = " for ";
    const float room = std::max(0.0F, room_px - text_size(font, kFor).x);
    const float in_px = text_size(font, exchange.in).x;
    const float out_px = text_size(font, exchange.out).x;
    if (in_px + out_px <= room) return exchange.in + kFor + exchange.out;
    const float for_in = std::min(in_px, std::max(0.5F * room, room - out_px));
    return shortened(font, exchange.in, for_in) + kFor +
           shortened(font, exchange.out, room - for_in);
}

// Who comes for whom, and at the right how far the weakest pair is apart then.
void draw_alternative(Ui& ui, SubsetState& picking, const Pick& pick, std::size_t k) {
    const Theme& theme = ui.theme;
    const Subset& other = pick.answer.alternatives[k];
    const bool as_good = other.weakest_dissimilarity == pick.answer.best.weakest_dissimilarity;
    const Exchange exchange = exchange_of(pick, other);
    const std::string text = exchange.in + " for " + exchange.out;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    std::string value = as_good ? "the same" : grouped(other.weakest_dissimilarity);
    const auto px = [&theme](const std::string& words) {
        return text_size(theme.fonts.regular, words).x;
    };
    // Names are worth more room than these two words.
    if (as_good && px(text) + theme.gap_px + px(value) > width) value = "=";
    const float value_px = px(value);
    ImGui::PushID(static_cast<int>(k));
    if (ImGui::Selectable("##alternative", picking.alternative == k)) picking.alternative = k;
    ImGui::PopID();
    note_item(ui.rects, "alternative:" + std::to_string(k + 1), text + ": " + value);
    const std::string shown =
        exchange_text(theme.fonts.regular, exchange, width - value_px - theme.gap_px);
    if (shown != text) draw_tooltip(ui, (text + ": " + value).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, theme.fonts.regular, corner, theme.text, shown);
    draw_text(list, theme.fonts.regular, {corner.x + width - value_px, corner.y}, theme.dim_text,
              value);
}

}  // namespace

const std::string& name_of(const Pick& pick, std::size_t member) {
    return pick.request.map->request.set->vibrations[member].name;
}

float alternatives_px(const Ui& ui, const SubsetState& picking, const Pick& pick) {
    if (pick.answer.alternatives.empty()) return 0.0F;
    const std::size_t rows = pick.answer.alternatives.size() + (picking.alternative ? 1 : 0);
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    return 0.5F * ui.theme.gap_px + gap + text_size(ui.theme.fonts.small, "N").y + gap +
           static_cast<float>(rows) * ImGui::GetTextLineHeightWithSpacing();
}

void draw_alternatives(Ui& ui, SubsetState& picking, const Pick& pick) {
    const auto& all = pick.answer.alternatives;
    if (all.empty()) return;
    ImGui::Dummy({1.0F, 0.5F * ui.theme.gap_px});
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, pick.answer.are_alternatives_proven ? "Next best" : "Others that are good");
    ImGui::PopFont();
    if (picking.alternative) {
        if (ImGui::Selectable("Back to the best")) picking.alternative.reset();
        note_item(ui.rects, "alternative:0");
    }
    for (std::size_t k = 0; k < all.size(); ++k) draw_alternative(ui, picking, pick, k);
}

}  // namespace tact
