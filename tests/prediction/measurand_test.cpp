#include "prediction/measurand.h"

#include <gtest/gtest.h>

namespace {

using prediction::compatible;
using prediction::Measurand;
using prediction::measurandNamed;

TEST(Measurand, NameAndColumnOfADetectionMeanTheSame) {
  EXPECT_EQ(measurandNamed("epw"), (Measurand{"epw", "epw_m", "m"}));
  EXPECT_EQ(measurandNamed("epw_m"), measurandNamed("epw"));
  EXPECT_EQ(measurandNamed("speed_m_s"), (Measurand{"speed_m_s", "speed_m_s", ""}));
}

// What was not recorded contradicts nothing; what was must agree.
TEST(Measurand, IsCompatibleUnlessBothRecordedOtherwise) {
  const Measurand range{"range", "range_m", "m"};
  EXPECT_TRUE(compatible(range, {"range", "", ""}));
  EXPECT_TRUE(compatible(range, {"distance", "range_m", "m"}));
  EXPECT_FALSE(compatible(range, {"range", "range_m", "mm"}));
  EXPECT_FALSE(compatible(range, {"range", "range_cm", ""}));
  EXPECT_FALSE(compatible(range, {"epw", "epw_m", "m"}));
}

TEST(Measurand, ReadsBackWhatItWrote) {
  for (const Measurand& measurand : {Measurand{"range", "range_m", "m"}, Measurand{"range", "", ""}}) {
    const nlohmann::json written = prediction::toJson(measurand);
    EXPECT_EQ(prediction::readMeasurand(core::JsonObject(written, "file.json")), measurand);
  }
}

}  // namespace
