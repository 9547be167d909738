#include "gap/replay/geometry_cache.h"

#include <utility>

namespace gap {

namespace {

std::size_t bytesOf(const model::BeamHits& hits) {
  constexpr std::size_t kOfRay = 3 * sizeof(double);
  return hits.beams.size() * (sizeof(model::Beam) + sizeof(std::uint32_t)) + hits.hits.size() * sizeof(model::Hit) +
         hits.second.size() * sizeof(model::SecondHit) + hits.rays.size() * kOfRay;
}

}  // namespace

GeometryCache::Geometry GeometryCache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = places_.find(key);
  if (found == places_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->geometry;
}

void GeometryCache::remember(const std::string& key, Geometry geometry) {
  const std::size_t bytes = bytesOf(geometry->hits);
  if (bytes > most_bytes_) return;
  const std::lock_guard lock(mutex_);
  if (places_.contains(key)) return;
  entries_.push_front({key, std::move(geometry), bytes});
  places_.emplace(key, entries_.begin());
  bytes_ += bytes;
  while (bytes_ > most_bytes_) {
    const Entry& oldest = entries_.back();
    bytes_ -= oldest.bytes;
    places_.erase(oldest.key);
    entries_.pop_back();
  }
}

}  // namespace gap
