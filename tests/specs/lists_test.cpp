#include "specs/lists.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/file.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using test_specs::kEve;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

class Lists : public ::testing::Test {
 protected:
  Lists() {
    test_specs::fill(store);
    writeLists(store.specification(), folder / "lists");
  }
  /// Edits one list as a spreadsheet would.
  void edit(const std::string& list, const std::string& what, const std::string& by) const {
    const auto file = folder / "lists" / list;
    core::writeFile(file, replaced(core::readFile(file), what, by));
  }
  ListChanges import(bool remove_missing = false) {
    return applyLists(store, readLists(folder / "lists", store.specification()), remove_missing, kEve);
  }
  std::string complaint() {
    try {
      import();
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  }
  test_support::TemporaryFolder folder;
  ProjectStore store = ProjectStore::create(folder / "demo.fidelis");
};

TEST_F(Lists, RoundTripLosesNothing) {
  auto nasty = store.find<Requirement>("RangeError_Fog_1").value();
  nasty.title = "=1+1";
  nasty.text = "'quoted', \"twice\"\r\nand; a line\n";
  nasty.rationale = "'";
  nasty.author = "-\t@";
  nasty.effects = {"a;b", "", " c "};
  store.update(nasty, kEve);
  const Specification before = store.specification();
  writeLists(before, folder / "lists");

  auto other = ProjectStore::create(folder / "other.fidelis");
  other.saveGraph(test_specs::smallGraph(), kEve);
  other.saveCepra(cepra::buildTable(test_specs::smallGraph()), kEve);
  applyLists(other, readLists(folder / "lists", other.specification()), false, kEve);
  const Specification after = other.specification();
  EXPECT_EQ(after.requirements, before.requirements);
  EXPECT_EQ(after.tests, before.tests);
  EXPECT_EQ(after.experiment_data, before.experiment_data);
  EXPECT_EQ(after.reference_data, before.reference_data);
  EXPECT_EQ(after.links, before.links);
  EXPECT_EQ(after.cepra, before.cepra);
}

TEST_F(Lists, ReadAgainChangeNothing) {
  const ListChanges changes = import(true);
  EXPECT_EQ(changes.added + changes.changed + changes.removed, 0u);
}

TEST_F(Lists, AnEditedCellIsOneChange) {
  edit("acceptance_tests.csv", "0.005", "0.010");
  edit("requirements.csv", "RangeError_Fog_2", "RangeError_Aerosols_7");  // renamed: the uid tells
  edit("links.csv", "RangeError_Fog_2,RangeError_Fog_3", "RangeError_Aerosols_7,RangeError_Fog_3");
  edit("links.csv", "RangeError_Fog_1,RangeError_Fog_2", "RangeError_Fog_1,RangeError_Aerosols_7");
  EXPECT_EQ(import().changed, 2u);
  EXPECT_EQ(store.find<AcceptanceTest>("RangeError_Fog_3")->expression, "abs(d_bias) <= 0.010 * range_m");
  EXPECT_EQ(store.originsOf("RangeError_Fog_3").front().id, "RangeError_Aerosols_7");
}

TEST_F(Lists, WhatTheyLackIsRemovedOnlyOnRequest) {
  core::writeFile(folder / "lists/reference_data.csv", "id,title\n");
  const ReadLists lists = readLists(folder / "lists", store.specification());
  EXPECT_THAT(lists.missing, ElementsAre("RangeError_Fog_5"));
  EXPECT_EQ(applyLists(store, lists, false, kEve).removed, 0u);
  EXPECT_TRUE(store.find<ReferenceData>("RangeError_Fog_5"));
  edit("links.csv", "RangeError_Fog_3,RangeError_Fog_5,\n", "");
  EXPECT_EQ(import(true).removed, 1u) << "its link went with it";
  EXPECT_FALSE(store.find<ReferenceData>("RangeError_Fog_5"));
}

TEST_F(Lists, ColumnsMayBeLeftOutAndMoved) {
  core::writeFile(folder / "lists/requirements.csv",
                  "status,id\nrejected,RangeError_Fog_1\nUnder review,RangeError_Fog_2\n");
  import();
  EXPECT_EQ(store.find<Requirement>("RangeError_Fog_1")->status, Status::Rejected);
  EXPECT_EQ(store.find<Requirement>("RangeError_Fog_1")->title, "Fog is modelled");
}

TEST_F(Lists, ABadCellIsNamedAndNothingIsTaken) {
  edit("acceptance_tests.csv", "accepted", "acepted");
  edit("requirements.csv", "Fog is modelled", "changed");
  EXPECT_THAT(complaint(), AllOf(HasSubstr("acceptance_tests.csv:2, row 2, column status"), HasSubstr("'acepted'")));
  EXPECT_EQ(store.find<Requirement>("RangeError_Fog_1")->title, "Fog is modelled");
}

TEST_F(Lists, ABadLinkUndoesTheWholeImport) {
  edit("requirements.csv", "Fog is modelled", "changed");
  edit("links.csv", "RangeError_Fog_1,RangeError_Fog_2", "RangeError_Fog_1,RangeError_Fag_2");
  EXPECT_THAT(complaint(), HasSubstr("Did you mean 'RangeError_Fog_2'?"));
  EXPECT_EQ(store.find<Requirement>("RangeError_Fog_1")->title, "Fog is modelled");
}

TEST_F(Lists, UnknownColumnsAndEmptyFoldersAreErrors) {
  edit("requirements.csv", "rationale", "rationales");
  EXPECT_THAT(complaint(), HasSubstr("Did you mean 'rationale'?"));
  std::filesystem::create_directories(folder / "empty");
  EXPECT_THROW((void)readLists(folder / "empty", store.specification()), core::InputError);
}

TEST(GuardedCells, AreNoFormulasAndComeBack) {
  for (const std::string text : {"", "a", "=1", "+1", "-1", "@x", "'", "''", "'=1", "'a", "\tx", "a=1"}) {
    EXPECT_EQ(unguardedCell(guardedCell(text)), text);
    EXPECT_TRUE(guardedCell(text).empty() || std::string("=+-@\t").find(guardedCell(text)[0]) == std::string::npos);
  }
  EXPECT_EQ(unguardedCell("'tis typed"), "'tis typed");
}

}  // namespace
}  // namespace specs
