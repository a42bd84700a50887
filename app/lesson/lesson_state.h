// Which lesson is open, where it is, and what it turns to its own ends.
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

// What a lesson turns to its own ends, as it was.
struct ViewBeforeLesson {
    Layout layout;
    std::size_t current = 0;
    std::string pinned;
    Playhead playhead;
    TimeRange time_range;
    std::optional<Stage> open;
    SpaceCamera camera;
    float text_scale = 1.0F;
    int dimensions = 3;  // of the map
};

// The person's own document while a lesson shows its set in the place of it.
struct SetAside {
    EditedDocument document;
    DocumentEffects effects;
    Selection selection;
    Side side = Side::both;
    std::uint64_t number = 0;  // of the document
};

using MapPlace = std::array<double, 2>;  // in a flat map

// What a class said to a step's question.
struct Tally {
    std::array<int, limits::kMaxOptions> votes{};
    std::array<int, limits::kMaxOptions> elsewhere{};  // of these: not by hands, but by phones
    std::optional<MapPlace> place{};                   // where the pattern was put
    bool revealed = false;

    bool operator==(const Tally&) const = default;
};

// Which edge of the window the card stands at.
enum class DockSide { right, bottom, left, top };

// How wide a card at a side has become for all its words to be in sight.
struct CardGrowth {
    std::size_t step = 0;
    DockSide dock = DockSide::right;
    ImVec2 area{};  // of the window
    float font_px = 0.0F;
    float width_px = 0.0F;
};

struct LessonAsked {
    std::shared_ptr<const Lesson> lesson;
    bool with_pairs = false;  // which take longer: they come second
};

struct LessonAnswered {
    std::shared_ptr<const Lesson> of;
    bool with_pairs = false;
    LessonAnswers answers;
};

inline constexpr float kPresentScale = 1.25F;  // of text, on a screen of 1280 x 720

struct LessonState {
    std::shared_ptr<const Lesson> lesson;  // open; kept when it is left
    std::shared_ptr<const Lesson> shown;   // the same in one language
    std::string language;                  // wanted, by its code; empty: the lesson's first
    std::filesystem::path path;            // of its file; empty: it has none
    std::string key;                       // its file's or asset's path; empty: it is in neither
    bool is_tour = false;
    bool is_of_set = false;  // it is made of the open set to be presented, and holds none itself
    std::optional<std::size_t> step;  // under way
    // Where lessons were left before their end, by their keys: never at their first step.
    std::map<std::string, std::size_t> left_at;
    ViewBeforeLesson before;
    std::optional<SetAside> aside;
    std::uint64_t document_number = 0;  // of the set on screen, while it is open
    std::vector<Tally> tallies;         // of each step
    Query<LessonAsked, LessonAnswered> job;
    std::shared_ptr<const LessonAnswered> answered;

    // What was written of it, and is kept (lesson_keeping.h).
    bool is_written = false;                  // it was edited, or is
    std::shared_ptr<const Lesson> saved;      // as it was begun, read or written last
    std::shared_ptr<const Lesson> unsaved;    // as it would be saved; null: nothing is unsaved ...
    std::shared_ptr<const Lesson> looked_at;  // ... as of this lesson
    std::uint64_t looked_revision = 0;        // ... and the document's revision
    bool keep_pending = false;
    double keep_due_s = 0.0;
    double unkept_since_s = 0.0;         // the first change that is pending
    std::future<std::string> keeping{};  // an autosave under way: why it could not be written
    std::string told_unkept;             // why it is in memory alone
    std::filesystem::path kept_in;       // the file that what was unsaved last went to

    bool presenting = false;
    bool blank = false;
    bool editing = false;
    History<Lesson> history{};    // of what was written
    std::uint64_t edited_at = 0;  // the document's revision then
    TextBox box;                  // that is written in
    bool shows_source = false;
    std::u32string lacking;  // characters of the step's texts that no font here has
    DockSide dock = DockSide::right;
    float card_share = 0.24F;  // of the window's width; of its height while it is written
    float low_card_px = 0.0F;  // what its words need along the top or the foot; 0: not known yet
    CardGrowth grown;
    float present_scale = kPresentScale;      // of text while presenting
    bool hands_on = false;                    // what is asked for is to be handed on
    std::filesystem::path sheet_to;           // a student sheet is wanted there ...
    std::vector<std::string> sheet_pictures;  // ... and these of its steps are drawn
    std::string told;                         // to who speaks, last
    double presenting_since_s = 0.0;          // by the program's clock
    std::optional<bool> notes_wanted;  // in a second window; none: where there is a second screen
    bool shows_notes = false;          // there, now
};

}  // namespace tact
