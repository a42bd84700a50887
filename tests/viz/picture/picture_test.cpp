#include "viz/picture/picture.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"

namespace tact::picture_test {
namespace {

constexpr unsigned char kWhiteTexel = 255;

// Rasterises bare triangles on black; returns the image.
Image triangles(const std::vector<ImVec2>& corners, ImU32 colour, int side) {
    ImDrawList list(nullptr);
    for (const ImVec2 corner : corners) {
        list.IdxBuffer.push_back(static_cast<ImDrawIdx>(list.VtxBuffer.Size));
        list.VtxBuffer.push_back({corner, {0.5F, 0.5F}, colour});
    }
    ImDrawCmd command;
    command.ClipRect = {0, 0, static_cast<float>(side), static_cast<float>(side)};
    command.ElemCount = static_cast<unsigned>(list.IdxBuffer.Size);
    list.CmdBuffer.push_back(command);
    std::array<ImDrawList*, 1> lists{&list};
    ImDrawData frame;
    set_draw_lists(frame, lists);
    Image image = blank_image(side, side, IM_COL32_BLACK);
    rasterise(frame, {1, 1, &kWhiteTexel}, image);
    return image;
}

int red(const Image& image, int x, int y) {
    return static_cast<int>((pixel(image, x, y) >> IM_COL32_R_SHIFT) & 0xFFU);
}

}  // namespace

TEST_CASE("picture: two half-transparent triangles that share an edge leave no seam") {
    const ImU32 half = faded(IM_COL32_WHITE, 0.5F);
    const std::vector<std::vector<ImVec2>> quads{
        {{2, 2}, {30, 2}, {30, 30}, {2, 2}, {30, 30}, {2, 30}},   // through pixel centres
        {{2, 2}, {30, 2}, {2, 30}, {30, 2}, {30, 30}, {2, 30}},   // the other diagonal
        {{2, 2}, {30, 30}, {30, 2}, {2, 30}, {30, 30}, {2, 2}}};  // either sense of rotation
    for (const auto& quad : quads) {
        const Image image = triangles(quad, half, 32);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const bool inside = x >= 2 && x < 30 && y >= 2 && y < 30;
                CHECK(red(image, x, y) == (inside ? 128 : 0));
            }
        }
    }
}

TEST_CASE("picture: a fan of thin triangles around any point paints each pixel once") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(10.0F, 54.0F);
    for (int trial = 0; trial < 50; ++trial) {
        const ImVec2 middle{place(random), place(random)};
        const std::array<ImVec2, 8> rim{ImVec2{4, 4},   {31.3F, 4}, {60, 4}, {60, 22.7F},
                                        ImVec2{60, 60}, {17, 60},   {4, 60}, {4, 40.1F}};
        std::vector<ImVec2> corners;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            corners.insert(corners.end(), {middle, rim[i], rim[(i + 1) % rim.size()]});
        }
        const Image image = triangles(corners, faded(IM_COL32_WHITE, 0.5F), 64);
        int wrong = 0;
        for (int y = 4; y < 60; ++y) {
            for (int x = 4; x < 60; ++x) wrong += red(image, x, y) == 128 ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("picture: colours between the corners of a triangle are between theirs") {
    ImDrawList list(nullptr);
    for (const auto& [x, colour] : {std::pair{0.0F, IM_COL32_BLACK}, {64.0F, IM_COL32_WHITE}}) {
        for (const float y : {0.0F, 64.0F}) list.VtxBuffer.push_back({{x, y}, {0, 0}, colour});
    }
    for (const ImDrawIdx i : std::initializer_list<ImDrawIdx>{0, 2, 3, 0, 3, 1}) {
        list.IdxBuffer.push_back(i);
    }
    ImDrawCmd command;
    command.ClipRect = {0, 0, 64, 64};
    command.ElemCount = 6;
    list.CmdBuffer.push_back(command);
    std::array<ImDrawList*, 1> lists{&list};
    ImDrawData frame;
    set_draw_lists(frame, lists);
    Image image = blank_image(64, 64, IM_COL32_BLACK);
    rasterise(frame, {1, 1, &kWhiteTexel}, image);
    for (int x = 0; x < 64; ++x) {
        // Rounding to 8 bit.
        CHECK(std::abs(red(image, x, 20) - 255.0 * (x + 0.5) / 64.0) <= 1.0);
    }
}

TEST_CASE("picture: nothing is drawn outside the clip rectangle") {
    const Image image = draw_picture(100, 100, {}, [](const Theme&) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRect({20, 30}, {60, 50});
        list.AddRectFilled({0, 0}, {100, 100}, IM_COL32_WHITE);
        list.PopClipRect();
    });
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            const bool inside = x >= 20 && x < 60 && y >= 30 && y < 50;
            CHECK((pixel(image, x, y) == IM_COL32_WHITE) == inside);
        }
    }
}

TEST_CASE("picture: more vertices than 16 bits can count are all drawn") {
    const Image image = draw_picture(200, 200, {}, [](const Theme&) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (int i = 0; i < 40'000; ++i) {
            const ImVec2 at{static_cast<float>(i % 200), static_cast<float>(i / 200)};
            list.AddRectFilled(at, {at.x + 1, at.y + 1}, rgb(0xD55E00));
        }
    });
    CHECK(image == blank_image(200, 200, rgb(0xD55E00)));
}

TEST_CASE("picture: the same drawing gives the same bytes, and leaves the current context alone") {
    ImGuiContext* const before = ImGui::GetCurrentContext();
    const auto draw = [](const Theme& theme) {
        ImGui::TextUnformatted("Perceptual space");
        ImGui::GetWindowDrawList()->AddCircleFilled({50, 60}, 20.3F, theme.accent);
    };
    const Image first = draw_picture(160, 90, {}, draw);
    CHECK(first == draw_picture(160, 90, {}, draw));
    CHECK(first != draw_picture(160, 90, {.dark = false}, draw));
    CHECK(ImGui::GetCurrentContext() == before);
}

TEST_CASE("picture: a PNG file begins with its signature and its size") {
    const std::string path = (std::filesystem::temp_directory_path() / "tact_picture.png").string();
    REQUIRE(write_png(path, blank_image(258, 3, IM_COL32_WHITE)));
    std::ifstream file(path, std::ios::binary);
    std::string head(24, '\0');
    file.read(head.data(), 24);
    CHECK(head.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(head.substr(16, 8) == std::string("\0\0\1\2\0\0\0\3", 8));
    std::filesystem::remove(path);
}

TEST_CASE("picture: a PNG in a folder that does not exist fails with a sentence") {
    const auto result = write_png("/nonexistent/folder/picture.png", blank_image(1, 1, 0));
    REQUIRE_FALSE(result);
    CHECK(result.error().message.find("picture.png") != std::string::npos);
}

}  // namespace tact::picture_test
