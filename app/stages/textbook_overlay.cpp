#include "app/stages/parts.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/ui/widgets.h"
#include "model/textbook/textbook.h"
#include "model/textbook/textbook_beside.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr const char* kParts = "\u2260 ";  // deviates from the measured facts
constexpr const char* kTitle = "Textbook: ";
constexpr float kMostOfStage = 0.3F;  // share of a large stage's height
constexpr double kHighestHz = 500.0;

// For a pair, the difference that people notice replaces the general facts.
std::string pair_line(const std::vector<ShownStages>& patterns, Stage stage) {
    if (patterns.size() < 2 || stage != Stage::brain) return {};
    const auto* a = std::get_if<Pattern>(&patterns[0].live->request.vibration.source);
    const auto* b = std::get_if<Pattern>(&patterns[1].live->request.vibration.source);
    return a != nullptr && b != nullptr ? noticed_text(*a, *b) : std::string();
}

std::string words_of(const BesideLine& line) {
    return (line.parts ? kParts : "") + (kTitle + line.text);
}

std::string all_words(const std::vector<BesideLine>& lines) {
    std::string text;
    for (const BesideLine& line : lines) text += (text.empty() ? "" : "\n") + words_of(line);
    return text;
}

float height_px(const ImFont& font, const std::string& text, float width_px) {
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, width_px, text.c_str()).y;
}

}  // namespace

float draw_textbook(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                    Stage stage, const Rect& below) {
    if (!physiology.view.textbook || patterns.empty()) return 0.0F;
    std::vector<BesideFact> facts = patterns[0].live->beside[index_of(stage)];
    const std::string of_pair = pair_line(patterns, stage);
    if (!of_pair.empty()) {
        std::erase_if(facts, [](const BesideFact& one) { return one.fact->id.ends_with(" jnd"); });
    }
    std::vector<BesideLine> lines = lines_of(facts);
    if (!of_pair.empty()) lines.insert(lines.begin(), BesideLine{of_pair, false});
    if (lines.empty()) return 0.0F;
    const Theme& theme = ui.theme;
    const ImFont& font = font_or_current(theme.fonts.small);
    const float left = below.min.x + 1.25F * theme.gap_px;
    const float width = below.max.x - left;
    const float most = kMostOfStage * below.height();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float top = below.min.y;
    std::size_t shown = 0;
    for (const BesideLine& line : lines) {
        // The last line that fits leaves room to say that there are more.
        const bool is_last = shown + 1 == lines.size();
        const std::string words = words_of(line);
        const float line_px = height_px(font, words, width);
        const float more_px = is_last ? 0.0F : font.FontSize;
        if (shown > 0 && top + line_px + more_px > below.min.y + most) break;
        const bool is_of_pair = shown == 0 && !of_pair.empty();
        list.AddText(&font, font.FontSize, {left, top},
                     line.parts || is_of_pair ? theme.text : theme.dim_text, words.c_str(), nullptr,
                     width);
        top += line_px;
        ++shown;
    }
    if (shown < lines.size()) {
        const std::string more =
            "and " + std::to_string(lines.size() - shown) + " more, in the stage's text (i)";
        draw_text(list, &font, {left, top}, theme.dim_text, shortened(&font, more, width));
        top += font.FontSize;
    }
    const float bar = std::max(2.0F, 2.0F * theme.scale);
    list.AddRectFilled(below.min, {below.min.x + bar, top}, theme.dim_text);
    note_rect(ui.rects, std::string("textbook:") + text_of(stage).key, below.min,
              {below.max.x, top}, all_words(lines));
    return top - below.min.y + 1.5F * theme.gap_px;
}

float draw_textbook_sign(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                         Stage stage, const Rect& label) {
    if (!physiology.view.textbook) return 0.0F;
    const ImFont& font = font_or_current(ui.theme.fonts.small);
    if (label.height() < font.FontSize) return 0.0F;
    const std::vector<BesideLine> lines = lines_of(shown.live->beside[index_of(stage)]);
    if (std::ranges::none_of(lines, &BesideLine::parts)) return 0.0F;
    const std::string words = shortened(&font, std::string(kParts) + "textbook", label.width());
    const ImVec2 at{label.min.x, std::floor(label.max.y - font.FontSize)};
    draw_text(*ImGui::GetWindowDrawList(), &font, at, ui.theme.text, words);
    const ImVec2 size = text_size(&font, words);
    note_rect(ui.rects, std::string("textbook:") + text_of(stage).key, at, at + size,
              all_words(lines));
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy(size);
    draw_tooltip(ui, all_words(lines).c_str());
    return font.FontSize + 2.0F * ui.theme.scale;
}

MeasuredSpectrum measured_spectrum(const Physiology& physiology) {
    MeasuredSpectrum measured;
    if (!physiology.view.textbook) return measured;
    for (const TextbookFact& fact : textbook()) {
        if (fact.sure == Sure::from_memory) continue;
        if (fact.id == "least amplitude felt") measured.felt_db = fact.points;
        if (!fact.id.starts_with("best band")) continue;
        measured.bands.push_back(
            {*fact.receptor, {fact.low.value_or(1.0), fact.high.value_or(kHighestHz)}});
    }
    return measured;
}

}  // namespace tact
