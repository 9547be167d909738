#include "model/demonstration/plan.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/json_object.h"
#include "model/demonstration/columns.h"

namespace model {

namespace {

constexpr double kMostSteps = 2000.0;

const std::vector<std::string> kViews{"sweep", "bins", "histogram", "points", "waveform"};
const std::vector<std::string> kValues{"rate", "echoes", "mean", "stddev"};

template <typename Enum>
Enum chosen(core::JsonObject& object, const std::string& key, const std::vector<std::string>& names) {
  const std::string name = object.choice(key, names);
  return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

Steps readSteps(core::JsonObject& object) {
  const Steps steps{object.number("from"), object.number("to"), object.number("step", {.min = 0.0, .open_min = true})};
  if (!(steps.to > steps.from)) object.fail("to", "must be greater than 'from'.", "Exchange them.");
  if ((steps.to - steps.from) / steps.step > kMostSteps)
    object.fail("step", "makes more than 2000 steps.", "Take a coarser one.");
  return steps;
}

std::optional<std::array<double, 2>> readRange(core::JsonObject& object, const std::string& key) {
  if (!object.has(key)) return std::nullopt;
  const auto ends = object.numbers(key, 2);
  if (!(ends[0] < ends[1])) object.fail(key, "must rise.", "Write [lowest, highest].");
  return std::array<double, 2>{ends[0], ends[1]};
}

void readNumber(core::JsonObject& draw, DemonstrationPlan& plan) {
  plan.value = chosen<Value>(draw, "value", kValues);
  const bool of_column = plan.value == Value::kMean || plan.value == Value::kStddev;
  if (of_column) plan.of = draw.choice("of", shownColumns());
}

void readDrawing(core::JsonObject draw, DemonstrationPlan& plan) {
  plan.view = chosen<View>(draw, "view", kViews);
  if (plan.view == View::kSweep) plan.over = draw.text("over");
  if (plan.view == View::kBins || plan.view == View::kPoints) plan.over = draw.choice("over", shownColumns());
  if (plan.view == View::kHistogram || plan.view == View::kPoints) plan.of = draw.choice("of", shownColumns());
  if (plan.view == View::kSweep || plan.view == View::kBins) readNumber(draw, plan);
  if (plan.view != View::kPoints) plan.steps = readSteps(draw);
  if (plan.view == View::kSweep) {
    plan.zero = draw.numberOr("zero", 0.0);
    plan.minus_sweep = draw.flagOr("minus_sweep", false);
  }
  plan.decibel = draw.flagOr("decibel", false);
  plan.factor = draw.numberOr("factor", 1.0);
  const bool above = plan.view == View::kPoints && plan.over == "x_m" && plan.of == "y_m";
  plan.x_name = above ? draw.textOr("x_name", "x, forward, in m") : draw.text("x_name");
  plan.y_name = above ? draw.textOr("y_name", "y, to the left, in m") : draw.text("y_name");
  plan.x_range = readRange(draw, "x");
  plan.y_range = readRange(draw, "y");
  if (plan.view == View::kPoints && (!plan.x_range || !plan.y_range))
    draw.fail(plan.x_range ? "y" : "x", "is missing.", "Points need both ranges: [lowest, highest].");
  draw.finish();
}

nlohmann::json rawOr(core::JsonObject& object, const std::string& key, nlohmann::json otherwise) {
  return object.has(key) ? object.raw(key) : otherwise;
}

DemonstrationPlan::Setting readSetting(core::JsonObject& object) {
  DemonstrationPlan::Setting setting;
  setting.name = object.text("name");
  setting.parameters = rawOr(object, "parameters", nlohmann::json::object());
  setting.patch = rawOr(object, "patch", nlohmann::json::array());
  setting.where_light_hits = object.flagOr("where_light_hits", false);
  return setting;
}

nlohmann::json patchedScene(core::JsonObject& object, const std::filesystem::path& file) {
  const nlohmann::json scene = core::readJson(file);
  try {
    return scene.patch(rawOr(object, "patch", nlohmann::json::array()));
  } catch (const nlohmann::json::exception& error) {
    object.fail("patch", std::string("does not fit the scene: ") + error.what() + ".",
                "Its paths must exist in " + file.string() + ".");
  }
}

}  // namespace

DemonstrationPlan readDemonstration(const std::filesystem::path& file) {
  const nlohmann::json json = core::readJson(file);
  core::JsonObject object(json, file);
  object.expectFormat("fidelis-demonstration", 1);
  DemonstrationPlan plan{.file = file, .effect = object.text("effect")};
  plan.title = object.text("title");
  plan.caption = object.text("caption");
  plan.experiment_file = file.parent_path() / "scenes" / (object.text("scene") + ".json");
  plan.experiment = patchedScene(object, plan.experiment_file);
  plan.frames = static_cast<int>(object.integerOr("frames", 1, {.min = 1, .max = 10000}));
  if (object.has("rays_per_beam")) {
    const auto rays = object.numbers("rays_per_beam", 2);
    plan.rays = {static_cast<int>(rays[0]), static_cast<int>(rays[1])};
  }
  plan.with = rawOr(object, "with", nlohmann::json::object());
  plan.off = {"off", nlohmann::json::object(), nlohmann::json::array(), false};
  if (object.has("off")) {
    core::JsonObject off = object.object("off");
    plan.off = readSetting(off);
    off.finish();
  }
  object.eachObject("on", [&](core::JsonObject& on) {
    plan.on.push_back(readSetting(on));
    on.finish();
  });
  if (plan.on.empty()) object.fail("on", "is missing.", "List at least one setting of the effect.");
  readDrawing(object.object("draw"), plan);
  object.finish();
  return plan;
}

}  // namespace model
