#include "app/commands.h"

int main(int argc, char** argv) { return gbl::run_program(argc, argv); }
