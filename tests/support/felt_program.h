// The program with a device that keeps what it is given.
#pragma once

#include <memory>
#include <string>

#include "app/play/play.h"
#include "devices/device/memory_device.h"
#include "devices/device/protection.h"
#include "tests/support/program.h"

namespace tact {

// The only device that is listed, with two channels, and it is open; it is for the caller to
// choose.
inline MemoryDevice* plug_in(App& app, const std::string& name) {
    DeviceInfo info;
    info.id = "audio/test/" + name;
    info.name = name;
    info.channels = {"left", "right"};
    app.play.listed = std::make_shared<const Listing>(Listing{info});
    auto device = std::make_unique<MemoryDevice>(true);
    MemoryDevice* const plugged_in = device.get();
    app.play.device = std::move(device);
    app.timeline.playhead.speed = 1.0;
    return plugged_in;
}

struct FeltProgram : Program {
    MemoryDevice* device = nullptr;

    explicit FeltProgram(std::size_t patterns = 3) : Program(short_patterns(patterns)) {
        device = plug_in(app, "memory");
        app.play.choice = app.play.opened =
            remembered_choice(app.play, app.play.listed->front().id);
        app.timeline.playhead.loop = false;
        settle();
    }

    void space() {
        window.press(key::kSpace, U' ');
        settle();
    }

    Drive drive_of_pattern(std::size_t index) const {
        return drive_of(waveform_of(app.work.document.set.vibrations[index]), 1.0);
    }

    bool plays(std::size_t index) const {
        if (!device->playing()) return false;
        const Drive whole = drive_of_pattern(index);
        return *device->playing() == protected_drive(whole, device->looping(), true).drive;
    }

    void wait(double seconds) {
        for (double s = 0.0; s < seconds; s += window.frame_s) frame();
    }
};

}  // namespace tact
