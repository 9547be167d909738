#include "app/cli/predict/box_output.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <ostream>

#include "core/csv.h"
#include "core/text.h"
#include "metrics/distributions/box_bounds.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using metrics::Interval;

constexpr std::array<double, 5> kLevels{0.05, 0.25, 0.5, 0.75, 0.95};

Json pair(const Interval& interval) { return Json::array({interval.low, interval.high}); }

Json toJson(const metrics::PBox& box) {
  Json quantiles = Json::array();
  for (const double p : kLevels) {
    quantiles.push_back({{"level", p}, {"interval", pair(metrics::quantileInterval(box, p))}});
  }
  return {{"quantiles", std::move(quantiles)}, {"mean", pair(metrics::meanInterval(box))}, {"width", box.area()}};
}

Json modelFormJson(const PointBoxes& at, const BoxRequest& request) {
  if (!at.model_form) return nullptr;
  return {{"of", request.model_form == "area" ? "area" : "portions"},
          {"below", at.model_form->below},
          {"above", at.model_form->above}};
}

std::string shown(double value) { return core::significant(value, 6); }
std::string shown(const Interval& interval) {
  if (interval.low == interval.high) return shown(interval.low);
  return "[" + shown(interval.low) + ", " + shown(interval.high) + "]";
}

std::string title(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

bool has(const PointBoxes& at, std::string_view name) {
  return std::any_of(at.boxes.begin(), at.boxes.end(), [&](const NamedBox& named) { return named.name == name; });
}

template <typename Cell>
void writeRow(const PointBoxes& at, const std::string& label, Cell cell, std::ostream& out) {
  out << fmt::format("  {:<6}", label);
  for (const NamedBox& named : at.boxes) out << fmt::format("  {:>22}", cell(named));
  out << "\n";
}

/// Levels at which any edge steps, ascending. All boxes are moved edges of the first and step where it does.
std::vector<double> stepsOf(const metrics::PBox& box) {
  std::vector<double> levels;
  const auto left = box.left().levels();
  const auto right = box.right().levels();
  std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(levels));
  return levels;
}

}  // namespace

Json toJson(const PointBoxes& at, const BoxRequest& request) {
  Json object{{"column", request.column},
              {"n_sim", at.n},
              {"bounds", request.bounds},
              {"model_form", modelFormJson(at, request)},
              {"numerical", request.numerical}};
  object["left_out"] = Json::array();
  for (const BoxLeftOut& box : at.left_out) {
    object["left_out"].push_back({{"box", box.name}, {"why", box.why}});
  }
  for (const NamedBox& named : at.boxes) object[named.name] = toJson(named.box);
  return object;
}

void writeBoxTable(const PointBoxes& at, const BoxRequest& request, const BoxCaption& caption, std::ostream& out) {
  out << fmt::format("\nBoxes of {} at {}\n", request.column, caption.where);
  writeRow(
      at, "", [](const NamedBox& named) { return title(named.name); }, out);
  for (const double p : kLevels) {
    writeRow(
        at, fmt::format("{:g} %", 100.0 * p),
        [p](const NamedBox& named) { return shown(metrics::quantileInterval(named.box, p)); }, out);
  }
  writeRow(
      at, "mean", [](const NamedBox& named) { return shown(metrics::meanInterval(named.box)); }, out);
  writeRow(
      at, "width", [](const NamedBox& named) { return shown(named.box.area()); }, out);
  const double percent = 100.0 * caption.level;
  if (has(at, "bound")) {
    out << fmt::format("  bound: each error at its {:g} % bound of {}\n", percent,
                       request.bounds == "observation" ? "one more sample" : "the mean");
  }
  if (at.model_form) {
    out << fmt::format("  model form: {} below, {} above: {:g} % bounds of one more sample; numerical: {}\n",
                       shown(at.model_form->below), shown(at.model_form->above), percent, shown(request.numerical));
  }
}

void writeBoxRemarks(const PointBoxes& at, std::ostream& messages) {
  for (const BoxLeftOut& box : at.left_out) {
    messages << fmt::format("fidelis: the box '{}' is left out: {}.\n  {}\n", title(box.name), box.why, box.remedy);
  }
}

std::string edgesAsCsv(const PointBoxes& at) {
  std::vector<std::string> record{"p"};
  for (const NamedBox& named : at.boxes) {
    record.push_back(named.name + "_left");
    record.push_back(named.name + "_right");
  }
  std::string text = core::csvRecord(record);
  for (const double p : stepsOf(at.boxes.front().box)) {
    record.assign(1, core::shortestNumber(p));
    for (const NamedBox& named : at.boxes) {
      record.push_back(core::shortestNumber(named.box.left().quantile(p)));
      record.push_back(core::shortestNumber(named.box.right().quantile(p)));
    }
    text += core::csvRecord(record);
  }
  return text;
}

}  // namespace app
