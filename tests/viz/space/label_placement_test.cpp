#include "viz/space/label_placement.h"

#include <doctest/doctest.h>

#include <random>

namespace tact::label_placement_test {
namespace {

const Rect kPane{{0, 0}, {640, 400}};

struct Crowd {
    std::vector<Disc> discs;
    std::vector<LabelRequest> requests;
};

// Points evenly or in `clusters` tight groups, each with a name.
Crowd crowd(std::size_t n, std::size_t clusters, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> x(0.0F, 640.0F);
    std::uniform_real_distribution<float> y(0.0F, 400.0F);
    std::uniform_real_distribution<float> width(20.0F, 110.0F);
    std::uniform_real_distribution<float> radius(2.0F, 11.0F);
    std::normal_distribution<float> near(0.0F, 15.0F);
    std::vector<ImVec2> middles;
    for (std::size_t i = 0; i < clusters; ++i) middles.push_back({x(random), y(random)});
    Crowd result;
    for (std::size_t i = 0; i < n; ++i) {
        const ImVec2 at = clusters == 0
                              ? ImVec2{x(random), y(random)}
                              : middles[i % clusters] + ImVec2{near(random), near(random)};
        result.discs.push_back({at, radius(random)});
        result.requests.push_back({i, {width(random), 13.0F}});
    }
    return result;
}

}  // namespace

TEST_CASE("labels: none covers another, a point or the pane's edge, in the open and in clusters") {
    const std::vector<Rect> occupied{{{0, 330}, {70, 400}}};
    for (unsigned seed = 0; seed < 40; ++seed) {
        for (const std::size_t clusters : {0U, 1U, 5U}) {
            const Crowd c = crowd(10 + 7 * seed, clusters, seed);
            const auto placed = place_labels(c.requests, {c.discs, occupied, kPane, 3.0F});
            REQUIRE(placed.size() == c.requests.size());
            for (std::size_t i = 0; i < placed.size(); ++i) {
                if (!placed[i]) continue;
                CHECK(kPane.contains(*placed[i]));
                CHECK_FALSE(placed[i]->intersects(occupied[0]));
                for (std::size_t j = 0; j < i; ++j) {
                    if (placed[j]) CHECK_FALSE(placed[i]->intersects(*placed[j]));
                }
                for (const Disc& d : c.discs) {
                    CHECK(squared_distance(*placed[i], d.centre) >= d.radius * d.radius);
                }
            }
        }
    }
}

TEST_CASE("labels: the most important one that fits alone is always shown") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Crowd c = crowd(40, 0, seed);
        const LabelRequest first = c.requests.front();
        const auto alone = place_labels(std::span{&first, 1}, {c.discs, {}, kPane, 3.0F});
        const auto among = place_labels(c.requests, {c.discs, {}, kPane, 3.0F});
        CHECK(among.front().has_value() == alone.front().has_value());
    }
}

TEST_CASE("labels: far apart points are all named, right of them") {
    std::vector<Disc> discs;
    std::vector<LabelRequest> requests;
    for (std::size_t i = 0; i < 12; ++i) {
        discs.push_back({{60.0F + 150.0F * static_cast<float>(i % 4),
                          60.0F + 120.0F * static_cast<float>(i / 4)},
                         5.0F});
        requests.push_back({i, {50.0F, 13.0F}});
    }
    const auto placed = place_labels(requests, {discs, {}, kPane, 3.0F});
    for (std::size_t i = 0; i < 12; ++i) {
        REQUIRE(placed[i].has_value());
        CHECK(placed[i]->min.x > discs[i].centre.x);
    }
}

TEST_CASE("labels: a point buried among others stays unnamed") {
    std::vector<Disc> discs{{{320, 200}, 4.0F}};
    for (int i = 0; i < 400; ++i) {
        discs.push_back({{270.0F + 5.0F * static_cast<float>(i % 20),
                          150.0F + 5.0F * static_cast<float>(i / 20)},
                         4.0F});
    }
    const LabelRequest request{0, {30.0F, 13.0F}};
    CHECK_FALSE(place_labels(std::span{&request, 1}, {discs, {}, kPane, 3.0F})[0].has_value());
}

TEST_CASE("labels: a name that has room only farther off gets a line to its point") {
    // Eight discs all around one.
    std::vector<Disc> discs{{{200, 200}, 6.0F}};
    for (int k = 0; k < 8; ++k) {
        const auto angle = static_cast<float>(k) * 0.7854F;
        discs.push_back({{200 + 17 * std::cos(angle), 200 + 17 * std::sin(angle)}, 6.0F});
    }
    const std::vector<LabelRequest> wanted{{0, {20, 12}}};
    LabelField field{discs, {}, {{0, 0}, {400, 400}}, 3.0F};
    CHECK_FALSE(place_labels(wanted, field)[0]);
    field.far_px = 16.0F;
    const auto placed = place_labels(wanted, field)[0];
    REQUIRE(placed);
    CHECK_FALSE(placed->contains(discs[0].centre));
    const auto line = leader(discs[0], *placed, field.gap_px);
    REQUIRE(line);
    CHECK(std::hypot(line->from.x - 200, line->from.y - 200) < 8.0F);
    // Beside its point a name needs none.
    CHECK_FALSE(leader(discs[0], {{209, 194}, {229, 206}}, field.gap_px));
}

TEST_CASE("labels: beside its point a name is nearer to that than to any other one") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Crowd c = crowd(40, 5, seed);
        const auto placed = place_labels(c.requests, {c.discs, {}, kPane, 3.0F, 14.0F});
        for (std::size_t i = 0; i < placed.size(); ++i) {
            const Disc& own = c.discs[c.requests[i].disc];
            if (!placed[i] || leader(own, *placed[i], 3.0F)) continue;
            const auto off = [&](const Disc& d) {
                return std::sqrt(squared_distance(*placed[i], d.centre)) - d.radius;
            };
            // A pixel where two points are in one place.
            for (const Disc& d : c.discs) CHECK(off(d) > off(own) - 1.01F);
        }
    }
}

TEST_CASE("labels: no line to a far name strikes through another name") {
    int lines = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Crowd c = crowd(40, 5, seed);
        const auto placed = place_labels(c.requests, {c.discs, {}, kPane, 3.0F, 14.0F});
        for (std::size_t i = 0; i < placed.size(); ++i) {
            const auto line =
                placed[i] ? leader(c.discs[c.requests[i].disc], *placed[i], 3.0F) : std::nullopt;
            if (!line) continue;
            ++lines;
            for (std::size_t j = 0; j < placed.size(); ++j) {
                if (i == j || !placed[j]) continue;
                for (int step = 0; step <= 50; ++step) {
                    const ImVec2 at =
                        line->from + (line->to - line->from) * (static_cast<float>(step) / 50.0F);
                    CHECK_FALSE(inset(*placed[j], 0.1F).contains(at));
                }
            }
        }
    }
    CHECK(lines > 0);
}

TEST_CASE("labels: a long name is shortened at its point's height before it goes elsewhere") {
    const std::vector<Disc> discs{{{400, 100}, 6.0F}, {{200, 100}, 6.0F}};
    const LabelRequest request{0, {220, 12}, 100.0F};
    const LabelField field{discs, {}, {{0, 0}, {420, 200}}, 3.0F};
    const auto placed = place_labels(std::span{&request, 1}, field)[0];
    REQUIRE(placed);
    CHECK(placed->max.x < 395.0F);
    CHECK(placed->min.x > 206.0F);
    CHECK(std::abs(placed->centre().y - 100.0F) <= 1.0F);
    CHECK(placed->width() >= 100.0F);
}

}  // namespace tact::label_placement_test
