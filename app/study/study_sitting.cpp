// A participant at the study: what they do goes to the run, and what it asks for is done.

#include <utility>

#include "app/document/editing.h"
#include "app/document/folders.h"
#include "app/play/calibrating.h"
#include "app/play/playing.h"
#include "app/study/study_follow.h"
#include "app/study/study_masking.h"
#include "model/set/set_study.h"
#include "model/text/utc_time.h"

namespace tact {

namespace fs = std::filesystem;

using What = StudyEvent::What;

namespace {

void end_run(App& app) {
    StudyState& state = *app.study;
    const std::string code = state.run->record.header.participant.code;
    const bool is_complete = state.run->page == StudyPage::finished;
    const bool has_file = state.log.has_value();
    state.device->stop();
    stop_masking(state);
    state.run.reset();
    state.log.reset();
    state.set.reset();
    ++state.folder_revision;
    if (!has_file) return say(app, "Nobody took part; nothing was written.");
    say(app, code + (is_complete ? " has finished." : " can go on where it was left."));
}

// The participant's file, with its first line on the disk.
Expected<Done> begin_file(App& app) {
    StudyState& state = *app.study;
    const StudyHeader& header = state.run->record.header;
    const fs::path folder = study_folder(app);
    if (folder.empty()) return Error{"expected a folder for participants, choose one first"};
    if (const auto made = make_folder(folder); !made) return made;
    auto log = StudyLog::begin(folder / study_file_name(header.participant.code), header);
    if (!log) return log.error();
    state.log.emplace(*std::move(log));
    return Done{};
}

Expected<Done> write_line(StudyState& state, const std::string& line) {
    if (!state.log) return Error{"the participant's file is closed"};
    return state.log->append(line);
}

void act_on(App& app, const StudyDeeds& deeds) {
    StudyState& state = *app.study;
    if (deeds.silence) state.device->stop();
    if (deeds.play) {
        const std::string& name = state.run->record.header.patterns[*deeds.play];
        const Vibration& vibration = state.set->vibrations[*place_named(*state.set, name)];
        const Drive drive = made_drive(drive_request(app, vibration)).drive;
        if (const auto played = state.device->play(drive, false); !played) {
            complain(app, played.error().message);
        }
    }
    if (deeds.begin_file || deeds.line) {
        const Expected<Done> done = deeds.line ? write_line(state, *deeds.line) : begin_file(app);
        act(app, {done ? What::saved : What::not_saved,
                  0,
                  0.0,
                  done ? std::string() : done.error().message,
                  {}});
    }
    if (deeds.left) end_run(app);
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

void start_run(App& app, StudyRecord record) {
    StudyState& state = *app.study;
    state.set = std::make_shared<const PatternSet>(app.document.set);
    std::vector<double> durations = study_durations_s(*state.set, record.header.patterns);
    begin_masking(app, record.header.design);
    state.run = study_run(std::move(record), std::move(durations));
    state.held.reset();
    state.settling.reset();
    silence(app);
    app.playhead.playing = false;
    app.status = {};
}

}  // namespace

void begin_participant(App& app) {
    StudyState& state = *app.study;
    StudyRecord record;
    record.header = study_header(app, unused_code(app));
    if (record.header.patterns.size() < 3) {
        return complain(app, "A study takes three patterns at least.");
    }
    const std::size_t patterns = record.header.patterns.size();
    for (const int groups : record.header.design.groups) {
        if (state.kind == StudyKind::sorting && static_cast<std::size_t>(groups) > patterns) {
            return complain(app, "A round asks for " + std::to_string(groups) + " groups of " +
                                     std::to_string(patterns) + " patterns.");
        }
    }
    state.code = record.header.participant.code;
    state.age.clear();
    state.gender.clear();
    state.hand.clear();
    state.agrees = false;
    start_run(app, std::move(record));
}

void resume_participant(App& app, const StudyRecord& record) {
    const std::string fingerprint = study_fingerprint(app.document.set, record.header.patterns);
    if (fingerprint != record.header.set_fingerprint) {
        return complain(app, record.header.participant.code +
                                 " felt other patterns: open the set as it was to go on.");
    }
    const fs::path file = study_folder(app) / study_file_name(record.header.participant.code);
    auto log = StudyLog::resume(file, record);
    if (!log) return complain(app, log.error().message);
    app.study->log.emplace(*std::move(log));
    start_run(app, record);
}

void act(App& app, const StudyEvent& event) {
    StudyState& state = *app.study;
    if (!state.run) return;
    if (event.what == What::go_on && state.run->page == StudyPage::consent) {
        StudyHeader& header = state.run->record.header;
        header.participant = {state.code, {}};
        for (const auto& [key, value] :
             {std::pair{"age", state.age}, {"gender", state.gender}, {"hand", state.hand}}) {
            if (!value.empty()) header.participant.fields.emplace_back(key, value);
        }
        header.device.masking = masking_words(app, header.design);
        header.seed = participant_seed(header.design.seed, state.code);
        if (!state.agrees) return;
        // Its order of trials is the code's.
        state.run = study_run(std::move(state.run->record), std::move(state.run->duration_s));
    }
    if (event.what == What::play && may_play(*state.run, app.time_s)) {
        state.pressed_button = event.index;
    }
    const StudyDesign& design = state.run->record.header.design;
    if (event.what == What::stay && !state.masks) begin_masking(app, design);
    const bool was_paused = is_paused(*state.run);
    StudyEvent timed = event;
    timed.at = utc_now();
    StudyStep step = stepped(*std::move(state.run), timed, app.time_s);
    state.run = std::move(step.run);
    if (is_paused(*state.run) && !was_paused) look_at_map(state);
    act_on(app, step.deeds);
}

}  // namespace tact
