// What an export costs: laws of the report, on short patterns.
#include "model/export/export_loss.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/export/ranks_among.h"

namespace export_loss_test {

using namespace tact;

namespace {

Vibration tone(const std::string& name, double amplitude_g, double frequency_hz,
               const std::string& rhythm = "") {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    if (!rhythm.empty()) pattern.rhythm = {rhythm, 0.02};
    pattern.duration_s = 0.12;
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

// Within what any target holds, but for jumps.
PatternSet six_tones() {
    PatternSet set;
    set.vibrations = {tone("a", 0.9, 80.0),         tone("b", 0.3, 80.0),
                      tone("c", 0.9, 200.0),        tone("d", 0.5, 140.0, "x-"),
                      tone("e", 0.7, 110.0, "x--"), tone("f", 0.4, 170.0, "x=-")};
    return set;
}

ExportTarget hjif() { return own_target(TargetFormat::hjif); }

// A phone that has no other frequency than this: what differs by frequency alone becomes one.
ExportTarget one_frequency(double frequency_hz) {
    ExportTarget target = own_target(TargetFormat::haptic);
    target.map.name = "one frequency";
    target.map.frequency_hz = {frequency_hz, frequency_hz};
    return target;
}

ExportTarget as_weak_as(double full_scale_g) {
    ExportTarget target = hjif();
    target.map.full_scale_g = full_scale_g;
    return target;
}

ExportLoss loss_of(const PatternSet& set, const ExportTarget& target,
                   ExportLossOptions options = {}) {
    auto loss = export_loss(set, target, options);
    REQUIRE(loss);
    return *std::move(loss);
}

Waveform waveform_back(const ExportedPattern& one) {
    Vibration vibration;
    vibration.source = one.back;
    return waveform_of(vibration);
}

bool contains(const std::vector<std::string>& remarks, const std::string& words) {
    return std::ranges::any_of(remarks,
                               [&](const std::string& one) { return one.find(words) != one.npos; });
}

}  // namespace

TEST_CASE("ranks among others: of the others themselves, their average ranks to the bit") {
    const std::vector<double> values{3.0, 1.0, 2.0, 2.0, 0.0, 5.0};
    CHECK(ranks_among(values, values) == average_ranks(values));
}

TEST_CASE("ranks among others: between two of them, below all and above all") {
    const std::vector<double> others{1.0, 2.0, 4.0};
    CHECK(ranks_among(std::vector{0.0, 1.5, 3.0, 9.0}, others) == std::vector{0.5, 1.5, 2.5, 3.5});
    CHECK(ranks_among(std::vector{7.0}, {}) == std::vector{0.5});
}

TEST_CASE("ranks among others: rounding noise makes no order") {
    const std::vector<double> others{1.0, 2.0, 4.0};
    CHECK(ranks_among(std::vector{2.0 + 1e-12}, others) == std::vector{2.0});
}

TEST_CASE("export loss: HJIF loses nothing of plain patterns, and all is as before") {
    const PatternSet set = six_tones();
    const ExportLoss loss = loss_of(set, hjif());
    for (const PatternLoss& one : loss.patterns) {
        CAPTURE(one.name);
        CHECK(one.remarks.empty());
        CHECK(one.rms_error_g < 1e-9);  // times are read back within rounding
        CHECK(one.moved == 0.0);
    }
    CHECK(loss.before == loss.after);
    CHECK(loss.most_moved.empty());
    CHECK(loss.closest_before == loss.closest_after);
    REQUIRE(loss.subset);
    CHECK(loss.subset->is_still_best);
    CHECK(loss.subset->meant == loss.subset->best);
    CHECK(best_for_target(loss) == loss.subset->meant.best.members);
    CHECK(loss.subset->weakest.dissimilarity == loss.subset->meant.best.weakest_dissimilarity);
    REQUIRE(loss.map);
    CHECK((loss.map->before - loss.map->after).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("export loss: before is the PM that the program predicts of the set") {
    const PatternSet set = six_tones();
    const auto prediction = predict(model_waveforms(set), set.model);
    const ExportLoss loss = loss_of(set, one_frequency(150.0));
    CHECK(loss.before == prediction->pm);
    ExportLossOptions options;
    options.known = &*prediction;
    const ExportLoss known = loss_of(set, one_frequency(150.0), options);
    CHECK(known.before == loss.before);
    CHECK(known.after == loss.after);
}

TEST_CASE("export loss: what comes back alike is as close as can be, and says why") {
    PatternSet set = six_tones();
    set.vibrations[1] = tone("b", 0.9, 200.0);  // c again, but for the name
    set.vibrations[0] = tone("a", 0.9, 230.0);
    const ExportLoss loss = loss_of(set, one_frequency(200.0));
    // a, b and c are one tone of 200 Hz now.
    CHECK(loss.after(0, 2) < loss.before(0, 2));
    CHECK(loss.after(0, 1) == loss.after(1, 2));
    CHECK(contains(loss.patterns[0].remarks, "230 Hz is out of the band"));
    CHECK(loss.patterns[1].remarks.empty());
    CHECK(loss.patterns[0].moved > 0.0);
    REQUIRE(loss.closest_after);
    CHECK(loss.closest_after->dissimilarity == loss.after(0, 1));
}

TEST_CASE("export loss: where all become one, all are closer than any two were meant to be") {
    PatternSet set;
    set.vibrations = {tone("low", 0.5, 60.0), tone("middle", 0.5, 130.0), tone("high", 0.5, 240.0)};
    const ExportLoss loss = loss_of(set, one_frequency(150.0));
    const double least = *std::ranges::min_element(loss.before.condensed);
    for (const double after : loss.after.condensed) CHECK(after < least);
}

TEST_CASE("export loss: patterns that come back longer are compared at that length") {
    PatternSet set = six_tones();
    for (Vibration& one : set.vibrations) std::get<Pattern>(one.source).duration_s = 0.007;
    const ExportLoss loss = loss_of(set, own_target(TargetFormat::android_xml));
    CHECK(contains(loss.patterns[0].remarks, "s in place of"));
    CHECK(loss.patterns[0].rms_error_g > 0.0);
}

TEST_CASE("export loss: the verdict turns where the target makes two of the subset one") {
    PatternSet set;  // two that differ in frequency alone, and two that are almost one
    set.vibrations = {tone("low", 0.5, 60.0), tone("high", 0.5, 240.0),
                      tone("pulses", 0.5, 150.0, "x-"), tone("pulses 2", 0.45, 150.0, "x-")};
    ExportLossOptions options;
    options.subset_count = 3;
    const ExportLoss kept = loss_of(set, hjif(), options);
    REQUIRE(kept.subset);
    CHECK(kept.subset->is_still_best);
    const std::vector<std::size_t> meant = kept.subset->meant.best.members;
    const bool has_both = std::ranges::binary_search(meant, std::size_t{0}) &&
                          std::ranges::binary_search(meant, std::size_t{1});
    REQUIRE(has_both);
    const ExportLoss merged = loss_of(set, one_frequency(150.0), options);
    REQUIRE(merged.subset);
    CHECK(merged.subset->meant == kept.subset->meant);
    CHECK_FALSE(merged.subset->is_still_best);
    CHECK(best_for_target(merged) == merged.subset->best.best.members);
    CHECK(merged.subset->best.proof == SubsetProof::optimal);
    CHECK(merged.subset->weakest.a == 0);
    CHECK(merged.subset->weakest.b == 1);
    CHECK(merged.subset->weakest.dissimilarity == merged.after(0, 1));
    CHECK(merged.subset->weakest.dissimilarity < merged.subset->meant.best.weakest_dissimilarity);
    CHECK(merged.subset->kept.weakest_dissimilarity <
          merged.subset->best.best.weakest_dissimilarity);
}

TEST_CASE("export loss: what is best for the target is what the exported set by itself says") {
    const PatternSet set = six_tones();
    const ExportTarget target = one_frequency(150.0);
    const ExportLoss loss = loss_of(set, target);
    const auto exported = exported_set(set, target);
    const Prediction prediction = *predict(model_waveforms(exported->back), set.model);
    REQUIRE(loss.subset);
    CHECK(loss.subset->best == *most_distinct_subset(prediction.pm, loss.subset->problem));
}

TEST_CASE("export loss: twice the loss is twice the error, 6 dB, and farther from what was meant") {
    PatternSet set = six_tones();
    // Loud ones: full scale turns them down, the weak ones stay.
    set.vibrations[0] = tone("a", 2.0, 80.0);
    const ExportLoss some = loss_of(set, as_weak_as(1.5));
    const ExportLoss twice = loss_of(set, as_weak_as(1.0));
    const double rms_g = 2.0 / std::sqrt(2.0);
    CHECK(some.patterns[0].rms_error_g == doctest::Approx(0.25 * rms_g).epsilon(0.02));
    CHECK(twice.patterns[0].rms_error_g ==
          doctest::Approx(2.0 * some.patterns[0].rms_error_g).epsilon(1e-6));
    REQUIRE(some.patterns[0].psnr_db);
    REQUIRE(twice.patterns[0].psnr_db);
    CHECK(*some.patterns[0].psnr_db - *twice.patterns[0].psnr_db ==
          doctest::Approx(20.0 * std::log10(2.0)).epsilon(1e-6));
    CHECK(twice.patterns[0].moved >= some.patterns[0].moved);
    CHECK(some.patterns[0].moved > 0.0);
    CHECK(some.patterns[1].moved == 0.0);
}

TEST_CASE("export loss: pairs that moved come with the most moved first, and all did change") {
    ExportLossOptions options;
    options.most_pairs = 4;
    const ExportLoss loss = loss_of(six_tones(), one_frequency(150.0), options);
    REQUIRE(loss.most_moved.size() == 4);
    double last = std::numeric_limits<double>::infinity();
    for (const PairChange& one : loss.most_moved) {
        CHECK(one.a < one.b);
        CHECK(one.before == loss.before(one.a, one.b));
        CHECK(one.after == loss.after(one.a, one.b));
        CHECK(std::abs(one.after - one.before) > 0.0);
        CHECK(std::abs(one.after - one.before) <= last);
        last = std::abs(one.after - one.before);
    }
}

TEST_CASE("export loss: the same on any number of threads") {
    ExportLossOptions options;
    options.threads = 1;
    const ExportLoss one = loss_of(six_tones(), own_target(TargetFormat::android_xml), options);
    options.threads = 3;
    const ExportLoss three = loss_of(six_tones(), own_target(TargetFormat::android_xml), options);
    CHECK(one.patterns == three.patterns);
    CHECK(one.files == three.files);
    CHECK(one.before == three.before);
    CHECK(one.after == three.after);
    CHECK(one.subset == three.subset);
    CHECK(one.map->after == three.map->after);
}

TEST_CASE("export loss: nothing when stopped") {
    std::stop_source source;
    source.request_stop();
    ExportLossOptions options;
    options.stop = source.get_token();
    CHECK_FALSE(export_loss(six_tones(), hjif(), options));
}

TEST_CASE("export loss: of nothing, of one and of two patterns there is less to say, not nothing") {
    PatternSet set;
    CHECK(loss_of(set, hjif()).patterns.empty());
    set.vibrations = {tone("a", 0.9, 400.0)};
    const ExportLoss one = loss_of(set, own_target(TargetFormat::haptic));
    REQUIRE(one.patterns.size() == 1);
    CHECK(one.patterns[0].rms_error_g > 0.0);
    CHECK_FALSE(one.patterns[0].moved);  // no pairs to hold it against
    CHECK_FALSE(one.closest_before);
    set.vibrations.push_back(tone("b", 0.9, 60.0));
    const ExportLoss two = loss_of(set, own_target(TargetFormat::haptic));
    CHECK(two.closest_before);
    CHECK_FALSE(two.subset);
    CHECK_FALSE(two.no_subset.empty());
    CHECK_FALSE(two.map);
}

TEST_CASE("export loss: locks hold, and a subset that cannot be says why") {
    PatternSet set = six_tones();
    set.vibrations[1].locked = true;
    ExportLossOptions options;
    options.subset_count = 2;
    const ExportLoss loss = loss_of(set, one_frequency(150.0), options);
    REQUIRE(loss.subset);
    CHECK(std::ranges::binary_search(loss.subset->meant.best.members, std::size_t{1}));
    CHECK(std::ranges::binary_search(loss.subset->best.best.members, std::size_t{1}));
    options.subset_count = 7;
    const ExportLoss none = loss_of(set, hjif(), options);
    CHECK_FALSE(none.subset);
    CHECK(none.no_subset == "7 to pick of 6: expected at most as many");
}

TEST_CASE("export loss: recordings stay as they are, and say so") {
    PatternSet set = six_tones();
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(waveform_of(set.vibrations[2]));
    set.vibrations[2].source = measurement;
    const ExportLoss loss = loss_of(set, one_frequency(150.0));
    CHECK(loss.patterns[2].recording);
    CHECK(loss.patterns[2].rms_error_g == 0.0);
    CHECK(loss.files[2].empty());
    CHECK_FALSE(loss.files[1].empty());
    const auto exported = exported_set(set, one_frequency(150.0));
    CHECK(exported->recordings == 1);
    CHECK(exported->back.vibrations[2] == set.vibrations[2]);
}

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
            CHECK(contains({loss.beside[k]}, "\"scale_g\":"));
            CHECK(loss.patterns[k].rms_error_g <= 0.5 * full_g / steps);
        }
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
    CHECK(words_on(*chosen) == "as .haptic of Meta for console-pcm holds them");
    const auto unknown = export_target_named("mp3");
    REQUIRE_FALSE(unknown);
    CHECK(unknown.error().message.find("expected a format that is written, one of haptic, ahap") !=
          std::string::npos);
    CHECK_FALSE(export_target_named("ahap:"));
    CHECK_FALSE(export_target_named("ahap:no-such"));
}

}  // namespace export_loss_test
