// lesson_photographs FOLDER [WORDS]: a PNG of every step of every lesson that comes with the
// program, presented and in the window, with the card at the right and at the foot, before and
// after the answer; its further languages with text of 150 %; of those only whose path has the
// words.
//
// The program's own frames, drawn without a screen.
#include <cstdio>
#include <filesystem>
#include <string>

#include "app/lesson/lesson.h"
#include "tests/support/lesson_walk.h"
#include "tests/support/photograph.h"

using namespace tact;

namespace {

const LessonScreen kScreens[] = {{{1280.0F, 720.0F}, 1.0F, true},  {{1280.0F, 720.0F}, 1.5F, true},
                                 {{1280.0F, 720.0F}, 2.0F, true},  {{1920.0F, 1080.0F}, 1.0F, true},
                                 {{1920.0F, 1080.0F}, 1.5F, true}, {{1280.0F, 720.0F}, 1.0F, false},
                                 {{1280.0F, 720.0F}, 1.5F, false}};

std::string name_of(const LessonScreen& screen, DockSide side) {
    char text[80];
    std::snprintf(text, sizeof text, "%.0fx%.0f at %gx %s %s", screen.size.x, screen.size.y,
                  screen.scale, screen.presented ? "presented" : "in the window", edge_name(side));
    return text;
}

void take_step(LessonWalk& walk, std::size_t k, DockSide side, const std::filesystem::path& folder,
               const std::string& words) {
    const std::string name = (k < 9 ? "0" : "") + std::to_string(k + 1);
    const std::filesystem::path file = folder / (name + ".png");
    if (file.string().find(words) == std::string::npos) return;
    std::filesystem::create_directories(folder);
    walk.lesson().tallies[k] = {};
    walk.show_step(k, side);
    write_photograph(file, walk.app.ui.theme);
    if (!hides_answer(walk.lesson())) return;
    walk.lesson().tallies[k].revealed = true;
    walk.settle();
    write_photograph(folder / (name + " answered.png"), walk.app.ui.theme);
}

void take_lesson(LessonWalk& walk, const LessonScreen& screen, const std::filesystem::path& folder,
                 const std::string& words) {
    walk.show_on(screen);
    for (const DockSide side : {DockSide::right, DockSide::bottom}) {
        const auto own = folder / name_of(screen, side) / walk.lesson().lesson->name;
        for (std::size_t k = 0; k < walk.lesson().lesson->steps.size(); ++k) {
            take_step(walk, k, side, own, words);
        }
    }
}

}  // namespace

int main(int count, char** words) {
    if (count < 2 || words[1][0] == '-') {
        std::fprintf(stderr, "lesson_photographs FOLDER [WORDS]\n");
        return 1;
    }
    const std::filesystem::path folder = words[1];
    const std::string wanted = count > 2 ? words[2] : "";
    try {
        for (const char* path : bundled_lesson_paths()) {
            LessonWalk walk(path);
            for (const LessonScreen& screen : kScreens) take_lesson(walk, screen, folder, wanted);
            const std::vector<std::string> languages = walk.lesson().lesson->languages;
            for (std::size_t k = 1; k < languages.size(); ++k) {
                choose_language(walk.app.ui, walk.lesson(), languages[k]);
                walk.wait_for_numbers();
                take_lesson(walk, kScreens[1], folder / languages[k], wanted);
            }
        }
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "lesson_photographs: %s\n", fault.what());
        return 1;
    }
    return 0;
}
