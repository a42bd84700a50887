// Widgets: buttons, rows, fields of numbers, tables.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "app/ui/ui.h"
#include "model/pattern/pattern.h"
#include "model/text/described.h"
#include "model/text/typed_number.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/icons.h"

namespace tact {

// The panes' shares of the window, and the shown panes.

// Tabs of the lower right pane.
enum class BenchTab { matrix, candidates, subset, compare, shepard, why, model, device, library };

struct BenchRow {
    BenchTab tab;
    const char* key;      // in sessions: it never changes
    const char* label;    // on the tab, and the title of the pane
    const char* about;    // after the title
    const char* command;  // in the View menu
    const char* words;    // more words by which the palette finds it
};

// In the order of BenchTab. app/window/panes.cpp draws them, assets/manual/panes.html has an entry
// for each.
inline constexpr auto kBenchTabs = std::to_array<BenchRow>({
    {BenchTab::matrix, "matrix", "Matrix", "dissimilarity of every pair", "Matrix",
     "dissimilarity heat map"},
    {BenchTab::candidates, "candidates", "Table", "candidates side by side", "Table of candidates",
     "columns sort filter lock drop numbers"},
    {BenchTab::subset, "subset", "Subset", "the most distinct patterns", "Subset",
     "pick most distinct confusable separate stable"},
    {BenchTab::compare, "compare", "Compare", "metrics against people", "Compare with people",
     "ratings metrics rho table"},
    {BenchTab::shepard, "shepard", "Shepard", "how well the map fits", "Shepard diagram",
     "stress fit map"},
    {BenchTab::why, "why", "Why", "are these two different?", "Why are these two different?",
     "pair channels explain"},
    {BenchTab::model, "model", "Model", "parameters of PM", "Model",
     "parameters weights layers thresholds"},
    {BenchTab::device, "device", "Device", "what an actuator makes of", "What a device makes of it",
     "rendering actuator controller joy-con energy lost"},
    {BenchTab::library, "library", "Library", "effects to choose from", "Library",
     "effects folder search tags like shape"},
});

static_assert(
    [] {
        for (std::size_t k = 0; k < kBenchTabs.size(); ++k) {
            if (kBenchTabs[k].tab != static_cast<BenchTab>(k)) return false;
        }
        return true;
    }(),
    "rows are in the order of BenchTab");

enum class Pane {
    patterns,
    editor,
    physiology,
    space,
    matrix,
    study_design,  // these three only in the view of studies
    study_people,
    study_answers,
    start  // replaces map, answers and editor while the set is empty
};

// Arrangements of the window, by purpose.
enum class Arrangement { design, select, physiology };

// The stages: in the middle column, in one row below the map, or hidden. When folded, the map
// leads.
enum class Fold { open, row, closed };

struct Layout {
    float left = 0.21F;  // shares of the window's width
    float right = 0.34F;
    float left_split = 0.45F;  // shares of the column's height above the splitter
    float right_split = 0.58F;
    float band = 0.42F;  // share of the window's height for the editor below the map
    std::optional<Pane> maximised;
    BenchTab bench = BenchTab::matrix;
    Arrangement arrangement = Arrangement::design;
    Fold physiology = Fold::open;

    bool operator==(const Layout&) const = default;
};

// The entry for every number of the window.
//
// A click selects all of it. Enter, Tab and leaving it accept the typed text, Esc does not. Up,
// down and the wheel step, Shift coarsely, Alt finely, and take effect at once. Text that is not a
// number is refused with a message, a number out of range is clamped with a message. Unchanged text
// changes nothing, even if the number has more digits than are shown. A double click on its label
// restores its default.

struct NumberEntry {
    std::string id;      // within its window; the caller gives the name for tests
    std::string label;   // its name in messages
    const char* format;  // of printf, with the unit
    NumberRules rules;
    float width_px = 0.0F;
    double step = 0.0;   // 0: one in the second digit
    bool live = false;   // valid text takes effect while typing; leaving the entry with invalid
                         // text restores the number
    bool mixed = false;  // shown while several numbers differ, until one is typed for all
};

// The way a number changed; others that it stands for change in the same way.
enum class Along {
    same,    // all get its value
    factor,  // each times the factor
    ratio,   // times the ratio of its value to that at the beginning of the gesture
    step,    // each by the same difference
    back     // each to its value at the beginning of the gesture
};

struct NumberEdit {
    bool changed = false;  // to another value; if several differ, perhaps to the same
    bool begun = false;    // the entry has got the keyboard
    Along along = Along::same;
    double factor = 1.0;
};

// True if the number changed.
bool enter_number(Ui& ui, const NumberEntry& entry, double& value);

// Whether the last item, the label of a number, was double-clicked to restore its default.
bool is_reset_asked(const Ui& ui);

// Restores the default then. True if the number changed.
bool reset_by_label(const Ui& ui, double normal, double& value);
bool reset_by_label(const Ui& ui, int normal, int& value);

// Whether a number was typed in this frame or the last one: Enter and Esc belong to it.
bool is_number_typed(const Ui& ui);

// A whole number.
bool enter_whole(Ui& ui, const NumberEntry& entry, int& value);

// With buttons for one less and one more, within the width.
bool enter_whole_with_buttons(Ui& ui, const NumberEntry& entry, int& value);

// Widgets shared by all panels: panes, parameter fields, splitters, hints.

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

// Widgets that say themselves: each notes its place for tests, lessons and Tab, and carries its
// tooltip. A reason not to be pressed disables it, and is its tooltip then.

struct Item {
    std::string id;         // its name for tests, lessons and Tab; unique in its window
    std::string label;      // its words
    std::string tip{};      // a sentence or two
    std::string why_not{};  // not empty: disabled, for this reason
    bool enabled = true;    // false: disabled for a reason that is in sight
    std::optional<std::string> value{};  // noted with its place; default: the label
};

// True if pressed.
bool button(Ui& ui, const Item& item, ImVec2 size = {0.0F, 0.0F});
bool small_button(Ui& ui, const Item& item);

// The main action of a dialog or a pane, which has only one.
bool primary_button(Ui& ui, const Item& item, ImVec2 size = {0.0F, 0.0F});

// Quiet buttons: for an action within a text or a row of small items; in a line of fields, as high
// as they are; and a name in the accent colour, which a press goes to.
bool link(Ui& ui, const Item& item);
bool row_link(Ui& ui, const Item& item);
bool name_link(Ui& ui, const Item& item);

// A word that chooses a view, for tabs and strips; a setting in a row of fields, with an edge; a
// box with words, as high as a field, noted as on or off; a ring with its word; one option of a
// control of segments.
bool chip(Ui& ui, const Item& item, bool lit);
bool toggle(Ui& ui, const Item& item, bool on);
bool check(Ui& ui, Item item, bool& on);
bool radio(Ui& ui, const Item& item, bool chosen);
bool segment(Ui& ui, const Item& item, bool chosen, std::optional<Icon> icon = {});

// A row of a list or a drop-down, and of a menu.
bool option(Ui& ui, const Item& item, bool chosen, ImGuiSelectableFlags flags = 0,
            ImVec2 size = {0.0F, 0.0F});
bool menu_item(Ui& ui, const Item& item, const char* keys = nullptr, bool checked = false);

// A list that opens below what is chosen, the label; `rows` draws its options. Its width is that of
// other fields if none is given.
void drop_down(Ui& ui, const Item& item, float width_px, const std::function<void()>& rows,
               ImGuiComboFlags flags = ImGuiComboFlags_HeightLargest);

// A text that is noted.
struct Said {
    std::string id;
    std::string text;
    std::string tip{};
    std::optional<std::string> value{};  // noted with its place; default: the text
};
void plain_text(Ui& ui, const Said& said);
void dim_text(Ui& ui, const Said& said);
void dim_text_beside(Ui& ui, const Said& said);
void wrapped_text(Ui& ui, const Said& said);
void coloured_text(Ui& ui, ImU32 colour, const Said& said);

// Notes the last item, and draws its tooltip.
void say_of_last_item(Ui& ui, const Said& said);

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
    for (const auto& one : all) width += segment_width(ui, one.words, bool(one.icon));
    return width;
}

// Side by side, or below each other in a narrow pane. True if another option was chosen.
template <class Segments, class Value>
bool draw_segments(Ui& ui, const Segments& all, Value& chosen,
                   const std::string& noted = "radio:") {
    const Value before = chosen;
    bool is_first = true;
    for (const auto& one : all) {
        if (!is_first) flow_on(segment_width(ui, one.words, bool(one.icon)), 0.0F);
        is_first = false;
        const bool is_chosen = before == one.value;
        const Item item{.id = noted + one.words,
                        .label = one.words,
                        .tip = one.help == nullptr ? "" : one.help,
                        .value = is_chosen ? "chosen" : ""};
        if (segment(ui, item, is_chosen, one.icon)) chosen = one.value;
    }
    return chosen != before;
}

float check_width(const Theme& theme, const char* label);

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

// Places the popup that begins next, about this wide: beside the pane whose picture it changes, at
// the height of the last item; at the right, as lists stand at the left. Without room on either
// side it covers the right end of the pane.
void open_beside_pane(const Theme& theme, float width_px);

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

float chip_width(const Ui& ui, const char* text);

// The text of a pane that has nothing to show, and a button that helps. True if pressed.
bool draw_empty_with(Ui& ui, const Rect& area, const char* title, const std::string& reason,
                     const Item& item, bool is_primary = true);

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

// A name for ImGui's own widgets, which hide everything after "##".
std::string label_of(const std::string& name);

// The rest of the pane below the cursor.
Rect rest_of_pane();

// A field for a number that is described: its words, slider, range and steps are those of
// everything that takes the number.

// `id` is its name for tests. Shown are number.times as many as files hold.
constexpr Field field_of(const Number& number, const char* id) {
    return {.id = id,
            .label = number.label,
            .format = number.format,
            .slider = number.shown(number.slider),
            .typed = number.shown(number.range),
            .step = number.step,
            .snap = number.snap,
            .logarithmic = number.logarithmic,
            .help = number.help};
}

// The same with where the number is: in shown units.
template <class Struct>
struct DescribedField {
    Field field;
    double (*get)(const Struct&);
    void (*set)(Struct&, double);
};

// `path`: members from the struct down to the number.
template <const Number& number, class Struct, auto... path>
constexpr DescribedField<Struct> described_field(const char* id) {
    return {field_of(number, id),
            [](const Struct& all) { return number.times * static_cast<double>((all.*....*path)); },
            [](Struct& all, double shown) {
                auto& value = (all.*....*path);
                if constexpr (std::is_same_v<decltype(value), int&>) {
                    value = static_cast<int>(std::lround(shown / number.times));
                } else {
                    value = shown / number.times;
                }
            }};
}

}  // namespace tact
