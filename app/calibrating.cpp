#include "app/calibrating.h"

#include "app/editing.h"
#include "app/playing.h"
#include "app/widgets.h"
#include "devices/calibration_file.h"
#include "viz/plot.h"

namespace tact {

void follow_calibration(App& app) {
    PlayState& play = app.play;
    if (play.calibration_read == play.choice.calibration) return;
    play.calibration_read = play.choice.calibration;
    play.calibration.reset();
    if (play.calibration_read.empty()) return;
    Expected<Calibration> read = read_calibration(play.calibration_read);
    if (!read) return complain(app, read.error().message + "; the device plays uncalibrated");
    play.calibration = std::make_shared<const Calibration>(*std::move(read));
    const Calibration& made = *play.calibration;
    const bool is_other = !made.device.empty() && made.device != play.choice.id;
    if (is_other || made.channel != play.choice.channel) {
        complain(app, "This calibration was made for " +
                          (made.device.empty() ? "this device" : made.device) + ", channel " +
                          std::to_string(made.channel) + ": here its strengths may be wrong");
    }
}

void load_calibration_dialog(App& app) {
    app.chooser_purpose = ChooserPurpose::load_calibration;
    app.chooser.use = ChooserUse::open;
    app.chooser.title = "Load the calibration of this device";
    app.chooser.extensions = {".json"};
    app.chooser.folders_too = false;
    app.dialog = Dialog::none;  // its list would lie over the files
    const std::filesystem::path last = app.play.choice.calibration;
    show(app.chooser, last.empty() ? app.document.path.parent_path() : last.parent_path());
}

void use_calibration(App& app, const std::filesystem::path& path) {
    DeviceChoice choice = app.play.choice;
    choice.calibration = path.string();
    choose_device(app, choice);
    follow_calibration(app);
    if (app.play.calibration && !app.status.is_error) say(app, calibration_text(app) + ".");
}

std::string calibration_text(const App& app) {
    if (!app.play.calibration) return {};
    const Calibration& made = *app.play.calibration;
    std::string text = "Calibrated";
    if (!made.actuator.empty()) text += ": " + made.actuator;
    if (!made.date.empty()) text += ", " + made.date;
    return text + ", " + significant(made.points.front().frequency_hz) + "\u2013" +
           significant(made.points.back().frequency_hz) + " Hz";
}

Drive drive_for(App& app, const Vibration& vibration) {
    const Waveform waveform = waveform_of(vibration);
    if (!app.play.calibration) return drive_of(waveform, app.play.full_scale_g);
    CalibratedDrive driven = calibrated_drive(waveform, *app.play.calibration);
    if (!driven.warnings.empty()) {
        std::string words = vibration.name;
        for (const std::string& warning : driven.warnings) {
            words += (words.size() == vibration.name.size() ? " " : "; it ") + warning;
        }
        say(app, words + ".");
    }
    return std::move(driven.drive);
}

}  // namespace tact
