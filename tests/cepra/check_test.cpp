#include "cepra/check.h"

#include <functional>
#include <gmock/gmock.h>

#include "tests/percollect/small_graph.h"

using cepra::buildTable;
using cepra::check;
using cepra::Table;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// One row, p, with the cause x.
Table complete() {
  Table table = buildTable(test_support::smallGraph({"e:p", "d:x"}, {{"p", "x"}}));
  table.rows[0].occurrence = {3, "why", "Sensor expert"};
  table.rows[0].impact = {4, "why", "System expert"};
  return table;
}

std::vector<std::string> findingsAfter(const std::function<void(Table&)>& edit) {
  Table table = complete();
  edit(table);
  std::vector<std::string> texts;
  for (const auto& finding : check(table)) texts.push_back(toString(finding));
  return texts;
}

}  // namespace

TEST(CheckTable, ACompleteTableHasNoFindings) {
  EXPECT_THAT(findingsAfter([](Table&) {}), ElementsAre());
}

TEST(CheckTable, NamesRowAndColumnOfWhatIsMissing) {
  const std::string row = "row " + complete().rows[0].key;
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].impact.rationale.clear(); }),
              ElementsAre(HasSubstr(row + ", column impact_rationale: warning: the score has no rationale")));
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].occurrence.expert.clear(); }),
              ElementsAre(HasSubstr(row + ", column occurrence_expert: warning: the score has no expert")));
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].suspect = "Look."; }),
              ElementsAre(HasSubstr("column suspect: warning: Look.")));
}

TEST(CheckTable, ARowScoredByOneRoleOnlyIsNamed) {
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].impact = {}; }),
              ElementsAre(HasSubstr("column impact: warning: only the occurrence is scored"),
                          HasSubstr("1 of 1 rows have no relevance yet")));
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].impact.expert = "Sensor expert"; }),
              ElementsAre(HasSubstr("note: occurrence and impact were both scored by Sensor expert")));
}

TEST(CheckTable, ImpossibleScoresAndDoubledKeysAreErrors) {
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows[0].impact.value = 11; }),
              ElementsAre(HasSubstr("column impact: error: the score is 11")));
  EXPECT_THAT(findingsAfter([](Table& t) { t.rows.push_back(t.rows[0]); }),
              ElementsAre(HasSubstr("column key: error: the key is used twice")));
}

TEST(CheckTable, ARationaleWithoutScoreAndAnEffectWithoutCauseAreNamed) {
  const auto texts = findingsAfter([](Table& t) {
    t.rows[0].occurrence.value.reset();
    t.rows[0].causes.clear();
  });
  EXPECT_THAT(texts, Contains(HasSubstr("column occurrence: warning: there is a rationale but no score")));
  EXPECT_THAT(texts, Contains(HasSubstr("note: the effect 'p' has no cause")));
}
