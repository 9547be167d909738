#include "gap/causes/starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/physics.h"
#include "model/extinction.h"

namespace gap {

namespace {

constexpr std::size_t kMostStrata = 4;  // of azimuth, and of range
// How strong the cause is there, the map does not say: shares of the plausible range, and of its logarithm.
constexpr std::array kStrengths = {0.002, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.6, 0.9};
constexpr std::array kLogStrengths = {0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.9};
static_assert(kStrengths.size() == kLogStrengths.size());
constexpr double kDistances_m[] = {4.0, 8.0, 14.0, 22.0};                       // of a cloud in a direction
constexpr double kVisibilities_m[] = {30.0, 60.0, 120.0, 240.0, 480.0, 960.0};  // thinner ones are hardly seen
constexpr double kLidarRatios_sr[] = {12.0, 20.0, 35.0, 65.0, 120.0};           // of fogs, Hahner et al. 2021: 65
constexpr double kPulls[] = {0.0, -0.25, 0.25, -0.5, 0.5};  // of the echo separation: within it two echoes are one

const model::SensorProfile& sensorOf(const Replay& replay) {
  return replay.baseline().model.sensor(replay.samples().front().sample->sensor);
}

/// How long the receiver listens after a shot. [s]
double listening_s(const model::SensorProfile& sensor) {
  return 2.0 * sensor.detection.max_range_m / core::kSpeedOfLight_m_s;
}

struct Stratum {
  double low, high;
  [[nodiscard]] double middle() const { return (low + high) / 2.0; }
  /// From edge to edge of its beams.
  [[nodiscard]] double width(double half_deg) const { return high - low + 2.0 * half_deg; }
};

std::vector<Stratum> strataOf(const std::vector<WhereRow>& where, const std::string& covariate) {
  std::vector<Stratum> strata;
  for (const WhereRow& row : where) {
    const auto same = [&](const Stratum& s) { return s.low == row.low && s.high == row.high; };
    if (row.covariate != covariate || strata.size() >= kMostStrata) continue;
    if (std::none_of(strata.begin(), strata.end(), same)) strata.push_back({row.low, row.high});
  }
  return strata;
}

/// The starts of a hypothesis, built up parameter by parameter.
class Starts {
 public:
  explicit Starts(const Hypothesis& hypothesis) : parameters_(hypothesis.parameters) {
    for (const FreeParameter& parameter : parameters_) typical_.push_back(parameter.start);
  }

  [[nodiscard]] bool has(const std::string& name) const { return place(name).has_value(); }
  using Setting = std::vector<std::pair<std::string, double>>;
  void add(const Setting& setting) {
    std::vector<double> start = typical_;
    for (const auto& [name, value] : setting) {
      if (const auto at = place(name)) start[*at] = std::clamp(value, parameters_[*at].low, parameters_[*at].high);
    }
    list_.push_back(std::move(start));
  }
  /// Every start so far with several strengths: of all numbers that are not settled together, and of each alone (a
  /// light may take much of a receiver's gain and make hardly any noise).
  void vary(const std::vector<std::string>& settled) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      if (std::count(settled.begin(), settled.end(), parameters_[i].name) == 0) all.push_back(i);
    std::vector<std::vector<std::size_t>> strengthened{all};
    for (std::size_t k = 0; all.size() > 1 && k < all.size(); ++k) strengthened.push_back({all[k]});
    std::vector<std::vector<double>> varied;
    for (const auto& start : list_) {
      for (const auto& numbers : strengthened) {
        for (std::size_t k = 0; k < kStrengths.size(); ++k) {
          varied.push_back(start);
          for (const std::size_t i : numbers) varied.back()[i] = strength(parameters_[i], k);
        }
      }
    }
    list_ = std::move(varied);
  }
  [[nodiscard]] std::vector<std::vector<double>> list() const { return list_; }

 private:
  static double strength(const FreeParameter& p, std::size_t k) {
    return p.logarithmic ? p.low * std::pow(p.high / p.low, kLogStrengths[k])
                         : p.low + kStrengths[k] * (p.high - p.low);
  }
  [[nodiscard]] std::optional<std::size_t> place(const std::string& name) const {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      if (parameters_[i].name == name) return i;
    }
    return std::nullopt;
  }
  const std::vector<FreeParameter>& parameters_;
  std::vector<double> typical_;
  std::vector<std::vector<double>> list_;
};

/// Fogs, thin and thick, of droplets that send back much or little: echoes of a fog are as wide as it is deep, and no
/// small step leads from one to another that is seen as well.
void addFogs(double wavelength_nm, Starts& starts) {
  for (const double visibility_m : kVisibilities_m)
    for (const double ratio_sr : kLidarRatios_sr)
      starts.add({{"visibility_m", visibility_m},
                  {"backscatter_1_m_sr", model::extinctionFromVisibility(visibility_m, wavelength_nm) / ratio_sr}});
}

/// Clouds in these directions, dark ones too if their albedo is free: light that is lost tells how wide they look, not
/// how far away they are. And one where echoes came from.
void addClouds(const std::vector<Stratum>& azimuths, double half_deg, const std::optional<UnexpectedEchoes>& extra,
               Starts& starts) {
  const auto add = [&](double azimuth_deg, double width_deg, double r, Starts::Setting setting) {
    setting.emplace_back("centre_x_m", r * std::cos(azimuth_deg * core::kRadPerDeg));
    setting.emplace_back("centre_y_m", r * std::sin(azimuth_deg * core::kRadPerDeg));
    setting.emplace_back("size_m", r * width_deg * core::kRadPerDeg);
    starts.add(setting);
  };
  for (const Stratum& a : azimuths) {
    for (const double r : kDistances_m) {
      add(a.middle(), a.width(half_deg), r, {});
      if (starts.has("albedo")) add(a.middle(), a.width(half_deg), r, {{"albedo", 0.0}});
    }
  }
  if (extra) add(extra->azimuth_deg, extra->width_deg, extra->range_m, {});
  starts.vary({"centre_x_m", "centre_y_m", "size_m", "albedo"});
}

/// Sectors that reach from edge to edge of these directions.
void addSectors(const std::vector<Stratum>& azimuths, double half_deg, Starts& starts) {
  for (const Stratum& a : azimuths)
    starts.add({{"azimuth_from_deg", a.low - half_deg}, {"azimuth_to_deg", a.high + half_deg}});
  starts.vary({"azimuth_from_deg", "azimuth_to_deg"});
}

Starts::Setting direction(const Stratum& azimuth, double half_deg) {
  return {{"azimuth_deg", azimuth.middle()}, {"width_deg", azimuth.width(half_deg)}};
}

void addDirections(const std::vector<Stratum>& azimuths, double half_deg, Starts& starts) {
  for (const Stratum& a : azimuths) starts.add(direction(a, half_deg));
  starts.vary({"azimuth_deg", "width_deg"});
}

/// False targets where directions and ranges cross, and where echoes came from. One pulls the echo that it merges with.
void addTargets(const std::vector<Stratum>& azimuths, const std::vector<Stratum>& ranges, double half_deg,
                double echo_separation_m, const std::optional<UnexpectedEchoes>& extra, Starts& starts) {
  for (const Stratum& a : azimuths) {
    for (const Stratum& r : ranges) {
      for (const double pull : kPulls) {
        Starts::Setting at = direction(a, half_deg);
        at.emplace_back("range_m", r.middle() + pull * echo_separation_m);
        starts.add(at);
      }
    }
  }
  if (extra)
    starts.add({{"azimuth_deg", extra->azimuth_deg}, {"width_deg", extra->width_deg}, {"range_m", extra->range_m}});
}

/// Gates that begin or end where echoes are, where a range stands out, and where all is lost.
void addGates(const Gate& gate, const std::vector<Stratum>& ranges, double half_step_m, Starts& starts) {
  constexpr double kFar_m = 1e9, kBit_m = 0.01;
  const auto opens = [&](double at_m) { starts.add({{"from_m", at_m}, {"to_m", kFar_m}}); };
  const auto closes = [&](double at_m) { starts.add({{"from_m", 0.0}, {"to_m", at_m}}); };
  if (gate.nearest_m) opens(*gate.nearest_m - half_step_m);
  if (gate.farthest_m) closes(*gate.farthest_m + half_step_m);
  for (const Stratum& r : ranges) {
    opens(r.high + kBit_m);
    closes(r.low - kBit_m);
  }
  if (gate.opens_m) opens(*gate.opens_m);
  if (gate.closes_m) closes(*gate.closes_m);
}

}  // namespace

std::vector<std::vector<double>> startsFrom(const Replay& replay, const Hypothesis& hypothesis,
                                            const WhereResult& where) {
  const model::SensorProfile& sensor = sensorOf(replay);
  const double half_deg = azimuthStep_deg(replay) / 2.0;
  const auto ranges = strataOf(where.rows, "range_m");
  auto azimuths = strataOf(where.rows, "azimuth_deg");
  for (const Sector& sector : where.sectors) azimuths.push_back({sector.from_deg + half_deg, sector.to_deg - half_deg});
  Starts starts(hypothesis);
  if (starts.has("azimuth_from_deg") && starts.has("azimuth_to_deg")) addSectors(azimuths, half_deg, starts);
  if (starts.has("azimuth_deg")) {
    if (starts.has("range_m"))
      addTargets(azimuths, ranges, half_deg, sensor.detection.echo_separation_m, where.unexpected, starts);
    else
      addDirections(azimuths, half_deg, starts);
  }
  if (const double rate = where.false_echoes_per_shot; rate > 0.0) {
    if (starts.has("rate_per_beam")) starts.add({{"rate_per_beam", rate}});
    if (starts.has("rate_1_s")) starts.add({{"rate_1_s", rate / listening_s(sensor)}});
  }
  if (const auto within_m = where.near_echoes.peaks_within_m; within_m && starts.has("separation_m"))
    starts.add({{"separation_m", *within_m}});
  if (const auto within_m = where.near_echoes.within_m; within_m && starts.has("dead_time_ns"))
    starts.add({{"dead_time_ns", 2.0 * *within_m / core::kMetresPerNanosecond}});
  if (starts.has("from_m") && starts.has("to_m")) addGates(where.gate, ranges, replay.resolution(kRange) / 2.0, starts);
  if (starts.has("visibility_m") && starts.has("backscatter_1_m_sr")) addFogs(sensor.emitter.wavelength_nm, starts);
  if (starts.has("centre_x_m") && starts.has("centre_y_m")) addClouds(azimuths, half_deg, where.unexpected, starts);
  return starts.list();
}

}  // namespace gap
