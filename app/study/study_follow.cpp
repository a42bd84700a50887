#include "app/study/study_follow.h"
#include "model/set/set_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "app/document/editing.h"
#include "app/play/calibrating.h"
#include "app/session/folders.h"
#include "app/session/program_version.h"
#include "app/study/study_actuator.h"
#include "app/study/study_answers.h"
#include "app/study/study_masking.h"
#include "app/ui/file_question.h"
#include "devices/device/memory_device.h"
#include "model/io/people/study_csv.h"
#include "model/set/set_ratings.h"
#include "model/study/synthetic_study.h"
#include "model/text/atomic_file.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

void follow_question(App& app) {
    StudyState& state = *app.study;
    StudyQuestion question = state.asked;
    question.number = state.folder_revision;
    question.folder = study_folder(app);
    if (question.folder != state.asked.folder) state.shown.reset();
    question.kind = state.kind;
    question.rule = state.rule;
    question.rule.attention = app.document.set.study.attention;
    question.set = app.committed;
    if (!state.job) {
        state.job = std::make_unique<LatestJob<StudyQuestion, StudyAnswers>>(
            JobPolicy::supersede, read_answers, app.wake);
    }
    if (question != state.asked) state.job->submit(question);
    state.asked = question;
    state.answers = state.job->latest();
}

}  // namespace

std::shared_ptr<StudyState> make_study() {
    auto state = std::make_shared<StudyState>();
    state->device = std::make_shared<MemoryDevice>(false);
    return state;
}

void stop_study(App& app) {
    app.study->job.reset();
    if (app.study->run) app.study->device->stop();
    stop_masking(*app.study);
}

void use_device(StudyState& study, const std::shared_ptr<Device>& device) {
    if (study.run) return;
    if (device) {
        study.device = device;
        study.has_window_device = true;
    } else if (study.has_window_device) {
        release_device(study);
    }
}

void release_device(StudyState& study) {
    study.device = std::make_shared<MemoryDevice>(false);
    study.has_window_device = false;
}

void open_study(App& app) {
    app.study->is_open = true;
    app.layout.maximised.reset();
    ++app.study->folder_revision;
}

void close_study(App& app) { app.study->is_open = false; }

fs::path study_folder(const App& app, const SavedFrom& place) {
    const ChosenFolder& chosen = app.study->folder;
    if (chosen.document_number == app.document_number) return chosen.path;
    // A set that was recovered into the state folder has its participants where they were.
    const fs::path& file = place.file;
    if (!file.empty() && file.parent_path() != app.session.folder) {
        std::string stem = file.stem().string();
        if (stem.ends_with(".tactspace")) stem.resize(stem.size() - 10);
        return file.parent_path() / (stem + " study");
    }
    if (app.session.folder.empty()) return {};
    std::string name = place.set_name.empty() ? "unnamed" : place.set_name;
    std::ranges::replace(name, '/', '_');
    return app.session.folder / "studies" / name;
}

fs::path study_folder(const App& app) {
    return study_folder(app, {app.document.path, app.document.set.name});
}

void choose_study_folder(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::study_folder,
                  .use = ChooserUse::save_folder,
                  .title = "Folder for participants",
                  .folders_too = true},
                 study_folder(app).parent_path(), study_folder(app).filename().string());
}

void set_study_folder(App& app, const fs::path& folder) {
    app.study->folder = {folder, app.document_number};
}

std::string unused_code(const App& app, const std::string& prefix) {
    const fs::path folder = study_folder(app);
    std::error_code none;
    for (int number = 1;; ++number) {
        const std::string code = prefix + "P" + std::to_string(number);
        if (!fs::exists(folder / study_file_name(code), none)) return code;
    }
}

std::string study_calibration(const App& app) {
    const std::string level = ", level " + significant(app.play.level);
    if (app.play.calibration) {
        std::string text = calibration_text(app);
        text.front() = 'c';  // in the middle of a sentence
        return text + level;
    }
    return "uncalibrated, full scale stands for " + significant(app.play.full_scale_g) + " g" +
           level;
}

StudyHeader study_header(const App& app, const std::string& code) {
    const PatternSet& set = app.document.set;
    StudyHeader header;
    header.program = kProgramVersion;
    header.kind = app.study->kind;
    header.set_name = set.name;
    header.patterns = study_patterns(set);
    header.set_fingerprint = study_fingerprint(set, header.patterns);
    header.design = set.study;
    header.participant.code = code;
    header.device = {app.study->device->status().name, study_calibration(app), {}};
    return header;
}

std::vector<double> study_durations_s(const PatternSet& set,
                                      const std::vector<std::string>& names) {
    std::vector<double> all;
    for (const std::string& name : names) {
        const auto place = place_named(set, name);
        const Waveform waveform = place ? waveform_of(set.vibrations[*place]) : Waveform{};
        all.push_back(static_cast<double>(waveform.samples_g.size()) / waveform.rate_hz);
    }
    return all;
}

void simulate_participant(App& app) {
    const StudyState& state = *app.study;
    const auto& map = app.map.shown;
    const std::vector<std::string> names = study_names(app);
    if (!map || names.size() < 3 || names_of(*map->request.set) != names_of(app.document.set)) {
        return complain(app, "The map must be there first: simulated people feel by it.");
    }
    std::vector<std::size_t> place;
    for (const std::string& name : names) place.push_back(*place_named(app.document.set, name));
    Dissimilarity truth{names.size(), {}};
    for (std::size_t i = 0; i < place.size(); ++i) {
        for (std::size_t j = i + 1; j < place.size(); ++j) {
            truth.condensed.push_back(map->prediction.pm(place[i], place[j]));
        }
    }
    const std::string code = unused_code(app, "synthetic ");
    StudyHeader header = study_header(app, code);
    header.device = {"none: simulated", "none", {}};
    header.synthetic = true;
    header.seed = participant_seed(header.design.seed, code);
    const StudyRecord record = simulated_study(header, {{}, truth, header.seed});
    const fs::path folder = study_folder(app);
    if (const auto made = make_folder(folder); !made) return complain(app, made.error().message);
    const auto written = write_study_file(folder / study_file_name(code), record);
    if (!written) return complain(app, written.error().message);
    ++app.study->folder_revision;
    say(app, "Simulated a participant" + std::string(state.kind == StudyKind::sorting
                                                         ? " who sorted."
                                                         : " who rated all pairs."));
}

void use_as_ratings(App& app) {
    const auto& answers = app.study->answers;
    if (!answers || !answers->results || answers->results->study.judgements.empty()) return;
    const StudyResults& results = *answers->results;
    const Expected<RatingStudy> study = matched(results.study, names_of(app.document.set));
    if (!study) return complain(app, study.error().message);
    const std::string source = std::string(results.synthetic ? kSyntheticRatings : "") +
                               answers->question.folder.filename().string();
    app.document.set.ratings = kept_ratings(*study, source);
    document_changed(app);
    commit_step(app, "Use the study as ratings");
    app.bench = BenchTab::compare;
    app.compare.view = CompareView::table;
    close_study(app);
    const std::string unrated = remark_on_unrated(unrated_patterns(*study), study->labels.size());
    say(app, "The study's ratings are compared with the metrics." +
                 (unrated.empty() ? "" : " " + unrated + "."));
}

void export_study_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::export_study,
                  .use = ChooserUse::save,
                  .title = "Export answers as CSV",
                  .extensions = {".csv"}},
                 study_folder(app).parent_path(), "answers.csv");
}

void export_study(App& app, const fs::path& file) {
    const auto& answers = app.study->answers;
    if (!answers || !answers->results) return complain(app, "There are no answers to export yet.");
    std::ostringstream text;
    write_study_csv(text, answers->records, *answers->results, StudyRows::everyone);
    if (const auto written = write_atomically(file, text.str()); !written) {
        return complain(app, written.error().message);
    }
    say(app, "Exported " + file.string() + ".");
}

void follow_study(App& app) {
    StudyState& state = *app.study;
    if (state.run && state.run->playing && app.time_s >= state.run->playing_until_s) {
        act(app, {});
    }
    follow_actuator(app);
    follow_masking(app);
    if (state.is_open && !state.run) follow_question(app);
}

bool is_study_running(const App& app) { return app.study->run.has_value(); }

bool is_study_playing(const App& app) { return app.study->run && app.study->run->playing; }

std::vector<std::string> study_names(const App& app) { return study_patterns(app.document.set); }

double study_duration_s(const App& app) {
    double longest_s = 0.0;
    for (const std::string& name : study_names(app)) {
        const auto place = place_named(app.document.set, name);
        const Vibration& vibration = app.document.set.vibrations[*place];
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        longest_s = std::max(longest_s, pattern != nullptr
                                            ? pattern->duration_s
                                            : study_durations_s(app.document.set, {name}).front());
    }
    return longest_s;
}

double study_wake_s(const App& app) {
    const StudyState& state = *app.study;
    if (state.run) {
        const double next_s = next_change_s(*state.run, app.time_s) + 0.005;
        const bool looks = state.masks || state.actuator.is_there;
        return looks ? std::min(next_s, kMaskingLookS) : next_s;
    }
    const bool is_busy = state.is_open && state.job && state.job->busy();
    return is_busy ? 0.1 : std::numeric_limits<double>::infinity();
}

}  // namespace tact
