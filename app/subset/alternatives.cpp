#include "app/subset/parts.h"

#include <algorithm>
#include <vector>

#include "app/subset/subset.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr const char* kFor = "for ";

// What another subset has that the best has not, and what it has not.
struct Exchange {
    std::vector<std::string> in;
    std::vector<std::string> out;
};

Exchange exchange_of(const Pick& pick, const Subset& other) {
    const Subset& best = pick.answer.best;
    Exchange exchange;
    for (const std::size_t member : best.members) {
        if (!std::ranges::binary_search(other.members, member)) {
            exchange.out.push_back(name_of(pick, member));
        }
    }
    for (const std::size_t member : other.members) {
        if (!std::ranges::binary_search(best.members, member)) {
            exchange.in.push_back(name_of(pick, member));
        }
    }
    return exchange;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Every name is seen: the longest are cut, alike, until all fit.
std::string fitting(const ImFont* font, std::vector<std::string> names, float room_px) {
    std::vector<float> widths;
    for (const std::string& name : names) widths.push_back(text_size(font, name).x);
    float room = room_px;
    if (names.size() > 1) room -= text_size(font, ", ").x * static_cast<float>(names.size() - 1);
    std::ranges::sort(widths);
    float most = 0.0F;
    for (std::size_t k = 0; k < widths.size(); ++k) {
        most = std::max(0.0F, room) / static_cast<float>(widths.size() - k);
        if (widths[k] > most) break;
        room -= widths[k];
        most = widths[k];
    }
    for (std::string& name : names) name = shortened(font, name, most);
    return joined(names);
}

bool is_by_sum(const Pick& pick) {
    return pick.request.problem.objective == SubsetObjective::max_sum;
}

double worth_of(const Pick& pick, const Subset& subset) {
    return worth_of(subset, pick.request.problem.objective);
}

struct Alternative {
    Exchange exchange;
    std::string words;
    std::string value;  // by what was asked for: the weakest pair then, or the sum
    bool is_one_line = false;
};

Alternative alternative_of(const Theme& theme, const Pick& pick, std::size_t k, float width_px) {
    const Subset& other = pick.answer.alternatives[k];
    const double worth = worth_of(pick, other);
    const bool as_good = worth == worth_of(pick, pick.answer.best);
    Alternative one;
    one.exchange = exchange_of(pick, other);
    one.value = as_good ? "ties" : worth_text(worth);
    one.words = joined(one.exchange.in) + " " + kFor + joined(one.exchange.out);
    const ImFont* font = theme.fonts.regular;
    one.is_one_line =
        text_size(font, one.words).x + theme.gap_px + text_size(font, one.value).x <= width_px;
    return one;
}

float height_px(const Alternative& one) {
    const float line = ImGui::GetTextLineHeight();
    return one.is_one_line ? line : 2.0F * line;
}

// Which pattern replaces which, in two lines if one has no room, and at the right what it is worth.
void draw_alternative(Ui& ui, SubsetState& picking, const Pick& pick, std::size_t k) {
    const Theme& theme = ui.theme;
    const ImFont* font = theme.fonts.regular;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const Alternative one = alternative_of(theme, pick, k, width);
    const float line = ImGui::GetTextLineHeight();
    const float value_px = text_size(font, one.value).x;
    const std::string whole = one.words + ": " + one.value;
    if (option(ui,
               {.id = "alternative:" + std::to_string(k + 1),
                .label = "",
                .tip = one.is_one_line ? "" : whole,
                .value = whole},
               picking.alternative == k, 0, {0.0F, height_px(one)})) {
        picking.alternative = k;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float last_y = corner.y + height_px(one) - line;
    draw_text(list, font, {corner.x + width - value_px, last_y}, theme.dim_text, one.value);
    if (one.is_one_line) return draw_text(list, font, corner, theme.text, one.words);
    draw_text(list, font, corner, theme.text, fitting(font, one.exchange.in, width));
    const float for_px = text_size(font, kFor).x;
    draw_text(list, font, {corner.x, last_y}, theme.dim_text, kFor);
    draw_text(list, font, {corner.x + for_px, last_y}, theme.text,
              fitting(font, one.exchange.out, width - for_px - value_px - theme.gap_px));
}

}  // namespace

const std::string& name_of(const Pick& pick, std::size_t member) {
    return pick.request.map->request.set->vibrations[member].name;
}

float alternatives_px(const Ui& ui, const SubsetState& picking, const Pick& pick, float width_px) {
    if (pick.answer.alternatives.empty()) return 0.0F;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    float height = 0.5F * ui.theme.gap_px + gap + text_size(ui.theme.fonts.small, "N").y + gap;
    if (picking.alternative) height += ImGui::GetTextLineHeightWithSpacing();
    for (std::size_t k = 0; k < pick.answer.alternatives.size(); ++k) {
        height += height_px(alternative_of(ui.theme, pick, k, width_px)) + gap;
    }
    return height;
}

void draw_alternatives(Ui& ui, SubsetState& picking, const Pick& pick) {
    const auto& all = pick.answer.alternatives;
    if (all.empty()) return;
    ImGui::Dummy({1.0F, 0.5F * ui.theme.gap_px});
    ImGui::PushFont(ui.theme.fonts.small);
    const std::string title =
        pick.answer.are_alternatives_proven ? "Next best" : "Others that are good";
    dim_text(ui, title + (is_by_sum(pick) ? ", by the sum" : ", by the weakest pair"));
    ImGui::PopFont();
    if (picking.alternative) {
        if (option(ui, {.id = "alternative:0", .label = "Back to the best"}, false))
            picking.alternative.reset();
    }
    for (std::size_t k = 0; k < all.size(); ++k) draw_alternative(ui, picking, pick, k);
}

}  // namespace tact
