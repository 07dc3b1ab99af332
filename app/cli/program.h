// The command line of the program: its commands, their options, their help.
#pragma once

namespace dougong::app {

/// Parses, runs the command, prints errors to standard error. Returns the exit code.
int run_program(int argc, const char* const* argv);

}  // namespace dougong::app
