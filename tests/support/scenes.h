// Every pane, tab, dialog, menu and popup of the window, one after the other, as a person would
// open them: for photographs, and for what must hold of all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tact {

struct Scene {
    std::string name;
    std::function<void(Program&)> show;  // from the first window of the set
    bool is_costly = false;              // computes for seconds
};

const std::vector<Scene>& scenes();

// The twelve patterns of the paper with two long names, its exact map, and a subset picked. What is
// compared grows with the square of how long they are: where words and places are looked at, a
// fifth of a second is enough.
struct SceneWindow : Program {
    // `sign`: in the middle of the long names, and of the set's.
    explicit SceneWindow(double duration_s = 0.2, const std::string& sign = "");

    // The first window again, then the scene.
    void show(const Scene& scene);

    // A screen of this size, with nothing presented on it.
    void resize(ImVec2 size, float scale);

  private:
    void leave_presentation();

    Document document_;
};

}  // namespace tact
