#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "model/simulate.h"

namespace gap {

/// Traced geometry, up to a size: what was asked for longest ago is forgotten first, so that a search that moves
/// geometry keeps what it is at work on. Thread-safe.
class GeometryCache {
 public:
  using Geometry = std::shared_ptr<const model::TracedSample>;

  explicit GeometryCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Empty if it is not (or no longer) known.
  [[nodiscard]] Geometry find(const std::string& key);
  /// Of two threads that trace the same, the first one's is kept. Geometry larger than the whole cache is not.
  void remember(const std::string& key, Geometry geometry);

 private:
  struct Entry {
    std::string key;
    Geometry geometry;
    std::size_t bytes = 0;
  };

  const std::size_t most_bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;  ///< the latest asked for first
  std::unordered_map<std::string, std::list<Entry>::iterator> places_;
  std::size_t bytes_ = 0;
};

}  // namespace gap
