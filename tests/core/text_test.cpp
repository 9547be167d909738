#include "core/text.h"

#include <gtest/gtest.h>

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
