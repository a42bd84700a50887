// A lesson: a set, and steps through what the model makes of its patterns, with what is said,
// asked and pointed at.
//
// Numbers of the model stand in a text as what they are to be, in braces: "{nc | A | B}"
// (lesson_numbers.h). Nobody types them, so that they follow the model.
//
// Left out  where it is stored (model/io/lesson), what is shown and how (app/lesson).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/common/range.h"
#include "model/set/pattern_set.h"

namespace tact {

// What of the program a step shows: all stages small, one of them large, or the map.
inline constexpr std::array<const char*, 11> kLessonViews{
    "all",      "vibration", "spectrum", "filtered", "receptors", "spikes",
    "networks", "central",   "brain",    "envelope", "map"};

enum class QuestionKind {
    choice,     // the lesson's own options
    receptors,  // which types fire on the step's pattern
    closest,    // which of the pairs PM puts nearest together
    farthest,   // or farthest apart
    place       // where in the map the step's pattern lies, which is hidden there until then
};

inline constexpr std::array<const char*, 5> kQuestionKinds{"choice", "receptors", "closest",
                                                           "farthest", "place"};

struct PatternPair {
    std::string a;
    std::string b;

    bool operator==(const PatternPair&) const = default;
};

struct LessonQuestion {
    QuestionKind kind = QuestionKind::choice;
    std::string ask;
    std::vector<std::string> options;  // of a choice
    std::size_t answer = 0;            // of a choice: the right one
    std::vector<PatternPair> pairs;    // of closest and farthest
    std::string reveal;                // said with the answer

    bool operator==(const LessonQuestion&) const = default;
};

struct LessonCamera {
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    double zoom = 1.0;

    bool operator==(const LessonCamera&) const = default;
};

// A step's texts in a further language; an empty one is the first language's.
struct StepWords {
    std::string title;
    std::string text;
    std::string note;
    std::string ask;
    std::vector<std::string> options;  // may be fewer than the question has
    std::string reveal;

    bool operator==(const StepWords&) const = default;
};

// The same of the lesson as a whole.
struct LessonWords {
    std::string name;
    std::string about;

    bool operator==(const LessonWords&) const = default;
};

struct LessonStep {
    std::string title;
    std::string text;
    std::string note;    // for who speaks
    std::string source;  // of what the text says of the body
    std::string pattern;
    std::string partner;  // compared with it; empty: none
    std::string view = "all";
    std::string point_at;  // a widget by its name, outlined: "grid FA2"
    double at_s = 0.0;     // of the playhead
    double speed = 0.0;    // of it; 0: it stands still
    double from_s = 0.0;   // of all time axes ...
    double to_s = 0.0;     // ... up to there; both 0: the whole pattern
    std::optional<LessonCamera> camera{};
    std::optional<LessonQuestion> question{};
    std::vector<StepWords> words{};  // in the lesson's further languages, in their order
    std::string unknown_json{};      // keys of the step, its camera and its question, kept on save

    bool operator==(const LessonStep&) const = default;
};

namespace limits {
inline constexpr Range kLessonSpeed{0.0, 1.0};
inline constexpr Range kLessonTimeS{0.0, 60.0};
inline constexpr Range kLessonAngleRad{-10.0, 10.0};
inline constexpr Range kLessonZoom{0.1, 40.0};
inline constexpr std::size_t kMaxSteps = 200;
inline constexpr std::size_t kMaxOptions = 9;   // a number key each
inline constexpr std::size_t kLeastPlaced = 4;  // patterns of a set in whose map one is placed
inline constexpr std::size_t kMaxLanguages = 20;
}  // namespace limits

struct Lesson {
    std::string name;
    std::string about;     // for whom, how long
    std::string set_name;  // of a set that comes with the program; empty: the lesson's own
    PatternSet set;
    std::vector<LessonStep> steps;
    // Of its texts, as "en" or "pt-BR" (lesson_languages.h): the first is that of the texts above;
    // none: which it is is not told.
    std::vector<std::string> languages;
    std::vector<LessonWords> words;  // in the further ones, in their order
    std::string unknown_json;  // keys of the file that this version does not know, kept on save

    bool operator==(const Lesson&) const = default;
};

// What a step's question still needs before it can be answered, in words that follow "expected";
// empty: nothing, or the step asks nothing.
std::string question_needs(const LessonStep& step, std::size_t patterns);

// The step's source without what its author has not looked up and says so: "Helmholtz 1863 (not
// looked up); sin a + sin b" gives "sin a + sin b". Such a remark is for authors.
std::string source_for_class(const LessonStep& step);

// Every text of a step in which numbers may stand, in order; those of the further languages behind.
std::vector<std::string> texts_of(const LessonStep& step);

}  // namespace tact
