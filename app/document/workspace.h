// The open document, its selection and its history, and what is known of its patterns.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "app/jobs/jobs.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "model/set/felt_versions.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/marks.h"

namespace tact {

// What was done to the document, for rooms that hold patterns by their names or files beside its
// own. The frame hands it on once what was asked for in it is done.

struct Renaming {
    std::string before, after;
};

// Where the document was before it was saved, and what it was called.
struct SavedFrom {
    std::filesystem::path file;  // empty: it had none
    std::string set_name;
};

struct DocumentChanges {
    std::vector<Renaming> renamings;  // in their order
    std::optional<SavedFrom> saved_from;
};

inline void follow(const Renaming& renaming, std::string& name) {
    if (name == renaming.before) name = renaming.after;
}

// Undo and redo as whole values: one gesture, one step.
//
// Whole values instead of commands: nothing has to know how to revert itself, and a value shares
// what is big (recorded waveforms) with its neighbours.
//
// Input     the value before and after a gesture, and what the gesture did ("Change amplitude")
// Output    the value to go back or forward to
// Left out  knowing what is one gesture: the caller commits when it ends, or has it join the last.

inline constexpr std::size_t kHistorySteps = 200;

template <class Value>
class History {
  public:
    using State = std::shared_ptr<const Value>;

    explicit History(std::size_t limit = kHistorySteps) : limit_(limit) {}

    // Makes a step, forgets what could be redone and, at the limit, the oldest step. Equal values
    // are no step: false. Hand on the last `after` as the next `before`: then both steps share it.
    bool commit(State before, State after, std::string label) {
        assert(before && after && "a step lies between two values");
        if (before == after || *before == *after) return false;
        steps_.resize(done_);
        steps_.push_back({std::move(before), std::move(after), std::move(label)});
        if (steps_.size() > limit_) steps_.pop_front();
        done_ = steps_.size();
        return true;
    }

    // Moves the end of the last step, where one can be undone and ends at `before`; one that comes
    // back to where it began is dropped. Otherwise adds a step.
    bool join(State before, State after, std::string label) {
        if (done_ == 0 || steps_[done_ - 1].after != before) {
            return commit(std::move(before), std::move(after), std::move(label));
        }
        if (*before == *after) return false;
        steps_.resize(done_);
        steps_.back().after = std::move(after);
        if (*steps_.back().before == *steps_.back().after) steps_.pop_back();
        done_ = steps_.size();
        return true;
    }

    // The value to show from now on; null: there is no such step.
    State undo() { return done_ == 0 ? nullptr : steps_[--done_].before; }
    State redo() { return done_ == steps_.size() ? nullptr : steps_[done_++].after; }

    // What undo() or redo() would take back or do again; null: nothing.
    const std::string* undo_label() const {
        return done_ == 0 ? nullptr : &steps_[done_ - 1].label;
    }
    const std::string* redo_label() const {
        return done_ == steps_.size() ? nullptr : &steps_[done_].label;
    }

    // All steps from the oldest one on, those that could be redone behind those that are done.
    std::size_t size() const { return steps_.size(); }
    std::size_t done() const { return done_; }
    const std::string& label(std::size_t step) const { return steps_[step].label; }

    // Puts `of(state)` in the place of every value: what happened to all of them alike is no step.
    template <class Of>
    void amend(Of of) {
        for (Step& step : steps_) {
            step.before = of(step.before);
            step.after = of(step.after);
        }
    }

    void clear() {
        steps_.clear();
        done_ = 0;
    }

  private:
    struct Step {
        State before;
        State after;
        std::string label;
    };

    std::size_t limit_;
    std::size_t done_ = 0;  // steps before this one can be undone, from it on redone
    std::deque<Step> steps_;
};

// "Undo" and "Change amplitude of L-4-full" make "Undo change amplitude of L-4-full".
inline std::string menu_text(std::string verb, const std::string* label) {
    if (label == nullptr || label->empty()) return verb;
    std::string what = *label;
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const bool is_acronym = what.size() > 1 && is_capital(what[1]);
    if (is_capital(what[0]) && !is_acronym) what[0] = static_cast<char>(what[0] - 'A' + 'a');
    return std::move(verb) + " " + what;
}

// The open document with its undo steps, which own it: whatever writes the set is a step of undo.
//
// A gesture writes what edit() gives; commit() makes a step of it, and what was never committed
// becomes one as soon as anybody undoes or saves. A save is no step: it gives every state the name
// and the files of recordings that it gave, so that undo back to a save is back to the file.
//
// Places    where a set's map lay is known once its exact map was shown. Each state keeps its own,
//           so that undo turns the map back; one that a file holds is written as it stands there.
// Left out  what is one gesture, and what is said of it (editing.h).

class EditedDocument {
  public:
    using State = std::shared_ptr<const PatternSet>;

    // Views of the present state, to read.
    const PatternSet& set = now_.set;
    const std::filesystem::path& path = now_.path;
    const PatternSet& saved = now_.saved;
    const std::optional<std::uint64_t>& file_mark = now_.file_mark;
    const History<PatternSet>& history = history_;
    const State& committed = committed_;  // the set as of the last undo step

    EditedDocument();
    // The references are each object's own.
    EditedDocument(const EditedDocument& other);
    EditedDocument(EditedDocument&& other) noexcept;
    EditedDocument& operator=(const EditedDocument& other);
    EditedDocument& operator=(EditedDocument&& other) noexcept;
    ~EditedDocument() = default;

    // Another document takes the place of this one; nothing of this one can be undone.
    void open(Document document);

    // The set, to be changed by the gesture under way.
    PatternSet& edit() { return now_.set; }

    // What was changed since the last step becomes one, or with `joins` part of the last one where
    // that is there still. False: nothing was.
    bool commit(const std::string& label, bool joins = false);

    // False: there is no such step.
    bool undo();
    bool redo();

    // The document as a file should store it: with the places of its map where they are known.
    Document kept() const;

    // The set was written to the file as `stored`, which may have a name and other files of
    // recordings than the set had.
    void was_saved(const std::filesystem::path& file, const PatternSet& stored,
                   std::optional<std::uint64_t> mark);

    // The places of the current set's map; null: they are not known, or a gesture is under way.
    const MapPlaces* places() const;
    void note_places(MapPlaces places);

  private:
    struct Lying {
        MapPlaces shown;
        bool is_in_file = false;  // the state's own places are what its file has, or has not
    };

    bool show(const State& state);
    void end_gesture();
    bool is_committed() const { return now_.set == *committed_; }
    void amend(const PatternSet& before, const PatternSet& stored);
    void forget_places();

    Document now_;
    History<PatternSet> history_;
    State committed_;
    std::map<State, Lying> lying_;
};

// The part of the document that the person is looking at.

// A number of the pattern in the editor whose slider the mouse rests on: what the pattern would be
// over the slider's range, and the number there in words.
struct RestedNumber {
    std::string name;   // of the pattern
    std::string field;  // its id
    std::vector<Pattern> patterns;
    std::vector<std::string> words;

    bool operator==(const RestedNumber&) const = default;
};

// A change of a pattern that is pointed at, such as one that would separate two.
struct SuggestedChange {
    std::string name;  // of the pattern
    Pattern changed;
    std::string words;

    bool operator==(const SuggestedChange&) const = default;
};

// The part of the document that the person is looking at. Indices into document.set.vibrations.
struct Selection {
    std::string pinned;       // name of the pattern shown for comparison; empty: none
    std::string partner;      // name of the pattern that makes a pair with the current one
    std::size_t current = 0;  // shown in the editor and the middle column
    std::size_t layer = 0;    // that is open in the editor, of the pattern of the name below
    std::string layer_of;
    std::set<std::size_t> others;             // edited together with it
    std::optional<std::size_t> hovered;       // in this frame, by any panel drawn so far
    std::string search;                       // what the list is narrowed to
    bool scroll_to_current = false;           // in the list, in the next frame
    std::set<std::string> too_close{};        // names in pairs that are marked as too close
    std::set<std::string> picked{};           // names of the subset that is picked
    bool is_pick_preview = false;             // by a preview of the map, or an earlier one
    bool only_picked = false;                 // the list is narrowed to them, where there are any
    std::vector<std::size_t> table_order{};   // as a table shows them; empty: no table
    std::set<std::string> unfelt{};           // names of those that no receptor answers to
    std::optional<std::size_t> hovered_last;  // in the last frame, by any panel
    // Two at once, as a cell of the matrix has them: in this frame, and in the last.
    std::optional<std::pair<std::size_t, std::size_t>> hovered_pair{};
    std::optional<std::pair<std::size_t, std::size_t>> hovered_pair_last{};
    // In this frame, by any panel; a candidate is in no document yet.
    std::optional<Vibration> pressed{};
    std::optional<RestedNumber> rested{};        // in this frame
    std::optional<SuggestedChange> suggested{};  // in this frame
    bool on_track = false;                       // in this frame the mouse is on the rested one's
};

inline bool is_narrowed_to_picked(const Selection& selection) {
    return selection.only_picked && !selection.picked.empty();
}

// What panels draw of a vibration every frame, computed once per value.
//
// Left out  anything of the perceptual model: that comes from the jobs.

struct CachedVibration {
    VibrationSource source;
    Waveform waveform;  // of a pattern, or of layers
    double peak_g = 0.0;
};

// Long patterns that a frame wanted, rendered in the background.
using WantedWaveforms = std::vector<Vibration>;
using RenderedWaveforms = std::vector<std::pair<Vibration, Waveform>>;

// By name; an entry is replaced when the vibration of that name has changed.
struct VibrationCache {
    std::unordered_map<std::string, CachedVibration> entries;

    // Small pictures may be behind by some frames, so that no frame renders all patterns of a set.
    std::size_t samples_left = std::numeric_limits<std::size_t>::max();  // to render in this frame
    bool behind = false;                                                 // some of them are
    bool put_off = false;  // all of them, in this frame: it has others to draw

    bool has_job = false;  // for long ones, which are otherwise, as for a picture, rendered at once
    Query<WantedWaveforms, RenderedWaveforms> render_job;
    WantedWaveforms wanted, asked;
    std::shared_ptr<const RenderedWaveforms> taken;

    // The strongest peak of the set: all waveforms are drawn on this one scale, in g.
    double reach_g = 1.0;
    double axis_s = 0.0;         // the end of the time axis that pictures of the set share
    std::uint64_t reach_of = 0;  // the revision it was found at, all its patterns rendered
};

const Waveform& cached_waveform(VibrationCache& cache, const Vibration& vibration);

// Above this many samples a pattern is rendered in the background.
inline constexpr std::size_t kMostSamplesAtOnce = 30'000;

// At the beginning of a frame: what was rendered since, and what the last frame still wanted. An
// empty `wake`: the cache has no job.
void follow_render_job(VibrationCache& cache, const std::function<void()>& wake);

// The same while there are samples left to render; then what it was before, or null.
const Waveform* waveform_in_time(VibrationCache& cache, const Vibration& vibration);

// The peak of what waveform_in_time() gives; 0 for null.
double peak_in_time(const VibrationCache& cache, const Vibration& vibration);

// Updates the scales of the set when its revision changes or a peak becomes known. Until a pattern
// is rendered, its numbers give the peak.
void follow_reach(VibrationCache& cache, const PatternSet& set, std::uint64_t revision);

// What a person works on: the document, its undo steps, what of it is looked at, and what is
// unsaved.

// Files of other programs' effects that the document was made of.
struct EffectFiles {
    std::vector<std::filesystem::path> paths;
    std::vector<std::vector<Vibration>> read;  // each vibration of theirs, as each map has read it
};

struct DocumentEffects {
    std::vector<EffectFiles> files;
    bool is_told = false;  // by which maps they were read, above the list of patterns
};

struct Workspace {
    EditedDocument document;            // with its undo steps
    std::uint64_t revision = 1;         // of document.set, every change during a drag too
    std::uint64_t document_number = 1;  // tells the open one from all others; part of each request
    std::uint64_t documents = 1;        // that were numbered so far
    DocumentChanges changes;
    DocumentEffects effects;
    Selection selection;
    Side side = Side::both;  // of the set: in the map, the matrix and what follows them
    VibrationCache cache;
    StalePatterns stale;             // what of the set is not as it was felt or measured ...
    EditedDocument::State stale_of;  // ... as of this step
    bool own_heights = false;        // waveforms fill their rows, instead of one scale of g for all
    Session session;
    std::vector<Vibration> clipboard;    // what was copied here last ...
    std::string clipboard_text;          // ... and as the desktop has it: a set file
    bool unsaved = false;                // the document differs from its file ...
    std::uint64_t unsaved_revision = 0;  // ... as of this revision
    bool autosave_pending = false;
    double autosave_due_s = 0.0;
    double unkept_since_s = 0.0;              // the first change that is pending
    std::future<std::string> autosave_write;  // under way; its value is the error
    std::string autosave_error;               // why unsaved changes are in memory alone
};

// Which side of a set with measured twins is shown: maps, matrices and what follows are of that
// part.

// Changing it makes the maps again.
Side shown_side(const Workspace& work);
void show_side(Workspace& work, Side side);

// The part of the document that maps are made of.
PatternSet shown_set(const Workspace& work);

// "1 pattern", "12 patterns".
std::string patterns_text(std::size_t count);

// "24 patterns", "12 measured of 24".
std::string shown_patterns_text(const Workspace& work);

// How a pattern looks wherever it is shown: mark, colour, and a small picture of its waveform.

// Mark and colour of the pattern at a position: its own (default: by position).
PatternLook look_of(const Theme& theme, const PatternSet& set, std::size_t index);
PatternLook look_of(const Ui& ui, const Workspace& work, std::size_t index);

// Patterns without a colour get the look that is least used, in the order of the palette. Whoever
// has one keeps it.
void give_looks(PatternSet& set);

// One step: colour, "#RRGGBB", and mark of all that is selected.
void change_look(Ui& ui, Workspace& work, const std::string& colour, bool ring);

// What a waveform is drawn up to where all of the set have one scale, g; 0: up to its own peak.
double shown_reach_g(const Workspace& work);

// "22 ms", "1.5 s".
std::string length_text(double length_s);

// The waveform of a vibration without axes, over so much time; 0: over its own length.
void draw_thumbnail(const Ui& ui, Workspace& work, const Rect& area, const Vibration& vibration,
                    ImU32 colour, double reach_g, double axis_s = 0.0);

// What lies under a row of the set: selected, one of several, or pointed at.
void draw_row_ground(const Ui& ui, const Workspace& work, std::size_t index, const Rect& row);

// Signs of what holds for a pattern besides its numbers, locked or dropped, up to `right`; how wide
// they are, with the gap before them.
float state_signs_px(const Theme& theme, const Vibration& vibration);
void draw_state_signs(Ui& ui, const Vibration& vibration, ImVec2 right);

// All words of a set that are drawn: what fonts need glyphs for.
std::string drawn_text(const PatternSet& set);

}  // namespace tact
