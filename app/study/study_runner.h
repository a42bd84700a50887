// One participant's way through a study: state and event in, state and what is to be done out.
//
// Source    Lim & Park 2023, section 6.1: training with every pattern at least once, then pairs;
// the
//           slider opens after both were felt; replays without limit; a gap between vibrations.
// Input     what the person did, and the time, s, which never runs backwards
// Output    at most one of each: a pattern to play, silence, a line for the participant's file. The
//           next trial comes only with the word that the line is on the disk. A play counts when
//           it has come to its end, whole. One that is asked for in the gap waits for its end,
//           which the device keeps.
// Left out  sound, files, drawing: app/study/study_follow.h, app/study/study_pages.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/study/study_record.h"

namespace tact {

enum class StudyPage { consent, instructions, training, trial, sorting, rest, finished };

struct StudyRun {
    StudyRecord record;              // what is on the disk
    std::vector<double> duration_s;  // of every pattern
    StudyPage page = StudyPage::consent;
    bool is_asking = false;   // whether to leave, over the page
    bool is_waiting = false;  // for the disk
    std::string trouble;      // why it did not take the last line

    std::vector<std::size_t> training;  // patterns by button
    std::vector<int> felt;              // how often, by button

    std::vector<Trial> trials;         // of the full design
    Trial trial;                       // on the screen
    PairAnswer given;                  // to it so far: how its sides were felt
    bool feels_again = false;          // the last play was not whole, and does not count
    int cut_short = 0;                 // plays in a row that were not whole
    int cut_short_in_all = 0;          // of this sitting
    int broken_in_training = 0;        // of these
    std::optional<double> similarity;  // where the slider was put

    int asked_groups = 0;           // of the round of sorting on the screen; 0: free
    Sorting groups;                 // so far
    SortingAnswer felt_in_round;    // how the round's patterns were felt
    std::vector<int> felt_sorting;  // whole plays of each pattern in this sitting

    std::optional<std::size_t> playing;  // position of the pattern
    std::size_t playing_button = 0;
    double playing_until_s = 0.0;
    double quiet_until_s = 0.0;      // the gap
    double rest_s = 0.0;             // how long that is
    bool was_silenced = false;       // nothing keeps the gap but the clock
    double shown_s = 0.0;            // since when the trial is on the screen, pauses taken off
    double asked_s = 0.0;            // since when is_asking
    std::size_t answers_before = 0;  // of an earlier sitting
};

// What the person, the clock or the disk did.
struct StudyEvent {
    enum class What {
        tick,   // time passed
        go_on,  // to the next page; with a trial: the answer is given
        play,   // the pattern behind button `index`: 0 left, 1 right; of the training; of sorting
        rate,   // the slider is at `value`
        put,    // pattern `index` into group `value`; kUnsorted: back
        plays_on,   // what plays takes `value` seconds more
        cut_short,  // it stopped before its end
        ask,        // whether to leave
        stay,       // rather not
        leave,      // the answers so far are kept
        saved,      // the line is on the disk
        not_saved   // it is not; `text` says why
    };
    What what = What::tick;
    std::size_t index = 0;
    double value = 0.0;
    std::string text{};
    std::string at{};                    // the time of day, UTC, for what is written
    Play played{.is_to_the_end = true};  // what plays, if it has come to its end by now
};

struct StudyActions {
    std::optional<std::size_t> play;  // position of a pattern ...
    double rest_s = 0.0;              // ... so long after the end of the last one, at the soonest
    bool silence = false;
    bool begin_file = false;          // with the header
    std::optional<std::string> line;  // into the file
    bool left = false;                // the run is over
};

struct StudyStep {
    StudyRun run;
    StudyActions actions;
};

// The run of a record: of one without a file yet (`header.begun` empty) from the consent, of
// another from where it was left.
StudyRun study_run(StudyRecord record, std::vector<double> duration_s);

StudyStep stepped(StudyRun run, const StudyEvent& event, double now_s);

// Whether a button answers now: nothing plays, nor waits for the end of the gap.
bool may_play(const StudyRun& run, double now_s);
// Both were felt to the end: the slider is open.
bool may_rate(const StudyRun& run, double now_s);
// What Enter does now would be done.
bool may_go_on(const StudyRun& run, double now_s);
// When something changes by itself, such as a gap that ends; infinite: nothing does.
double next_change_s(const StudyRun& run, double now_s);

// This many plays in a row that were cut short are not for the participant to mend.
inline constexpr int kCallAfter = 3;

// Patterns to sort that were not felt whole in this sitting.
std::size_t unfelt_count(const StudyRun& run);

// Groups of the round that have patterns, and what is still to be sorted.
std::size_t filled_groups(const StudyRun& run);
std::size_t unsorted_count(const StudyRun& run);

// Minutes to the end, by the pace of the latest trials, or by the expected pace.
double minutes_left(const StudyRun& run);

}  // namespace tact
