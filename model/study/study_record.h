// What one participant of a study did, from the consent to the last answer.
//
// Left out  names of persons: participants go by codes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/study/adaptive_order.h"
#include "model/study/cluster_sorting.h"
#include "model/study/pairwise_study.h"
#include "model/study/study_design.h"

namespace tact {

enum class StudyKind { pairwise, sorting };

struct Participant {
    std::string code;                                         // "P1": also the name of the file
    std::vector<std::pair<std::string, std::string>> fields;  // "age" "27"; empty ones are left out

    bool operator==(const Participant&) const = default;
};

// The name in place of a device's if there is no device.
inline constexpr const char* kNoDevice = "no device";

// How the patterns reached the skin.
struct StudyDevice {
    std::string name;
    std::string calibration;  // its name, or "uncalibrated"
    std::string masking;      // noise against hearing it, or why it was off; empty: not asked
    double buffer_ms = 0.0;   // of a sound output, ahead of what is heard; 0: none, or not known

    bool operator==(const StudyDevice&) const = default;
};

// Nothing is felt without a device.
bool is_rehearsal(const StudyDevice& device);

// Another device from some answer on, or the same at another level, scale or calibration.
struct DeviceChange {
    std::size_t before = 0;  // answers given until then
    StudyDevice device;
    std::string at;  // UTC

    bool operator==(const DeviceChange&) const = default;
};

struct StudyHeader {
    std::string program;  // "tactspace 1.2"
    StudyKind kind = StudyKind::pairwise;
    bool synthetic = false;  // no person was asked
    std::string set_name;
    std::string set_fingerprint;
    std::vector<std::string> patterns;  // names of those that took part, in the order of the set
    StudyDesign design;
    std::uint64_t seed = 1;  // of this participant's trials
    StudyDevice device;
    Participant participant;
    bool consented = false;
    std::string begun;  // UTC, ISO 8601
    // Version of each pattern (model/set/felt_versions.h); empty in older files.
    std::vector<std::string> versions{};

    bool operator==(const StudyHeader&) const = default;
};

// One play, as the device told of it afterwards.
struct Play {
    bool is_to_the_end = false;
    int dropouts = 0;             // gaps in what went out
    double turned_down_db = 0.0;  // as a whole, being too strong for full scale; 0: not
};

// What else is known of the plays of one side of a trial.
struct PlaysReport {
    int broken = 0;               // plays that were not whole, besides those that count
    int dropouts = 0;             // gaps in them
    double turned_down_db = 0.0;  // the most of all plays

    bool operator==(const PlaysReport&) const = default;
};

// Which side of a trial was felt whole before the other; files of before do not say.
enum class FeltFirst { unknown, left, right };

struct PairAnswer {
    Trial trial;
    double similarity = 0.0;  // 0 totally different .. 100 the same
    int plays_left = 0;
    int plays_right = 0;
    double response_s = 0.0;  // from when the trial was shown
    std::string at;           // UTC
    PlaysReport left{};
    PlaysReport right{};
    FeltFirst first = FeltFirst::unknown;
    int broken_in_training = 0;  // plays of the training before it that were not whole

    bool operator==(const PairAnswer&) const = default;
};

// Whether it was felt as it was meant: to the end and without gaps. Weaker is as meant.
bool is_whole(const Play& play);

// A play into the answer that is being given: one that is not whole does not count as a play.
void note_play(PairAnswer& answer, bool is_left, const Play& play);

// Plays beyond the first of each side.
int replays_of(const PairAnswer& answer);

struct SortingAnswer {
    int asked_groups = 0;  // 0: free
    Sorting groups;
    double response_s = 0.0;
    std::string at;
    std::vector<int> plays{};  // whole ones in this round, of each pattern; files of before: none
    PlaysReport report{};      // of all patterns

    bool operator==(const SortingAnswer&) const = default;
};

// A play into the sorting that is being made, in which a button is a pattern.
void note_play(SortingAnswer& answer, std::size_t pattern, const Play& play);

struct StudyRecord {
    StudyHeader header;
    std::vector<PairAnswer> answers;      // of a pairwise study
    std::vector<SortingAnswer> sortings;  // of a sorting study
    bool is_torn = false;                 // the last line was cut off, and left out
    std::vector<DeviceChange> devices{};  // after the header's, in their order
    // Why whoever runs the study leaves the participant out; empty: they do not. It is kept beside
    // the participants' files (model/io/people/exclusions_file.h), which nobody changes.
    std::string excluded{};

    bool operator==(const StudyRecord&) const = default;
};

// The words shown before a study of a kind: the design's own or the standard ones.
std::string instructions_of(const StudyDesign& design, StudyKind kind);

// What `now` is asked otherwise than `first` was, as phrases: "repetitions 2, not 4". Whoever is
// asked otherwise takes part in another study. Left out: what nobody is asked by (the seed of the
// orders, the rule on who counts, the output of the noise). Fingerprints count where both are
// known.
std::vector<std::string> changes_since(const StudyHeader& first, const StudyHeader& now);

// The phrases in one: "repetitions 2, not 4; gap 0 s, not 1 s".
std::string words_on_changes(const std::vector<std::string>& changes);

// Who fixed the design of a study: the person who began first; of no people whoever was simulated,
// of none of those whoever rehearsed. Null of no records.
const StudyRecord* founder_of(std::span<const StudyRecord> records);

// Plays that were cut short or had gaps, training included: nobody was to blame for them but the
// sound.
int cut_short_plays(const StudyRecord& record);

// How many answers make the record complete.
std::size_t answers_wanted(const StudyRecord& record);
std::size_t answers_given(const StudyRecord& record);

// How many groups the next round of an incomplete sorting asks for; 0: as many as the person likes.
int next_round_groups(const StudyRecord& record);

// Answers as the adaptive order and its indicator take them.
std::vector<RatedTrial> rated_trials(const StudyRecord& record);

// The device of the k-th answer; of the next one where there are fewer.
const StudyDevice& device_of(const StudyRecord& record, std::size_t k);

// Whether an answer can count: given with a device and, of pairs, with both sides felt whole.
enum class Felt {
    whole,
    nothing,  // there was no device
    in_part   // a side, or a pattern that was sorted, was never played whole
};
Felt felt_of(const StudyRecord& record, std::size_t k);

}  // namespace tact
