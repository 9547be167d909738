#include "tests/proposals/demo_project.h"

#include "cepra/csv.h"
#include "core/json_object.h"
#include "gap/chain.h"
#include "gap/report/json.h"
#include "model/experiment.h"
#include "percollect/read_graph.h"
#include "specs/import_graph.h"
#include "specs/lists.h"

namespace test_proposals {

namespace {

std::filesystem::path demo() { return test_support::sourceFolder() / "resources" / "demo"; }

}  // namespace

DemoProject::DemoProject() {
  for (const char* part : {"range-sweep", "foggy-sweep", "model.json"}) {
    std::filesystem::copy(demo() / part, folder_ / part, std::filesystem::copy_options::recursive);
  }
  auto store = specs::ProjectStore::create(file());
  specs::importGraph(store, percollect::readGraph(demo() / "lidar-excerpt.json").graph, kEve);
  specs::applyLists(store, specs::readLists(demo() / "specification", store.specification()), false, kEve);
  store.saveCepra(cepra::importCsv(store.cepra(), demo() / "cepra.csv").table, kEve);
}

const gap::Diagnosis& DemoProject::diagnosis() {
  static const gap::Diagnosis once = [] {
    core::SilentProgress progress;
    gap::Diagnosis made = gap::diagnose(model::readExperiment(demo() / "foggy-sweep"),
                                        model::readModel(demo() / "model.json"), {}, progress);
    gap::addChains(made, percollect::readGraph(demo() / "lidar-excerpt.json").graph);
    return made;
  }();
  return once;
}

std::filesystem::path DemoProject::report() const {
  const std::filesystem::path file = folder_ / "gap.json";
  core::writeJson(file, gap::reportJson(diagnosis()));
  return file;
}

}  // namespace test_proposals
