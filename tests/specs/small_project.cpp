#include "tests/specs/small_project.h"

namespace test_specs {

using namespace specs;

percollect::Graph smallGraph() {
  percollect::GraphData data;
  data.tree = "small";
  data.source = "small.json";
  data.sha256 = "5f";
  const auto add = [&](const char* id, const char* title, percollect::NodeKind kind) -> percollect::Node& {
    percollect::Node& node = data.nodes.emplace_back();
    node.id = id;
    node.title = title;
    node.kind = kind;
    node.block = "Signal propagation";
    return node;
  };
  add("0", "Range error", percollect::NodeKind::Effect);
  add("1", "Attenuation by \"aerosols\"; <fog>", percollect::NodeKind::Effect);
  percollect::Node& design = add("2", "Emitter wavelength λ", percollect::NodeKind::DesignParameter);
  design.description = "two\nlines";
  design.tags = {"b", "a"};
  design.labels = {{"FMCWspecific", "true"}};
  design.extra = {{"x", "[1,2]"}};
  design.references_text = "[1, A, T, https://x.y, note]";
  design.references = {{"1", "A", "T", "https://x.y", "note", "1, A, T, https://x.y, note"}};
  design.placement_parent = "1";
  add("3", "Number concentration", percollect::NodeKind::SystemIndependent);
  data.edges = {{0, 1}, {1, 3}, {1, 2}, {0, 3}};
  data.phenomena = {0};
  return percollect::Graph(std::move(data));
}

void fill(ProjectStore& store) {
  store.inOneAction([&] {
    store.saveGraph(smallGraph(), kEve);
    cepra::Table table = cepra::buildTable(smallGraph());
    table.rows.back().occurrence = {.value = 7, .rationale = "fog is common", .expert = "eve"};
    table.rows.back().impact = {.value = 9, .rationale = "objects are missed", .expert = "adam"};
    store.saveCepra(table, kEve);

    Requirement general{{.id = "RangeError_Fog_1", .title = "Fog is modelled", .status = Status::Accepted},
                        Level::General,
                        {"atmospheric-attenuation"}};
    Requirement detection{{.id = "RangeError_Fog_2", .title = "Range bias in fog", .status = Status::Accepted}};
    detection.text = "The bias, in m,\nis \"small\"; see <1>.";
    AcceptanceTest test{{.id = "RangeError_Fog_3", .title = "Range bias at 10 m", .status = Status::Accepted}};
    test.experiment = "experiments/range-sweep";
    test.model = "models/demo.json";
    test.measurand = "range";
    test.metric = "dvm";
    test.expression = "abs(d_bias) <= 0.005 * range_m";
    test.samples = {"r10", "odd; sample", "validation"};
    test.frames = 20;
    test.options = {{"rays", "3;5"}, {"note", "a=b"}};
    ExperimentData experiment{{.id = "RangeError_Fog_4", .title = "Sweep", .author = "eve"}};
    experiment.device = "Ibeo LUX 2010";
    experiment.conditions = "10 m to 20 m";
    ReferenceData reference{{.id = "RangeError_Fog_5", .title = "True range"}};
    reference.uncertainty = "± 2 mm (95 %)";
    store.add(general, kEve);
    store.add(detection, kEve);
    store.add(test, kEve);
    store.add(experiment, kEve);
    store.add(reference, kEve);
    store.link({table.rows.back().key, general.id}, kEve);
    store.link({general.id, detection.id}, kEve);
    store.link({detection.id, test.id}, kEve);
    store.link({test.id, experiment.id}, kEve);
    store.link({test.id, reference.id}, kEve);
  });
}

}  // namespace test_specs
