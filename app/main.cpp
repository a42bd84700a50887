#include "app/command_line/command_line.h"
#include "app/command_line/endings.h"
#include "app/window/window.h"

int main(int argc, char** argv) {
    tact::prepare_endings();
    return tact::run_command_line(argc, argv, tact::run_main_window);
}
