// The page of a browser: a window alone. Its arguments are the sets and lessons that its address
// names.
#include <filesystem>
#include <iostream>
#include <vector>

#include "app/window/window.h"

int main(int argc, char** argv) {
    const std::vector<std::filesystem::path> named(argv + 1, argv + argc);
    const tact::Expected<tact::Done> opened = tact::run_main_window(named);
    if (!opened) std::cerr << "tactspace: " << opened.error().message << "\n";
    return opened ? 0 : 1;
}
