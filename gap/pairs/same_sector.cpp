#include "gap/pairs/same_sector.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "gap/candidates/polish.h"
#include "gap/candidates/whole_gap.h"

namespace gap {

namespace {

/// Two numbers of a cause that say where its sector is: its ends, or its middle and its width.
struct SectorNumbers {
  std::size_t first, second;
  bool ends;
};

std::optional<SectorNumbers> sectorNumbersOf(const Hypothesis& hypothesis) {
  const auto& parameters = hypothesis.parameters;
  const auto place = [&](const std::string& name) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(), [&](const FreeParameter& p) { return p.name == name; });
    return static_cast<std::size_t>(found - parameters.begin());
  };
  const std::size_t none = parameters.size();
  const std::size_t from = place("azimuth_from_deg"), to = place("azimuth_to_deg");
  if (from != none && to != none) return SectorNumbers{from, to, true};
  const std::size_t middle = place("azimuth_deg"), width = place("width_deg");
  if (middle != none && width != none) return SectorNumbers{middle, width, false};
  return std::nullopt;
}

Sector sectorAt(const SectorNumbers& numbers, const std::vector<double>& values) {
  const double first = values[numbers.first], second = values[numbers.second];
  return numbers.ends ? Sector{first, second} : Sector{first - second / 2.0, first + second / 2.0};
}

/// In its plausible range, if the other cause's is larger.
void put(const Sector& sector, const SectorNumbers& numbers, Candidate& candidate) {
  const auto set = [&](std::size_t i, double value) {
    const FreeParameter& p = candidate.hypothesis.parameters[i];
    candidate.values[i] = std::clamp(value, p.low, p.high);
  };
  set(numbers.first, numbers.ends ? sector.from_deg : 0.5 * (sector.from_deg + sector.to_deg));
  set(numbers.second, numbers.ends ? sector.to_deg : sector.to_deg - sector.from_deg);
}

}  // namespace

std::vector<Candidate> inSectorOf(const Candidate& known, const std::vector<Candidate>& others) {
  std::vector<Candidate> moved;
  const std::optional<SectorNumbers> of_known = sectorNumbersOf(known.hypothesis);
  if (!of_known) return moved;
  const Sector sector = sectorAt(*of_known, known.values);
  for (const Candidate& other : others) {
    const std::optional<SectorNumbers> numbers = sectorNumbersOf(other.hypothesis);
    if (!numbers || other.hypothesis.name == known.hypothesis.name ||
        other.hypothesis.sensors != known.hypothesis.sensors)
      continue;
    moved.push_back(other);
    put(sector, *numbers, moved.back());
  }
  return moved;
}

void shareTheSector(const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                    std::vector<Candidate>& singles, const core::Progress& progress) {
  std::vector<Candidate> moved = inSectorOf(singles.front(), singles);
  for (Candidate& candidate : moved) {
    core::stopIfCancelled(progress);
    hearOnTotal(exact, gaps, candidate);
  }
  std::erase_if(moved, [&](const Candidate& one) { return !better(one, singles[placeOfForm(singles, one)]); });
  if (moved.empty()) return;
  polish(exact, gaps, moved, where, progress);
  takeBetter(std::move(moved), singles);
}

}  // namespace gap
