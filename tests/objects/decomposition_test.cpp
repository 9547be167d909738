#include "objects/decomposition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/json_object.h"
#include "tests/support/paths.h"

namespace {

TEST(Decomposition, EveryEffectActsBeforeDetectionsLeave) {
  for (const model::EffectEntry& entry : model::allEffects()) {
    EXPECT_LE(objects::blockOf(entry.info.stage), objects::Block::kDetectionIdentification) << entry.info.name;
  }
}

// The names are those of the graphs, all of them and in their order.
TEST(Decomposition, NamesAreThoseOfTheGraphs) {
  FIDELIS_NEEDS_SHARED(shared);
  std::set<std::string> in_graph, here;
  for (const char* file : {"lidarlimbs-2022-10-14.json", "radarrami-2025.json"}) {
    const auto nodes = core::readJson(shared / "data" / "percollect" / "json" / file);
    for (const auto& node : nodes) in_graph.insert(node.at("decomBlock"));
  }
  for (const objects::BlockInfo& block : objects::allBlocks()) {
    here.insert(block.name);
    EXPECT_EQ(objects::infoOf(block.block).name, block.name);
  }
  EXPECT_EQ(here, in_graph);
}

}  // namespace
