#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/sensor/beams.h"

namespace model {

/// One sub-ray that met a surface.
struct Hit {
  double range_m = 0.0;
  float cos_incidence = 0.0F;
  std::int32_t object = -1;
  std::uint32_t ray = 0;  ///< index into the sub-rays
};

/// Columns of hits; beam b's are those from first[b] to first[b + 1].
struct Hits {
  std::vector<std::uint32_t> first{0};
  std::vector<double> range_m;
  std::vector<float> cos_incidence;
  std::vector<std::int32_t> object;
  std::vector<std::uint32_t> ray;

  [[nodiscard]] std::size_t size() const noexcept { return range_m.size(); }
  [[nodiscard]] Hit at(std::size_t i) const { return {range_m[i], cos_incidence[i], object[i], ray[i]}; }
  void add(const Hit& hit);
  void endBeam() { first.push_back(static_cast<std::uint32_t>(size())); }
  void clear();
  void truncate(std::size_t size);
  /// Puts the beams of another behind the own ones.
  void append(const Hits& other);
};

/// The hits of one beam.
class HitsOfBeam {
 public:
  HitsOfBeam(const Hits& hits, std::size_t beam) : hits_(hits), begin_(hits.first[beam]), end_(hits.first[beam + 1]) {}

  [[nodiscard]] std::size_t size() const noexcept { return end_ - begin_; }
  [[nodiscard]] bool empty() const noexcept { return begin_ == end_; }
  [[nodiscard]] Hit operator[](std::size_t i) const { return hits_.at(begin_ + i); }

  struct Iterator {
    const Hits* hits;
    std::size_t index;
    [[nodiscard]] Hit operator*() const { return hits->at(index); }
    Iterator& operator++() {
      ++index;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index != other.index; }
  };
  [[nodiscard]] Iterator begin() const { return {&hits_, begin_}; }
  [[nodiscard]] Iterator end() const { return {&hits_, end_}; }

 private:
  const Hits& hits_;
  std::size_t begin_;
  std::size_t end_;
};

/// A pane that a sub-ray went through, or a mirror that turned it.
struct Turn {
  bool mirrored = false;
  std::int32_t object = -1;
  float cos_incidence = 1.0F;
};

/// What a sub-ray met behind a pane or by way of a mirror. Light returns on the same way.
struct SecondHit {
  static constexpr std::size_t kMostTurns = 3;
  Hit hit;  ///< range: length of the whole path; incidence on the last surface
  std::array<Turn, kMostTurns> turns;
  std::size_t turn_count = 0;
};

/// Everything that the signal pass needs of the geometry: no material, no power, so hypotheses share it (but for hits
/// from elsewhere, see model/reflections.h).
struct BeamHits {
  std::vector<Beam> beams;
  SubRays rays;
  Hits hits;
  std::vector<SecondHit> second;            ///< beam by beam
  std::vector<std::uint32_t> first_second;  ///< like Hits::first; empty if none were asked for
  /// Received peak powers of hits and second hits that are known from elsewhere; empty: the laser radar equation. [W]
  std::vector<double> power_w;
  std::vector<double> second_power_w;

  [[nodiscard]] HitsOfBeam of(std::size_t beam) const { return {hits, beam}; }
  [[nodiscard]] std::span<const SecondHit> secondOf(std::size_t beam) const {
    if (first_second.empty()) return {};
    return std::span(second).subspan(first_second[beam], first_second[beam + 1] - first_second[beam]);
  }
};

}  // namespace model
