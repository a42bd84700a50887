#include "app/map/map.h"

#include "app/jobs/jobs.h"
#include "model/io/set/set_file.h"
#include "tests/support/places.h"
#include "tests/support/program.h"

namespace live_map_test {

using namespace tact;

namespace {

LiveMapRequest request_of(const PatternSet& set, bool preview) {
    return {1, 1, std::make_shared<const PatternSet>(set), 3, preview};
}

}  // namespace

TEST_CASE("live map: sets of a usual size need no asking, long or very large ones do") {
    CHECK_FALSE(needs_asking(short_patterns(0)));
    CHECK_FALSE(needs_asking(short_patterns(300)));
    CHECK(needs_asking(short_patterns(kMostLivePatterns + 1)));
    PatternSet minutes = short_patterns(100);
    std::get<Pattern>(minutes.vibrations[3].source).duration_s = 60.0;
    std::get<Pattern>(minutes.vibrations[4].source).duration_s = 60.0;
    CHECK(needs_asking(minutes));
    CHECK(expected_map_s(short_patterns(24)) > 4.0 * expected_map_s(short_patterns(12)));
}

TEST_CASE("live map: a pair is expected to take the product of its own lengths") {
    const double half_s = expected_map_s({0.5, 0.5});
    CHECK(half_s > 0.0);
    CHECK(expected_map_s({1.0, 1.0}) == doctest::Approx(4.0 * half_s));
    // The third is the longest and sounds to its end: its pairs are as long as it on both sides.
    CHECK(expected_map_s({0.49, 0.49, 2.0}) == doctest::Approx(half_s + 2.0 * 16.0 * half_s));
    // One clip of 6 s among a hundred of half a second: far less than if all were that long.
    std::vector<double> one_long(100, 0.5);
    one_long.push_back(6.0);
    CHECK(expected_map_s(one_long) < expected_map_s(101, 6.0) / 25.0);
    CHECK(expected_map_s(std::vector<double>{}) == 0.0);
    CHECK(expected_map_s(std::vector<double>{1.0}) == 0.0);
    // Where waiting costs, silence is compared, too.
    PatternSet waits = short_patterns(5);
    std::get<Pattern>(waits.vibrations[3].source).duration_s = 6.0;
    const double free_s = expected_map_s(waits);
    waits.model.envelope.waiting_cost = 0.1;
    CHECK(expected_map_s(waits) > 1.5 * free_s);
    CHECK(expected_map_s(waits) == doctest::Approx(expected_map_s(5, 6.0)));
}

TEST_CASE("live map: other names and locks are the same work, another sound or map is not") {
    PatternSet set = short_patterns(4);
    const LiveMapRequest request = request_of(set, false);
    set.vibrations[1].name = "another";
    set.vibrations[2].locked = true;
    LiveMapRequest same = request_of(set, false);
    same.revision = 9;
    CHECK(is_same_work(request, same));
    LiveMapRequest other = same;
    other.dimensions = 2;
    CHECK_FALSE(is_same_work(request, other));
    CHECK_FALSE(is_same_work(request, request_of(set, true)));
    std::get<Pattern>(set.vibrations[3].source).amplitude_g = 2.0;
    CHECK_FALSE(is_same_work(request, request_of(set, false)));
    CHECK_FALSE(is_same_work(request, request_of(short_patterns(5), false)));
}

TEST_CASE("live map: a stopped run answers nothing, and the next one starts from before it") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    const PatternSet set = short_patterns(5);
    const auto first = work(request_of(set, false), {}, progress);
    REQUIRE(first.has_value());
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(work(request_of(short_patterns(6), false), stop.get_token(), progress).has_value());
    const auto again = work(request_of(set, false), {}, progress);
    CHECK(again->prediction.pm == first->prediction.pm);
    CHECK(again->space.points == first->space.points);
    CHECK(again->prediction.codes == first->prediction.codes);  // the very same, not computed again
}

TEST_CASE("live map: a set as it was some edits ago is not computed again") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    PatternSet set = short_patterns(6);
    const auto first = work(request_of(set, false), {}, progress);
    for (int edit = 0; edit < 5; ++edit) {
        std::get<Pattern>(set.vibrations[2].source).amplitude_g = 2.0 + edit;
        CHECK(work(request_of(set, false), {}, progress)->prediction.pm != first->prediction.pm);
    }
    LiveMapRequest undone = request_of(short_patterns(6), false);
    undone.revision = 17;
    const auto again = work(undone, {}, progress);
    CHECK(again->request.revision == 17);
    CHECK(again->seconds == first->seconds);  // the very same answer
    CHECK(again->prediction.codes == first->prediction.codes);
    CHECK(again->space.points == first->space.points);
    // Two dimensions are another question.
    undone.dimensions = 2;
    CHECK(work(undone, {}, progress)->space.points.cols() == 2);
}

TEST_CASE("live map: a preview says so and keeps the size of the set") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    const auto preview = work(request_of(short_patterns(7), true), {}, progress);
    CHECK(preview->prediction.envelope_decimation > 1);
    CHECK(preview->space.points.rows() == 7);
    CHECK(preview->request.preview);
}

TEST_CASE("live map: an edit of one pattern renders and codes no other, and costs no bit") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    PatternSet set = short_patterns(8);
    const auto first = work(request_of(set, false), {}, progress);
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 2.0;
    const auto edited = work(request_of(set, false), {}, progress);
    for (std::size_t k = 0; k < 8; ++k) {
        CHECK((edited->prediction.codes[k] == first->prediction.codes[k]) == (k != 2));
    }
    // Where one is gone, the others are known by their names.
    set.vibrations.erase(set.vibrations.begin() + 1);
    const auto fewer = work(request_of(set, false), {}, progress);
    for (std::size_t k = 1; k < 7; ++k) {
        CHECK(fewer->prediction.codes[k] == edited->prediction.codes[k + 1]);
    }
    const auto alone = LiveMapWork(1)(request_of(set, false), {}, progress);
    CHECK(fewer->prediction.pm == alone->prediction.pm);
    CHECK(fewer->space.points == alone->space.points);
    // A longer one pads all of them.
    std::get<Pattern>(set.vibrations[0].source).duration_s = 0.15;
    const auto longer = work(request_of(set, false), {}, progress);
    CHECK(longer->prediction.pm ==
          LiveMapWork(1)(request_of(set, false), {}, progress)->prediction.pm);
}

TEST_CASE("live map: after an edit exact PM is there first, its points on their way") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    std::vector<LiveMap> parts;
    const auto partly = [&](LiveMap part) { parts.push_back(std::move(part)); };
    PatternSet set = short_patterns(8);
    work.in_parts(request_of(set, false), {}, progress, partly);
    CHECK(parts.empty());  // nothing was shown that could drift
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 2.0;
    const auto map = work.in_parts(request_of(set, false), {}, progress, partly);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].request.preview);
    CHECK(parts[0].exact_share == 1.0);
    CHECK(parts[0].prediction.pm == map->prediction.pm);
    CHECK(parts[0].space.points.rows() == 8);
    CHECK_FALSE(map->request.preview);
}

TEST_CASE("live map: the longer and the more patterns are, the coarser is their preview") {
    const auto decimation = [](std::size_t patterns, double duration_s) -> std::size_t {
        PatternSet set = short_patterns(patterns);
        for (Vibration& one : set.vibrations) {
            std::get<Pattern>(one.source).duration_s = duration_s;
        }
        const auto grain = preview_grain(set);
        return grain ? grain->decimation : 0;
    };
    CHECK(decimation(12, 1.0) == 10);
    CHECK(decimation(300, 0.5) == 10);
    CHECK(decimation(1000, 1.0) == 40);
    CHECK(decimation(2000, 1.0) == 100);
    CHECK(decimation(2001, 0.1) == 0);
    CHECK(decimation(1500, 3.0) == 200);
    CHECK(decimation(2000, 5.0) == 1000);   // there is much to code as well
    CHECK(decimation(2000, 60.0) == 1000);  // however long: there is one
}

TEST_CASE("live map: with a clip of a minute a preview codes approximately, the exact map never" *
          doctest::test_suite("long")) {
    PatternSet set = short_patterns(100);
    set.vibrations.push_back(set.vibrations[0]);
    set.vibrations.back().name = "clip";
    std::get<Pattern>(set.vibrations.back().source).duration_s = 60.0;
    LiveMapWork work;
    std::atomic<float> progress = 0.0F;
    const auto preview = work(request_of(set, true), {}, progress);
    REQUIRE(preview);
    const auto is_quick = [](const auto& code) { return code->is_quick; };
    CHECK(std::ranges::count_if(preview->prediction.codes, is_quick) == 100);
    CHECK_FALSE(preview->prediction.codes.back()->is_quick);
    const auto grain = preview_grain(preview->prediction);
    REQUIRE(grain);
    CHECK(grain->most_flips > preview_grain(set)->most_flips);
    // Its first part tells what it is made from; the pairs with the clip would take minutes.
    std::stop_source stop;
    LiveMapRequest request = request_of(set, false);
    request.coarse = std::make_shared<const LiveMap>(*preview);
    int parts = 0;
    work.in_parts(request, stop.get_token(), progress, [&](const LiveMap& part) {
        CHECK(std::ranges::none_of(part.prediction.codes, is_quick));
        CHECK(part.prediction.codes.back() == preview->prediction.codes.back());
        ++parts;
        stop.request_stop();
    });
    CHECK(parts == 1);
}

TEST_CASE("live map: no preview changes more orders of pairs than is told" *
          doctest::test_suite("long")) {
    for (const char* name : {"pm_2023_twelve", "rhythms_tactspace"}) {
        CAPTURE(name);
        const auto loaded =
            read_set_file(std::string(kAssetsDir) + "/sets/" + name + ".tactspace.json");
        REQUIRE(loaded);
        const auto waveforms = model_waveforms(loaded->set);
        const auto exact = predict(waveforms, loaded->set.model);
        for (const std::size_t decimation : {10U, 40U, 100U, 200U, 400U, 1000U}) {
            CAPTURE(decimation);
            PredictOptions options;
            options.envelope_decimation = decimation;
            const auto preview = predict(waveforms, loaded->set.model, options);
            const auto& a = exact->pm.condensed;
            const auto& b = preview->pm.condensed;
            int pairs = 0;
            int flips = 0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                for (std::size_t j = i + 1; j < a.size(); ++j) {
                    if (a[i] == a[j]) continue;
                    ++pairs;
                    if ((a[i] < a[j]) != (b[i] < b[j])) ++flips;
                }
            }
            CAPTURE(100.0 * flips / pairs);
            CHECK(100 * flips <= preview_grain(*preview)->most_flips * pairs);
        }
        CHECK_FALSE(preview_grain(*exact));
    }
}

TEST_CASE("live map: after many edits it keeps the newest maps alone, with their codes") {
    LiveMapWork work(1);
    std::atomic<float> progress = 0.0F;
    PatternSet set = short_patterns(2);
    std::vector<std::weak_ptr<const PatternCode>> codes;
    for (std::size_t edit = 0; edit < kKeptMaps + 2; ++edit) {
        std::get<Pattern>(set.vibrations[0].source).amplitude_g = 0.5 + 0.01 * double(edit);
        const auto map = work(request_of(set, false), {}, progress);
        REQUIRE(map);
        codes.emplace_back(map->prediction.codes[0]);
    }
    CHECK(codes[1].expired());
    CHECK_FALSE(codes[2].expired());
    CHECK_FALSE(codes.back().expired());
}

TEST_CASE("live map: in turns of one thread it has the bits that it has at once") {
    const PatternSet set = short_patterns(9);
    std::atomic<float> progress = 0.0F;
    const auto at_once = LiveMapWork(1)(request_of(set, false), {}, progress);
    REQUIRE(at_once);
    pretend_no_threads(true);
    int turns = 0;
    {
        const auto work = std::make_shared<LiveMapWork>();
        LatestJob<LiveMapRequest, LiveMap> job(
            JobPolicy::supersede,
            [work](const LiveMapRequest& request, std::stop_token stop, std::atomic<float>& share) {
                return (*work)(request, std::move(stop), share);
            });
        job.submit(request_of(set, false));
        while (give_turn(true)) ++turns;
        REQUIRE(job.latest());
        CHECK(job.latest()->prediction.pm.condensed == at_once->prediction.pm.condensed);
        CHECK(job.latest()->space.points == at_once->space.points);
        CHECK(job.progress() > 0.5F);
    }
    pretend_no_threads(false);
    CHECK(turns >= 1);
}

}  // namespace live_map_test
