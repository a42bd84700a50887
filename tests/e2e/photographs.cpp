// photographs FOLDER [WORDS [SHOTS]]: a PNG of every pane, tab, dialog, menu and popup, dark and
// light, at four sizes of the window, one of them also with larger text; of those only whose name
// has the words, and only such shots ("1280x720", "dark", "1280x720/dark").
//
// The program's own frames, drawn without a screen.
#include <cstdio>
#include <filesystem>
#include <string>

#include "tests/support/photograph.h"
#include "tests/support/scenes.h"

using namespace tact;

namespace {

struct Screen {
    const char* name;
    ImVec2 size;
    float scale;
};

const Screen kScreens[] = {
    {"1280x720", {1280.0F, 720.0F}, 1.0F},           {"1600x1000", {1600.0F, 1000.0F}, 1.0F},
    {"1600x1000 at 1.5x", {1600.0F, 1000.0F}, 1.5F}, {"1600x1000 at 2x", {1600.0F, 1000.0F}, 2.0F},
    {"2560x1440", {2560.0F, 1440.0F}, 1.0F},         {"3840x2160 at 2x", {3840.0F, 2160.0F}, 2.0F}};

void take_all(SceneWindow& window, const std::filesystem::path& folder, const std::string& words) {
    std::filesystem::create_directories(folder);
    for (const Scene& scene : scenes()) {
        if (scene.name.find(words) == std::string::npos) continue;
        window.show(scene);
        write_photograph(folder / (scene.name + ".png"), window.app.ui.theme);
    }
}

}  // namespace

int main(int count, char** words) {
    if (count < 2 || words[1][0] == '-') {
        std::fprintf(stderr, "photographs FOLDER [WORDS [SHOTS]]\n");
        return 1;
    }
    try {
        SceneWindow window(1.0);
        for (const bool dark : {true, false}) {
            for (const Screen& screen : kScreens) {
                const std::string shot = std::string(screen.name) + (dark ? "/dark" : "/light");
                if (count > 3 && shot.find(words[3]) == std::string::npos) continue;
                window.app.ui.dark = dark;
                window.resize(screen.size, screen.scale);
                take_all(window, std::filesystem::path(words[1]) / shot, count > 2 ? words[2] : "");
            }
        }
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "photographs: %s\n", fault.what());
        return 1;
    }
    return 0;
}
