// A program that stands still while pictures of it are drawn.
#pragma once

#include "app/window/app.h"

namespace tact {

struct StillView {
    App app;
};

}  // namespace tact
