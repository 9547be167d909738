#include "app/desktop/tsv.h"

#include <gtest/gtest.h>

namespace {

using desktop::CellBlock;
using desktop::fromTsv;
using desktop::toTsv;

TEST(Tsv, BlocksComeBackAsTheyWere) {
  const CellBlock block = {{"7", "fog is \"common\""}, {"", "two\nlines"}, {"a\tb", "c\r\nd"}};
  EXPECT_EQ(fromTsv(toTsv(block)), block);
}

TEST(Tsv, AnEmptyLineIsARowWithOneEmptyCell) { EXPECT_EQ(fromTsv("3\n\n5\n"), (CellBlock{{"3"}, {""}, {"5"}})); }

TEST(Tsv, WindowsLineBreaksEndRows) { EXPECT_EQ(fromTsv("1\t2\r\n3\t4\r\n"), (CellBlock{{"1", "2"}, {"3", "4"}})); }

TEST(Tsv, AQuoteInsideAnUnquotedCellIsAnOrdinaryCharacter) {
  EXPECT_EQ(fromTsv("5\" wheel\tx"), (CellBlock{{"5\" wheel", "x"}}));
}

TEST(Tsv, AnOpenQuoteEndsWithTheText) { EXPECT_EQ(fromTsv("\"open\t1"), (CellBlock{{"open\t1"}})); }

TEST(Tsv, NothingIsNoBlock) { EXPECT_TRUE(fromTsv("").empty()); }

}  // namespace
