#include "cepra/scales.h"

#include <gmock/gmock.h>
#include <set>

#include "core/file.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

using cepra::readScales;
using cepra::Scale;
using test_support::sourceFolder;
using test_support::TemporaryFolder;
using testing::HasSubstr;

TEST(Scales, DescribeEachValueFromOneToTen) {
  const auto scales = readScales(sourceFolder() / "resources/scales");
  for (const Scale* scale : {&scales.occurrence, &scales.impact}) {
    ASSERT_EQ(scale->levels.size(), 10u);
    std::set<std::string> labels;
    for (int value = 1; value <= 10; ++value) {
      EXPECT_EQ(scale->level(value).value, value);
      EXPECT_FALSE(scale->level(value).description.empty());
      labels.insert(scale->level(value).label);
    }
    EXPECT_EQ(labels.size(), 10u);
    EXPECT_THAT(scale->source, HasSubstr("Wording by Fidelis"));
  }
  EXPECT_EQ(scales.occurrence.id, "occurrence");
  EXPECT_EQ(scales.impact.id, "impact");
}

TEST(Scales, AMissingOrMisplacedLevelIsNamed) {
  const TemporaryFolder folder;
  const std::string whole = core::readFile(sourceFolder() / "resources/scales/occurrence.json");
  folder.write("impact.json", core::readFile(sourceFolder() / "resources/scales/impact.json"));
  const auto errorWith = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    folder.write("occurrence.json", text);
    return test_support::thrownMessage([&] { (void)readScales(folder.path()); });
  };
  EXPECT_EQ(errorWith("\"value\": 3", "\"value\": 3"), "");
  EXPECT_THAT(errorWith("\"value\": 3", "\"value\": 4"), HasSubstr("/levels/2/value: is 4"));
  EXPECT_THAT(errorWith("\"value\": 10", "\"value\": 11"), HasSubstr("/levels/9/value: is 11"));
  EXPECT_THAT(errorWith("\"question\"", "\"qestion\""), HasSubstr("question"));
  EXPECT_THAT(errorWith("\"id\": \"occurrence\"", "\"id\": \"impact\""), HasSubstr("/id"));
}
