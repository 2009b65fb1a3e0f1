// Numbers as they are typed.
#include "renderer/base/number.h"

#include <gtest/gtest.h>

namespace gbl {
namespace {

TEST(Numbers, DecimalsAreThoseOfJson) {
  EXPECT_EQ(decimal("12"), 12);
  EXPECT_EQ(decimal("-0.5"), -0.5);
  EXPECT_EQ(decimal("0"), 0);
  EXPECT_EQ(decimal("1e-3"), 1e-3);
  EXPECT_EQ(decimal("1E+3"), 1e3);
  EXPECT_EQ(decimal("0.1"), 0.1);
  for (const char* text : {"",     "-",  ".5", "5.",  "010", "-01", "0x10", "+1",    "nan", "inf",
                           "-inf", " 1", "1 ", "1,5", "1e",  "1e+", "--1",  "1e999", "1f",  "1_000"})
    EXPECT_FALSE(decimal(text)) << text;
}

TEST(Numbers, WholeOnesHaveNoPointAndNoExponent) {
  EXPECT_EQ(whole_decimal("16384"), 16384);
  EXPECT_EQ(whole_decimal("-3"), -3);
  for (const char* text : {"", "1.0", "1e3", "010", "0x10", "+8", "99999999999999999999"})
    EXPECT_FALSE(whole_decimal(text)) << text;
}

}  // namespace
}  // namespace gbl
