#include "app/study/study_masking.h"

#include <algorithm>

#include "app/play/playing.h"
#include "app/study/study_follow.h"
#include "devices/device_list.h"
#include "model/signal/pink_noise.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

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
