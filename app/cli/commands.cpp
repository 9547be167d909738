#include "app/cli/commands.h"

namespace app {

void addAcceptCommand(CLI::App& program, Session& session);
void addCepraCommand(CLI::App& program, Session& session);
void addConvertCommand(CLI::App& program, Session& session);
void addDetectCommand(CLI::App& program, Session& session);
void addEffectsCommand(CLI::App& program, Session& session);
void addExplainCommand(CLI::App& program, Session& session);
void addGapCommand(CLI::App& program, Session& session);
void addImportCommand(CLI::App& program, Session& session);
void addMaterialsCommand(CLI::App& program, Session& session);
void addMetricCommand(CLI::App& program, Session& session);
void addObjectsCommand(CLI::App& program, Session& session);
void addPredictCommand(CLI::App& program, Session& session);
void addSceneCommand(CLI::App& program, Session& session);
void addScenesCommand(CLI::App& program, Session& session);
void addSensitivityCommand(CLI::App& program, Session& session);
void addSensorsCommand(CLI::App& program, Session& session);
void addSimulateCommand(CLI::App& program, Session& session);
void addSpecCommand(CLI::App& program, Session& session);
void addValidityCommand(CLI::App& program, Session& session);

// Each command adds itself: its options, its help, and a callback that calls one library function.

void addCommands(CLI::App& program, Session& session) {
  using AddCommand = void (*)(CLI::App&, Session&);
  constexpr AddCommand kCommands[] = {
      addImportCommand,   addCepraCommand,       addSpecCommand,     addAcceptCommand,  addMetricCommand,
      addValidityCommand, addPredictCommand,     addSimulateCommand, addExplainCommand, addObjectsCommand,
      addGapCommand,      addSensitivityCommand, addEffectsCommand,  addSensorsCommand, addMaterialsCommand,
      addConvertCommand,  addDetectCommand,      addScenesCommand,   addSceneCommand,
  };
  for (const AddCommand add : kCommands) {
    add(program, session);
  }
}

}  // namespace app
