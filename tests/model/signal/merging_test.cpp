#include "model/signal/merging.h"

#include <gtest/gtest.h>

namespace model {
namespace {

DetectionStage stageOf(RangeMode mode) {
  DetectionStage stage;
  stage.range_mode = mode;
  stage.echo_separation_m = 5.0;
  return stage;
}

// A surface at 20 m, 2 m wide (c · width), and a weaker pulse 3 m behind it, 1 m wide: rise at 19.5 m, fall at 23.25 m.
TEST(Intruders, AreOneEchoWithWhatIsNearerThanTheSeparation) {
  std::vector<Echo> echoes{{20.0, 2.0, 5e-6}, {23.0, 1.0, 1e-6}};
  mergeIntruders(echoes, 1, stageOf(RangeMode::kPeak));
  EXPECT_EQ(echoes[1].fate, Fate::kMerged);
  EXPECT_EQ(echoes[0].fate, Fate::kDetected);
  EXPECT_DOUBLE_EQ(echoes[0].range_m, 20.0);
  EXPECT_DOUBLE_EQ(echoes[0].epw_m, 2.0 * (23.25 - 19.5));
  EXPECT_DOUBLE_EQ(echoes[0].peak_w, 5e-6);
}

TEST(Intruders, TakeTheRangeIfTheyAreStronger) {
  std::vector<Echo> echoes{{20.0, 2.0, 1e-6}, {23.0, 1.0, 5e-6}};
  mergeIntruders(echoes, 1, stageOf(RangeMode::kPeak));
  EXPECT_DOUBLE_EQ(echoes[0].range_m, 23.0);
  EXPECT_DOUBLE_EQ(echoes[0].peak_w, 5e-6);
}

// Read at the leading edge, the surface reaches from 20 to 21 m, the pulse from 17 to 17.5 m; at the centre, the
// middle.
TEST(Intruders, AreReadLikeAllEchoes) {
  std::vector<Echo> edge{{20.0, 2.0, 5e-6}, {17.0, 1.0, 1e-6}}, centre = edge;
  mergeIntruders(edge, 1, stageOf(RangeMode::kLeadingEdge));
  EXPECT_DOUBLE_EQ(edge[0].range_m, 17.0);
  EXPECT_DOUBLE_EQ(edge[0].epw_m, 2.0 * (21.0 - 17.0));
  mergeIntruders(centre, 1, stageOf(RangeMode::kCentre));
  EXPECT_DOUBLE_EQ(centre[0].range_m, 0.5 * (16.75 + 20.5));
}

TEST(Intruders, StandAloneBeyondTheSeparation) {
  std::vector<Echo> echoes{{20.0, 2.0, 5e-6}, {25.0, 1.0, 1e-6}, {60.0, 1.0, 1e-6}};
  mergeIntruders(echoes, 1, stageOf(RangeMode::kPeak));
  for (const Echo& echo : echoes) EXPECT_EQ(echo.fate, Fate::kDetected);
  EXPECT_DOUBLE_EQ(echoes[0].epw_m, 2.0);
}

TEST(Intruders, DoNotMergeWhatWasThereBefore) {
  std::vector<Echo> echoes{{20.0, 2.0, 5e-6}, {21.0, 1.0, 1e-6}};
  mergeIntruders(echoes, 2, stageOf(RangeMode::kPeak));
  EXPECT_EQ(echoes[1].fate, Fate::kDetected);
}

}  // namespace
}  // namespace model
