#include <csignal>

#include "app/command_line/command_line.h"
#include "app/window/frame.h"

int main(int argc, char** argv) {
    // A file that may not grow further is an error of writing like any other, with its sentence.
    std::signal(SIGXFSZ, SIG_IGN);
    return tact::run_command_line(argc, argv, tact::run_main_window);
}
