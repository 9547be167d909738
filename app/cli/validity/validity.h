#pragma once

#include <CLI/App.hpp>

#include "app/cli/session.h"

namespace app {

/// One function a question: each adds its sub-command to `fidelis validity`.
void addLabels(CLI::App& validity, Session& session);
void addFidelityGap(CLI::App& validity, Session& session);
void addToleranceCheck(CLI::App& validity, Session& session);
void addPositiveTests(CLI::App& validity, Session& session);

}  // namespace app
