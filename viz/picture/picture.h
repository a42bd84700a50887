// Pictures without a window: one ImGui frame, as pixels of a small software rasteriser or as SVG.
//
// Input     drawing code that needs a theme and ImGui, as in the window
// Output    8-bit RGBA, rows from the top; or the text of svg.h
// Left out  user textures (only the font texture is known), draw callbacks, gamma-correct blending
//           (graphics cards do not do it either).
// Exact     fill rule: a pixel belongs to a triangle if its centre is inside, or on a top or left
//           edge; two triangles that share an edge paint every pixel once. Same bytes every time.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "viz/drawing/theme.h"

namespace tact {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba{};  // 4 width height bytes

    bool operator==(const Image&) const = default;
};

// An opaque image of one colour.
Image blank_image(int width, int height, ImU32 colour);

// The pixel as a packed colour; x and y must be inside.
ImU32 pixel(const Image& image, int x, int y);

// What triangles are textured with: opacity only, as ImGui's font atlas holds it.
struct AlphaTexture {
    int width = 0;
    int height = 0;
    const unsigned char* alpha = nullptr;
};

// Blends a frame's triangles over the image, as the OpenGL backend would.
void rasterise(const ImDrawData& frame, const AlphaTexture& texture, Image& image);

// How far a window within the frame is scrolled.
struct WindowScroll {
    std::string window;  // ImGui's name of it
    ImVec2 px;
};

// Windows of the current context that are not scrolled to their beginning.
std::vector<WindowScroll> scrolled_windows();

struct PictureOptions {
    bool dark = true;
    float scale = 1.0F;
    std::string extra_text{};          // names in the picture, for the choice of glyphs
    std::optional<ImVec2> mouse_px{};  // where the mouse hovers, if anywhere
    bool has_panes = false;            // the drawing brings panes of its own, on the background
    std::string svg_ids{};             // what names in an SVG begin with
    std::vector<WindowScroll> scrolled{};
};

// Runs `draw` for two frames (layout settles in the first) inside a borderless window that fills
// the picture, on the theme's pane colour or its background. Uses an ImGui context of its own and
// restores the current one.
Image draw_picture(int width, int height, const PictureOptions& options,
                   const std::function<void(const Theme&)>& draw);

// The same picture as SVG.
std::string draw_svg(int width, int height, const PictureOptions& options,
                     const std::function<void(const Theme&)>& draw);

Expected<std::string> png_bytes(const Image& image);

// Writes a PNG; a failed write leaves an existing file as it was.
Expected<Done> write_png(const std::string& path, const Image& image);

}  // namespace tact
