#include <algorithm>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/icons.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

PatternLook look_of(const Theme& theme, const PatternSet& set, std::size_t index) {
    const Vibration& vibration = set.vibrations[index];
    const auto own = shown_colour(theme, vibration.colour);
    return own ? PatternLook{*own, vibration.ring} : pattern_look(theme, index);
}

PatternLook look_of(const Ui& ui, const Workspace& work, std::size_t index) {
    return look_of(ui.theme, work.document.set, index);
}

void give_looks(PatternSet& set) {
    const auto is_bare = [](const Vibration& vibration) { return vibration.colour.empty(); };
    if (std::ranges::none_of(set.vibrations, is_bare)) return;
    // By look: the discs of the palette in its order, then its rings.
    std::array<std::size_t, 2 * kPatternColourCount> used{};
    for (const Vibration& vibration : set.vibrations) {
        if (const auto place = palette_place(vibration.colour)) {
            ++used[*place + (vibration.ring ? kPatternColourCount : 0)];
        }
    }
    for (Vibration& vibration : set.vibrations) {
        if (!is_bare(vibration)) continue;
        const auto least = std::ranges::min_element(used) - used.begin();
        const auto place = static_cast<std::size_t>(least);
        vibration.colour = kPatternColours[place % kPatternColourCount].hex;
        vibration.ring = place >= kPatternColourCount;
        ++used[place];
    }
}

void change_look(Ui& ui, Workspace& work, const std::string& colour, bool ring) {
    for (const std::size_t index : selected_indices(work)) {
        Vibration& vibration = work.document.edit().vibrations[index];
        vibration.colour = colour;
        vibration.ring = ring;
    }
    document_changed(work);
    commit_step(ui, work, of_selection(work, "Change colour"));
}

double shown_reach_g(const Workspace& work) { return work.own_heights ? 0.0 : work.cache.reach_g; }

std::string length_text(double length_s) {
    return length_s < 0.9995 ? significant_digits(1000.0 * length_s, 3) + " ms"
                             : significant_digits(length_s, 3) + " s";
}

void draw_thumbnail(const Ui& ui, Workspace& work, const Rect& area, const Vibration& vibration,
                    ImU32 colour, double reach_g, double axis_s) {
    const Waveform* known = waveform_in_time(work.cache, vibration);
    if (known == nullptr) return;
    const Waveform& waveform = *known;
    Plot plot;
    plot.area = area;
    const double length_s = axis_s > 0.0 ? axis_s : std::max(duration_s(waveform), 1e-3);
    // Silence needs a scale, too.
    const double largest_g = reach_g > 0.0 ? reach_g : std::max(peak_g(waveform), 1e-6);
    plot.x = {0.0, length_s, Scale::linear, area.min.x, area.max.x};
    plot.y = {-largest_g, largest_g, Scale::linear, area.max.y, area.min.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min, area.max, true);
    draw_signal(list, ui.theme, plot, waveform.samples_g, waveform.rate_hz, colour,
                TraceStyle::line);
    list.PopClipRect();
}

void draw_row_ground(const Ui& ui, const Workspace& work, std::size_t index, const Rect& row) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool current = index == work.selection.current;
    if (current || work.selection.others.contains(index)) {
        list.AddRectFilled(row.min, row.max, faded(theme.text, current ? 0.16F : 0.08F),
                           theme.rounding_px);
        if (current) draw_selection_frame(list, theme, row);
    } else if (work.selection.hovered_last == index) {
        list.AddRectFilled(row.min, row.max, theme.hover, theme.rounding_px);
    }
}

namespace {

constexpr float kSignPx = 11.0F;
constexpr float kSignStepPx = 16.0F;

}  // namespace

float state_signs_px(const Theme& theme, const Vibration& vibration) {
    const int count = (vibration.locked ? 1 : 0) + (vibration.dropped ? 1 : 0);
    return static_cast<float>(count) * kSignStepPx * theme.scale;
}

void draw_state_signs(Ui& ui, const Vibration& vibration, ImVec2 right) {
    const Theme& theme = ui.theme;
    const float step = kSignStepPx * theme.scale;
    ImVec2 centre{right.x - 0.5F * step, right.y};
    const auto sign = [&](bool holds, Icon icon, const char* word, const char* help) {
        if (!holds) return;
        draw_icon(*ImGui::GetWindowDrawList(), icon, centre, kSignPx * theme.scale, theme.dim_text);
        const ImVec2 half{0.5F * step, 0.5F * step};
        note_rect(ui.rects, std::string(word) + ":" + vibration.name, centre - half, centre + half);
        if (Rect{centre - half, centre + half}.contains(ImGui::GetIO().MousePos))
            draw_tooltip(ui, help);
        centre.x -= step;
    };
    sign(vibration.dropped, Icon::dropped, "dropped", "Dropped: picked in no subset.");
    sign(vibration.locked, Icon::locked, "locked",
         "Locked: picked in every subset, and not edited.");
}

std::string drawn_text(const PatternSet& set) {
    std::string text = set.name;
    for (const Vibration& vibration : set.vibrations) text += vibration.name + vibration.note;
    return text;
}

Side shown_side(const Workspace& work) { return work.side; }

void show_side(Workspace& work, Side side) {
    if (shown_side(work) == side) return;
    work.side = side;
    document_changed(work);
}

PatternSet shown_set(const Workspace& work) {
    return one_side(work.document.set, shown_side(work));
}

std::string patterns_text(std::size_t count) { return counted(count, "pattern", "patterns"); }

std::string shown_patterns_text(const Workspace& work) {
    const std::size_t all = work.document.set.vibrations.size();
    const Side side = shown_side(work);
    if (side == Side::both && !work.selection.search.empty())
        return grouped_digits(listed_indices(work).size()) + " of " + grouped_digits(all);
    if (side == Side::both) return grouped_digits(all);
    const auto count =
        std::ranges::count_if(work.document.set.vibrations, [side](const Vibration& vibration) {
            return measures_another(vibration) == (side == Side::measured);
        });
    return std::to_string(count) + " " + kSideNames[static_cast<std::size_t>(side)] + " of " +
           std::to_string(all);
}

}  // namespace tact
