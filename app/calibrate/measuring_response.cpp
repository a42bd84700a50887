#include "app/calibrate/calibrate.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "devices/calibration/calibration_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/wave_file.h"
#include "model/text/names.h"
#include "model/text/utc_time.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::optional<ResponseAnswer> answered(const ResponseQuestion& question, std::stop_token stop,
                                       std::atomic<float>& progress) {
    ResponseAnswer answer{question, {}, {}, {}};
    const auto recording = read_acceleration_file(question.recording, question.options);
    if (!recording) {
        answer.fault = recording.error().message;
        return answer;
    }
    answer.remarks = recording->remarks;
    progress = 0.3F;
    if (stop.stop_requested()) return std::nullopt;
    auto result = calibration_from(question.params, recording->waveform);
    if (result) {
        answer.result = *std::move(result);
    } else {
        answer.fault = result.error().message;
    }
    return answer;
}

// One that is not there yet: what was measured before stays.
fs::path new_file(const Workspace& work, const PlayState& play, const Calibration& made) {
    const fs::path folder = calibration_folder(work);
    if (folder.empty()) return {};
    const std::string stem = file_stem(device_text(play) + ", " + made.date);
    std::error_code fault;
    for (int number = 1;; ++number) {
        const std::string ending = number == 1 ? "" : " " + std::to_string(number);
        fs::path file = folder / (stem + ending + ".json");
        if (!fs::exists(file, fault)) return file;
    }
}

// Its fields would lie over the files.
void leave_for_files(Ui& ui, CalibrateState& calibrating) {
    ui.dialog = kNoDialog;
    calibrating.comes_back = true;
}

}  // namespace

void play_calibration_signal(Ui& ui, Timeline& timeline, PlayState& play,
                             CalibrateState& calibrating) {
    if (!can_sound(play)) return;
    silence(timeline, play);
    calibrating.is_playing = true;
    // As devices/device/drive.h has it, full scale is 1.
    play_signal(ui, timeline, play, calibration_plan(calibrating.params).drive, 1.0);
}

void save_calibration_signal_dialog(Ui& ui, const Workspace& work, CalibrateState& calibrating) {
    leave_for_files(ui, calibrating);
    ask_for_file(
        ui,
        {.use = ChooserUse::save,
         .title = "Save the measuring signal",
         .extensions = {".wav"},
         .take = [&](const fs::path& file) { save_calibration_signal(ui, calibrating, file); }},
        work.document.path.parent_path(), "calibration signal.wav");
}

void save_calibration_signal(Ui& ui, const CalibrateState& calibrating, const fs::path& file) {
    const Drive drive = calibration_plan(calibrating.params).drive;
    const auto written = write_wave_file(file, Waveform{drive.rate_hz, drive.samples});
    if (!written) return complain(ui, written.error().message);
    say(ui, "Saved " + file.string() + ": play it at full level while the sensor records.");
}

void open_calibration_recording_dialog(Ui& ui, const Workspace& work, CalibrateState& calibrating) {
    leave_for_files(ui, calibrating);
    const fs::path last = calibrating.recording;
    ask_for_file(
        ui,
        {.use = ChooserUse::open,
         .title = "Open what the accelerometer recorded",
         .extensions = {".csv", ".txt", ".wav"},
         .take = [&](const fs::path& file) { read_calibration_recording(ui, calibrating, file); }},
        last.empty() ? work.document.path.parent_path() : last.parent_path());
}

void read_calibration_recording(const Ui& ui, CalibrateState& calibrating, const fs::path& file) {
    calibrating.recording = file;
    look_at_recording(ui, calibrating);
}

void look_at_recording(const Ui& ui, CalibrateState& calibrating) {
    if (calibrating.recording.empty()) return;
    calibrating.job.ask({++calibrating.asked, calibrating.params, calibrating.recording,
                         options_of(calibrating.fields)},
                        answered, ui.wake);
}

void follow_calibrate(Ui& ui, const PlayState& play, CalibrateState& calibrating) {
    if (calibrating.comes_back && !ui.chooser.is_open && ui.dialog == kNoDialog) {
        calibrating.comes_back = false;
        ui.dialog = kCalibrateDialog;
    }
    if (auto answer = calibrating.job.latest()) calibrating.answer = std::move(answer);
    calibrating.is_playing = calibrating.is_playing && is_sounding(play);
}

const ResponseAnswer* current_answer(const CalibrateState& state) {
    const bool is_current = state.answer && state.answer->question.number == state.asked;
    return is_current ? state.answer.get() : nullptr;
}

void save_and_use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                              PlayState& play, const CalibrateState& calibrating) {
    const ResponseAnswer* const answer = current_answer(calibrating);
    if (answer == nullptr || answer->result.points.empty()) return;
    Calibration made = calibrating.about;
    made.device = play.choice.id;
    made.channel = play.choice.channel;
    made.date = utc_today();
    made.points = answer->result.points;
    const fs::path file = new_file(work, play, made);
    if (file.empty()) return complain(ui, "There is no folder to keep the calibration in.");
    if (const auto folder = make_folder(file.parent_path()); !folder) {
        return complain(ui, folder.error().message);
    }
    if (const auto written = write_calibration(file, made); !written) {
        return complain(ui, written.error().message);
    }
    use_calibration(ui, work, timeline, rendered, play, file);
    if (!ui.status.is_error) say(ui, calibration_text(play) + ", in " + file.string() + ".");
}

}  // namespace tact
