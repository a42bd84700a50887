#include "devices/rumble/motor_envelope.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "devices/calibration/rendering.h"
#include "model/pattern/pattern.h"
#include "model/signal/spectrum.h"

namespace on_off_motor_test {

using namespace tact;

namespace {

constexpr double kRateHz = 10'000.0;

double rms(const std::vector<double>& samples, double from_s, double to_s) {
    const auto first = static_cast<std::size_t>(std::lround(from_s * kRateHz));
    const auto behind = static_cast<std::size_t>(std::lround(to_s * kRateHz));
    double sum = 0.0;
    for (std::size_t n = first; n < behind; ++n) sum += samples[n] * samples[n];
    return std::sqrt(sum / static_cast<double>(behind - first));
}

Waveform tone(double frequency_hz, double amplitude_g) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    return render(pattern);
}

Rendering on_phone(const Waveform& meant, double level = 1.0) {
    RenderedBy by{ActuatorKind::phone_web, 1.0};
    by.level = level;
    return rendering(by, meant);
}

}  // namespace

TEST_CASE("on-off motor: it comes up to strength and fades by its time constants") {
    const std::vector<int> ms{200, 200};
    const OnOffMotor motor{100.0, 0.020, 0.030};
    const std::vector<double> made = shaken_by(motor, ms, kRateHz, 4000);
    REQUIRE(made.size() == 4000);
    const double whole = std::sqrt(0.5);
    CHECK(std::abs(rms(made, 0.15, 0.2) - whole) <= 0.001);  // seven time constants: 1e-3
    // Over a period of 10 ms around a time constant the mean strength is that in its middle
    // within 1 %.
    CHECK(std::abs(rms(made, 0.015, 0.025) / whole - (1.0 - std::exp(-1.0))) <= 0.01);
    CHECK(std::abs(rms(made, 0.225, 0.235) / whole - std::exp(-1.0)) <= 0.01);
    CHECK(rms(made, 0.39, 0.4) <= 0.002);
}

TEST_CASE("on-off motor: silence, and nothing at all, are silent") {
    const std::vector<double> silence(1000, 0.0);
    CHECK(shaken_by(kGuessedPhoneMotor, {}, kRateHz, 1000) == silence);
    const std::vector<int> off{0, 100};
    CHECK(shaken_by(kGuessedPhoneMotor, off, kRateHz, 1000) == silence);
    CHECK(shaken_by(kGuessedPhoneMotor, off, kRateHz, 0).empty());
}

TEST_CASE("phone: any tone is played at the motor's own frequency") {
    for (const double hz : {60.0, 150.0, 300.0}) {
        const Rendering made = on_phone(tone(hz, 1.0));
        const Spectrum spectrum = amplitude_spectrum(made.waveform.samples_g, kRateHz);
        const auto peak = std::ranges::max_element(spectrum.amplitude_g);
        const auto place = static_cast<std::size_t>(peak - spectrum.amplitude_g.begin());
        CHECK(std::abs(frequency_hz(spectrum, place) - kGuessedPhoneMotor.frequency_hz) <= 1.0);
        CHECK(made.waveform.samples_g.size() == tone(hz, 1.0).samples_g.size());
        CHECK(made == on_phone(tone(hz, 1.0)));
    }
}

TEST_CASE("phone: a weaker tone is weaker, and one below the floor is nothing") {
    double before = 0.0;
    for (const double amplitude_g : {0.1, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        const double now = rms_g(on_phone(tone(160.0, amplitude_g)).waveform);
        CHECK(now > before);
        before = now;
    }
    CHECK(peak_g(on_phone(tone(160.0, 0.05)).waveform) == 0.0);
    CHECK(on_phone(tone(160.0, 0.5), 0.5).waveform == on_phone(tone(160.0, 0.25)).waveform);
    CHECK(on_phone(tone(160.0, 2.0)).clipped);
}

}  // namespace on_off_motor_test
