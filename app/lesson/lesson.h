// A running lesson: it drives the real program through its steps with a set of its own, and
// restores document and view at the end.
//
// Input     a lesson; or the tour, the first of the lessons that come with the program
// Left out  the card of a step (lesson_card.h), the whole screen (presenting.h)
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/document/renaming.h"
#include "app/lesson/lesson_state.h"
#include "app/map/map_state.h"
#include "app/physiology/physiology_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// Everything that a lesson drives.
struct LessonContext {
    Ui& ui;
    Workspace& work;
    Layout& layout;
    Timeline& timeline;
    ShownMap& shown_map;
    Physiology& physiology;
};

struct BundledLesson {
    const char* path;  // below assets/
    const char* name;  // the name inside the lesson
};

inline constexpr const char* kTourLesson = "lessons/tour.tactlesson.json";
inline constexpr std::array<BundledLesson, 8> kBundledLessons{{
    {"lessons/thresholds.tactlesson.json", "Thresholds by frequency"},
    {"lessons/pacinian_meissner.tactlesson.json", "Pacinian against Meissner"},
    {"lessons/twins.tactlesson.json", "Amplitude twins, and where they part"},
    {"lessons/beats.tactlesson.json", "Beats and amplitude modulation"},
    {"lessons/gaps.tactlesson.json", "Gaps, and the window of 10 ms"},
    {"lessons/why.tactlesson.json", "Why PM puts these two apart"},
    {"lessons/pipeline.tactlesson.json", "From two patterns to one distance"},
    {"lessons/mds.tactlesson.json", "How a perceptual space is made"},
}};

// A lesson that comes with the program.
std::shared_ptr<const Lesson> bundled_lesson(const char* path);

// The present view, to be restored when the lesson is left.
ViewBeforeLesson view_of(const LessonContext& context);

// Shows the lesson's set in place of the document, which is set aside, and goes to the first step.
void start_lesson(const LessonContext& context, LessonState& state,
                  std::shared_ptr<const Lesson> lesson, const std::filesystem::path& path);

// Starts a lesson that comes with the program, by its path below assets/.
void start_bundled_lesson(const LessonContext& context, LessonState& state, const char* path);

// Continues the tour at the step at which it was left, or starts it.
void start_tour(const LessonContext& context, LessonState& state);

// Asks whether to continue at the step at which this lesson was left before.
void ask_where_to_begin(const LessonContext& context, LessonState& state);

// The steps at which lessons were left, by key; the running lesson counts as left now.
std::map<std::string, std::size_t> places_left(const LessonState& state);

void open_lesson(const LessonContext& context, LessonState& state,
                 const std::filesystem::path& path);

void go_to_step(const LessonContext& context, LessonState& state, std::size_t step);

// Replaces the open lesson by this one, in the wanted language.
void show_lesson(LessonState& state, std::shared_ptr<const Lesson> lesson);

// The wanted language from now on, for every lesson that has it.
void choose_language(Ui& ui, LessonState& state, const std::string& code);

// Index of the shown language among the lesson's.
std::size_t shown_language(const LessonState& state);

// Restores the document and the view. Unsaved text of the lesson goes to a file of its own; if that
// cannot be written, the lesson stays open: false.
bool leave_lesson(const LessonContext& context, LessonState& state);

// Ends the lesson if another document was opened; unsaved changes of the document set aside go to a
// file of their own.
void follow_document(const LessonContext& context, LessonState& state);

// Steps name patterns, so they follow renaming.
void follow_renaming(LessonState& state, const Renaming& renaming);

// The lesson's numbers are computed in the background.
void follow_lesson(const Ui& ui, LessonState& state);
const LessonAnswers* answers_of(const LessonState& state);

// The current step, in the shown language; null if no lesson is running.
const LessonStep* step_of(const LessonState& state);

std::optional<Stage> stage_of_view(const std::string& view);
bool shows_map(const LessonStep& step);

}  // namespace tact
