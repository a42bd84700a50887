#include "devices/calibration/rendering.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/rumble/motor_envelope.h"
#include "model/pattern/pattern.h"
#include "model/signal/spectrum.h"
#include "tests/support/golden.h"

namespace rendering_test {

using namespace tact;

namespace {

Waveform tone(double frequency_hz, double amplitude_g) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    return render(pattern);
}

double strongest_hz(const Waveform& waveform) {
    const Spectrum spectrum = amplitude_spectrum(waveform.samples_g, waveform.rate_hz);
    const auto peak = std::ranges::max_element(spectrum.amplitude_g);
    return frequency_hz(spectrum, static_cast<std::size_t>(peak - spectrum.amplitude_g.begin()));
}

double intended_g2(const Rendering& rendering) {
    double sum = 0.0;
    for (const BandEnergy& band : rendering.bands) sum += band.intended_g2;
    return sum;
}

}  // namespace

TEST_CASE("rendering: silence is silent on every kind of device, and nothing is lost of it") {
    const Waveform silence{kModelRateHz, std::vector<double>(2000, 0.0)};
    for (const ActuatorKind kind : kActuatorKinds) {
        CAPTURE(traits(kind).key);
        const Rendering made = rendering({kind, 1.0}, silence);
        CHECK(made.waveform == silence);
        CHECK(made.share_lost == 0.0);
        CHECK(made.share_added == 0.0);
        CHECK_FALSE(made.clipped);
        CHECK(rendering({kind, 1.0}, Waveform{}).waveform.samples_g.empty());
    }
}

TEST_CASE("rendering: a tone of 160 Hz, which HD rumble has a code for, is kept whole") {
    for (const ActuatorKind kind : {ActuatorKind::joy_con, ActuatorKind::switch_pro}) {
        const Rendering made = rendering({kind, 1.0}, tone(160.0, 0.5));
        CHECK(std::abs(strongest_hz(made.waveform) - 160.0) <= 1.0);
        CHECK(std::abs(rms_g(made.waveform) / rms_g(tone(160.0, 0.5)) - 1.0) <= 0.011);
        CHECK(made.share_lost <= 0.03);  // half a step of the amplitude, squared
        CHECK(made.share_added <= 0.03);
        for (const RenderedFrame& frame : made.frames) CHECK(frame.share_lost <= 1e-3);
    }
}

TEST_CASE("rendering: two tones come through HD rumble, each within half a step") {
    Pattern pattern;
    pattern.carriers = {{80.0, 0.6, 0.0}, {250.0, 0.3, 0.5}};
    const Rendering made = rendering({ActuatorKind::switch_pro, 1.0}, render(pattern));
    const Spectrum spectrum = amplitude_spectrum(made.waveform.samples_g, kModelRateHz);
    const auto largest_in = [&spectrum](double low_hz, double high_hz) {
        std::size_t best = 0;
        for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
            const double f_hz = frequency_hz(spectrum, k);
            if (f_hz < low_hz || f_hz > high_hz) continue;
            if (spectrum.amplitude_g[k] > spectrum.amplitude_g[best]) best = k;
        }
        return frequency_hz(spectrum, best);
    };
    CHECK(std::abs(largest_in(60.0, 100.0) - 80.0) <= 1.0);
    CHECK(std::abs(largest_in(200.0, 300.0) - 250.0) <= 0.0109 * 250.0 + 0.5);
    CHECK(made.share_lost <= 0.05);
}

TEST_CASE("rendering: what is above HD rumble's bands is lost, and told by band") {
    Pattern pattern;
    pattern.carriers = {{160.0, 0.5, 0.0}, {250.0, 0.3, 0.0}, {500.0, 0.3, 0.0}};
    const Rendering made = rendering({ActuatorKind::switch_pro, 1.0}, render(pattern));
    // One of the two that are equally weak finds no place.
    CHECK(std::abs(made.share_lost - 0.09 / 0.43) <= 0.05);
    for (const RenderedFrame& frame : made.frames) {
        CHECK(std::abs(frame.share_lost - 0.09 / 0.43) <= 0.05);
    }
}

TEST_CASE(
    "rendering: a motor plays 250 Hz at its own speed: all of it is lost where it was meant") {
    const Rendering made = rendering({ActuatorKind::dualshock_4, 1.0}, tone(250.0, 0.6));
    double lost = 0.0;
    for (const BandEnergy& band : made.bands) {
        if (band.low_hz < 250.0 && 250.0 < band.high_hz) lost = band.share_lost;
    }
    CHECK(lost > 0.9);
    CHECK(made.share_lost > 0.9);
    CHECK(made.share_added > 0.3);
    // sqrt 0.6 of the weak motor's full speed.
    CHECK(std::abs(strongest_hz(made.waveform) - std::sqrt(0.6) * kWeakMotor.full_speed_hz) <= 6.0);
}

TEST_CASE(
    "rendering: a motor comes up to strength after the vibration has, and rings on behind it") {
    Pattern pattern;
    pattern.carriers[0].frequency_hz = 200.0;
    pattern.rhythm = {"-x-", 0.2};
    pattern.duration_s = 0.6;
    const Waveform meant = render(pattern);
    const Rendering made = rendering({ActuatorKind::dualshock_4, 1.0}, meant);
    const auto energy = [&made](std::size_t from, std::size_t to) {
        double sum = 0.0;
        for (std::size_t n = from; n < to; ++n) {
            sum += made.waveform.samples_g[n] * made.waveform.samples_g[n];
        }
        return sum / static_cast<double>(to - from);
    };
    CHECK(energy(2000, 2200) < 0.3 * energy(3600, 3900));
    CHECK(energy(4000, 4300) > 0.01 * energy(3600, 3900));
    CHECK(energy(5700, 6000) < 1e-3 * energy(3600, 3900));
}

TEST_CASE("rendering: at a level every kind is as much weaker, and nothing more is lost") {
    for (const ActuatorKind kind : kActuatorKinds) {
        CAPTURE(traits(kind).key);
        // Has no strength, and nothing below its floor (tests/devices/rumble/on_off_motor_test).
        if (traits(kind).language == Language::on_off) continue;
        for (const double amplitude_g : {0.3, 0.9}) {
            const Waveform meant = tone(250.0, amplitude_g);
            const Rendering whole = rendering({kind, 1.0}, meant);
            RenderedBy by{kind, 1.0};
            by.level = 0.1;
            const Rendering tenth = rendering(by, meant);
            // Steps of the amplitude table, 2^(1/16) at that strength and coarser than of duties.
            CHECK(std::abs(rms_g(tenth.waveform) / rms_g(whole.waveform) / 0.1 - 1.0) <= 0.09);
            CHECK(std::abs(tenth.share_lost - whole.share_lost) <= 0.15);
        }
    }
}

TEST_CASE("rendering: what is too strong at full level is whole at a lower one") {
    RenderedBy by{ActuatorKind::dualshock_4, 1.0};
    CHECK(rendering(by, tone(250.0, 4.0)).clipped);
    by.level = 0.2;
    const Rendering made = rendering(by, tone(250.0, 4.0));
    CHECK_FALSE(made.clipped);
    CHECK(
        std::abs(rms_g(made.waveform) /
                     rms_g(rendering({ActuatorKind::dualshock_4, 1.0}, tone(250.0, 0.8)).waveform) -
                 1.0) <= 0.01);
}

TEST_CASE("rendering: a voice coil keeps what is in its band, sample by sample") {
    const Waveform meant = tone(150.0, 0.8);
    const Rendering made = rendering({ActuatorKind::voice_coil, 1.0}, meant);
    for (std::size_t n = 1000; n < 9000; ++n) {
        CHECK(std::abs(made.waveform.samples_g[n] - meant.samples_g[n]) <= 0.01);
    }
    CHECK(rendering({ActuatorKind::voice_coil, 1.0}, tone(3.0, 0.8)).share_lost > 0.99);
}

TEST_CASE("rendering: strength follows full scale, and what is beyond it is told") {
    const Rendering small = rendering({ActuatorKind::switch_pro, 1.0}, tone(160.0, 0.5));
    const Rendering large = rendering({ActuatorKind::switch_pro, 4.0}, tone(160.0, 2.0));
    for (std::size_t n = 0; n < small.waveform.samples_g.size(); ++n) {
        CHECK(std::abs(large.waveform.samples_g[n] - 4.0 * small.waveform.samples_g[n]) <= 1e-9);
    }
    CHECK_FALSE(large.clipped);
    const Rendering over = rendering({ActuatorKind::switch_pro, 1.0}, tone(160.0, 2.0));
    CHECK(over.clipped);
    CHECK(peak_g(over.waveform) <= 1.01);
    CHECK(over.share_lost > 0.7);
}

TEST_CASE("rendering: the bands' energies are the waveform's") {
    const Waveform meant = golden::noise(3, 9999, 0.7);
    const Rendering made = rendering({ActuatorKind::joy_con, 1.0}, meant);
    CHECK(std::abs(intended_g2(made) - rms_g(meant) * rms_g(meant)) <= 1e-9);
    double rendered_g2 = 0.0;
    for (const BandEnergy& band : made.bands) rendered_g2 += band.rendered_g2;
    CHECK(std::abs(rendered_g2 - rms_g(made.waveform) * rms_g(made.waveform)) <= 1e-9);
    CHECK(made == rendering({ActuatorKind::joy_con, 1.0}, meant));
}

TEST_CASE("rendering: kinds are called by their keys, and a wrong one lists them") {
    for (const ActuatorKind kind : kActuatorKinds) {
        CHECK(*actuator_kind_named(traits(kind).key) == kind);
    }
    const std::string message = actuator_kind_named("wii").error().message;
    CHECK(message.find("\"wii\"") != std::string::npos);
    CHECK(message.find("joy-con, switch-pro") != std::string::npos);
}

namespace {

// Response of a coil that gives most at 80 Hz.
Calibration resonant_coil() {
    Calibration calibration;
    calibration.actuator = "coil";
    for (const auto& [frequency_hz, g] : {std::pair{20.0, 0.3},
                                          {40.0, 1.0},
                                          {80.0, 4.0},
                                          {160.0, 2.0},
                                          {320.0, 1.0},
                                          {500.0, 0.6}}) {
        calibration.points.push_back({frequency_hz, g, 0.6, 0.01, 0.01});
    }
    return calibration;
}

Waveform on_coil(double frequency_hz, double amplitude_g) {
    return rendering({ActuatorKind::voice_coil, 1.0, resonant_coil()},
                     tone(frequency_hz, amplitude_g))
        .waveform;
}

}  // namespace

TEST_CASE("rendering: a calibrated coil gives what was meant where its table reaches") {
    const Waveform meant = tone(150.0, 0.7);
    const Waveform made = on_coil(150.0, 0.7);
    REQUIRE(made.samples_g.size() == meant.samples_g.size());
    double worst_g = 0.0;
    for (std::size_t n = 500; n + 500 < meant.samples_g.size(); ++n) {
        worst_g = std::max(worst_g, std::abs(made.samples_g[n] - meant.samples_g[n]));
    }
    // The onset has frequencies beyond the table, whose ringing dies away.
    CHECK(worst_g < 0.01 * 0.7);
}

TEST_CASE("rendering: a calibrated coil is turned down to its limiter, and says so") {
    // 0.6 g at 500 Hz is its full scale; the limiter leaves 80 %.
    const Rendering made =
        rendering({ActuatorKind::voice_coil, 1.0, resonant_coil()}, tone(500.0, 3.0));
    CHECK(made.clipped);
    CHECK(made.warnings.size() == 2);  // more than the output gives, and than was measured
    CHECK(peak_g(made.waveform) < 0.6);
    CHECK(peak_g(made.waveform) > 0.8 * 0.6 * 0.8);
}

TEST_CASE("rendering: beyond its table a calibrated coil is given nothing, and gives nothing") {
    const Rendering made =
        rendering({ActuatorKind::voice_coil, 1.0, resonant_coil()}, tone(900.0, 0.5));
    CHECK(made.share_lost > 0.99);
    CHECK(made.waveform.samples_g.size() == tone(900.0, 0.5).samples_g.size());
}

TEST_CASE("rendering: a calibration changes nothing of a controller, whose packets it is not of") {
    const RenderedBy plain{ActuatorKind::joy_con, 1.0};
    const RenderedBy with{ActuatorKind::joy_con, 1.0, resonant_coil()};
    CHECK_FALSE(is_calibrated(with));
    CHECK(rendering(plain, tone(150.0, 0.5)).waveform ==
          rendering(with, tone(150.0, 0.5)).waveform);
}

}  // namespace rendering_test
