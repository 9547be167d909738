#include "core/forward_progress.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace {

/// Keeps what it is told.
class Heard final : public core::Progress {
 public:
  void report(double fraction, std::string_view doing) override {
    fractions.push_back(fraction);
    last = doing;
  }
  [[nodiscard]] bool cancelled() const override { return stopped; }

  std::vector<double> fractions;
  std::string last;
  bool stopped = false;
};

TEST(ForwardProgress, NeverGoesBackAndSaysWhatIsDoneNow) {
  Heard heard;
  core::ForwardProgress progress(heard);
  for (const double fraction : {0.2, 0.6, 0.4}) progress.report(fraction, "fitting");
  progress.report(0.7, "judging");
  EXPECT_EQ(heard.fractions, (std::vector<double>{0.2, 0.6, 0.6, 0.7}));
  EXPECT_EQ(heard.last, "judging");
}

TEST(ForwardProgress, LetsAPersonStop) {
  Heard heard;
  const core::ForwardProgress progress(heard);
  EXPECT_FALSE(progress.cancelled());
  heard.stopped = true;
  EXPECT_TRUE(progress.cancelled());
}

}  // namespace
