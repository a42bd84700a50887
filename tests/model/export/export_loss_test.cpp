// What an export costs: laws of the report, on short patterns.
#include "model/export/export_loss.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/model/export/exported_tones.h"

namespace export_loss_test {

using namespace tact;

namespace {

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

}  // namespace

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

TEST_CASE("export loss: with the weakest pair as far apart, the larger sum is the better one") {
    SubsetChange change;
    change.kept = {{0, 1, 2}, {0, 1}, 3.0, 12.0};
    change.best.best = {{0, 1, 3}, {0, 1}, 3.0, 12.5};
    CHECK_FALSE(is_best_there(change));
    change.best.best.sum = 12.0;
    CHECK(is_best_there(change));
    change.best.best.weakest_dissimilarity = 3.5;
    CHECK_FALSE(is_best_there(change));
}

TEST_CASE("export loss: what the target silences is named, and neither kept nor recommended") {
    PatternSet set;
    set.vibrations = {tone("low", 0.5, 80.0), tone("high", 0.5, 420.0),
                      tone("pulses", 0.5, 80.0, "x-"), tone("slow", 0.5, 80.0, "x--")};
    // A device that plays no transients.
    Pattern taps = std::get<Pattern>(tone("taps", 0.0, 80.0).source);
    taps.transients = {{0.02, 0.8, 120.0, 0.02}};
    Vibration tapping;
    tapping.name = "taps";
    tapping.source = taps;
    set.vibrations.push_back(tapping);
    ExportTarget target = own_target(TargetFormat::haptic);
    target.map.transient_gain = 0.0;
    ExportLossOptions options;
    options.subset_count = 3;
    const ExportLoss loss = loss_of(set, target, options);
    CHECK(loss.patterns[4].silenced);
    CHECK(loss.patterns[4].remarks.back() == "nothing of this can be felt on the target");
    CHECK_FALSE(loss.patterns[0].silenced);
    REQUIRE(loss.subset);
    CHECK(loss.subset->silenced == std::vector<std::size_t>{4});
    CHECK_FALSE(std::ranges::binary_search(best_for_target(loss), std::size_t{4}));
    CHECK(std::ranges::binary_search(loss.subset->meant.best.members, std::size_t{4}));
    CHECK_FALSE(loss.subset->is_still_best);
    options.subset_count = 5;
    const ExportLoss none = loss_of(set, target, options);
    CHECK_FALSE(none.subset);
    CHECK(none.no_subset.starts_with("too few patterns can be felt on the target: 5 to pick"));
}

// For each format its own actuator, one that plays no transients, one that plays nothing else, and
// one so weak that little is felt.
std::vector<ExportTarget> hard_targets() {
    std::vector<ExportTarget> all;
    for (const TargetTraits& format : target_formats()) {
        const ExportTarget own = own_target(*target_format_of(format.key));
        for (std::size_t which = 0; which < 4; ++which) {
            ExportTarget target = own;
            if (which == 1) target.map.transient_gain = 0.0;
            if (which == 2) target.map.continuous_gain = 0.0;
            if (which == 3) target.map.full_scale_g = 0.01;
            all.push_back(target);
            if (is_sampled(target.format)) break;
        }
    }
    return all;
}

TEST_CASE("export loss: in no format is anything silent kept, recommended, or unsaid" *
          doctest::test_suite("long")) {
    PatternSet set;
    set.vibrations = {tone("low", 0.5, 80.0), tone("high", 0.5, 420.0),
                      tone("pulses", 0.5, 80.0, "x-"), tone("faint", 0.02, 200.0)};
    for (const double time_s : {0.0, 0.03}) {
        Pattern taps = std::get<Pattern>(tone("taps", 0.0, 80.0).source);
        taps.transients = {{time_s, 0.8, 120.0, 0.005}};
        Vibration tapping;
        tapping.name = "tap " + std::to_string(time_s);
        tapping.source = taps;
        set.vibrations.push_back(tapping);
    }
    ExportLossOptions options;
    options.subset_count = 3;
    for (const ExportTarget& target : hard_targets()) {
        CAPTURE(traits(target.format).key);
        CAPTURE(target.map.transient_gain);
        CAPTURE(target.map.continuous_gain);
        CAPTURE(target.map.full_scale_g);
        const ExportLoss loss = loss_of(set, target, options);
        const std::vector<std::size_t> best = best_for_target(loss);
        for (std::size_t k = 0; k < loss.patterns.size(); ++k) {
            if (!loss.patterns[k].silenced) continue;
            CHECK(loss.patterns[k].remarks.back() == kSilenced);
            CHECK_FALSE(std::ranges::binary_search(best, k));
        }
        if (!loss.subset) CHECK_FALSE(loss.no_subset.empty());
    }
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

TEST_CASE("export loss: samples of 24 bits move no pair of a set that has equal pairs") {
    PatternSet set = six_tones();
    for (const char* twin : {"a", "d"}) {
        const auto found = std::ranges::find(set.vibrations, twin, &Vibration::name);
        Vibration same = *found;
        same.name += " again";
        set.vibrations.push_back(same);
    }
    ExportTarget target = own_target(TargetFormat::wav);
    target.sampled.rate_hz = 10'000.0;  // the set's own: a filter of another rate moves jumps
    const ExportLoss loss = loss_of(set, target);
    CHECK(loss.most_moved.empty());
    CHECK(loss.before == loss.after);
    REQUIRE(loss.subset);
    CHECK(loss.subset->is_still_best);
}

TEST_CASE("export loss: as far a weakest pair with a smaller sum is not the best for the target") {
    int with_smaller_sum = 0;
    for (const double amplitude_g : {0.1, 0.2, 0.3, 0.5}) {
        for (const char* rhythm : {"x-", "x--", "x=-"}) {
            PatternSet set;  // two alike that stay in, and one more by frequency or by rhythm
            set.vibrations = {tone("a", 0.9, 150.0), tone("b", 0.88, 150.0),
                              tone("high", amplitude_g, 260.0), tone("pulses", 0.9, 150.0, rhythm)};
            set.vibrations[0].locked = true;
            set.vibrations[1].locked = true;
            ExportLossOptions options;
            options.subset_count = 3;
            const ExportLoss loss = loss_of(set, one_frequency(150.0), options);
            REQUIRE(loss.subset);
            const Subset& kept = loss.subset->kept;
            const Subset& best = loss.subset->best.best;
            if (kept.weakest_dissimilarity != best.weakest_dissimilarity || kept.sum == best.sum)
                continue;
            ++with_smaller_sum;
            CHECK_FALSE(loss.subset->is_still_best);
            CHECK(best_for_target(loss) == best.members);
        }
    }
    CHECK(with_smaller_sum > 0);
}

}  // namespace export_loss_test
