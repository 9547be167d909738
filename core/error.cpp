#include "core/error.h"

namespace core {

std::string toString(const Place& place) {
  std::string text = place.file.string();
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!place.item.empty()) text += (text.empty() ? "" : ", ") + place.item;
  return text;
}

namespace {
std::string message(const Place& place, const std::string& problem, const std::string& remedy) {
  const std::string where = toString(place);
  std::string text = where.empty() ? problem : where + ": " + problem;
  if (!remedy.empty()) text += "\n  " + remedy;
  return text;
}
}  // namespace

InputError::InputError(Place place, std::string problem, std::string remedy)
    : std::runtime_error(message(place, problem, remedy)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

}  // namespace core
