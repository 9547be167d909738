// withheld_generator EXPERIMENT --model WORLD.json --out DIR [--truth TRUTH.json] [--seed N] [--threads N]
// Exit status: 0 good, 2 bad usage or input, 3 internal error.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <optional>

#include "bench/withheld/generator/bad_input.h"
#include "bench/withheld/generator/package.h"

int main(int count, char** words) {
  CLI::App app(
      "Makes the measurements of an experiment package in a world that shares no code with the built-in lidar");
  std::string experiment, model, out, truth, sensors = WITHHELD_SENSORS;
  std::optional<std::uint64_t> seed;
  int threads = 1;
  bool list = false;
  app.add_option("EXPERIMENT", experiment, "Experiment package: a folder; its measurements need not exist");
  app.add_option("--model", model, "Model file: the sensor and all effects that truly exist");
  app.add_option("--out", out, "Folder that becomes the experiment package");
  app.add_option("--truth", truth, "Where the true scene stands other than recorded (README)");
  app.add_option("--seed", seed, "In place of the model file's");
  app.add_option("--threads", threads, "The same bytes for any number")->check(CLI::Range(1, 256));
  app.add_option("--sensors", sensors, "Folder of sensor profiles that are named by their id");
  app.add_flag("--list", list, "Print the names of all effects");
  try {
    app.parse(count, words);
    if (list) {
      for (const auto& entry : withheld::allEffects()) fmt::print("{}\n", entry.name);
      return 0;
    }
    if (experiment.empty() || model.empty() || out.empty()) {
      throw withheld::BadInput("withheld_generator", "EXPERIMENT, --model or --out is missing.", "See --help.");
    }
    const withheld::World world = withheld::readWorld(model, sensors);
    const std::uint64_t chosen = seed.value_or(world.seed);
    const withheld::Package package = withheld::readPackage(experiment, truth, chosen);
    withheld::writePackage(package, withheld::simulate(package, world, chosen, threads), out);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const withheld::BadInput& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const nlohmann::json::exception& error) {
    fmt::print(stderr, "A value in the input has the wrong type: {}\n  Compare it with docs/formats.md.\n",
               error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "internal error: {}\n", error.what());
    return 3;
  }
}
