// The open lesson, its current step, and the view it has replaced.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/latest_job.h"
#include "app/physiology/stages.h"
#include "app/timeline/playhead.h"
#include "app/ui/layout.h"
#include "app/writing/text_box.h"
#include "model/lesson/lesson_numbers.h"
#include "viz/space/space_camera.h"

namespace tact {

// The parts of the view that a lesson changes, as they were before it.
struct ViewBeforeLesson {
    Layout layout;
    std::size_t current = 0;
    std::string pinned;
    Playhead playhead;
    TimeRange time_range;
    std::optional<Stage> open;
    SpaceCamera camera;
    float text_scale = 1.0F;
    int dimensions = 3;  // map dimensions
};

// The person's document while a lesson shows its set in place of it.
struct SetAside {
    EditedDocument document;
    DocumentEffects effects;
    Selection selection;
    Side side = Side::both;
    std::uint64_t number = 0;  // document number
};

using MapPlace = std::array<double, 2>;  // in a flat map

// The class's answers to a step's question.
struct Tally {
    std::array<int, limits::kMaxOptions> votes{};
    std::array<int, limits::kMaxOptions> elsewhere{};  // votes from phones, included in `votes`
    std::optional<MapPlace> place{};                   // the place chosen for the pattern
    bool revealed = false;

    bool operator==(const Tally&) const = default;
};

// The edge of the window at which the card stands.
enum class DockSide { right, bottom, left, top };

// The width of a card at the left or right edge, grown until all its words are visible.
struct CardGrowth {
    std::size_t step = 0;
    DockSide dock = DockSide::right;
    ImVec2 area{};  // window size
    float font_px = 0.0F;
    float width_px = 0.0F;
};

struct LessonAsked {
    std::shared_ptr<const Lesson> lesson;
    bool with_pairs = false;  // pairs take longer, so they come second

    bool operator==(const LessonAsked&) const = default;
};

struct LessonAnswered {
    std::shared_ptr<const Lesson> of;
    bool with_pairs = false;
    LessonAnswers answers;
};

inline constexpr float kPresentScale = 1.25F;  // text scale, on a screen of 1280 x 720

struct LessonState {
    std::shared_ptr<const Lesson> lesson;  // open; kept after it is left
    std::shared_ptr<const Lesson> shown;   // the same, in the shown language
    std::string language;                  // code of the wanted language; empty: the lesson's first
    std::filesystem::path path;            // its file; empty: no file
    std::string key;                       // path of its file or asset; empty: neither
    bool is_tour = false;
    bool is_of_set = false;  // made from the open set for presenting, without a set of its own
    std::optional<std::size_t> step;  // current step; nullopt: not running
    // The steps at which lessons were left before their end, by key; never a first step.
    std::map<std::string, std::size_t> left_at;
    ViewBeforeLesson before;
    std::optional<SetAside> aside;
    std::uint64_t document_number = 0;  // number of the shown set, while the lesson is open
    std::vector<Tally> tallies;         // one per step
    Query<LessonAsked, LessonAnswered> job;
    std::shared_ptr<const LessonAnswered> answered;

    // The edited lesson and its autosave (lesson_keeping.h).
    bool is_written = false;                  // it was or is edited
    std::shared_ptr<const Lesson> saved;      // last version begun, read or written
    std::shared_ptr<const Lesson> unsaved;    // version to be saved; null: nothing is unsaved ...
    std::shared_ptr<const Lesson> looked_at;  // ... for this lesson
    std::uint64_t looked_revision = 0;        // ... and this revision of the document
    bool keep_pending = false;
    double keep_due_s = 0.0;
    double unkept_since_s = 0.0;                // time of the first pending change
    std::future<std::string> autosave_write{};  // a running autosave; its value is the error
    std::string autosave_error;                 // error of the autosave
    std::filesystem::path kept_in;              // the last file with unsaved changes

    bool presenting = false;
    bool blank = false;
    bool editing = false;
    History<Lesson> history{};    // edits of the lesson
    std::uint64_t edited_at = 0;  // the document's revision at the last edit
    TextBox box;                  // the text field being edited
    bool shows_source = false;
    std::u32string lacking;  // characters of the step's texts that no installed font has
    DockSide dock = DockSide::right;
    float card_share = 0.24F;  // share of the window's width; of its height while editing
    float low_card_px = 0.0F;  // height of its words at the top or bottom; 0: not known yet
    CardGrowth grown;
    float present_scale = kPresentScale;      // text scale while presenting
    bool hands_on = false;                    // the next sheet is for a teacher
    std::filesystem::path sheet_to;           // path of a requested student sheet ...
    std::vector<std::string> sheet_pictures;  // ... and the pictures of its steps drawn so far
    std::string told;                         // last line for the speaker
    double presenting_since_s = 0.0;          // on the program's clock
    std::optional<bool> notes_wanted;  // a second window; nullopt: if there is a second screen
    bool shows_notes = false;          // the window is open
};

}  // namespace tact
