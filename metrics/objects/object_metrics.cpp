#include "metrics/objects/object_metrics.h"

#include <utility>

#include "metrics/objects/gospa.h"
#include "metrics/objects/jaccard.h"
#include "metrics/objects/ospa.h"
#include "metrics/objects/ospa_mt.h"
#include "metrics/objects/track_ospa.h"
#include "metrics/objects/trajectory_metric.h"

namespace metrics {

namespace {

using Numbers = std::vector<double>;
constexpr std::string_view kOspa = "Schuhmacher et al. 2008, doi:10.1109/TSP.2008.920469";
constexpr std::string_view kGospa = "Rahmathullah et al. 2017, doi:10.23919/ICIF.2017.8009645";

/// The lists without objects that are too improbable.
struct ProbableLists {
  explicit ProbableLists(const ObjectListInput& in)
      : simulated((mustBeValid(in.lists), existing(in.lists.simulated, in.options.least_existence))),
        measured(existing(in.lists.measured, in.options.least_existence)) {}

  [[nodiscard]] ObjectLists view() const noexcept { return {.simulated = simulated, .measured = measured}; }

  std::vector<Object> simulated;
  std::vector<Object> measured;
};

Numbers jaccard(const ObjectListInput& in) { return {jaccardDistance(ProbableLists(in).view())}; }

Numbers ospaParts(const ObjectListInput& in) {
  const Ospa d = ospa(ProbableLists(in).view(), in.options.set);
  return {d.distance, d.localisation, d.cardinality};
}

Numbers gospaParts(const ObjectListInput& in) {
  const Gospa d = gospa(ProbableLists(in).view(), in.options.set);
  return {d.distance, d.localisation, static_cast<double>(d.missed), static_cast<double>(d.false_objects)};
}

Numbers ospaTMean(const TracksInput& in) {
  return {ospaT(in.sets, {.set = in.options.set, .label_m = in.options.label_m}).mean};
}

Numbers ospaMtParts(const TracksInput& in) {
  const MultiTrackOspa d = ospaMt(in.sets, {.set = in.options.set, .piece_m = in.options.piece_m});
  return {d.distance, static_cast<double>(d.pieces)};
}

Numbers ospaOfTracksParts(const TracksInput& in) {
  const Ospa d = ospaOfTracks(in.sets, in.options.set);
  return {d.distance, d.localisation, d.cardinality};
}

Numbers trackMetricParts(const TracksInput& in) {
  const TrajectoryDistance d = trajectoryDistance(in.sets, {.set = in.options.set, .switch_m = in.options.switch_m});
  return {d.distance, d.localisation, d.missed, d.false_objects, d.switches};
}

template <typename Input>
MetricOf<Input> entry(DataKind kind, MetricInfo info, std::vector<std::string_view> parts,
                      Numbers (*compute)(const Input&)) {
  info.best = "0";
  info.scale = Scale::Interval;
  info.data = {kind};
  return {.info = std::move(info),
          .shape = parts.empty() ? MetricShape::Number : MetricShape::Object,
          .parts = std::move(parts),
          .compute = compute};
}

MetricOf<ObjectListInput> ofLists(MetricInfo info, std::vector<std::string_view> parts,
                                  Numbers (*compute)(const ObjectListInput&)) {
  return entry(DataKind::ObjectList, std::move(info), std::move(parts), compute);
}

MetricOf<TracksInput> ofTracks(MetricInfo info, std::vector<std::string_view> parts,
                               Numbers (*compute)(const TracksInput&)) {
  return entry(DataKind::Tracks, std::move(info), std::move(parts), compute);
}

/// The lists: one entry a metric. x real, y simulated.
std::vector<MetricOf<ObjectListInput>> makeObjectMetrics() {
  return {
      ofLists({.number = 24,
               .name = "jaccard",
               .title = "Jaccard distance",
               .meaning = "1 - intersection over union of the objects' boxes, mean over the larger list",
               .formula = "1 - |x and y| / |x or y|; OSPA of it with p = c = 1",
               .worst = "1",
               .unit = MetricUnit::None,
               .source = "Jaccard 1912, doi:10.1111/j.1469-8137.1912.tb05611.x; the mean over a list is ours",
               .meets = "12347"},
              {}, jaccard),
      ofLists({.number = 25,
               .name = "ospa",
               .title = "optimal sub-pattern assignment",
               .meaning = "error per object of the larger list; an object too many costs c",
               .formula = "(1/n (min sum_i min(c, |x_i - y_i|)^p + c^p (n - m)))^(1/p)",
               .worst = "c",
               .source = kOspa,
               .meets = "23457"},
              {"distance", "localisation", "cardinality"}, ospaParts),
      ofLists({.number = 28,
               .name = "gospa",
               .title = "generalised optimal sub-pattern assignment",
               .meaning = "localisation errors of pairs, and a price for each missed and each false object",
               .formula = "(min sum_pairs |x - y|^p + c^p/2 (missed + false))^(1/p)",
               .worst = "infinity",
               .source = kGospa,
               .meets = "2345"},
              {"distance", "localisation", "missed", "false"}, gospaParts),
  };
}

std::vector<MetricOf<TracksInput>> makeTrackMetrics() {
  return {
      ofTracks({.number = 26,
                .name = "ospa_t",
                .title = "OSPA for tracks",
                .meaning = "OSPA with a price for wrong labels, mean over time",
                .formula = "mean_k OSPA of d = (|x - y|^p + alpha^p [labels differ])^(1/p)",
                .worst = "c",
                .source = "Ristic et al. 2011, doi:10.1109/TSP.2011.2140111; the mean over time is ours",
                .meets = "257"},
               {}, ospaTMean),
      ofTracks(
          {.number = 27,
           .name = "ospa_mt",
           .title = "OSPA for multiple tracks (OSPA-MT), our reading",
           .meaning = "OSPA over time with whole tracks assigned, several pieces of a broken one to one",
           .formula =
               "(sum_k (sum matched |x - y|^p + Delta^p [further piece] + c^p unmatched) / sum_k max(n_k, m_k))^(1/p)",
           .worst = "c",
           .source = "after Vu & Evans 2018, arXiv:1808.02242, of which only the abstract was at hand",
           .meets = "2357"},
          {"distance", "pieces"}, ospaMtParts),
      ofTracks({.number = 0,
                .name = "ospa_2",
                .title = "OSPA(2)",
                .meaning = "OSPA of whole tracks, which are compared by their mean cut-off distance over time",
                .formula = "OSPA of d = mean over k where x or y exists of min(c, |x_k - y_k|)",
                .worst = "c",
                .source = "Beard et al. 2020, doi:10.1109/TSP.2020.2986136",
                .meets = "23457"},
               {"distance", "localisation", "cardinality"}, ospaOfTracksParts),
      ofTracks({.number = 29,
                .name = "track_metric",
                .title = "Rahmathullah's track metric (trajectory GOSPA)",
                .meaning = "GOSPA at every time step, and a price for each switch of tracks",
                .formula = "(min sum_k D(k).W(k) + gamma^p/2 sum_k |W(k+1) - W(k)|)^(1/p)",
                .worst = "infinity",
                .source = "Rahmathullah et al. 2016, arXiv:1605.01177; 2020, doi:10.1109/TSP.2020.3005309",
                .meets = "2345"},
               {"distance", "localisation", "missed", "false", "switches"}, trackMetricParts),
  };
}

}  // namespace

std::span<const MetricOf<ObjectListInput>> objectMetrics() {
  static const std::vector<MetricOf<ObjectListInput>> list = makeObjectMetrics();
  return list;
}

std::span<const MetricOf<TracksInput>> trackMetrics() {
  static const std::vector<MetricOf<TracksInput>> list = makeTrackMetrics();
  return list;
}

}  // namespace metrics
