// Widgets shared by all panels: panes, parameter fields, splitters, hints.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/layout.h"
#include "app/ui/number_field.h"
#include "app/ui/ui.h"
#include "model/pattern/pattern.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/icons.h"

namespace tact {

// Flag for panes that large text makes too narrow: they scroll sideways, too. Wider panes do not,
// as ImGui would not wrap text that is as wide as the one before.
ImGuiWindowFlags sideways_if_narrow(const Ui& ui, float width_px);

// Whether the window is too narrow for columns of panes: it shows one at a time.
bool is_narrow(const Theme& theme);

// A pane of the window with its title; a double click on the title maximises it or restores it.
// Draws `content` inside, with the cursor at its top left.
struct PaneTitle {
    std::string title;
    std::string detail;              // dim, after the title
    std::vector<std::string> right;  // dim, at the right end: the longest form that fits
    bool has_ground = false;         // background of a scene in space: darker toward the viewer
};
void draw_pane(Ui& ui, Layout& layout, Pane pane, const Rect& area, const PaneTitle& title,
               const std::function<void()>& content);

// A number with a slider and typed entry. Typing is exact and has a wider range than the slider;
// the slider moves in multiples of `snap`, and so do arrow keys. In a narrow row the label stands
// above; in a very narrow one the slider is left out.
struct Field {
    const char* id;      // "amplitude_g": also its name for tests
    const char* label;   // "Amplitude"
    const char* format;  // of printf, with the unit: "%.2f g"
    Range slider;
    Range typed;
    double step;  // step of an arrow key; 5 steps with Shift, a tenth with Alt
    double snap = 0.0;
    bool logarithmic = false;
    const char* help = nullptr;  // a tooltip
    bool enabled = true;
    float right_room_px = 0.0F;      // room after the entry
    std::optional<double> normal{};  // the default, restored by a double click on the label
    std::optional<Range> mixed{};    // smallest and largest of several numbers
};

struct FieldEdit : NumberEdit {
    bool finished = false;  // the gesture ended: an undo step
    bool over_bar = false;  // the mouse is on the slider
};

FieldEdit draw_field(Ui& ui, const Field& field, double& value);

// Within a row of other items: label, slider and entry in this width.
FieldEdit draw_short_field(Ui& ui, const Field& field, float width_px, double& value);

// A row's label column, for rows that are not a Field. The label stands above if less than
// `room_px` would be left beside it. An empty label only moves the cursor.
void draw_label(const Ui& ui, const char* label, float room_px = 0.0F);

// Places the next item beside the last one if it fits there; otherwise below: false.
bool flow_on(float width_px, float gap_px);

// A tooltip on the last item, shown after a moment's rest.
void draw_tooltip(const Ui& ui, const char* text);

// One option of a list: a ring and its word. True if pressed.
bool draw_radio(const Ui& ui, const char* label, bool chosen);
float radio_width(const Ui& ui, const char* label);

// One option of a row: segments of one control. True if pressed.
bool draw_segment(const Ui& ui, const char* words, bool chosen, std::optional<Icon> icon = {});
float segment_width(const Ui& ui, const char* words, bool has_icon = false);

// Options of a control of segments. The words, after "radio:", name a segment for tests.
template <class Value>
struct Choice {
    Value value;
    const char* words;
    const char* help = nullptr;
    std::optional<Icon> icon{};  // before the words
};
template <class Value>
Choice(Value, const char*, const char* = nullptr, std::optional<Icon> = {}) -> Choice<Value>;

template <class Segments>
float segments_width(const Ui& ui, const Segments& all) {
    float width = 0.0F;
    for (const auto& segment : all) width += segment_width(ui, segment.words, bool(segment.icon));
    return width;
}

// Side by side, or below each other in a narrow pane. True if another option was chosen.
template <class Segments, class Value>
bool draw_segments(Ui& ui, const Segments& all, Value& chosen,
                   const std::string& noted = "radio:") {
    const Value before = chosen;
    bool is_first = true;
    for (const auto& segment : all) {
        if (!is_first) flow_on(segment_width(ui, segment.words, bool(segment.icon)), 0.0F);
        is_first = false;
        const bool is_chosen = before == segment.value;
        if (draw_segment(ui, segment.words, is_chosen, segment.icon)) chosen = segment.value;
        note_item(ui.rects, noted + segment.words, before == segment.value ? "chosen" : "");
        if (segment.help != nullptr) draw_tooltip(ui, segment.help);
    }
    return chosen != before;
}

// A setting that is on or off, as words beside a small box; the whole item, as high as a field, can
// be pressed. Label text after "###" is only a name. True if pressed.
bool draw_check(const Theme& theme, const char* label, bool& on);
float check_width(const Theme& theme, const char* label);

// Whether the last item is disabled.
bool is_item_disabled();

// The line between the parts of a menu, a popup or a dialog, of whole pixels.
void draw_divider(const Theme& theme);

float button_width(const char* label);

// A 6 px bar between two panes; dragging it changes a share of `total` pixels. An upright bar
// stands between columns.
struct Splitter {
    const char* id;
    Rect bar;
    bool upright;
    float total_px;
    Range share;
};
void draw_splitter(Ui& ui, const Splitter& splitter, float& share);

// A line of advice that stays hidden once closed.
void draw_hint(Ui& ui, const char* id, const char* text);

// The main action of a dialog or a pane, which has only one. Disabled it looks like any other
// button.
bool primary_button(Ui& ui, const char* label, ImVec2 size = {0.0F, 0.0F});

// Places the popup that begins next below the last item, without covering it.
void open_below_last_item(const Theme& theme);

// Places the popup that begins next, about this wide: beside the pane whose picture it changes, at
// the height of the last item; at the right, as lists stand at the left. Without room on either
// side it covers the right end of the pane.
void open_beside_pane(const Theme& theme, float width_px);

// Call in an open popup: moves it up if it would end below the window.
void keep_on_screen(const Theme& theme);

// A menu item with the sign of its button; empty: its words stand below those of the others.
struct MenuRow {
    const char* words;
    const char* keys = "";
    bool checked = false;
    bool enabled = true;
    std::optional<Icon> icon{};
};
bool draw_menu_row(const Theme& theme, const MenuRow& row);

// A number or a heading at the right of its cell.
void right_aligned(const std::string& text);

// A word that chooses a view, for tabs and strips. True if pressed.
bool draw_chip(const Ui& ui, const char* id, const char* text, bool lit);
float chip_width(const Ui& ui, const char* text);

// A setting that is on or off, or an option, in a row of fields: it has an edge, and its words
// stand on their line. True if pressed.
bool draw_switch(const Ui& ui, const char* id, const char* text, bool on);

// The text of a pane that has nothing to show, and a button that helps. True if pressed.
bool draw_empty_with(Ui& ui, const Rect& area, const char* title, const std::string& reason,
                     const char* button, bool is_primary = true);

// The following show control characters as their numbers (model/text/shown_text.h).
//
// Text in the theme's dim colour.
void dim_text(const Ui& ui, const std::string& text);

// The same in small letters, at the end of a line of fields if it fits, otherwise below.
void dim_text_beside(const Ui& ui, const std::string& text);

// Text whose lines break only at spaces (wrapped() in viz/drawing/marks.h); ImGui also breaks
// numbers at their points.
void wrapped_text(const std::string& text);

// Text in a colour, wrapped at the pane's edge.
void coloured_text(ImU32 colour, const std::string& text);

// The "i" in a circle.
void draw_info_mark(const Ui& ui, ImVec2 centre, bool lit);

// A quiet button for an action within a text or a row of small items.
bool link(const Ui& ui, const char* id, const std::string& text);

// A name in the accent colour: a press goes to it.
bool name_link(const Ui& ui, const char* id, const std::string& text);

// A quiet button in a line of fields: as high as they are, with words on their line.
bool row_link(const Ui& ui, const char* id, const std::string& text);

// A name for ImGui's own widgets, which hide everything after "##".
std::string label_of(const std::string& name);

// The rest of the pane below the cursor.
Rect rest_of_pane();

}  // namespace tact
