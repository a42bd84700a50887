#include "app/command_line/command_line.h"

int main(int argc, char** argv) { return tact::run_command_line(argc, argv); }
