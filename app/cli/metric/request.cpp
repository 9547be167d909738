#include "app/cli/metric/request.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/error.h"
#include "core/text.h"
#include "metrics/metric_catalog.h"

namespace app {

namespace {

/// "NAME=2.5" of an option that takes such. Throws InputError for what is no number.
std::pair<std::string, double> assignmentOf(const std::string& option, const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string name = text.substr(0, equals);
  const std::string number = equals < text.size() ? text.substr(equals + 1) : "";
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc() && end == number.data() + number.size() && std::isfinite(value)) return {name, value};
  throw core::InputError({.item = option + " " + text}, "gives no number.",
                         "Write it as " + option + " " + name + "=2.5.");
}

}  // namespace

std::string unitOfName(const std::string& column) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kUnits{{
      {"_m_s", "m/s"},
      {"_m", "m"},
      {"_mm", "mm"},
      {"_cm", "cm"},
      {"_rad", "rad"},
      {"_deg", "deg"},
      {"_s", "s"},
      {"_ms", "ms"},
      {"_ns", "ns"},
      {"_nw", "nW"},
      {"_w", "W"},
      {"_hz", "Hz"},
      {"intensity", "nW"},
  }};
  const std::string name = core::lowerCase(column);
  for (const auto& [suffix, unit] : kUnits) {
    if (name.ends_with(suffix)) return std::string(unit);
  }
  return "";
}

metrics::MetricOptions MetricRequest::metricOptions() const {
  return {.shift = shift == "balanced" ? metrics::Shift::Balanced : metrics::Shift::One, .experiments = experiments};
}

std::vector<std::pair<std::string, double>> MetricRequest::wantedHalfWidths() const {
  std::vector<std::pair<std::string, double>> wanted;
  for (const std::string& text : half_widths) wanted.push_back(assignmentOf("--half-width", text));
  return wanted;
}

std::string MetricRequest::unitOfColumn(std::size_t index) const {
  if (units.empty()) return unitOfName(columns[index]);
  return units[units.size() == 1 ? 0 : index];
}

metrics::Scale MetricRequest::scaleOfColumn(const std::string& column) const {
  metrics::Scale scale = metrics::Scale::Ratio;
  for (const std::string& text : scales) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) scale = metrics::scaleNamed(text);
    if (equals != std::string::npos && text.substr(0, equals) == column) {
      return metrics::scaleNamed(text.substr(equals + 1));
    }
  }
  return scale;
}

MetricSettings::MetricSettings(const MetricRequest& request, std::map<std::string, double> defaults)
    : values_(std::move(defaults)) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values_) names.push_back(name);
  for (const std::string& text : request.settings) {
    const auto [name, value] = assignmentOf("--set", text);
    if (!values_.contains(name)) {
      const std::string nearest = core::nearestName(name, names);
      throw core::InputError({.item = "--set " + text}, "is no setting for " + request.data + ".",
                             !nearest.empty() ? "Did you mean '" + nearest + "'?"
                             : names.empty()  ? "This kind of data has no settings."
                                              : "Its settings are " + core::join(names) + ".");
    }
    values_[name] = value;
  }
}

std::size_t MetricSettings::count(const std::string& name) const {
  const double value = values_.at(name);
  if (value >= 0.0 && value == std::floor(value)) return static_cast<std::size_t>(value);
  throw core::InputError({.item = "--set " + name}, "must be a whole number, 0 or more.",
                         "Write --set " + name + "=4.");
}

}  // namespace app
