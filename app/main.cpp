#include "app/commands.h"
#include "renderer/base/memory.h"

int main(int argc, char** argv) {
  gbl::return_freed_memory();
  return gbl::run_program(argc, argv);
}
