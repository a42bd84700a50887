#include "app/study/study_actuator.h"

#include <algorithm>
#include <cmath>

#include "app/play/calibrating.h"
#include "app/play/playing.h"
#include "app/study/study_follow.h"
#include "devices/device/clip.h"
#include "devices/device/playback.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

using What = StudyEvent::What;

constexpr double kOutputRateHz = 48'000.0;
// The output may run at another rate, whose samples meet other peaks.
constexpr double kRoom = 0.995;
// A device begins after it was told to, hence ends after its time; this much earlier it was cut.
constexpr double kEarlyS = 0.1;

bool is_controller(const PlayState& play) {
    const std::optional<DeviceInfo> info = chosen_device(play);
    return info && info->kind != DeviceKind::audio;
}

double largest_of(const Drive& drive, bool is_controller) {
    if (!is_controller) return static_cast<double>(clip_of(drive, kOutputRateHz, false).peak);
    double largest = 0.0;
    for (const double sample : drive.samples) largest = std::max(largest, std::abs(sample));
    return largest;
}

// The factor of all, so that the strongest is not held back at this level.
double common_factor(const std::vector<double>& peaks, double level, double ceiling) {
    const double strongest = peaks.empty() ? 0.0 : std::ranges::max(peaks);
    if (level * strongest <= ceiling) return 1.0;
    return kRoom * ceiling / (level * strongest);
}

bool is_at_work(const StudyRun& run) {
    return run.page != StudyPage::consent && run.page != StudyPage::finished;
}

// A gap is counted once, though the device forgets its count when it is opened again.
void count_dropouts(StudyActuator& actuator, std::uint64_t seen) {
    if (seen < actuator.seen_dropouts) actuator.seen_dropouts = 0;
    actuator.dropouts += static_cast<int>(seen - actuator.seen_dropouts);
    actuator.seen_dropouts = seen;
}

}  // namespace

StudyActuator study_actuator(const PlayState& play, const StudyState& studying,
                             const PatternSet& set, const std::vector<std::string>& names) {
    StudyActuator actuator;
    const DeviceStatus status = studying.device->status();
    actuator.is_there = status.connected && status.trouble.empty();
    actuator.seen_dropouts = status.dropouts;
    actuator.ceiling = is_controller(play) ? 1.0 : kCeiling;
    actuator.level = play.level;
    for (const std::string& name : names) {
        const Vibration& vibration = set.vibrations[*place_named(set, name)];
        MadeDrive made = made_drive(drive_request(play, vibration));
        if (!made.remark.empty()) actuator.remark += made.remark + " ";
        actuator.peaks.push_back(largest_of(made.drive, is_controller(play)));
        actuator.drives.push_back(std::move(made.drive));
    }
    if (!actuator.is_there) return actuator;
    const double factor = common_factor(actuator.peaks, play.level, actuator.ceiling);
    if (factor == 1.0) return actuator;
    for (Drive& drive : actuator.drives) {
        for (double& sample : drive.samples) sample *= factor;
    }
    for (double& peak : actuator.peaks) peak *= factor;
    actuator.turned_down_db = -20.0 * std::log10(factor);
    return actuator;
}

StudyDevice study_device(const PlayState& play, const StudyState& studying,
                         const StudyActuator& actuator) {
    std::string calibration = study_calibration(play);
    if (actuator.turned_down_db > 0.0) {
        calibration += ", all patterns turned down by " + significant(actuator.turned_down_db) +
                       " dB, as the strongest is too strong for the output";
    }
    // One that is listed and cannot play is felt as little as none.
    if (!actuator.is_there) return {kNoDevice, calibration, {}};
    const double buffer_ms = is_controller(play) ? 0.0 : 1e3 * play.whole_buffer_s;
    return {studying.device->status().name, calibration, {}, buffer_ms};
}

std::string strength_words(const StudyActuator& actuator) {
    std::string words;
    if (actuator.turned_down_db > 0.0) {
        words = "All patterns are turned down by " + significant(actuator.turned_down_db) +
                " dB: at this level the strongest is too strong for the output. ";
    }
    return words + actuator.remark;
}

Play play_so_far(const StudyState& state, const DeviceStatus& status) {
    const StudyActuator& actuator = state.actuator;
    Play play{.is_to_the_end = true};
    if (!actuator.is_there) return play;  // a rehearsal, which its file says
    play.is_to_the_end = status.trouble.empty() && status.connected;
    play.dropouts = actuator.dropouts;
    play.is_to_the_end = play.is_to_the_end && !status.is_warm;
    if (status.clipped && state.run && state.run->playing) {
        const double peak = actuator.peaks[*state.run->playing];
        const double most = std::min(peak > 0.0 ? actuator.ceiling / peak : actuator.level,
                                     actuator.drives[*state.run->playing].largest_level);
        // What the device says counts; how much is known from what it was given.
        const double kept = std::min(actuator.level, most) * std::max(status.kept, 1e-5);
        play.turned_down_db = std::max(20.0 * std::log10(actuator.level / kept), 0.01);
    }
    return play;
}

void lose_actuator(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                   const std::string& trouble) {
    StudyActuator& actuator = studying.actuator;
    actuator.known_trouble = trouble;
    actuator.fault = "The actuator stopped, please call the experimenter. " + trouble + ".";
    const StudyRun& run = *studying.run;
    if (is_at_work(run) && !run.is_asking) act(ui, work, play, studying, {.what = What::ask});
}

void follow_actuator(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying) {
    StudyActuator& actuator = studying.actuator;
    if (!studying.run || !actuator.is_there) return;
    const DeviceStatus status = studying.device->status();
    if (studying.run->playing) count_dropouts(actuator, status.dropouts);
    std::string trouble = status.trouble;
    if (trouble.empty() && !status.connected) trouble = status.name + " is gone";
    if (trouble.empty()) {
        actuator.known_trouble.clear();
    } else if (studying.run->playing || trouble != actuator.known_trouble) {
        return lose_actuator(ui, work, play, studying, trouble);
    }
    if (!studying.run->playing) return;
    const double left_s = studying.run->playing_until_s - ui.time_s;
    if (left_s > kEarlyS && !status.playing)
        act(ui, work, play, studying, {.what = What::cut_short});
}

}  // namespace tact
