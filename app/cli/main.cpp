#include "app/cli/program.h"

int main(int argc, char** argv) {
  return dougong::app::run_program(argc, argv);
}
