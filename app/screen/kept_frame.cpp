#include "app/screen/screen.h"

#include <backends/imgui_impl_opengl3.h>

#include <utility>

#include "app/screen/open_gl.h"

namespace tact {

namespace {

void make_target(KeptFrame& kept, int width, int height) {
    destroy(kept);
    glGenTextures(1, &kept.texture);
    glBindTexture(GL_TEXTURE_2D, kept.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &kept.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, kept.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, kept.texture, 0);
}

void paint_rect(ImDrawData& frame, const Rect& rect, int height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(static_cast<int>(rect.min.x), height - static_cast<int>(rect.max.y),
              static_cast<int>(rect.width()), static_cast<int>(rect.height()));
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    ClippedFrame clipped(frame, rect);
    ImGui_ImplOpenGL3_RenderDrawData(clipped.data());
}

}  // namespace

void paint(KeptFrame& kept, ImDrawData& frame, int width, int height, ImU32 background) {
    FramePrint now = print_of(frame, background);
    const bool other_size = kept.print.size.x != now.size.x || kept.print.size.y != now.size.y;
    if (kept.framebuffer == 0 || other_size) make_target(kept, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, kept.framebuffer);
    glViewport(0, 0, width, height);
    const ImVec4 colour = ImGui::ColorConvertU32ToFloat4(background);
    glClearColor(colour.x, colour.y, colour.z, 1.0F);
    for (const Rect& rect : damage(kept.print, now)) paint_rect(frame, rect, height);
    kept.print = std::move(now);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void forget(KeptFrame& kept) { kept.print = {}; }

void destroy(KeptFrame& kept) {
    if (kept.framebuffer != 0) glDeleteFramebuffers(1, &kept.framebuffer);
    if (kept.texture != 0) glDeleteTextures(1, &kept.texture);
    kept = {};
}

}  // namespace tact
