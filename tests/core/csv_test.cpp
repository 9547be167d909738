#include "core/csv.h"

#include <gmock/gmock.h>

using testing::ElementsAre;
using testing::Pair;

namespace {

std::vector<std::pair<int, std::string>> linesAndFirstFields(std::string_view text, char delimiter = ',') {
  std::vector<std::pair<int, std::string>> records;
  core::eachCsvRecord(
      text,
      [&](int line, std::span<const std::string_view> fields) { records.emplace_back(line, std::string(fields[0])); },
      delimiter);
  return records;
}

}  // namespace

TEST(EachCsvRecord, CountsALineOnceWhateverItsEnd) {
  const auto expected = ElementsAre(Pair(1, "a"), Pair(2, "b\nc"), Pair(5, "d"));
  EXPECT_THAT(linesAndFirstFields("a,1\n\"b\nc\",2\n\nd,3\n"), expected);
  EXPECT_THAT(linesAndFirstFields("a,1\r\n\"b\nc\",2\r\n\r\nd,3\r\n"), expected);
}

TEST(EachCsvRecord, SplitsAtTheGivenDelimiterOnly) {
  EXPECT_THAT(linesAndFirstFields("a,b;c\n", ';'), ElementsAre(Pair(1, "a,b")));
}
