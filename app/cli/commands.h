#pragma once

#include <CLI/App.hpp>

#include "app/cli/session.h"

namespace app {

/// Adds every command of the list in commands.cpp to the program.
void addCommands(CLI::App& program, Session& session);

}  // namespace app
