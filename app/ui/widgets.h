// The few widgets the panels are made of: panes, parameter fields, splitters, hints.
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

// What large text leaves hardly any width scrolls sideways, too. Not where there is width: with
// such a bar, ImGui wraps no text that is as wide as what was there before.
ImGuiWindowFlags sideways_if_narrow(const Ui& ui, float width_px);

// A pane of the window with its title; double-clicking the title maximises it or puts it back.
// Draws `content` inside, with the cursor at its top left.
struct PaneTitle {
    std::string title;
    std::string detail;              // dim, after the title
    std::vector<std::string> right;  // dim, at the right end: the longest form that has room
    bool has_ground = false;         // of a scene in space: darker toward the viewer
};
void draw_pane(Ui& ui, Layout& layout, Pane pane, const Rect& area, const PaneTitle& title,
               const std::function<void()>& content);

// A number with a slider and typed entry. Typing reaches further than the slider and is exact; the
// slider keeps to multiples of `snap`, and arrow keys step onto them. Where the row is too narrow
// for all three the label stands above, and where even that is too narrow the slider goes.
struct Field {
    const char* id;      // "amplitude_g": also its name for tests
    const char* label;   // "Amplitude"
    const char* format;  // of printf, with the unit: "%.2f g"
    Range slider;
    Range typed;
    double step;  // of an arrow key; 5 steps with Shift, a tenth with Alt
    double snap = 0.0;
    bool logarithmic = false;
    const char* help = nullptr;  // a tooltip
    bool enabled = true;
    float right_room_px = 0.0F;      // left free after the entry
    std::optional<double> normal{};  // what a double click on the label brings back
    std::optional<Range> mixed{};    // it stands for several: the least and the most of them
};

struct FieldEdit : NumberEdit {
    bool finished = false;  // the gesture ended: an undo step
    bool over_bar = false;  // the mouse is on the slider
};

FieldEdit draw_field(Ui& ui, const Field& field, double& value);

// Within a row of other things: label, slider and entry in so many pixels.
FieldEdit draw_short_field(Ui& ui, const Field& field, float width_px, double& value);

// A row's label column, for rows that are no Field. The label stands above where less than
// `room_px` would be left beside it. An empty one only moves the cursor to what follows.
void draw_label(const Ui& ui, const char* label, float room_px = 0.0F);

// The next item comes beside the last one where its width has room, else below: false.
bool flow_on(float width_px, float gap_px);

// A tooltip on the last item after a moment's rest.
void draw_tooltip(const Ui& ui, const char* text);

// One of a list: a ring and its word. True when pressed.
bool draw_radio(const Ui& ui, const char* label, bool chosen);
float radio_width(const Ui& ui, const char* label);

// One of a few words in a row: segments of one control. True when pressed.
bool draw_segment(const Ui& ui, const char* words, bool chosen, std::optional<Icon> icon = {});
float segment_width(const Ui& ui, const char* words, bool has_icon = false);

// What a control of segments offers. The words, which follow "radio:", name a segment for tests.
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

// Beside each other, below where a pane is too narrow. True when another one was taken.
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

// A setting that is on or off, said in words beside a small box; all of it, as high as a field, can
// be pressed. What of the label follows "###" only names it. True when pressed.
bool draw_check(const Theme& theme, const char* label, bool& on);
float check_width(const Theme& theme, const char* label);

// Whether the last item cannot be pressed.
bool is_item_disabled();

// The line between the parts of a menu, a popup or a dialog, of whole pixels.
void draw_divider(const Theme& theme);

float button_width(const char* label);

// A 6 px bar between two panes that moves a share of `total` pixels while it is dragged. Upright
// bars part columns.
struct Splitter {
    const char* id;
    Rect bar;
    bool upright;
    float total_px;
    Range share;
};
void draw_splitter(Ui& ui, const Splitter& splitter, float& share);

// One line of advice that stays away once dismissed.
void draw_hint(Ui& ui, const char* id, const char* text);

// What a dialog or a pane is there for; there is one of them. Disabled it looks as any other.
bool primary_button(Ui& ui, const char* label, ImVec2 size = {0.0F, 0.0F});

// For a popup that is begun next: below the last item, and not over it.
void open_below_last_item(const Theme& theme);

// For a popup about so wide that is begun next: beside the pane, whose picture it changes, at the
// height of the last item. To the right, as lists stand at the left; over the right end of the pane
// where no side has room.
void open_beside_pane(const Theme& theme, float width_px);

// Within an open popup: up where it would end below the window.
void keep_on_screen(const Theme& theme);

// An item of a menu with the sign that its button has elsewhere; none: its words stand below those
// of the others.
struct MenuRow {
    const char* words;
    const char* keys = "";
    bool checked = false;
    bool enabled = true;
    std::optional<Icon> icon{};
};
bool draw_menu_row(const Theme& theme, const MenuRow& row);

// A number at the right of its cell, or what heads a column of them.
void right_aligned(const std::string& text);

// A word to choose a view by: tabs and strips are made of them. True when pressed.
bool draw_chip(const Ui& ui, const char* id, const char* text, bool lit);
float chip_width(const Ui& ui, const char* text);

// A setting that is on or off, or one of a few, in a row of fields: it has an edge, and its words
// stand on their line. True when pressed.
bool draw_switch(const Ui& ui, const char* id, const char* text, bool on);

// What a pane says while it has nothing to show, and below that what helps. True when pressed.
bool draw_empty_with(Ui& ui, const Rect& area, const char* title, const std::string& reason,
                     const char* button, bool is_primary = true);

// These show what steers a text as its number (model/text/shown_text.h).
//
// Text in the theme's dim colour.
void dim_text(const Ui& ui, const std::string& text);

// The same in small letters, at the end of a line of fields where it has room, else below.
void dim_text_beside(const Ui& ui, const std::string& text);

// Text with its lines broken at spaces alone (wrapped() in viz/drawing/marks.h), where ImGui breaks
// numbers at their points, too.
void wrapped_text(const std::string& text);

// Text in a colour, wrapped at the pane's edge.
void coloured_text(ImU32 colour, const std::string& text);

// The "i" in a circle.
void draw_info_mark(const Ui& ui, ImVec2 centre, bool lit);

// A quiet button, for deeds within a text or a row of small things.
bool link(const Ui& ui, const char* id, const std::string& text);

// The name of something, in the accent colour: a press leads to it.
bool name_link(const Ui& ui, const char* id, const std::string& text);

// A quiet button in a line of fields: as high as they are, its words on theirs.
bool row_link(const Ui& ui, const char* id, const std::string& text);

// A name as ImGui's own widgets take one, which hide what follows "##".
std::string label_of(const std::string& name);

// What is left of the pane below the cursor.
Rect rest_of_pane();

}  // namespace tact
