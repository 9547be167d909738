#include "specs/documents.h"

#include <gmock/gmock.h>
#include <regex>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Documents : public ::testing::Test {
 protected:
  Documents() {
    auto store = ProjectStore::create(folder / "demo.fidelis");
    test_specs::fill(store);
    store.storeRun(
        {.verdicts = {{.test = "RangeError_Fog_3", .verdict = Verdict::Failed, .text = "d_bias too large"}}});
    spec = store.specification();
  }
  test_support::TemporaryFolder folder;
  Specification spec;
};

std::set<std::string> all(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) found.insert((*at)[1]);
  return found;
}

TEST_F(Documents, HtmlLinksLeadSomewhereAndEveryItemIsAnAnchor) {
  const std::string html = htmlText(spec);
  const auto anchors = all(html, "id=\"([^\"]+)\"");
  for (const std::string& target : all(html, "href=\"#([^\"]+)\"")) EXPECT_TRUE(anchors.count(target)) << target;
  for (const Link& link : spec.links) {
    EXPECT_TRUE(anchors.count(link.from)) << link.from;
    EXPECT_TRUE(anchors.count(link.to)) << link.to;
  }
}

TEST_F(Documents, HtmlIsOneFileThatLoadsNothing) {
  const std::string html = htmlText(spec);
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST_F(Documents, HtmlEscapesWhatPeopleWrite) {
  spec.requirements[0].title = "<script>alert(1)</script>";
  spec.requirements[0].text = "a & b < c";
  const std::string html = htmlText(spec);
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("a &amp; b &lt; c"));
}

TEST_F(Documents, HtmlTellsStatusAndVerdictInWords) {
  const std::string html = htmlText(spec);
  EXPECT_THAT(html, HasSubstr("✓ accepted"));
  EXPECT_THAT(html, HasSubstr("○ under review"));
  EXPECT_THAT(html, HasSubstr("✗ failed"));
  EXPECT_THAT(html, HasSubstr("d_bias too large"));
}

TEST_F(Documents, EveryFormatGivesTheSameBytesTwice) {
  for (const DocumentFormat& format : documentFormats()) {
    const auto first = folder / ("first-" + std::string(format.name));
    const auto second = folder / ("second-" + std::string(format.name));
    format.write(spec, first);
    format.write(spec, second);
    if (format.is_folder) {
      for (const auto& entry : std::filesystem::directory_iterator(first)) {
        EXPECT_EQ(core::readFile(entry.path()), core::readFile(second / entry.path().filename()));
      }
    } else {
      EXPECT_EQ(core::readFile(first), core::readFile(second)) << format.name;
    }
  }
}

TEST_F(Documents, XlsxIsAZipOfSheets) {
  writeXlsx(spec, folder / "out.xlsx");
  const std::string bytes = core::readFile(folder / "out.xlsx");
  EXPECT_EQ(bytes.substr(0, 2), "PK");
  EXPECT_THAT(bytes, HasSubstr("xl/worksheets/sheet6.xml"));
}

TEST_F(Documents, VeryLongTextsStillMakeAWorkbook) {
  spec.requirements[0].text = std::string(200'000, 'x');
  writeXlsx(spec, folder / "out.xlsx");
  EXPECT_GT(std::filesystem::file_size(folder / "out.xlsx"), 5000u);
}

TEST_F(Documents, JsonHoldsEveryList) {
  writeJsonDump(spec, folder / "out.json");
  const nlohmann::json dump = core::readJson(folder / "out.json");
  EXPECT_EQ(dump.at("requirements").size(), 2u);
  EXPECT_EQ(dump.at("acceptance_tests")[0].at("expression"), "abs(d_bias) <= 0.005 * range_m");
  EXPECT_EQ(dump.at("latest_verdicts").at("RangeError_Fog_3"), "failed");
}

TEST_F(Documents, AFolderThatIsNotThereIsAnError) {
  for (const DocumentFormat& format : documentFormats()) {
    if (!format.is_folder) {
      EXPECT_THROW(format.write(spec, folder / "no/folder/x"), core::InputError) << format.name;
    }
  }
}

TEST(EmptySpecification, MakesEveryDocument) {
  test_support::TemporaryFolder folder;
  for (const DocumentFormat& format : documentFormats()) format.write({}, folder / std::string(format.name));
}

}  // namespace
}  // namespace specs
