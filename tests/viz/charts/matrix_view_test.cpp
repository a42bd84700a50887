#include "viz/charts/matrix_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "tests/support/presence.h"
#include "viz/drawing/colour.h"

namespace tact::matrix_view_test {
namespace {

struct Example {
    std::vector<std::string> labels;
    std::vector<double> condensed;
};

// |i - j|, so that every value is known.
Example example(std::size_t n) {
    Example result;
    for (std::size_t i = 0; i < n; ++i) {
        result.labels.push_back("pattern " + std::to_string(i));
        for (std::size_t j = i + 1; j < n; ++j) {
            result.condensed.push_back(static_cast<double>(j - i));
        }
    }
    return result;
}

const Rect kArea{{12, 12}, {528, 388}};

MatrixScene scene_of(const Example& e) {
    return {.condensed = e.condensed, .labels = e.labels, .quantity = "PM"};
}

Image picture(const MatrixScene& scene, std::optional<ImVec2> mouse = std::nullopt,
              MatrixAction* action = nullptr, MatrixLayout* layout = nullptr,
              int* vertices = nullptr) {
    return draw_picture(540, 400, {.mouse_px = mouse}, [&](const Theme& theme) {
        const MatrixAction result = draw_matrix("matrix", theme, kArea, scene);
        if (action != nullptr) *action = result;
        if (layout != nullptr) *layout = matrix_layout(theme, kArea, scene);
        if (vertices != nullptr) *vertices = ImGui::GetWindowDrawList()->VtxBuffer.Size;
    });
}

}  // namespace

TEST_CASE("matrix: the cells of 2, 12, 100 and 1000 patterns stay inside the pane") {
    for (const std::size_t n : {2U, 12U, 100U, 1000U}) {
        const Example e = example(n);
        MatrixLayout layout;
        const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
        CHECK(kArea.contains(layout.cells));
        CHECK(layout.cells.width() > 100.0F);
        CHECK(count_pixels(image, layout.cells, closeness_colour(1.0), 30) >= 2);
        CHECK(count_pixels(image, layout.cells, dark_theme(1.0F).pane) <
              0.2F * layout.cells.width() * layout.cells.height());
    }
}

TEST_CASE("matrix: a thousand patterns cost no more cells than the bound") {
    const Example e = example(1000);
    int vertices = 0;
    picture(scene_of(e), std::nullopt, nullptr, nullptr, &vertices);
    // Four vertices per cell, and a few thousand for names and scale.
    CHECK(vertices <= static_cast<int>(4 * kMostCells * kMostCells) + 10'000);
}

TEST_CASE("matrix: a cell has the colour of its value") {
    const Example e = example(12);
    MatrixLayout layout;
    const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
    for (const auto& [i, j] : {Pair{0, 11}, {3, 5}, {10, 2}}) {
        // A corner of the cell, away from its number.
        const auto x =
            static_cast<int>(layout.cells.min.x + static_cast<float>(j) * layout.cell_px.x + 1.0F);
        const auto y =
            static_cast<int>(layout.cells.min.y + static_cast<float>(i) * layout.cell_px.y + 1.0F);
        CHECK(pixel(image, x, y) ==
              closeness_colour(std::abs(static_cast<double>(i) - static_cast<double>(j)) / 11.0));
    }
}

TEST_CASE("matrix: rows in an order look as the matrix that has them so") {
    for (const std::size_t n : {12U, 500U}) {
        CAPTURE(n);
        const Example listed = example(n);
        Example moved;
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < n; ++k) order.push_back((7 * k + 3) % n);
        for (std::size_t i = 0; i < n; ++i) {
            moved.labels.push_back(listed.labels[order[i]]);
            for (std::size_t j = i + 1; j < n; ++j) {
                const auto [a, b] = std::minmax({order[i], order[j]});
                moved.condensed.push_back(listed.condensed[pair_index(n, a, b)]);
            }
        }
        MatrixScene by_order = scene_of(listed);
        by_order.labels = moved.labels;
        by_order.order = order;
        const ImVec2 mouse{300.0F, 200.0F};  // the read-out is the pair's, too
        CHECK(picture(by_order, mouse).rgba == picture(scene_of(moved), mouse).rgba);
        CHECK(picture(by_order).rgba != picture(scene_of(listed)).rgba);
    }
}

TEST_CASE("matrix: a cell that several pairs share has the colour of their mean") {
    constexpr std::size_t kObjects = 400;
    const Example e = example(kObjects);
    MatrixLayout layout;
    const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
    REQUIRE(layout.shown < kObjects);
    REQUIRE(3 * layout.shown >= kObjects);  // so that no pair is left out
    const auto first = [&](std::size_t cell) { return cell * kObjects / layout.shown; };
    const auto middle = [&](std::size_t cell, float begin, float extent) {
        const float side = extent / static_cast<float>(layout.shown);
        return static_cast<int>(std::round(begin + static_cast<float>(cell) * side));
    };
    for (const auto& [row, column] : {Pair{0, 150}, {30, 90}, {120, 20}, {5, 5}}) {
        CAPTURE(row);
        double sum = 0.0;
        int pairs = 0;
        for (std::size_t i = first(row); i < first(row + 1); ++i) {
            for (std::size_t j = first(column); j < first(column + 1); ++j) {
                if (i == j) continue;
                sum += std::abs(static_cast<double>(i) - static_cast<double>(j));
                ++pairs;
            }
        }
        CHECK(pixel(image, middle(column, layout.cells.min.x, layout.cells.width()),
                    middle(row, layout.cells.min.y, layout.cells.height())) ==
              closeness_colour(sum / pairs / (kObjects - 1.0)));
    }
}

TEST_CASE("matrix: the mouse over a cell names its row and its column") {
    for (const std::size_t n : {2U, 12U, 100U, 1000U}) {
        const Example e = example(n);
        MatrixLayout layout;
        picture(scene_of(e), std::nullopt, nullptr, &layout);
        const Pair wanted{n - 1, n / 2 - 1};
        const ImVec2 mouse =
            layout.cells.min + ImVec2{(static_cast<float>(wanted.second) + 0.5F) * layout.cell_px.x,
                                      (static_cast<float>(wanted.first) + 0.5F) * layout.cell_px.y};
        MatrixAction action;
        picture(scene_of(e), mouse, &action);
        REQUIRE(action.hovered.has_value());
        // The mouse moves by whole pixels, which limits the rows it can tell apart.
        const auto within = [](float px) {
            return static_cast<std::size_t>(std::ceil(1.0F / px)) - 1;
        };
        CHECK(wanted.first - action.hovered->first <= within(layout.cell_px.y));
        CHECK(wanted.second - action.hovered->second <= within(layout.cell_px.x));
        CHECK_FALSE(action.clicked.has_value());
    }
}

TEST_CASE("matrix: the diagonal and the margin are no pairs") {
    const Example e = example(6);
    MatrixLayout layout;
    picture(scene_of(e), std::nullopt, nullptr, &layout);
    MatrixAction action;
    picture(scene_of(e), layout.cells.min + ImVec2{5, 5}, &action);
    CHECK_FALSE(action.hovered.has_value());
    picture(scene_of(e), ImVec2{520, 380}, &action);
    CHECK_FALSE(action.hovered.has_value());
}

TEST_CASE("matrix: unknown pairs leave a field, and less than two patterns nothing") {
    Example e = example(3);
    e.condensed[0] = NAN;
    MatrixLayout layout;
    const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
    const int x = static_cast<int>(layout.cells.min.x + 1.5F * layout.cell_px.x);
    const int y = static_cast<int>(layout.cells.min.y + 0.5F * layout.cell_px.y);
    CHECK(pixel(image, x, y) == dark_theme(1.0F).field);
    const Example one = example(1);
    picture(scene_of(one));
}

TEST_CASE("matrix: few patterns have all their names, many only some") {
    MatrixLayout few;
    MatrixLayout many;
    const Example twelve = example(12);
    const Example thousand = example(1000);
    picture(scene_of(twelve), std::nullopt, nullptr, &few);
    picture(scene_of(thousand), std::nullopt, nullptr, &many);
    CHECK(few.label_step == 1);
    CHECK(few.column_labels);
    CHECK(many.label_step > 20);
    CHECK_FALSE(many.column_labels);
}

TEST_CASE("matrix: over cells as wide as every name these lie, and leave the height to the cells") {
    Example e = example(10);
    for (std::size_t k = 0; k < e.labels.size(); ++k) e.labels[k] = "name " + std::to_string(k);
    draw_picture(10, 10, {}, [&](const Theme& theme) {
        const Rect wide{{0, 0}, {1500, 680}};
        const MatrixLayout lying = matrix_layout(theme, wide, scene_of(e));
        CHECK(lying.level_labels);
        CHECK(lying.cells.height() > 0.9F * wide.height());
        CHECK(lying.cells.width() > 0.6F * wide.width());
        CHECK_FALSE(matrix_layout(theme, kArea, scene_of(e)).level_labels);
        Example cut = e;
        cut.labels[3] = "a name that would be cut if it lay over its column";
        CHECK_FALSE(matrix_layout(theme, wide, scene_of(cut)).level_labels);
    });
}

TEST_CASE("matrix: names of one or two letters are shown") {
    for (const char* stem : {"", "k"}) {
        Example e = example(6);
        for (std::size_t i = 0; i < 6; ++i) {
            e.labels[i] = stem + std::string(1, static_cast<char>('A' + i));
        }
        MatrixLayout layout;
        const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
        for (std::size_t i = 0; i < 6; ++i) {
            const float top = layout.cells.min.y + static_cast<float>(i) * layout.cell_px.y;
            const Rect beside{{kArea.min.x, top}, {layout.cells.min.x, top + layout.cell_px.y}};
            CHECK(count_pixels(image, beside, dark_theme(1.0F).dim_text, 60) >= 5);
        }
    }
}

TEST_CASE("matrix: where all pairs are equal none is bright, except that nothing is apart") {
    Example e = example(4);
    const auto first_pair = [&e] {
        MatrixLayout layout;
        const Image image = picture(scene_of(e), std::nullopt, nullptr, &layout);
        return pixel(image, static_cast<int>(layout.cells.min.x + layout.cell_px.x + 3.0F),
                     static_cast<int>(layout.cells.min.y + 3.0F));
    };
    std::fill(e.condensed.begin(), e.condensed.end(), 3.5);
    CHECK(first_pair() == dark_theme(1.0F).hover);
    std::fill(e.condensed.begin(), e.condensed.end(), 0.0);
    CHECK(first_pair() == closeness_colour(0.0));
    // The value of a single pair says nothing about its size.
    e = example(2);
    CHECK(first_pair() == closeness_colour(1.0));
}

TEST_CASE("matrix: it fills its pane, with numbers in its cells as soon as they fit") {
    const Example e = example(10);
    const auto layout_in = [&e](ImVec2 size) {
        MatrixLayout layout;
        draw_picture(1000, 600, {}, [&](const Theme& theme) {
            layout = matrix_layout(theme, rect_at({10, 10}, size), scene_of(e));
        });
        return layout;
    };
    for (const ImVec2 size : {ImVec2{500, 250}, ImVec2{520, 380}, ImVec2{900, 500}}) {
        CAPTURE(size.x);
        const Rect area = rect_at({10, 10}, size);
        const MatrixLayout layout = layout_in(size);
        CHECK(area.contains(layout.cells));
        const float right = std::max(layout.cells.max.x, layout.scale.max.x);
        CHECK(layout.cells.max.y > area.max.y - 13.0F);  // less than a row is left
        CHECK(right > area.max.x - 110.0F);
        CHECK(layout.has_values);
    }
    CHECK_FALSE(layout_in({240, 160}).has_values);
}

TEST_CASE("matrix: of many patterns only the selected ones have numbers, in square cells") {
    const Example e = example(12);
    MatrixScene scene = scene_of(e);
    MatrixLayout layout;
    const auto inks = [&](std::size_t row) {
        const Image image = picture(scene, std::nullopt, nullptr, &layout);
        // Outside the cells of the selected column, and outside the frame around the row.
        const float top = layout.cells.min.y + static_cast<float>(row) * layout.cell_px.y;
        const Rect cells{{layout.cells.min.x + layout.cell_px.x + 3.0F, top + 3.0F},
                         {layout.cells.max.x - 3.0F, top + layout.cell_px.y - 3.0F}};
        const ImU32 white = readable_on(closeness_colour(1.0));
        return count_pixels(image, cells, white, 40);
    };
    CHECK(inks(0) == 0);
    const std::array<std::size_t, 1> first{0};
    scene.selected = first;
    CHECK(inks(0) > 20);
    CHECK(inks(5) == 0);
    CHECK(layout.cell_px.x == layout.cell_px.y);
}

TEST_CASE("matrix: what is alike is brightest") {
    double before = 2.0;
    for (int k = 0; k <= 8; ++k) {
        const double now = luminance(closeness_colour(k / 8.0));
        CHECK(now < before);
        before = now;
    }
}

}  // namespace tact::matrix_view_test
