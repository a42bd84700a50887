// A row of likeness is a row of the matrix of the set.
#include "model/library/like.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "model/dissimilarity/dissimilarity.h"
#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model.h"

namespace likeness_test {

using namespace tact;

namespace {

Waveform tone(double hz, double g, double duration_s, const char* rhythm = "") {
    Pattern pattern;
    pattern.amplitude_g = g;
    pattern.carriers[0].frequency_hz = hz;
    pattern.duration_s = duration_s;
    if (*rhythm != '\0') pattern.rhythm = {rhythm, 0.05};
    return render(pattern);
}

// More than are in memory at once.
std::vector<Waveform> seventy() {
    std::vector<Waveform> all;
    for (int k = 0; k < 70; ++k) {
        all.push_back(
            tone(40.0 + 5.0 * k, 0.2 + 0.01 * k, 0.1 + 0.02 * (k % 13), k % 3 == 0 ? "x-x" : ""));
    }
    return all;
}

}  // namespace

TEST_CASE("likeness: NC and OC are those of a set of the two, and PM ranks the row") {
    const Waveform wanted = tone(150.0, 0.5, 0.2);
    const std::vector<Waveform> others = seventy();
    PerceptualModelParams params;
    params.nc_weight = 0.3;
    params.oc_weight = 0.7;
    const auto row = likeness_row(wanted, others, params, {.threads = 2});
    REQUIRE(row);
    for (std::size_t k = 0; k < others.size(); ++k) {
        const std::size_t samples = std::max(wanted.samples_g.size(), others[k].samples_g.size());
        const std::vector<Waveform> two{padded(wanted, samples), padded(others[k], samples)};
        const auto alone = predict(two, params);
        REQUIRE(alone);
        CHECK(row->nc[k] == alone->nc(0, 1));
        CHECK(row->oc[k] == alone->oc(0, 1));
        CHECK(row->felt[k] == is_felt(*alone->codes[1]));
    }
    const auto nc = average_ranks(row->nc);
    const auto oc = average_ranks(row->oc);
    for (std::size_t k = 0; k < others.size(); ++k) {
        CHECK(row->pm[k] == doctest::Approx(0.3 * nc[k] + 0.7 * oc[k]));
    }
    for (const int threads : {1, 3}) CHECK(likeness_row(wanted, others, params, {threads}) == row);
}

TEST_CASE("likeness: nothing is nearer than the same, and none of none") {
    const Waveform wanted = tone(90.0, 0.4, 0.3, "x-");
    std::vector<Waveform> others = seventy();
    others[41] = wanted;
    const auto row = likeness_row(wanted, others, {});
    REQUIRE(row);
    CHECK(row->nc[41] == 0.0);
    CHECK(row->oc[41] == 0.0);
    CHECK(std::ranges::min_element(row->pm) - row->pm.begin() == 41);
    const auto none = likeness_row(wanted, {}, {});
    REQUIRE(none);
    CHECK(none->pm.empty());
}

TEST_CASE("likeness: progress rises to its end, and a stop gives nothing") {
    const Waveform wanted = tone(90.0, 0.4, 0.1);
    double last = 0.0;
    bool has_risen = true;
    LikenessOptions options{.threads = 1, .progress = [&](double share) {
                                has_risen = has_risen && share >= last;
                                last = share;
                            }};
    REQUIRE(likeness_row(wanted, seventy(), {}, options));
    CHECK(has_risen);
    CHECK(last == doctest::Approx(1.0));
    std::stop_source source;
    source.request_stop();
    CHECK_FALSE(likeness_row(wanted, seventy(), {}, {.stop = source.get_token()}));
}

TEST_CASE("likeness: what lasts far longer is another thing") {
    CHECK(is_comparable(1.0, 0.01));
    CHECK_FALSE(is_comparable(1.01, 0.01));
    CHECK(is_comparable(8.0, 2.0));
    CHECK_FALSE(is_comparable(8.1, 2.0));
    CHECK(is_comparable(0.01, 60.0));
}

}  // namespace likeness_test
