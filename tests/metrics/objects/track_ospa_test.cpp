#include "metrics/objects/track_ospa.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::LabelledOptions;
using metrics::ospaOfTracks;
using metrics::ospaT;
using metrics::SetOptions;
using metrics::Track;
using metrics::TrackOspa;
using metrics_test::RandomObjects;
using metrics_test::trackAlongX;
using metrics_test::TrackList;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

// Two measured tracks 10 m apart. The simulated ones follow them exactly but change sides after 3 of 5 steps.
TrackList twoTracks() { return {trackAlongX(0, {0, 0, 0, 0, 0}, 5), trackAlongX(0, {10, 10, 10, 10, 10}, 5)}; }
TrackList crossing() { return {trackAlongX(0, {10, 10, 10, 0, 0}, 5), trackAlongX(0, {0, 0, 0, 10, 10}, 5)}; }

TEST(OspaT, ChargesTheLabelForAsLongAsTracksAreExchanged) {
  const TrackList measured = twoTracks();
  const TrackList simulated = crossing();
  const TrackOspa result =
      ospaT({.simulated = simulated, .measured = measured}, {.set = {.order = 1.0, .cutoff_m = 5.0}, .label_m = 2.0});
  EXPECT_THAT(result.per_step, ElementsAre(0.0, 0.0, 0.0, 2.0, 2.0));
  EXPECT_DOUBLE_EQ(result.mean, 0.8);
}

TEST(OspaT, LabelsFollowTheBestOverlapOverTheWholeTime) {
  const TrackList measured = twoTracks();
  const TrackList simulated = crossing();
  EXPECT_THAT(metrics::labelsOf({.simulated = simulated, .measured = measured}, 5.0), ElementsAre(1U, 0U));
}

TEST(OspaT, WithoutLabelPenaltyIsOspaAtEveryStep) {
  RandomObjects cases(70);
  for (int k = 0; k < 50; ++k) {
    const TrackList measured = cases.tracks(4, 6);
    const TrackList simulated = cases.tracks(4, 6);
    const SetOptions set{.order = 2.0, .cutoff_m = 3.0};
    const TrackOspa result = ospaT({.simulated = simulated, .measured = measured}, {.set = set, .label_m = 0.0});
    for (std::size_t step = 0; step < result.per_step.size(); ++step) {
      metrics_test::ObjectList lists[2];
      for (const Track& t : simulated) {
        if (t.existsAt(step)) lists[0].push_back({.position = *t.positions[step]});
      }
      for (const Track& t : measured) {
        if (t.existsAt(step)) lists[1].push_back({.position = *t.positions[step]});
      }
      EXPECT_NEAR(result.per_step[step], ospa({.simulated = lists[0], .measured = lists[1]}, set).distance, 1e-12);
    }
  }
}

TEST(OspaT, GrowsWithTheLabelPenalty) {
  RandomObjects cases(71);
  for (int k = 0; k < 50; ++k) {
    const TrackList measured = cases.tracks(4, 6);
    const TrackList simulated = cases.tracks(4, 6);
    double before = 0.0;
    for (const double label : {0.0, 1.0, 2.0, 3.0}) {
      const double mean = ospaT({.simulated = simulated, .measured = measured},
                                {.set = {.order = 1.0, .cutoff_m = 3.0}, .label_m = label})
                              .mean;
      EXPECT_GE(mean, before - 1e-12);
      before = mean;
    }
  }
}

TEST(OspaT, OfNoTracksIsNothing) {
  EXPECT_EQ(ospaT({}).mean, 0.0);
  const TrackList two = twoTracks();
  EXPECT_THAT(ospaT({.simulated = two, .measured = {}}).per_step,
              Pointwise(DoubleNear(1e-14), std::vector<double>(5, 5.0)));
}

TEST(OspaOfTracks, IsAMetricOnSetsOfTracks) {
  RandomObjects cases(72);
  for (int k = 0; k < 500; ++k) {
    const TrackList a = cases.tracks(3, 5);
    const TrackList b = cases.tracks(3, 5);
    const TrackList c = cases.tracks(3, 5);
    const SetOptions options{.order = k % 2 == 0 ? 1.0 : 2.0, .cutoff_m = 3.0};
    const auto d = [&](const TrackList& x, const TrackList& y) {
      return ospaOfTracks({.simulated = x, .measured = y}, options).distance;
    };
    EXPECT_EQ(d(a, a), 0.0);
    EXPECT_NEAR(d(a, b), d(b, a), 1e-12);
    EXPECT_LE(d(a, c), d(a, b) + d(b, c) + 1e-12);
  }
}

// A track of 10 steps against its first 6 and last 4: the longer piece lacks 4 of 10 steps, the other is one too many.
TEST(OspaOfTracks, BrokenTrackPaysForWhatItsPiecesLack) {
  const std::vector<double> still(10, 0.0);
  const TrackList whole{trackAlongX(0, still, 10)};
  const TrackList pieces{trackAlongX(0, {0, 0, 0, 0, 0, 0}, 10), trackAlongX(6, {0, 0, 0, 0}, 10)};
  const double d = ospaOfTracks({.simulated = pieces, .measured = whole}, {.order = 1.0, .cutoff_m = 5.0}).distance;
  EXPECT_DOUBLE_EQ(d, (0.4 * 5.0 + 5.0) / 2.0);
}

TEST(TrackSets, RefuseWhatIsNoTrack) {
  const TrackList good = twoTracks();
  const TrackList shorter{trackAlongX(0, {0, 0}, 2)};
  const TrackList nowhere{trackAlongX(0, {}, 5)};
  TrackList not_finite = twoTracks();
  not_finite[1].positions[3]->x_m = 1.0 / 0.0;
  EXPECT_THROW((void)ospaT({.simulated = shorter, .measured = good}), core::InputError);
  EXPECT_THROW((void)ospaT({.simulated = nowhere, .measured = good}), core::InputError);
  EXPECT_THROW((void)ospaT({.simulated = good, .measured = good}, {.set = {.cutoff_m = 2.0}, .label_m = 2.5}),
               core::InputError);
  try {
    (void)ospaT({.simulated = not_finite, .measured = good});
    FAIL() << "took infinity";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, "simulated track 2, step 4");
  }
}

}  // namespace
