#include "app/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// The common mark of the raters: synthetic, stale or both.
NumberMark mark_of(const std::vector<Ratings>& ratings) {
    NumberMark mark;
    for (const Ratings& one : ratings) mark = mark | one.mark;
    return mark;
}

}  // namespace

std::string of_people(const std::string& quantity, const NumberMark& mark) {
    const std::string words = words_of(mark);
    return words.empty() ? quantity : words + " " + quantity;
}

std::string of_counted(const std::string& quantity, const NumberMark& mark) {
    const std::string left_out = left_out_text(mark);
    return of_people(quantity, mark) + (left_out.empty() ? "" : " (" + left_out + ")");
}

std::string people_text(const PatternSet& set, const RatedPeople& people) {
    std::set<std::string> voices;
    std::set<std::string> nobody;
    for (const Ratings& one : set.ratings) {
        voices.insert(one.name);
        if (one.mark.synthetic) nobody.insert(one.name);
    }
    const std::string file = set.ratings.empty() ? "" : set.ratings.front().file;
    std::string text = file.empty() ? "Ratings of the set" : file;
    const std::string left_out = left_out_text(mark_of(set.ratings));
    if (!left_out.empty()) text += " (" + left_out + ")";
    text += ": " + std::to_string(voices.size());
    text += voices.size() == 1 ? " participant" : " participants";
    if (nobody.size() == voices.size() && !nobody.empty()) text += ", synthetic: nobody was asked";
    if (nobody.size() < voices.size() && !nobody.empty()) {
        text += ", " + std::to_string(nobody.size()) + " of them synthetic";
    }
    if (set.ratings.size() > voices.size()) {
        text += ", " + std::to_string(set.ratings.size()) + " passes";
    }
    const std::size_t patterns = people.rated.people.dissimilarity.size;
    if (!people.unrated.empty()) {
        text += ", " + std::to_string(patterns - people.unrated.size()) + " of " +
                std::to_string(patterns) + " patterns rated";
    }
    return text + ", " + std::to_string(people.rated_pairs) + " of " +
           std::to_string(pair_count(patterns)) + " pairs";
}

std::string ceiling_text(const Reliability& reliability, const NumberMark& mark) {
    if (reliability.voices < 2) return "Noise ceiling unknown: it takes two voices.";
    const std::string voices = std::to_string(reliability.voices);
    const std::string mean = reliability.is_of_one_person
                                 ? "one person's " + voices + " repetitions"
                                 : voices + " participants";
    const std::string one = reliability.is_of_one_person ? "repetition" : "participant";
    return "Noise ceiling: a metric can reach " + of_people("rho ", mark) +
           with_decimals(reliability.ceiling_of_mean, 2) + " with the mean of " + mean +
           " (reliability " + with_decimals(reliability.spearman_brown, 2) + "); one " + one +
           " reaches " + with_decimals(reliability.one_with_others, 2) +
           " with the mean of the others.";
}

std::string single_ceiling_text(const Ceilings& ceilings, const NumberMark& mark) {
    if (ceilings.voices < 2) return {};
    const auto bound = [](const Spread& spread) {
        return with_decimals(spread.mean, 2) + " (median " + with_decimals(spread.median, 2) + ")";
    };
    return std::string("With one ") + (ceilings.is_of_one_person ? "repetition" : "participant") +
           " the best metric there could be has a mean " + of_people("rho", mark) + " of " +
           bound(ceilings.with_others) + " to " + bound(ceilings.with_all) +
           ": of each with the mean of the others, and with that of all.";
}

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

void reading_text(Ui& ui, ImU32 colour, const Said& said) {
    reading_text(colour, said.text);
    say_of_last_item(ui, said);
}

}  // namespace tact
