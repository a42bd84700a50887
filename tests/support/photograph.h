// The frame drawn last, as a PNG, without a screen.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "viz/picture/picture.h"

namespace tact {

inline Image photograph(const Theme& theme) {
    const ImDrawData& frame = *ImGui::GetDrawData();
    Image image = blank_image(static_cast<int>(frame.DisplaySize.x),
                              static_cast<int>(frame.DisplaySize.y), theme.background);
    const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    rasterise(frame, {atlas.TexWidth, atlas.TexHeight, atlas.TexPixelsAlpha8}, image);
    return image;
}

inline void write_photograph(const std::filesystem::path& file, const Theme& theme) {
    const auto written = write_png(file.string(), photograph(theme));
    if (!written) throw std::runtime_error(written.error().message);
}

}  // namespace tact
