// What the window knows of studies: the experimenter's view, who took part, and who is at it now.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/study/study_runner.h"
#include "devices/device/device.h"
#include "devices/device/memory_device.h"
#include "model/evaluation/individual_weights.h"
#include "model/io/people/study_file.h"
#include "model/map/mds.h"
#include "model/set/pattern_set.h"
#include "model/study/agreement.h"
#include "model/study/study_results.h"

namespace tact {

// What is to be made of the participants' files; asked for by number, as the disk has no revision.
struct StudyQuestion {
    std::uint64_t number = 0;
    std::filesystem::path folder;
    StudyKind kind = StudyKind::pairwise;
    CollectRule rule;
    // Its fingerprint is made where the answers are read: of a large set it takes longer than a
    // frame may. As of the last undo step.
    std::shared_ptr<const PatternSet> set;

    bool operator==(const StudyQuestion&) const = default;
};

// Everything the experimenter's view shows of them.
struct StudyAnswers {
    StudyQuestion question;
    std::vector<StudyRecord> records;  // of the kind asked for
    std::vector<StudyRecord> others;   // of the other kind
    std::optional<StudyResults> results;
    std::string fault;  // why there are no results
    bool is_of_other_patterns = false;
    std::optional<StudyHeader> founder;   // whose design is that of the study
    std::vector<Dissimilarity> matrices;  // of every record
    PerceptualSpace mean_map;             // three dimensions
    std::vector<PerceptualSpace> maps;    // of every record
    std::optional<MapSettling> settling;  // of the latest one, in adaptive order
    InterRater raters;                    // of those who count, as the next
    OrderEffects effects;
    IndividualWeights weights;  // of a common map
};

// Where participants' files are to be, as chosen for one document.
struct ChosenFolder {
    std::filesystem::path path;
    std::uint64_t document_number = 0;  // 0: none was chosen
};

enum class StudyShow { matrix, map };

// Who is about to be left out, and why: while the reason is typed.
struct LeavingOut {
    std::string code;
    std::string because;
};

// What is known of the device that a run is felt by (app/study/study_actuator.h).
struct StudyActuator {
    bool is_there = false;        // when the run began; otherwise it is a rehearsal
    std::vector<Drive> drives;    // of every pattern of the run, turned down ...
    double turned_down_db = 0.0;  // ... all alike, so that none is too strong
    std::vector<double> peaks;    // of the drives, at a level of 1
    double level = 1.0;
    double ceiling = 1.0;             // above it the device turns a play down
    std::string remark;               // on what the actuator cannot do; empty: it can
    std::string fault;                // why the run paused; a sentence
    std::string known_trouble;        // of the device, that has been told
    std::uint64_t seen_dropouts = 0;  // by the device's count
    int dropouts = 0;                 // in the play that is under way
};

struct StudyState {
    bool is_open = false;  // the view, in place of the panes
    StudyKind kind = StudyKind::pairwise;
    ChosenFolder folder;
    std::optional<StudyRun> run;            // fills the window
    std::optional<StudyLog> log;            // its file
    std::shared_ptr<const PatternSet> set;  // as it was when the run began
    Query<StudyQuestion, StudyAnswers> job;
    std::shared_ptr<const StudyAnswers> answers;
    StudyQuestion asked;
    std::uint64_t folder_revision = 1;  // raised when a file was written, or may have been
    std::optional<std::size_t> shown;   // a participant; none: the mean
    StudyShow show = StudyShow::matrix;
    CollectRule rule;  // but for the attention, which is the design's
    LeavingOut leaving_out;

    std::string rounds_text;  // of sorting, while being typed
    std::string edited_text;  // id of the words being edited; empty: none

    // On the consent page.
    std::string code;
    std::string age;
    std::string gender;
    std::string hand;
    bool agrees = false;

    std::optional<std::size_t> held;      // pattern, in sorting: by the mouse or the keyboard
    std::optional<MapSettling> settling;  // of the run, in adaptive order, as of its last pause
    std::size_t pressed_button = 0;       // last: 0 left, 1 right
    std::shared_ptr<Device> device = std::make_shared<MemoryDevice>(false);  // never null
    bool has_window_device = false;   // it is the one that the window plays on
    StudyActuator actuator;           // of the run
    std::shared_ptr<Device> masking;  // on the participant's headphones; null: nothing is
    std::string masking_fault;        // a sentence; empty: it sounds, or is not asked for
    bool masks = false;
};

}  // namespace tact
