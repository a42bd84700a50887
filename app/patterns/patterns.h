// The list and the editor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/layers/layers.h"
#include "app/map/map.h"
#include "app/session/session.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/wave_strip/wave_strip.h"
#include "model/pattern/pattern.h"
#include "model/pattern/tapped_rhythm.h"
#include "model/pattern/traced.h"
#include "model/set/pattern_set.h"

namespace tact {

// The pattern in the editor and its closest neighbour: always visible, at the bottom of a narrow
// editor and in the first line of a wide one.

// Buttons pressed on the card, and the place of the neighbour in the document.
enum class NeighbourChoice { play_both, why, separate };
struct NeighbourAction {
    NeighbourChoice action;
    std::size_t neighbour = 0;
};

// Rows of the map on screen, and the closest one's place in the document. Computed once a frame.
struct Neighbour {
    std::size_t own = 0;
    std::size_t closest = 0;
    std::size_t place = 0;
};
std::optional<Neighbour> neighbour_of(const Workspace& work, const ShownMap& shown_map);

// Height of the card in the pane.
float neighbour_card_px(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        const Neighbour& pair);

std::optional<NeighbourAction> draw_neighbour_card(Ui& ui, Workspace& work,
                                                   const ShownMap& shown_map,
                                                   const Neighbour& pair);

// The cut of the recording in the editor, and the pattern traced from it.

// Settings relative to the recording as it came into the editor.
struct RecordingCut {
    double gain_db = 0.0;
    Range part_s{0.0, 0.0};
    double fade_in_s = 0.0;
    double fade_out_s = 0.0;

    bool operator==(const RecordingCut&) const = default;
};

struct TraceRequest {
    std::shared_ptr<const Waveform> recording;
    std::size_t most_points = 0;

    bool operator==(const TraceRequest&) const = default;  // the same recording, not only an equal
                                                           // one
};

struct TraceAnswer {
    TraceRequest request;
    TracedPattern traced;
};

struct RecordingEditor {
    std::string name;                       // the recording that all below belongs to
    Measurement before;                     // the cut recording ...
    std::string note_before;                // ... and its description
    std::shared_ptr<const Waveform> after;  // the version in the set
    RecordingCut cut;
    std::size_t most_points = TraceParams{}.most_points;
    Query<TraceRequest, TraceAnswer> job;
};

// State of the list of generated rhythms, and the drag that draws a note.

enum class RhythmList {
    necklaces,  // all of one length and number of notes
    euclidean   // the most even one for each number of notes
};

struct RhythmChoice {
    RhythmList list = RhythmList::necklaces;
    int steps = 8;
    int notes = 3;
    int note_steps = 1;  // length of a note; 0: held until the next

    std::vector<std::string> texts;  // rhythms for these settings, computed when the settings
                                     // change, most even first
    std::optional<RhythmList> made_list;
    int made_steps = 0;
    int made_notes = 0;
    int made_note_steps = 0;

    Pattern previewed;  // the rhythm with the kept envelope
    std::vector<double> envelope;
};

// A note from the pressed step of the grid to the step under the mouse.
struct NoteDrag {
    std::string before;  // the whole text before the drag
    std::size_t from = 0;
    bool moved = false;
};

// State of the list of patterns and of the editor.

// A click in the list takes effect at the end of its frame: an edit that it ends, such as a number
// being typed, belongs to the pattern selected before.
struct RowClick {
    std::size_t index = 0;
    bool shift = false;
    bool ctrl = false;
};

struct SetPanelState {
    std::optional<RowClick> clicked;
    std::string rename_text;
    std::optional<std::size_t> renaming;
    std::uint64_t renaming_in = 0;  // number of the document
    bool rename_begun = false;      // its field has had the keyboard
};

// The part that an editor shows if it has room for only one.
enum class EditorTab { numbers, drawing };

struct EditorState {
    EditorTab tab = EditorTab::numbers;
    std::string active_pattern;    // keys of the fields go to it
    std::string rhythm_text;       // while typing
    std::string rhythm_typed_for;  // name of the pattern; empty: no row is being renamed
    RhythmChoice rhythms;
    std::optional<NoteDrag> note_drag;
};

// A rhythm being tapped.
struct TappingState {
    std::vector<Tap> taps;         // on the window's clock
    std::optional<double> down_s;  // time at which the key or button was pressed
    std::optional<double> step_s;  // set by hand; nullopt: estimated
    bool has_opened = true;        // the key that opened the dialog may still be held, and starts
                                   // no note
};

// Ways to begin, offered while the set is empty.
struct StartPage {
    std::vector<Vibration> cards;                  // read when first shown
    std::vector<std::filesystem::path> recent_of;  // the session's list when it was looked for ...
    std::vector<RecentFile> recent;                // ... and the files of it that exist
};

struct PatternPanes {
    StartPage start;
    SetPanelState list;
    StripState strip;
    EditorState editor;
    LayersBar layers;
    TappingState tapping;
    RecordingEditor recording;
};

// The editor of the selected patterns.

// Drawn below the strip in a wide and high pane; may be empty.
using DrawFoot = std::function<void()>;

// Returns what was pressed on the card of the closest neighbour.
std::optional<NeighbourAction> draw_editor_panel(Ui& ui, Workspace& work,
                                                 PatternPanes& pattern_panes, Timeline& timeline,
                                                 const ShownMap& shown_map,
                                                 const DrawFoot& draw_foot);

// The actuator maps with which effects of other programs were read: a line above the list of
// patterns after opening some, and a dialog to read them with other maps.
//
// Left out  maps from files, which the command line's --actuator takes.

void draw_effect_maps_line(Ui& ui, Workspace& work);
inline constexpr Dialog kEffectMapsDialog{.title = "Actuator maps", .is_of_document = true};
void draw_effect_maps_dialog(Ui& ui, Workspace& work);

// The menu of a pattern, on its row, its point and its line in the table.

// Choices that the frame carries out, because they need more than this room knows.
enum class PatternAction { none, play, rename, similar, vary, steps, transform };

// Call inside an open popup. Selects the pattern, unless it is among the selected ones: choices
// apply to all of them, and are carried out after the frame's lists are drawn. `play_key` plays it,
// too.
PatternAction draw_pattern_menu(Ui& ui, Workspace& work, std::size_t index,
                                const char* play_key = "");

// The same, opened by a right click on the last item, a row of a list; it stands beside the row,
// whose name stays visible.
PatternAction draw_row_menu(Ui& ui, Workspace& work, std::size_t index, const char* play_key = "");

// A list of rhythms: a choice of length, notes and their lengths, one row each, and the envelope of
// the row under the mouse.

struct RhythmListAction {
    std::optional<std::string> pressed;
    std::optional<std::string> hovered;
    bool all = false;  // the link for all of them was pressed
};

// Call inside an open popup, which Esc closes. `chosen` tells which rows are highlighted. The
// envelope is that of `pattern` with the rhythm. `all`: label of a link for all of them; empty: no
// link.
RhythmListAction draw_rhythm_list(Ui& ui, RhythmChoice& choice, const Pattern& pattern,
                                  const std::function<bool(const std::string&)>& chosen,
                                  const std::string& all = {});

// Steps of a rhythm as a row of cells in an area; a held step is joined to the one before it.
void draw_rhythm_cells(const Theme& theme, const Rect& area, const std::string& text);

// "3 notes on 8 steps, evenness 0.97".
std::string rhythm_summary(const std::string& text);

// The list of patterns: search, order, names, locks.

PatternAction draw_set_panel(Ui& ui, Workspace& work, PatternPanes& pattern_panes);

// Its search field takes the keyboard in the next frame.
void begin_rename(const Workspace& work, PatternPanes& pattern_panes, std::size_t index);

// Shown in place of map, answers and editor while the set is empty: a few examples, and other ways
// to begin.

// Returns what was pressed, for the frame; an example is added here.
struct StartAction {
    enum class Way { open, generate, recent } way;
    std::filesystem::path file{};  // path of a recent file
};

std::optional<StartAction> draw_start_page(Ui& ui, Workspace& work, StartPage& page);

// The dialog for tapping a rhythm with a key or the mouse.

void open_tapping(Ui& ui, TappingState& tapping);

// Enter gives the rhythm to all selected patterns, and lengthens patterns that are too short for
// it; Esc changes nothing.
inline constexpr Dialog kTappingDialog{.title = "Tap a rhythm", .is_of_document = true};
void draw_tapping_dialog(Ui& ui, Workspace& work, TappingState& tapping);

}  // namespace tact
