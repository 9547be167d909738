#include <fstream>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "percollect/chains.h"
#include "percollect/read_graph.h"
#include "percollect/write_graph.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"

// Whatever happens to a file, reading it gives a whole graph or an InputError: no crash, no other exception.

namespace {

percollect::Graph exampleGraph() {
  percollect::GraphData data =
      test_support::smallGraphData({"e:1", "e:2", "s:3", "d:4"}, {{"1", "2"}, {"2", "3"}, {"3", "4"}, {"1", "4"}});
  data.nodes[1].references_text = "[1, A, T, http://a.org, note]";
  data.nodes[2].tags = {"x", "\xc3\xbc"};
  data.nodes[3].labels = {{"two words", "y"}};
  return percollect::Graph(std::move(data));
}

/// One random deletion, insertion, or overwriting of a byte or of a piece.
std::string damaged(std::string text, core::Random& random) {
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::size_t at = random.below(size);
  switch (random.below(5)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      text.erase(at, 1 + random.below(20));
      break;
    case 2:
      text[at] = static_cast<char>(random.below(256));
      break;
    case 3:
      text.insert(at, text.substr(random.below(size), random.below(60)));
      break;
    default:
      text.insert(at, 1, std::string_view("<>\"&[]{},\\\0\n'", 13)[random.below(13)]);
      break;
  }
  return text;
}

/// Not core::writeFile: it waits for the disk, thousands of times.
std::filesystem::path writeQuickly(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

/// Reads and uses the graph. Returns whether it was accepted.
bool readsOrRefuses(const std::filesystem::path& path) {
  try {
    const auto read = percollect::readGraph(path);
    (void)countGraph(read.graph);
    return true;
  } catch (const core::InputError& error) {
    EXPECT_FALSE(error.problem().empty());
    EXPECT_FALSE(error.remedy().empty());
    return false;
  }
}

}  // namespace

TEST(DamagedFiles, JsonIsReadOrRefused) {
  const test_support::TemporaryFolder folder;
  writeJsonRelease(exampleGraph(), folder / "graph.json");
  const std::string whole = core::readFile(folder / "graph.json");
  core::Random random({.seed = 1});
  int accepted = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = damaged(whole, random);
    if (round % 2 == 0) text = damaged(std::move(text) + " ", random);
    accepted += readsOrRefuses(writeQuickly(folder / "damaged.json", text)) ? 1 : 0;
  }
  EXPECT_GT(accepted, 0);     // a letter in a title is no damage that can be seen
  EXPECT_LT(accepted, 2000);  // but most is
}

TEST(DamagedFiles, XmlIsReadOrRefused) {
  const test_support::TemporaryFolder folder;
  writeXmlRelease(exampleGraph(), folder.path());
  core::Random random({.seed = 2});
  int accepted = 0;
  for (const char* name : {"root_node.xml", "2_node.xml", "4_node.xml"}) {
    const std::string whole = core::readFile(folder / name);
    for (int round = 0; round < 700; ++round) {
      writeQuickly(folder / name, damaged(whole, random));
      accepted += readsOrRefuses(folder.path()) ? 1 : 0;
    }
    writeQuickly(folder / name, whole);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, 2100);
}

TEST(DamagedFiles, EveryTruncationOfAPublishedFileIsRefused) {
  FIDELIS_NEEDS_SHARED(shared);
  const std::string whole = core::readFile(shared / "data/percollect/json/cameracopse.json");
  const test_support::TemporaryFolder folder;
  const std::size_t end = whole.rfind(']');
  for (std::size_t size = 0; size <= end; size += 97) {
    EXPECT_FALSE(readsOrRefuses(writeQuickly(folder / "cut.json", whole.substr(0, size)))) << size;
  }
}

TEST(DamagedFiles, DeepNestingIsRefused) {
  const test_support::TemporaryFolder folder;
  EXPECT_FALSE(readsOrRefuses(folder.write("deep.json", std::string(500'000, '['))));
  EXPECT_FALSE(readsOrRefuses(folder.write("deep2.json", std::string(200'000, '[') + std::string(200'000, ']'))));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<basic_node>";
  EXPECT_FALSE(readsOrRefuses(folder.write("root_node.xml", deep)));
}
