// What the dialogs for export were left at, and what is on its way to files.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/export/effect_export.h"
#include "app/export/paper.h"
#include "app/pictures/film.h"
#include "app/pictures/frame_sequence.h"
#include "app/pictures/pictures.h"

namespace tact {

// The part of the window that is drawn as a picture.
enum class PictureView { window, physiology, space, matrix, table, subset, compare, why };

inline constexpr std::array<PictureView, 8> kPictureViews{
    PictureView::window, PictureView::physiology, PictureView::space,   PictureView::matrix,
    PictureView::table,  PictureView::subset,     PictureView::compare, PictureView::why};

// "physiology": on the command line and in file names.
const char* name_of(PictureView view);

struct ViewSnapshot;  // app/window/view_pictures.h

struct RunningAnimation {
    std::shared_ptr<ViewSnapshot> still;  // what is drawn
    PictureView view = PictureView::physiology;
    PictureSize size;
    FrameSequence sequence;
    std::shared_ptr<Film> film;  // one file; null: a picture each
    std::string another_size;    // of the film than was asked, in words
    int done = 0;                // frames
    double begun_s = 0.0;
};

struct ExportState {
    PictureView view = PictureView::physiology;
    PictureView moving_view = PictureView::physiology;
    PictureSize picture_size;
    PictureSize frame_size;
    double from_s = 0.0;
    double to_s = 0.0;  // 0: the end of the pattern
    int frames = 150;
    std::optional<FilmFormat> film = FilmFormat::gif;  // none: pictures in a folder
    std::filesystem::path picture;  // to be drawn when the window's own frame is done
    std::shared_ptr<RunningAnimation> animation;
    bool cancel_asked = false;  // of the animation
    bool copy_asked = false;    // of the view, to the clipboard
    EffectExport effects;       // patterns for phones and other programs
    PaperState paper;           // tables and figures
};

}  // namespace tact
