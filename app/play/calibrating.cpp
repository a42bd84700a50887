#include "app/play/play.h"

#include <utility>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/parts.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "devices/calibration/calibration_file.h"
#include "devices/device/protection.h"
#include "devices/phone/phone_device.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The actuator of the rendering report is the calibrated one.
void follow_rendered_coil(Workspace& work, RenderingState& rendered, const PlayState& play) {
    std::optional<Calibration>& used = rendered.by.calibration;
    const bool is_coil = traits(rendered.by.kind).language == Language::waveform;
    const Calibration* const wanted = is_coil ? play.calibration.get() : nullptr;
    if (wanted == nullptr ? !used : used == *wanted) return;
    if (wanted != nullptr) {
        used = *wanted;
    } else {
        used.reset();
    }
    if (rendered.on) predictions_changed(work);
}

void read_chosen(Ui& ui, PlayState& play) {
    if (play.calibration_read == play.choice.calibration) return;
    play.calibration_read = play.choice.calibration;
    play.calibration.reset();
    if (play.calibration_read.empty()) return;
    Expected<Calibration> read = read_calibration(play.calibration_read);
    if (!read) return complain(ui, read.error().message + "; the device plays uncalibrated");
    play.calibration = std::make_shared<const Calibration>(*std::move(read));
    const Calibration& made = *play.calibration;
    const bool is_other = !made.device.empty() && made.device != play.choice.id;
    if (is_other || made.channel != play.choice.channel) {
        complain(ui, "This calibration was made for " +
                         (made.device.empty() ? "this device" : made.device) + ", channel " +
                         std::to_string(made.channel) + ": here its strengths may be wrong");
    }
}

}  // namespace

void follow_calibration(Ui& ui, Workspace& work, RenderingState& rendered, PlayState& play) {
    read_chosen(ui, play);
    follow_rendered_coil(work, rendered, play);
}

std::filesystem::path calibration_folder(const Workspace& work) {
    return work.session.folder.empty() ? std::filesystem::path{}
                                       : work.session.folder / "calibrations";
}

void load_calibration_dialog(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                             PlayState& play) {
    ui.dialog = kNoDialog;  // its list would cover the files
    const std::filesystem::path last = play.choice.calibration;
    const std::filesystem::path own = calibration_folder(work);
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Load the calibration of this device",
                  .extensions = {".json"},
                  .take =
                      [&](const std::filesystem::path& file) {
                          use_calibration(ui, work, timeline, rendered, play, file);
                      }},
                 !last.empty()   ? last.parent_path()
                 : is_there(own) ? own
                                 : work.document.path.parent_path());
}

void use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                     PlayState& play, const std::filesystem::path& path) {
    DeviceChoice choice = play.choice;
    choice.calibration = path.string();
    choose_device(ui, timeline, play, choice);
    follow_calibration(ui, work, rendered, play);
    if (play.calibration && !ui.status.is_error) say(ui, calibration_text(play) + ".");
}

std::string calibration_text(const PlayState& play) {
    if (!play.calibration) return {};
    const Calibration& made = *play.calibration;
    std::string text = "Calibrated";
    if (!made.actuator.empty()) text += ": " + made.actuator;
    if (!made.date.empty()) text += ", " + made.date;
    return text + ", " + significant(made.points.front().frequency_hz) + "\u2013" +
           significant(made.points.back().frequency_hz) + " Hz";
}

DrivenBy driven_by(const PlayState& play) {
    // A phone's motor has no strength in g, and protects itself.
    if (is_phone(play.choice.id)) return {nullptr, play.phone_full_scale_g, false, false};
    return {play.calibration, play.full_scale_g, play.is_protected, play.for_ear};
}

DriveRequest drive_request(const PlayState& play, const Vibration& vibration) {
    return {0, vibration, driven_by(play), false};
}

namespace {

Waveform waveform_for(const DriveRequest& request) {
    const auto* pattern = std::get_if<Pattern>(&request.vibration.source);
    const auto* layered = std::get_if<LayeredPattern>(&request.vibration.source);
    if (request.by.for_ear && pattern != nullptr) return render(for_ear(*pattern));
    if (request.by.for_ear && layered != nullptr) return render(for_ear(*layered));
    return waveform_of(request.vibration);
}

}  // namespace

MadeDrive made_drive(const DriveRequest& request) {
    const Waveform waveform = waveform_for(request);
    MadeDrive made{request, {}, {}};
    if (request.by.for_ear && !recordings_in(request.vibration).empty()) {
        const bool whole = std::holds_alternative<Measurement>(request.vibration.source);
        made.remark = request.vibration.name + (whole ? " is" : " has a layer that is") +
                      " a recording: it is heard unchanged, not two octaves up.";
    }
    if (!request.by.calibration) {
        ProtectedDrive kept = protected_drive(drive_of(waveform, request.by.full_scale_g),
                                              request.loops, request.by.is_protected);
        made.drive = std::move(kept.drive);
        if (kept.remark.empty()) return made;
        if (!made.remark.empty()) made.remark += " ";
        made.remark += request.vibration.name + " " + kept.remark + ".";
        return made;
    }
    CalibratedDrive driven = calibrated_drive(waveform, *request.by.calibration, request.loops);
    made.drive = std::move(driven.drive);
    for (const std::string& warning : driven.warnings) {
        made.remark += (made.remark.empty() ? request.vibration.name + " " : "; it ") + warning;
    }
    if (!made.remark.empty()) made.remark += ".";
    return made;
}

}  // namespace tact
