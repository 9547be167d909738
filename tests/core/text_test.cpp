#include "core/text.h"

#include <gtest/gtest.h>
#include <limits>

using core::findInvalidUtf8;

// The boundary cases are those of RFC 3629, section 3 and 4.
TEST(Utf8, AcceptsEveryLengthOfSequenceAtItsLimits) {
  for (const char* text : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                           "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(findInvalidUtf8(text), std::nullopt) << text;
  }
}

TEST(Utf8, RefusesOverlongFormsSurrogatesCutSequencesAndOtherEncodings) {
  for (const char* text : {"a\x80", "a\xc0\xaf", "a\xc1\xbf", "a\xe0\x9f\xbf", "a\xed\xa0\x80", "a\xf0\x8f\xbf\xbf",
                           "a\xf4\x90\x80\x80", "a\xf5\x80\x80\x80", "a\xe2\x82", "a\xfc",
                           "a\xfc"
                           "b"}) {
    EXPECT_EQ(findInvalidUtf8(text), 1u) << text;
  }
}

TEST(LineAt, CountsLineBreaksBeforeTheByte) {
  EXPECT_EQ(core::lineAt("a\nb\nc", 0), 1);
  EXPECT_EQ(core::lineAt("a\nb\nc", 2), 2);
  EXPECT_EQ(core::lineAt("a\nb\nc", 99), 3);
}

TEST(Significant, RoundsToItsDigitsAndWritesNoExponentUpToSevenPlaces) {
  EXPECT_EQ(core::significant(2062.4), "2060");
  EXPECT_EQ(core::significant(-2062.4, 2), "-2100");
  EXPECT_EQ(core::significant(2062.4, 6), "2062.4");
  EXPECT_EQ(core::significant(123456.0), "123000");
  EXPECT_EQ(core::significant(1e6), "1000000");
  EXPECT_EQ(core::significant(3.2e7), "3.2e+07");
}

// 999.6 has three places, what it is rounded to has four; and the same at the end of what is written out.
TEST(Significant, WhatRoundsUpToTheNextPowerOfTenIsWrittenAsThatPower) {
  EXPECT_EQ(core::significant(999.6), "1000");
  EXPECT_EQ(core::significant(99.96, 1), "100");
  EXPECT_EQ(core::significant(9.999e6), "1e+07");
}

TEST(Significant, SmallNumbersAndWhatIsNoNumberStayAsTheyWere) {
  EXPECT_EQ(core::significant(0.01234), "0.0123");
  EXPECT_EQ(core::significant(1.23456e-9, 2), "1.2e-09");
  EXPECT_EQ(core::significant(0.0), "0");
  EXPECT_EQ(core::significant(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(core::significant(std::numeric_limits<double>::quiet_NaN()), "nan");
}
