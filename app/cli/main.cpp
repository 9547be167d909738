// The program `fidelis`. Parses, runs one command, turns what it throws into a message and an exit status: the one
// boundary at which errors are printed.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/session.h"
#include "app/cli/terminal.h"
#include "core/error.h"
#include "core/json_object.h"
#include "core/parallel.h"
#include "core/text.h"
#include "core/version.h"

namespace app {

void Session::writeJsonTo(const std::string& name, const nlohmann::ordered_json& value) const {
  if (name == "-") {
    out << value.dump(2) << "\n";
  } else {
    core::writeJson(name, value);
  }
}

namespace {

void addGlobalOptions(CLI::App& program, Session& session) {
  program.set_version_flag("--version", std::string("fidelis ") + core::kVersion);
  program.add_flag("--quiet,-q", session.quiet, "No progress, no remarks; errors only");
  program.add_flag("--verbose", session.verbose, "Say more about what is done");
  program.add_option("--threads", session.threads, "Threads to use (0: all cores); never changes a result")
      ->check(CLI::NonNegativeNumber);
  program.add_option("--seed", session.seed, "Seed of every random number; without it the model's own");
}

/// CLI11 says what is wrong; this adds what was probably meant, down to the sub-command.
std::string hintFor(const CLI::App& program, int count, char** words) {
  const CLI::App* command = &program;
  std::string so_far;  // "spec " once that is read
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    double number = 0.0;
    if (word.empty() || word[0] == '-' || core::parseNumber(word, number)) continue;  // "--threads 2"
    const auto known = command->get_subcommands([](const CLI::App*) { return true; });
    if (known.empty()) return "";
    std::vector<std::string> names;
    for (const CLI::App* sub : known) names.push_back(sub->get_name());
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) {
      const std::string nearest = core::nearestName(word, names);
      if (nearest.empty() && command != &program) return "";  // may well be the value of an option
      return "There is no command '" + so_far + word + "'." +
             (nearest.empty() ? "" : " Did you mean 'fidelis " + so_far + nearest + "'?") + "\n";
    }
    command = known[static_cast<std::size_t>(found - names.begin())];
    so_far += word + " ";
  }
  return "";
}

int run(int count, char** words) {
  CLI::App program{
      "fidelis: specify, validate and improve simulation models of active perception sensors.\n"
      "Exit status: 0 all good, 1 something was not accepted, 2 bad usage or input, 3 internal error.",
      "fidelis"};
  TerminalProgress progress(false);
  Session session{.out = std::cout, .messages = std::cerr, .progress = progress, .seed = std::nullopt};
  addGlobalOptions(program, session);
  program.require_subcommand(1);
  program.fallthrough();
  program.parse_complete_callback([&] {
    progress.setQuiet(session.quiet);
    core::limitThreads(session.threads);
  });
  addCommands(program, session);
  try {
    program.parse(count, words);
    return session.status;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    program.exit(error, std::cerr, std::cerr);
    std::cerr << hintFor(program, count, words);
    return kBadInput;
  } catch (const core::InputError& error) {
    progress.clear();
    std::cerr << "fidelis: " << error.what() << "\n";
    return kBadInput;
  } catch (const core::Cancelled&) {
    progress.clear();
    std::cerr << "fidelis: stopped; nothing was half-written.\n";
    return kInterrupted;
  } catch (const std::exception& error) {
    progress.clear();
    std::cerr << "fidelis: internal error: " << error.what()
              << "\n  This is a fault of the program; please report it.\n";
    return kInternalError;
  }
}

}  // namespace
}  // namespace app

int main(int count, char** words) { return app::run(count, words); }
