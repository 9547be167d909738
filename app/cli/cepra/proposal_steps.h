#pragma once

namespace CLI {
class App;
}

namespace app {

struct Session;

/// fidelis cepra propose|proposals|accept|dismiss: what a diagnosis means for the table, decided by a person.
void addProposalSteps(CLI::App& cepra, Session& session);

}  // namespace app
