#include "model/external/external_package.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "model/package_files.h"

namespace model {

using nlohmann::json;

namespace {

/// Steps that set the uncertain quantities of a run to their values.
void applyOffsets(const Experiment& experiment, const Sample& sample, const EpistemicOffsets& offsets, json& patch) {
  if (offsets.empty()) return;
  const json patched = experiment.json.patch(sample.patch);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets[i] == 0.0) continue;
    const std::string& path = sample.epistemic[i].path;
    const double value = patched.at(json::json_pointer(path)).get<double>() + offsets[i];
    patch.push_back({{"op", "replace"}, {"path", path}, {"value", value}});
  }
}

/// A file name that no other run has.
std::string measurementsOf(const std::string& id, std::set<std::string>& taken) {
  std::string name = fileNameOf(id);
  for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}_{}", fileNameOf(id), n);
  return "measurements/" + name + ".csv";
}

}  // namespace

std::string idOf(const Sample& sample, const EpistemicOffsets& offsets) {
  if (std::all_of(offsets.begin(), offsets.end(), [](double offset) { return offset == 0.0; })) return sample.id;
  const std::vector<EpistemicOffsets> corners = epistemicCorners(sample);
  const auto found = std::find(corners.begin(), corners.end(), offsets);
  return found == corners.end() ? sample.id + "@between" : fmt::format("{}@{}", sample.id, found - corners.begin());
}

json externalPackage(const Experiment& experiment, std::span<const WantedRun> wanted, std::uint64_t seed) {
  json package = experiment.json;
  package.erase("columns");  // names of the measurement's files
  writeOutSensors(package, experiment.file);
  package["x-seed"] = seed;
  package["samples"] = json::array();
  std::set<std::string> taken, ids;
  for (const WantedRun& run : wanted) {
    const Sample& sample = experiment.samples.at(run.sample);
    json entry = experiment.json.at("samples").at(run.sample);
    std::string id = idOf(sample, run.offsets);
    while (!ids.insert(id).second) id += "'";  // two runs between the corners
    entry["id"] = id;
    entry["frames"] = sample.frames;
    entry["measurements"] = measurementsOf(id, taken);
    entry["patch"] = sample.patch;
    entry.erase("epistemic");
    applyOffsets(experiment, sample, run.offsets, entry["patch"]);
    package["samples"].push_back(std::move(entry));
  }
  return package;
}

void writeExternalPackage(const Experiment& experiment, std::span<const WantedRun> wanted, const json& package,
                          const std::filesystem::path& folder) {
  Experiment part = experiment;
  part.samples.clear();
  for (const WantedRun& run : wanted) part.samples.push_back(experiment.samples.at(run.sample));
  copyReferenced(part, folder);
  core::writeJson(folder / "experiment.json", package);
}

}  // namespace model
