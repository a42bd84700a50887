// A participant at the study: what they do goes to the run, and what it asks for is done.

#include <utility>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "app/session/session.h"
#include "app/study/parts.h"
#include "app/study/study.h"
#include "model/io/people/study_lines.h"
#include "model/set/set_ratings.h"
#include "model/text/utc_time.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

using What = StudyEvent::What;

constexpr double kLookS = 0.01;  // between two looks at a device that still plays

void end_run(Ui& ui, StudyState& studying) {
    const std::string code = studying.run->record.header.participant.code;
    const bool is_complete = studying.run->page == StudyPage::finished;
    const bool has_file = studying.log.has_value();
    studying.device->stop();
    stop_masking(studying);
    studying.run.reset();
    studying.log.reset();
    studying.set.reset();
    ++studying.folder_revision;
    if (!has_file) return say(ui, "No participant yet; nothing was written.");
    say(ui, code + (is_complete ? " has finished." : " can continue where it was left."));
}

// The participant's file, with its first line on the disk.
Expected<Done> begin_file(const Workspace& work, StudyState& studying) {
    const StudyHeader& header = studying.run->record.header;
    const fs::path folder = study_folder(work, studying);
    if (folder.empty()) return Error{"expected a folder for participants, choose one first"};
    if (const auto made = make_folder(folder); !made) return made;
    auto log = StudyLog::begin(folder / study_file_name(header.participant.code), header);
    if (!log) return log.error();
    studying.log.emplace(*std::move(log));
    return Done{};
}

Expected<Done> write_line(StudyState& state, const std::string& line) {
    if (!state.log) return Error{"the participant's file is closed"};
    return state.log->append(line);
}

void act_on(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
            const StudyActions& actions) {
    if (actions.silence) studying.device->stop();
    if (actions.play) {
        StudyActuator& actuator = studying.actuator;
        actuator.dropouts = 0;
        actuator.seen_dropouts = studying.device->status().dropouts;
        const auto played =
            studying.device->play_after(actuator.drives[*actions.play], actions.rest_s);
        if (!played && actuator.is_there)
            return lose_actuator(ui, work, play, studying, played.error().message);
    }
    if (actions.begin_file || actions.line) {
        const Expected<Done> done =
            actions.line ? write_line(studying, *actions.line) : begin_file(work, studying);
        act(ui, work, play, studying,
            {done ? What::saved : What::not_saved,
             0,
             0.0,
             done ? std::string() : done.error().message,
             {}});
    }
    if (actions.left) end_run(ui, studying);
}

bool is_paused(const StudyRun& run) { return run.is_asking || run.page == StudyPage::rest; }

// Whether more trials are worth it, when there is time to think about that.
void look_at_map(StudyState& state) {
    const StudyRecord& record = state.run->record;
    state.settling.reset();
    if (record.header.kind != StudyKind::pairwise) return;
    if (record.header.design.order != StudyOrder::adaptive) return;
    state.settling = map_settling(record.header.patterns.size(), rated_trials(record));
}

void start_run(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
               StudyState& studying, StudyRecord record) {
    studying.set = std::make_shared<const PatternSet>(work.document.set);
    std::vector<double> durations = study_durations_s(*studying.set, record.header.patterns);
    studying.run = study_run(std::move(record), std::move(durations));
    studying.held.reset();
    studying.settling.reset();
    silence(timeline, play);
    timeline.playhead.playing = false;
    ui.status = {};
}

}  // namespace

namespace {

const char* silence_obstacle(const PlayState& play, const StudyState& studying) {
    const bool is_silent = play.level <= 0.0 && studying.device->status().connected;
    return is_silent ? "The level is 0: nothing would be felt. Raise it first." : "";
}

}  // namespace

std::string participant_obstacle(const Workspace& work, const PlayState& play,
                                 const StudyState& studying) {
    const std::size_t patterns = study_names(work).size();
    if (patterns < 3) return "A study takes three patterns at least.";
    for (const int groups : work.document.set.study.groups) {
        if (studying.kind == StudyKind::sorting && static_cast<std::size_t>(groups) > patterns) {
            return "A round asks for " + std::to_string(groups) + " groups of " +
                   std::to_string(patterns) + " patterns.";
        }
    }
    if (std::string changed = design_obstacle(work, studying); !changed.empty()) return changed;
    return silence_obstacle(play, studying);
}

void begin_participant(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                       StudyState& studying) {
    const std::string obstacle = participant_obstacle(work, play, studying);
    if (!obstacle.empty()) return say(ui, obstacle);
    if (play.for_ear) choose_device(ui, timeline, play, {});  // what is heard is not what is felt
    StudyRecord record;
    record.header = study_header(work, play, studying, unused_code(work, studying));
    const auto changes = changes_on_disk(study_folder(work, studying), record.header);
    if (!changes.empty()) return complain(ui, another_study_words(changes));
    studying.code = record.header.participant.code;
    studying.age.clear();
    studying.gender.clear();
    studying.hand.clear();
    studying.agrees = false;
    studying.actuator = study_actuator(play, studying, work.document.set, record.header.patterns);
    record.header.device = study_device(play, studying, studying.actuator);
    begin_masking(play, studying, record.header.design);
    start_run(ui, work, timeline, play, studying, std::move(record));
}

namespace {

// What the answers from here on are given with, into the file, where it is not what it was.
Expected<Done> note_device(StudyState& state, StudyRecord& record, const StudyDevice& device) {
    if (device == device_of(record, answers_given(record))) return Done{};
    record.devices.push_back({answers_given(record), device, utc_now()});
    return write_line(state, device_line(record.devices.back()));
}

void go_on_with(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                StudyState& studying, StudyRecord record) {
    const fs::path file =
        study_folder(work, studying) / study_file_name(record.header.participant.code);
    auto log = StudyLog::resume(file, record);
    if (!log) return complain(ui, log.error().message);
    studying.log.emplace(*std::move(log));
    studying.actuator = study_actuator(play, studying, work.document.set, record.header.patterns);
    begin_masking(play, studying, record.header.design);
    StudyDevice device = study_device(play, studying, studying.actuator);
    device.masking = masking_words(studying, record.header.design);
    if (const auto noted = note_device(studying, record, device); !noted) {
        studying.log.reset();
        stop_masking(studying);
        return complain(ui, noted.error().message);
    }
    start_run(ui, work, timeline, play, studying, std::move(record));
}

std::string device_words(const StudyDevice& device) {
    if (is_rehearsal(device)) return "no device, so that nothing was felt";
    return device.name + ", " + device.calibration;
}

// Answers by another device, or another strength, are answers to other stimuli: that is a
// decision.
void ask_to_go_on(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                  StudyState& studying, const StudyRecord& record, const StudyDevice& was,
                  const StudyDevice& now) {
    const std::string& code = record.header.participant.code;
    const std::string words =
        is_rehearsal(now) ? "no device: nothing would be felt" : device_words(now);
    ask(ui, {.title = "Another device or strength",
             .text = "The last answers of " + code + " were given with " + device_words(was) +
                     ". Now it is " + words + ". The file notes this for the answers from here on.",
             .answers = {{"Go on as it is now",
                          [&, record] { go_on_with(ui, work, timeline, play, studying, record); }},
                         {"Not yet"}},
             .marked = 1});
}

}  // namespace

void resume_participant(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                        StudyState& studying, const StudyRecord& record) {
    const std::string silence = silence_obstacle(play, studying);
    if (!silence.empty()) return say(ui, silence);
    const std::string fingerprint = study_fingerprint(work.document.set, record.header.patterns);
    if (fingerprint != record.header.set_fingerprint) {
        return complain(ui, record.header.participant.code +
                                " felt other patterns: open the set as it was to go on.");
    }
    const StudyDevice now = study_device(
        play, studying, study_actuator(play, studying, work.document.set, record.header.patterns));
    const StudyDevice& was = device_of(record, answers_given(record));
    if (now.name != was.name || now.calibration != was.calibration) {
        return ask_to_go_on(ui, work, timeline, play, studying, record, was, now);
    }
    go_on_with(ui, work, timeline, play, studying, record);
}

namespace {

void step_run(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
              StudyEvent event, const DeviceStatus& status) {
    const bool was_paused = is_paused(*studying.run);
    event.at = utc_now();
    event.played = play_so_far(studying, status);
    StudyStep step = stepped(*std::move(studying.run), event, ui.time_s);
    studying.run = std::move(step.run);
    if (is_paused(*studying.run) && !was_paused) look_at_map(studying);
    act_on(ui, work, play, studying, step.actions);
}

}  // namespace

void act(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
         const StudyEvent& event) {
    if (!studying.run) return;
    const DeviceStatus status = studying.device->status();
    // It began later than it was told to, and is felt to its end.
    const bool is_late = studying.run->playing && ui.time_s >= studying.run->playing_until_s;
    if (is_late && studying.actuator.is_there && status.playing) {
        step_run(ui, work, play, studying, {.what = What::plays_on, .value = kLookS}, status);
    }
    if (event.what == What::go_on && studying.run->page == StudyPage::consent) {
        StudyHeader& header = studying.run->record.header;
        header.participant = {studying.code, {}};
        for (const auto& [key, value] : {std::pair{"age", studying.age},
                                         {"gender", studying.gender},
                                         {"hand", studying.hand}}) {
            if (!value.empty()) header.participant.fields.emplace_back(key, value);
        }
        header.device.masking = masking_words(studying, header.design);
        header.seed = participant_seed(header.design.seed, studying.code);
        if (!studying.agrees) return;
        // Its order of trials is the code's.
        studying.run =
            study_run(std::move(studying.run->record), std::move(studying.run->duration_s));
    }
    if (event.what == What::play && may_play(*studying.run, ui.time_s)) {
        studying.pressed_button = event.index;
    }
    const StudyDesign& design = studying.run->record.header.design;
    if (event.what == What::stay && !studying.masks) begin_masking(play, studying, design);
    if (event.what == What::stay) studying.actuator.fault.clear();
    step_run(ui, work, play, studying, event, status);
}

}  // namespace tact
