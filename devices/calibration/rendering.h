// What an actuator really makes of a vibration, beside what was meant, and what is lost on the way.
//
// Two bands   the bytes of every packet read back, as two sines whose phase runs on; amplitude and
//             frequency step from packet to packet
// Motors      two sines whose frequency is the motor's speed and whose amplitude its square; the
//             speed follows the duty with the motor's inertia (devices/rumble/motor_envelope.h)
// Intensity   a buzz of 160 Hz as strong as the envelope
// On, off     a phone's motor as a browser switches it (model/io/effects_out/on_off.h), with a rise
//             and a fall that are guessed (devices/rumble/motor_envelope.h)
// Voice coil  the waveform within the coil's band and within full scale; of a calibrated one what
//             its response makes of the drive that it is given, which the limiter turns down as a
//             whole
//
// Source    two bands: the protocol; a calibrated coil: its table; all else: own choices, none
//           measured.
// Input     a vibration in g; the g that full scale is taken for, or a calibration
// Output    the same length, 10 kHz; at the level that it is played at
// Left out  hysteresis of actuators, resonances of all but calibrated ones, how firmly a controller
//           is held, packets that are lost on the air.
// Exact     same input, same bits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/device/drive.h"
#include "devices/rumble/actuator_kind.h"
#include "model/common/units.h"
#include "model/signal/waveform.h"

namespace tact {

// What a device is taken to be: until it is measured, its full scale in g is a person's word.
// `calibration` is of kinds that take waveforms, for all others it counts as none.
// `level` is how strong it is played, as a share: of what was meant that share is, so that what is
// lost is the device's doing.
struct RenderedBy {
    ActuatorKind kind = ActuatorKind::joy_con;
    double full_scale_g = kFullScaleG;
    std::optional<Calibration> calibration{};
    double level = 1.0;

    bool operator==(const RenderedBy&) const = default;
};

// Full scales that a person may choose.
inline constexpr Range kFullScaleRangeG{0.01, 100.0};

// A frame that two bands were told.
struct RenderedFrame {
    double at_s = 0.0;        // its beginning
    double share_lost = 0.0;  // of its energy, that its sines are not
    bool folded = false;      // a tone below the low band became swells of 160 Hz
    bool noise = false;       // noise or a click became a tone of its level

    bool operator==(const RenderedFrame&) const = default;
};

// Mean squares within a band of the spectrum.
struct BandEnergy {
    double low_hz = 0.0;
    double high_hz = 0.0;
    double intended_g2 = 0.0;
    double rendered_g2 = 0.0;
    double share_lost =
        0.0;  // of the intended, that the rendered has not; 0 where nothing is meant

    bool operator==(const BandEnergy&) const = default;
};

struct Rendering {
    RenderedBy by;
    Waveform waveform;
    std::vector<RenderedFrame> frames;  // of kinds with two bands
    std::vector<BandEnergy> bands;      // over the whole spectrum, in order
    double share_lost = 0.0;            // of all intended energy
    double share_added = 0.0;           // energy where none or less was meant, as a share of it
    bool clipped = false;               // full scale is too little for it
    std::vector<std::string> warnings;  // of a calibrated drive

    bool operator==(const Rendering&) const = default;
};

Rendering rendering(const RenderedBy& by, const Waveform& intended);

// Whether the calibration counts: strengths in g are then known.
bool is_calibrated(const RenderedBy& by);

}  // namespace tact
