#include "report/page.h"

#include <gmock/gmock.h>

#include "tests/report/svg_reader.h"

namespace report {
namespace {

using testing::HasSubstr;
using testing::Not;

Page examplePage() {
  Page page("Report <1> & more", "run-1");
  page.banner("Synthetic data", Tone::Warning);
  page.answer("Answer", badge("no gap", Tone::Good), "They agree & more.", {{"How sure", text("90 %")}});
  page.section("Verdict", "verdict", badge("passed", Tone::Good));
  page.keyValues({{"requirement", text("a < b")}, {"expression", code("abs(d_bias) <= 1")}});
  page.lead("What <it> shows.");
  page.table({{"sample", Align::Left, true}, {"value", Align::Right}, {"share"}},
             {{text("r10"), shaded("0.1", 0.1), shareBar(0.62)}}, "a caption");
  page.block(definitions({{"a term", "word-a", text("its meaning")}}));
  page.block(orderedList({text("first"), text("second")}));
  page.beginDetails("Files used");
  page.preformatted("<raw>\x01");
  page.endDetails();
  return page;
}

TEST(Page, IsWellFormedAndEscapesWhatItIsGiven) {
  const std::string html = examplePage().html();
  report_test::eachElement(html, [](const tinyxml2::XMLElement&) {});
  EXPECT_THAT(html, HasSubstr("Report &lt;1&gt; &amp; more"));
  EXPECT_THAT(html, Not(HasSubstr("<raw>")));
  EXPECT_THAT(html, Not(HasSubstr("\x01")));  // no XML can hold it
}

TEST(Page, NeedsNothingFromElsewhere) {
  const std::string html = examplePage().html();
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

// Who cannot see colours or bars still reads the number, and a screen reader knows what a row is about.
TEST(Page, BarsAndShadesCarryTheirNumbersAndRowsTheirHeaders) {
  const std::string html = examplePage().html();
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">r10</th>"));
  EXPECT_THAT(html, HasSubstr(" 62 %"));
  EXPECT_THAT(html, HasSubstr("<caption>a caption</caption>"));
  EXPECT_THAT(html, HasSubstr("<dt id=\"word-a\">"));
}

TEST(Page, AnswersBeforeItsContents) {
  const std::string html = examplePage().html();
  EXPECT_LT(html.find("id=\"answer\""), html.find("<main>"));
}

TEST(Page, ListsItsSectionsOnceThereAreThree) {
  Page page("Report");
  page.section("One", "one");
  page.section("Two", "two");
  EXPECT_THAT(page.html(), Not(HasSubstr("<nav")));
  page.section("Three", "three");
  EXPECT_THAT(page.html(), HasSubstr("<a href=\"#three\">Three</a>"));
}

TEST(Page, AVerdictIsAWordNotOnlyAColour) { EXPECT_THAT(badge("failed", Tone::Bad).markup(), HasSubstr(">failed<")); }

}  // namespace
}  // namespace report
