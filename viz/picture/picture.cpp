#include "viz/picture/picture.h"

#include <imgui_internal.h>
#include <stb/stb_image_write.h>

#include <cassert>

#include "model/text/atomic_file.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/fonts.h"
#include "viz/picture/svg.h"

namespace tact {
namespace {

void run_frame(const Theme& theme, const std::function<void(const Theme&)>& draw) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::Begin("picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    draw(theme);
    ImGui::End();
    ImGui::Render();
}

// The next frame holds them to what there is.
void scroll(const std::vector<WindowScroll>& windows) {
    for (const WindowScroll& one : windows) {
        ImGuiWindow* window = ImGui::FindWindowByName(one.window.c_str());
        if (window == nullptr) continue;
        ImGui::SetScrollX(window, one.px.x);
        ImGui::SetScrollY(window, one.px.y);
    }
}

// Soft for pixels; exact where lines and curves are to be read back from the triangles.
enum class Edges { soft, exact };

void set_edges(ImGuiStyle& style, Edges edges) {
    if (edges == Edges::soft) return;
    style.AntiAliasedLines = false;
    style.AntiAliasedLinesUseTex = false;
    style.AntiAliasedFill = false;
    style.CircleTessellationMaxError = 0.05F;  // px; curves must bear magnifying
}

// Draws in a context of its own and hands the theme to `use` while the frame is there.
void draw_frames(int width, int height, const PictureOptions& options, Edges edges,
                 const std::function<void(const Theme&)>& draw,
                 const std::function<void(const Theme&)>& use) {
    assert(width > 0 && height > 0 && "a picture has pixels");
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGuiContext* const own = ImGui::CreateContext();
    ImGui::SetCurrentContext(own);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 1.0F / 60.0F;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    if (options.mouse_px) io.MousePos = *options.mouse_px;

    Theme theme = options.dark ? dark_theme(options.scale) : light_theme(options.scale);
    theme.fonts = load_fonts(*io.Fonts, options.scale, options.extra_text);
    apply(theme, ImGui::GetStyle());
    set_edges(ImGui::GetStyle(), edges);
    run_frame(theme, draw);
    scroll(options.scrolled);
    run_frame(theme, draw);
    use(theme);
    ImGui::DestroyContext(own);
    ImGui::SetCurrentContext(before);
}

ImU32 ground_of(const Theme& theme, const PictureOptions& options) {
    return options.has_panes ? theme.background : theme.pane;
}

}  // namespace

Image blank_image(int width, int height, ImU32 colour) {
    Image image{width, height, {}};
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgba.reserve(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (unsigned shift :
             {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT, IM_COL32_A_SHIFT}) {
            image.rgba.push_back(static_cast<std::uint8_t>((colour >> shift) & 0xFFU));
        }
    }
    return image;
}

ImU32 pixel(const Image& image, int x, int y) {
    assert(x >= 0 && x < image.width && y >= 0 && y < image.height && "pixel outside the image");
    const std::uint8_t* p =
        &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x))];
    return IM_COL32(p[0], p[1], p[2], p[3]);
}

std::vector<WindowScroll> scrolled_windows() {
    std::vector<WindowScroll> scrolled;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        const bool is_at_begin = window->Scroll.x == 0.0F && window->Scroll.y == 0.0F;
        if (!window->WasActive || is_at_begin) continue;
        scrolled.push_back({window->Name, {window->Scroll.x, window->Scroll.y}});
    }
    return scrolled;
}

Image draw_picture(int width, int height, const PictureOptions& options,
                   const std::function<void(const Theme&)>& draw) {
    Image image;
    draw_frames(width, height, options, Edges::soft, draw, [&](const Theme& theme) {
        image = blank_image(width, height, ground_of(theme, options));
        const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
        rasterise(*ImGui::GetDrawData(), {atlas.TexWidth, atlas.TexHeight, atlas.TexPixelsAlpha8},
                  image);
    });
    return image;
}

std::string draw_svg(int width, int height, const PictureOptions& options,
                     const std::function<void(const Theme&)>& draw) {
    std::string text;
    draw_frames(width, height, options, Edges::exact, draw, [&](const Theme& theme) {
        text = svg_text(*ImGui::GetDrawData(), theme.fonts, ground_of(theme, options),
                        options.svg_ids);
    });
    return text;
}

Expected<std::string> png_bytes(const Image& image) {
    std::string bytes;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                                   static_cast<std::size_t>(size));
    };
    const int done = stbi_write_png_to_func(append, &bytes, image.width, image.height, 4,
                                            image.rgba.data(), 4 * image.width);
    if (done == 0) return Error{"the picture could not be encoded as PNG"};
    return bytes;
}

Expected<Done> write_png(const std::string& path, const Image& image) {
    const Expected<std::string> bytes = png_bytes(image);
    if (!bytes) return Error{path + ": " + bytes.error().message};
    return write_atomically(path, *bytes);
}

}  // namespace tact
