#include "app/cli/commands.h"

namespace app {

// Each command adds itself: its options, its help, and a callback that calls one library function.

void addCommands(CLI::App& program, Session& session) {
  using AddCommand = void (*)(CLI::App&, Session&);
  constexpr AddCommand kCommands[] = {
      nullptr,
  };
  for (const AddCommand add : kCommands) {
    if (add) add(program, session);
  }
}

}  // namespace app
