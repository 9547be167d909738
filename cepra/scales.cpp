#include "cepra/scales.h"

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"

namespace cepra {

namespace {

constexpr int kLevels = 10;

Scale readScale(const std::filesystem::path& file, const std::string& id) {
  const nlohmann::json json = core::readJson(file);
  core::JsonObject object(json, file);
  object.expectFormat("fidelis-scale", 1);
  Scale scale;
  scale.id = object.choice("id", {id});
  scale.title = object.text("title");
  scale.question = object.text("question");
  scale.source = object.text("source");
  object.eachObject("levels", [&](core::JsonObject& level) {
    ScaleLevel read;
    read.value = static_cast<int>(level.integer("value", {.min = 1, .max = kLevels}));
    read.label = level.text("label");
    read.description = level.text("description");
    if (read.value != static_cast<int>(scale.levels.size()) + 1) {
      level.fail("value", "is " + std::to_string(read.value) + "; the levels are to be 1, 2, ... 10 in this order.",
                 "Sort the levels and leave none out.");
    }
    scale.levels.push_back(std::move(read));
  });
  if (scale.levels.size() != kLevels) {
    object.fail("levels", "has " + std::to_string(scale.levels.size()) + " levels; ten were expected.",
                "Describe each value from 1 to 10.");
  }
  object.finish();
  return scale;
}

}  // namespace

Scales readScales() { return readScales(core::resourceFolder() / "scales"); }

Scales readScales(const std::filesystem::path& folder) {
  return {readScale(folder / "occurrence.json", "occurrence"), readScale(folder / "impact.json", "impact")};
}

}  // namespace cepra
