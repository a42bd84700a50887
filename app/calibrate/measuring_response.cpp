#include "app/calibrate/measuring_response.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/document/editing.h"
#include "app/play/calibrating.h"
#include "app/play/playing.h"
#include "app/session/folders.h"
#include "app/ui/file_question.h"
#include "devices/calibration/calibration_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/wave_file.h"
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
    auto result = calibration_from(calibration_plan(question.params), recording->waveform);
    if (result) {
        answer.result = *std::move(result);
    } else {
        answer.fault = result.error().message;
    }
    return answer;
}

// One that is not there yet: what was measured before stays.
fs::path new_file(const App& app, const Calibration& made) {
    if (app.session.folder.empty()) return {};
    std::string stem = device_text(app) + ", " + made.date;
    std::ranges::replace(stem, '/', '_');
    std::error_code fault;
    for (int number = 1;; ++number) {
        const std::string ending = number == 1 ? "" : " " + std::to_string(number);
        fs::path file = app.session.folder / "calibrations" / (stem + ending + ".json");
        if (!fs::exists(file, fault)) return file;
    }
}

// Its fields would lie over the files.
void leave_for_files(App& app) {
    app.dialog = Dialog::none;
    app.calibrate->comes_back = true;
}

}  // namespace

void play_calibration_signal(App& app) {
    if (!can_sound(app)) return;
    silence(app);
    app.calibrate->is_playing = true;
    // As devices/device/drive.h has it, full scale is 1.
    play_signal(app, calibration_plan(app.calibrate->params).drive, 1.0);
}

void save_calibration_signal_dialog(App& app) {
    leave_for_files(app);
    ask_for_file(app,
                 {.purpose = ChooserPurpose::save_calibration_signal,
                  .use = ChooserUse::save,
                  .title = "Save the measuring signal",
                  .extensions = {".wav"}},
                 app.document.path.parent_path(), "calibration signal.wav");
}

void save_calibration_signal(App& app, const fs::path& file) {
    const Drive drive = calibration_plan(app.calibrate->params).drive;
    const auto written = write_wave_file(file, Waveform{drive.rate_hz, drive.samples});
    if (!written) return complain(app, written.error().message);
    say(app, "Saved " + file.string() + ": play it at full level while the sensor records.");
}

void open_calibration_recording_dialog(App& app) {
    leave_for_files(app);
    const fs::path last = app.calibrate->recording;
    ask_for_file(app,
                 {.purpose = ChooserPurpose::open_calibration_recording,
                  .use = ChooserUse::open,
                  .title = "Open what the accelerometer recorded",
                  .extensions = {".csv", ".txt", ".wav"}},
                 last.empty() ? app.document.path.parent_path() : last.parent_path());
}

void read_calibration_recording(App& app, const fs::path& file) {
    app.calibrate->recording = file;
    look_at_recording(app);
}

void look_at_recording(App& app) {
    CalibrateState& state = *app.calibrate;
    if (state.recording.empty()) return;
    if (!state.job) {
        state.job = std::make_unique<LatestJob<ResponseQuestion, ResponseAnswer>>(
            JobPolicy::supersede, answered, app.wake);
    }
    state.job->submit({++state.asked, state.params, state.recording, options_of(state.fields)});
}

void follow_calibrate(App& app) {
    CalibrateState& state = *app.calibrate;
    if (state.comes_back && !app.chooser.is_open && app.dialog == Dialog::none) {
        state.comes_back = false;
        app.dialog = Dialog::calibrate;
    }
    if (state.job) state.answer = state.job->latest();
    state.is_playing = state.is_playing && is_sounding(app);
}

const ResponseAnswer* current_answer(const CalibrateState& state) {
    const bool is_current = state.answer && state.answer->question.number == state.asked;
    return is_current ? state.answer.get() : nullptr;
}

void save_and_use_calibration(App& app) {
    const ResponseAnswer* const answer = current_answer(*app.calibrate);
    if (answer == nullptr || answer->result.points.empty()) return;
    Calibration made = app.calibrate->about;
    made.device = app.play.choice.id;
    made.channel = app.play.choice.channel;
    made.date = utc_now().substr(0, 10);
    made.points = answer->result.points;
    const fs::path file = new_file(app, made);
    if (file.empty()) return complain(app, "There is no folder to keep the calibration in.");
    if (const auto folder = make_folder(file.parent_path()); !folder) {
        return complain(app, folder.error().message);
    }
    if (const auto written = write_calibration(file, made); !written) {
        return complain(app, written.error().message);
    }
    use_calibration(app, file);
    if (!app.status.is_error) say(app, calibration_text(app) + ", in " + file.string() + ".");
}

}  // namespace tact
