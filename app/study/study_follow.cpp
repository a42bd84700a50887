#include "app/study/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "app/study/parts.h"
#include "app/ui/ui.h"
#include "devices/device/memory_device.h"
#include "devices/phone/phone_device.h"
#include "model/io/people/study_csv.h"
#include "model/set/felt_versions.h"
#include "model/set/set_ratings.h"
#include "model/study/synthetic_study.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

void follow_question(const Ui& ui, const Workspace& work, StudyState& studying) {
    StudyQuestion question = studying.asked;
    question.number = studying.folder_revision;
    question.folder = study_folder(work, studying);
    if (question.folder != studying.asked.folder) studying.shown.reset();
    question.kind = studying.kind;
    question.rule = studying.rule;
    question.rule.attention = work.document.set.study.attention;
    question.set = work.document.committed;
    if (question != studying.asked) studying.job.ask(question, read_answers, ui.wake);
    studying.asked = question;
    studying.answers = studying.job.latest();
}

// Onto another disk they are copied, and the first ones stay: nobody can be asked again.
bool move_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code fault;
    fs::rename(from, to, fault);
    if (!fault) return true;
    fault.clear();
    fs::copy(from, to, fs::copy_options::recursive, fault);
    if (!fault) return true;
    std::error_code none;
    fs::remove_all(to, none);
    return false;
}

}  // namespace

void stop_study(StudyState& studying) {
    if (studying.run) studying.device->stop();
    stop_masking(studying);
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

void open_study(Layout& layout, StudyState& studying) {
    studying.is_open = true;
    layout.maximised.reset();
    ++studying.folder_revision;
}

void close_study(StudyState& studying) { studying.is_open = false; }

fs::path study_folder(const Workspace& work, const StudyState& studying, const SavedFrom& place) {
    const ChosenFolder& chosen = studying.folder;
    if (chosen.document_number == work.document_number) return chosen.path;
    // A set that was recovered into the state folder has its participants where they were.
    const fs::path& file = place.file;
    if (!file.empty() && file.parent_path() != work.session.folder) {
        std::string stem = file.stem().string();
        if (stem.ends_with(".tactspace")) stem.resize(stem.size() - 10);
        return file.parent_path() / (stem + " study");
    }
    if (work.session.folder.empty()) return {};
    const std::string& name = place.set_name;
    return work.session.folder / "studies" / file_stem(name.empty() ? "unnamed" : name);
}

fs::path study_folder(const Workspace& work, const StudyState& studying) {
    return study_folder(work, studying, {work.document.path, work.document.set.name});
}

void choose_study_folder(Ui& ui, const Workspace& work, StudyState& studying) {
    ask_for_file(
        ui,
        {.use = ChooserUse::save_folder,
         .title = "Folder for participants",
         .folders_too = true,
         .take = [&](const fs::path& folder) { set_study_folder(work, studying, folder); }},
        study_folder(work, studying).parent_path(),
        study_folder(work, studying).filename().string());
}

void set_study_folder(const Workspace& work, StudyState& studying, const fs::path& folder) {
    studying.folder = {folder, work.document_number};
}

bool is_code_taken(const Workspace& work, const StudyState& studying, const std::string& code) {
    const std::string file = study_file_name(code);
    std::error_code none;
    return !file.empty() && fs::exists(study_folder(work, studying) / file, none);
}

std::string unused_code(const Workspace& work, const StudyState& studying,
                        const std::string& prefix) {
    for (int number = 1;; ++number) {
        std::string code = prefix + "P" + std::to_string(number);
        if (!is_code_taken(work, studying, code)) return code;
    }
}

std::string study_calibration(const PlayState& play) {
    const std::string level = ", level " + significant(play.level);
    if (is_phone(play.choice.id)) {
        return "uncalibrated, on-off times alone, the loudest pattern at full strength" + level;
    }
    if (play.calibration) {
        std::string text = calibration_text(play);
        text.front() = 'c';  // in the middle of a sentence
        return text + level;
    }
    return "uncalibrated, full scale stands for " + significant(play.full_scale_g) + " g" + level;
}

StudyHeader study_header(const Workspace& work, const PlayState& play, const StudyState& studying,
                         const std::string& code) {
    const PatternSet& set = work.document.set;
    StudyHeader header;
    header.program = kProgramVersion;
    header.kind = studying.kind;
    describe_set(header, set);
    header.design = set.study;
    header.participant.code = code;
    header.device = {studying.device->status().name, study_calibration(play), {}};
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

std::string simulation_obstacle(const Workspace& work, const StudyState& studying,
                                const ShownMap& shown_map) {
    const auto& map = shown_map.transition.shown;
    if (study_names(work).size() < 3) return "A study takes three patterns at least.";
    if (std::string changed = design_obstacle(work, studying); !changed.empty()) return changed;
    const bool is_there = map && names_of(*map->request.set) == names_of(work.document.set);
    return is_there ? "" : "The map must be there first: simulated people feel by it.";
}

void simulate_participant(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          const PlayState& play, StudyState& studying) {
    const auto& map = shown_map.transition.shown;
    const std::vector<std::string> names = study_names(work);
    const std::string obstacle = simulation_obstacle(work, studying, shown_map);
    if (!obstacle.empty()) return say(ui, obstacle);
    std::vector<std::size_t> place;
    for (const std::string& name : names) place.push_back(*place_named(work.document.set, name));
    Dissimilarity truth{names.size(), {}};
    for (std::size_t i = 0; i < place.size(); ++i) {
        for (std::size_t j = i + 1; j < place.size(); ++j) {
            truth.condensed.push_back(map->prediction.pm(place[i], place[j]));
        }
    }
    const std::string code = unused_code(work, studying, "synthetic ");
    StudyHeader header = study_header(work, play, studying, code);
    if (const auto changes = changes_on_disk(study_folder(work, studying), header);
        !changes.empty()) {
        return complain(ui, another_study_words(changes));
    }
    header.device = {"none: simulated", "none", {}};
    header.synthetic = true;
    header.seed = participant_seed(header.design.seed, code);
    const StudyRecord record = simulated_study(header, {{}, truth, header.seed});
    const fs::path folder = study_folder(work, studying);
    if (const auto made = make_folder(folder); !made) return complain(ui, made.error().message);
    const auto written = write_study_file(folder / study_file_name(code), record);
    if (!written) return complain(ui, written.error().message);
    ++studying.folder_revision;
    say(ui, "Simulated a participant" + std::string(studying.kind == StudyKind::sorting
                                                        ? " who sorted."
                                                        : " who rated all pairs."));
}

void use_as_ratings(Ui& ui, Workspace& work, Layout& layout, Comparing& comparing,
                    StudyState& studying) {
    const auto& answers = studying.answers;
    if (!answers || !answers->results || answers->results->study.judgements.empty()) return;
    const StudyResults& results = *answers->results;
    const Expected<RatingStudy> study = matched(results.study, names_of(work.document.set));
    if (!study) return complain(ui, study.error().message);
    auto ratings = kept_ratings(*study, answers->question.folder.filename().string());
    note_versions(ratings, *study, work.document.set);
    work.document.edit().ratings = std::move(ratings);
    document_changed(work);
    commit_step(ui, work, "Use the study as ratings");
    layout.bench = BenchTab::compare;
    comparing.panel.view = CompareView::table;
    close_study(studying);
    const std::string unrated = remark_on_unrated(unrated_patterns(*study), study->labels.size());
    say(ui, "The study's ratings are compared with the metrics." +
                (unrated.empty() ? "" : " " + unrated + ".") +
                (study->gone.empty() ? "" : " " + words_on_gone(study->gone) + "."));
}

void export_study_dialog(Ui& ui, const Workspace& work, const StudyState& studying) {
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Export answers as CSV",
                  .extensions = {".csv"},
                  .take = [&](const fs::path& file) { export_study(ui, studying, file); }},
                 study_folder(work, studying).parent_path(), "answers.csv");
}

void export_study(Ui& ui, const StudyState& studying, const fs::path& file) {
    const auto& answers = studying.answers;
    if (!answers || !answers->results) return say(ui, "There are no answers to export yet.");
    std::ostringstream text;
    write_study_csv(text, answers->records, *answers->results, StudyRows::everyone);
    if (const auto written = write_atomically(file, text.str()); !written) {
        return complain(ui, written.error().message);
    }
    say(ui, "Exported " + file.string() + ".");
}

void follow_study(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying) {
    if (studying.run && studying.run->playing && ui.time_s >= studying.run->playing_until_s) {
        act(ui, work, play, studying, {});
    }
    follow_actuator(ui, work, play, studying);
    follow_masking(ui, work, play, studying);
    if (studying.is_open && !studying.run) follow_question(ui, work, studying);
}

bool is_study_running(const StudyState& studying) { return studying.run.has_value(); }

bool is_study_playing(const StudyState& studying) { return studying.run && studying.run->playing; }

std::vector<std::string> study_names(const Workspace& work) {
    return study_patterns(work.document.set);
}

double study_duration_s(const Workspace& work) {
    double longest_s = 0.0;
    for (const std::string& name : study_names(work)) {
        const auto place = place_named(work.document.set, name);
        const Vibration& vibration = work.document.set.vibrations[*place];
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        longest_s = std::max(longest_s, pattern != nullptr
                                            ? pattern->duration_s
                                            : study_durations_s(work.document.set, {name}).front());
    }
    return longest_s;
}

double study_wake_s(const Ui& ui, const StudyState& studying) {
    if (studying.run) {
        const double next_s = next_change_s(*studying.run, ui.time_s) + 0.005;
        const bool looks = studying.masks || studying.actuator.is_there;
        return looks ? std::min(next_s, kMaskingLookS) : next_s;
    }
    const bool is_busy = studying.is_open && studying.job.busy();
    return is_busy ? 0.1 : std::numeric_limits<double>::infinity();
}

void keep_participants(Ui& ui, const Workspace& work, StudyState& studying,
                       const SavedFrom& place_before) {
    const fs::path before = study_folder(work, studying, place_before);
    const fs::path now = study_folder(work, studying);
    if (now == before || !contains_study(before)) return;
    ++studying.folder_revision;
    if (place_before.file.empty() && !is_there(now) && move_or_copy(before, now)) {
        return say(ui, ui.status.text + " Its participants are now in " + now.string() + ".");
    }
    set_study_folder(work, studying, before);
    say(ui, ui.status.text + " Its participants stay in " + before.string() +
                "; Study > Folder for participants... chooses another one.");
}

}  // namespace tact
