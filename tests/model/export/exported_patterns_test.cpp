// What comes back of patterns that were exported, format by format.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "model/export/export_loss.h"
#include "model/io/formats/samples/samples.h"
#include "tests/model/export/exported_tones.h"

namespace exported_patterns_test {

using namespace tact;

namespace {

Waveform waveform_back(const ExportedPattern& one) {
    Vibration vibration;
    vibration.source = one.back;
    return waveform_of(vibration);
}

}  // namespace

TEST_CASE("export: every format comes back, silence and transients too") {
    Pattern silent;
    silent.amplitude_g = 0.0;
    silent.duration_s = 0.2;
    Pattern taps = silent;
    taps.transients = {{0.02, 0.8, 120.0, 0.02}, {0.1, 0.5, 120.0, 0.02}};
    Pattern loud = std::get<Pattern>(tone("x", 0.8, 100.0).source);
    for (const TargetTraits& one : target_formats()) {
        CAPTURE(one.key);
        const ExportTarget target = own_target(*target_format_of(one.key));
        for (const Pattern& pattern : {silent, taps, loud}) {
            const ExportedPattern made = exported(pattern, "x", target);
            CHECK_FALSE(made.text.empty());
            const bool comes_back = !contains(made.remarks, "nothing of it comes back");
            const std::string first = made.remarks.empty() ? "" : made.remarks.front();
            CAPTURE(first);
            CHECK(comes_back);
            CHECK(made.beside.empty() == std::string(one.beside).empty());
            if (is_sampled(target.format)) continue;
            // The reader takes 150 Hz where the file has none, and says so.
            const bool has_hz = !contains(made.remarks, "the device has its own frequency");
            CHECK(contains(made.remarks, "as it is read back") != has_hz);
        }
        const ExportedPattern back = exported(loud, "x", target);
        CHECK(rms_g(waveform_back(back)) > 0.1);
        const bool has_taps = one.key != std::string("android-timings");
        if (has_taps) CHECK(peak_g(waveform_back(exported(taps, "x", target))) > 0.1);
    }
}

TEST_CASE("export: it is said that silence comes back, unless the pattern was silent before") {
    Pattern silent;
    silent.amplitude_g = 0.0;
    silent.duration_s = 0.2;
    Pattern faint = silent;
    faint.amplitude_g = 1e-5;
    for (const TargetTraits& one : target_formats()) {
        CAPTURE(one.key);
        const ExportTarget target = own_target(*target_format_of(one.key));
        if (is_sampled(target.format)) continue;
        CHECK_FALSE(contains(exported(silent, "x", target).remarks, "it is silent"));
        const ExportedPattern made = exported(faint, "x", target);
        const bool silent_back = !(peak_g(waveform_back(made)) > 0.0);
        const bool said =
            contains(made.remarks, "it is silent") || contains(made.remarks, "nothing of it");
        if (silent_back) CHECK(said);
    }
}

TEST_CASE("export: samples are read back at their one full scale, recordings among them") {
    PatternSet set = six_tones();
    Measurement measured;
    Waveform waveform = waveform_of(tone("r", 3.0, 90.0));
    measured.waveform = std::make_shared<const Waveform>(waveform);
    measured.measures = "a";
    set.vibrations[5].source = measured;
    for (const auto encoding : {WaveEncoding::float32, WaveEncoding::int16, WaveEncoding::int24}) {
        ExportTarget target = own_target(TargetFormat::wav);
        target.sampled.rate_hz = kModelRateHz;
        target.sampled.encoding = encoding;
        const ExportLoss loss = loss_of(set, target);
        const double full_g = loss.target.sampled.full_scale_g;
        CHECK(full_g == full_scale_of(peak_g(waveform), encoding));
        const double steps = encoding == WaveEncoding::int16 ? 32768.0 : 8388608.0;
        for (std::size_t k = 0; k < loss.patterns.size(); ++k) {
            CHECK_FALSE(loss.patterns[k].recording);
            CHECK(contains(std::vector{loss.beside[k]}, "\"scale_g\":"));
            CHECK(loss.patterns[k].rms_error_g <= 0.5 * full_g / steps);
            // Steps of 24 bits are no difference, though no number is the same.
            if (encoding == WaveEncoding::int24) CHECK(loss.patterns[k].moved == 0.0);
        }
        if (encoding == WaveEncoding::int24) CHECK(loss.after.condensed == loss.before.condensed);
        const auto back = exported_set(set, target);
        CHECK(back->recordings == 0);
        CHECK(std::get<Measurement>(back->back.vibrations[5].source).measures == "a");
    }
    const ExportLoss csv = loss_of(set, own_target(TargetFormat::csv));
    for (const PatternLoss& one : csv.patterns) {
        CHECK(one.remarks.empty());
        CHECK(one.rms_error_g == 0.0);
        CHECK(one.moved == 0.0);
    }
    CHECK(csv.after.condensed == csv.before.condensed);
}

TEST_CASE("export: samples of another rate come back but for what the filter's ends lose") {
    const PatternSet set = six_tones();
    for (const TargetFormat format : {TargetFormat::wav, TargetFormat::csv}) {
        ExportTarget target = own_target(format);
        target.sampled.rate_hz = 44'100.0;
        const ExportLoss loss = loss_of(set, target);
        for (const PatternLoss& one : loss.patterns) {
            CHECK(contains(one.remarks, "as it is read back: resampled from 44,100 Hz"));
            CHECK(one.rms_error_g < 0.02);
        }
    }
}

TEST_CASE("export: samples have no actuator, and a chosen one is refused") {
    CHECK(own_target(TargetFormat::wav).map == ActuatorMap{});
    const auto refused = export_target_named("wav:quest");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "\"quest\": expected no actuator, wav holds g");
    ExportTarget target = own_target(TargetFormat::wav);
    CHECK(words_on(target) == "as WAV of 48,000 Hz and 24 bits holds them");
    target.sampled.full_scale_g = 1.5;
    CHECK(meaning_of(target) == "full scale: 1.5 g, said in the .wav.json beside each file");
}

TEST_CASE("export: the usual actuator is the one that was chosen when all effects were read") {
    PatternSet set = six_tones();
    const auto usual = [&] { return usual_target(TargetFormat::haptic, set).map.name; };
    CHECK(usual() == "quest");
    set.vibrations[0].effect = {"ahap", "core-haptics"};  // nobody chose it
    CHECK(usual() == "quest");
    set.vibrations[0].effect = {"ahap", "console-pcm"};
    CHECK(usual() == "console-pcm");
    set.vibrations[1].effect = {"haptic", "console-pcm"};
    CHECK(usual() == "console-pcm");
    set.vibrations[1].effect = {"haptic", "android"};
    CHECK(usual() == "quest");
    set.vibrations[0].effect = set.vibrations[1].effect = {"ahap", "my phone"};
    CHECK(usual() == "quest");
}

TEST_CASE("export: a Kotlin builder and a C initialiser come back as what they say") {
    const Pattern pattern = std::get<Pattern>(tone("x", 0.8, 100.0, "x=-").source);
    CHECK(exported(pattern, "x", own_target(TargetFormat::android_kotlin)).back ==
          exported(pattern, "x", own_target(TargetFormat::android_xml)).back);
    Pattern drawn = pattern;
    drawn.transients = {{0.03, 0.8, 120.0, 0.02}, {0.0305, 0.8, 120.0, 0.02}};
    const ExportTarget target = own_target(TargetFormat::openxr);
    const ExportedPattern c = exported(drawn, "x", target);
    CHECK(contains(c.remarks, "merged with one less than 1 ms before"));
    const auto alone = [&](double time_s) {
        return std::ranges::count_if(
            std::get<Pattern>(c.back).transients,
            [&](const Transient& one) { return std::abs(one.time_s - time_s) < 1e-9; });
    };
    CHECK(alone(0.03) == 1);
    CHECK(alone(0.0305) == 0);
    const ExportedPattern plain = exported(pattern, "x", target);
    CHECK(plain.remarks.empty());
    // Floats of nine digits.
    const ExportLoss loss = [&] {
        PatternSet set;
        set.vibrations = {tone("x", 0.8, 100.0, "x=-")};
        return loss_of(set, target);
    }();
    CHECK(loss.patterns[0].rms_error_g < 1e-6);
}

TEST_CASE("export target: FORMAT or FORMAT:ACTUATOR, else a sentence") {
    const auto own = export_target_named("ahap");
    REQUIRE(own);
    CHECK(own->map.name == "core-haptics");
    const auto chosen = export_target_named("haptic:console-pcm");
    REQUIRE(chosen);
    CHECK(chosen->format == TargetFormat::haptic);
    CHECK(chosen->map.name == "console-pcm");
    CHECK(words_on(*chosen) == "as Meta .haptic for console-pcm holds them");
    const auto unknown = export_target_named("mp3");
    REQUIRE_FALSE(unknown);
    CHECK(unknown.error().message.find("expected a format that is written, one of haptic, ahap") !=
          std::string::npos);
    CHECK_FALSE(export_target_named("ahap:"));
    CHECK_FALSE(export_target_named("ahap:no-such"));
}

}  // namespace exported_patterns_test
