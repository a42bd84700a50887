// The part of a frame that differs from the one before, so that only that is painted.
//
// Most of a window stands still while a playhead moves; under a software renderer painting is what
// a frame costs. Draw commands are compared as sets, window by window: what is in one frame and not
// in the other marks its place.
//
// Input     ImGui's draw data of two frames
// Output    rectangles in whole pixels, none overlapping by much; outside of them the frames are
//           equal to the pixel
// Left out  changes of the font texture (the caller paints all then), draw callbacks.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>
#include <vector>

#include "viz/drawing/geometry.h"
#include "viz/picture/picture.h"

namespace tact {

struct CommandPrint {
    std::uint64_t hash = 0;
    Rect area;  // no pixel outside of it is touched
};

struct FramePrint {
    ImVec2 size{0, 0};
    ImU32 background = 0;
    std::vector<std::string> windows;                 // from the bottom
    std::vector<std::vector<CommandPrint>> commands;  // of each window
};

FramePrint print_of(const ImDrawData& frame, ImU32 background);

// At most `most` rectangles; of frames of another size or other windows the whole frame.
std::vector<Rect> damage(const FramePrint& before, const FramePrint& now, std::size_t most = 8);

// The frame's commands cut to a rectangle; those outside of it draw nothing. The frame is whole
// again when this goes.
class ClippedFrame {
  public:
    ClippedFrame(ImDrawData& frame, const Rect& rect);
    ~ClippedFrame();
    ClippedFrame(const ClippedFrame&) = delete;
    ClippedFrame& operator=(const ClippedFrame&) = delete;

    // Only the lists that draw anything; valid as long as this is.
    ImDrawData* data() { return &clipped_; }

  private:
    struct Saved {
        ImDrawCmd* command;
        ImVec4 clip;
        unsigned elements;
    };
    ImDrawData clipped_;
    std::vector<ImDrawList*> lists_;
    std::vector<Saved> saved_;
};

// The part of a picture that the next one has to paint again. Private to moving pictures.

// In whole pixels; of no change one pixel at the corner, as no format takes none.
struct ChangedArea {
    int x = 0;
    int y = 0;
    int width = 1;
    int height = 1;
};

// The smallest area outside of which two pictures of one size are alike.
ChangedArea changed_area(const Image& before, const Image& after);

// The bytes of a pixel.
const std::uint8_t* bytes_at(const Image& image, int x, int y);
bool is_same_pixel(const Image& a, const Image& b, int x, int y);

}  // namespace tact
