#include "app/study/study.h"

#include <algorithm>
#include <cmath>

#include "app/play/play.h"
#include "app/study/parts.h"
#include "devices/device/clip.h"
#include "devices/device/playback.h"
#include "devices/device_list.h"
#include "model/signal/pink_noise.h"
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

namespace {

constexpr double kRateHz = 48'000.0;
constexpr double kLoopS = 20.0;
constexpr const char* kOff = "Masking noise is off: ";

// Opens the output of the design, where this program has sound.
Expected<Done> open_masking(const PlayState& play, StudyState& studying,
                            const std::string& headphones) {
    if (!play.audio) {
        if (studying.masking) return Done{};
        return Error{"this program has no sound"};
    }
    const Expected<DeviceInfo> output = masking_output(play, headphones);
    if (!output) return output.error();
    DeviceChoice choice;
    choice.id = output->id;
    choice.everywhere = true;
    auto device = open_device(play.audio, *output, choice);
    if (!device) return device.error();
    studying.masking = std::move(*device);
    return Done{};
}

// By what sounds: one output may have several names.
std::string actuator_place(const PlayState& play) {
    for (const DeviceInfo& device : *play.listed) {
        if (device.id == play.choice.id) return place_of_sound(device);
    }
    return play.choice.id;
}

}  // namespace

bool is_actuators(const PlayState& play, const DeviceInfo& output) {
    return output.id == play.choice.id || place_of_sound(output) == actuator_place(play);
}

Expected<DeviceInfo> masking_output(const PlayState& play, const std::string& headphones) {
    if (!play.listed) return Error{"devices are still being looked for"};
    const DeviceInfo* wanted = nullptr;
    std::size_t outputs = 0;
    std::size_t others = 0;
    for (const DeviceInfo& device : *play.listed) {
        if (device.kind != DeviceKind::audio) continue;
        ++outputs;
        others += is_actuators(play, device) ? 0 : 1;
        if (device.id == headphones) wanted = &device;
    }
    if (outputs == 0) return Error{"there is no sound output"};
    if (others == 0) {
        return Error{"the only sound output is the actuator's: headphones need a second one"};
    }
    if (headphones.empty()) {
        return Error{"no output is chosen for the headphones in the study's design"};
    }
    if (headphones == play.choice.id || (wanted != nullptr && is_actuators(play, *wanted))) {
        return Error{"the headphones' output is the actuator's: choose another one"};
    }
    if (wanted == nullptr) {
        return Error{headphones.substr(headphones.rfind('/') + 1) +
                     ", the headphones' output, is not there: plug it in and refresh the devices"};
    }
    if (wanted->is_server && wanted->server_output.empty()) {
        return Error{wanted->name +
                     " is a sound server that does not say which output it plays on, and may take "
                     "the actuator's: choose an output itself"};
    }
    return *wanted;
}

void begin_masking(const PlayState& play, StudyState& studying, const StudyDesign& design) {
    stop_masking(studying);
    if (design.masking <= 0.0) return;
    Expected<Done> begun = open_masking(play, studying, design.headphones);
    if (begun) {
        studying.masking->set_level(design.masking);
        begun = studying.masking->play({kRateHz, pink_noise(kRateHz, kLoopS, 1)}, true);
    }
    studying.masks = static_cast<bool>(begun);
    if (!begun) studying.masking_fault = kOff + begun.error().message + ".";
}

void stop_masking(StudyState& state) {
    if (state.masking) state.masking->stop();
    state.masks = false;
    state.masking_fault.clear();
}

void follow_masking(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying) {
    if (!studying.run || !studying.masks) return;
    const DeviceStatus status = studying.masking->status();
    if (status.trouble.empty() && status.connected) return;
    studying.masks = false;
    const std::string why = status.trouble.empty() ? "its output is gone" : status.trouble;
    studying.masking_fault = "The masking noise stopped: " + why + ".";
    const bool is_at_work =
        studying.run->page != StudyPage::consent && studying.run->page != StudyPage::finished;
    if (is_at_work && !studying.run->is_asking)
        act(ui, work, play, studying, {StudyEvent::What::ask, 0, 0.0, {}, {}});
}

std::string masking_words(const StudyState& studying, const StudyDesign& design) {
    if (design.masking <= 0.0) return {};
    if (!studying.masks) {
        const std::string& fault = studying.masking_fault;
        const bool is_off = fault.starts_with(kOff);
        return "none: " + (is_off ? fault.substr(std::string(kOff).size()) : fault);
    }
    return "pink noise at " + significant(100.0 * design.masking, 2) + " % of full scale on " +
           studying.masking->status().name;
}

}  // namespace tact
