#include "model/geometry/hits.h"

namespace model {

void Hits::add(const Hit& hit) {
  range_m.push_back(hit.range_m);
  cos_incidence.push_back(hit.cos_incidence);
  object.push_back(hit.object);
  ray.push_back(hit.ray);
}

void Hits::truncate(std::size_t size) {
  range_m.resize(size);
  cos_incidence.resize(size);
  object.resize(size);
  ray.resize(size);
}

void Hits::clear() {
  first.assign(1, 0);
  range_m.clear();
  cos_incidence.clear();
  object.clear();
  ray.clear();
}

void Hits::append(const Hits& other) {
  const auto before = static_cast<std::uint32_t>(size());
  for (std::size_t b = 1; b < other.first.size(); ++b) first.push_back(before + other.first[b]);
  range_m.insert(range_m.end(), other.range_m.begin(), other.range_m.end());
  cos_incidence.insert(cos_incidence.end(), other.cos_incidence.begin(), other.cos_incidence.end());
  object.insert(object.end(), other.object.begin(), other.object.end());
  ray.insert(ray.end(), other.ray.begin(), other.ray.end());
}

}  // namespace model
