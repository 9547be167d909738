#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "specs/project_store.h"

namespace specs {

/// One end of links, as it is shown.
struct Entry {
  Kind kind = Kind::Requirement;
  std::string id;
  std::string title;
  std::optional<Status> status;  ///< none for CEPRA rows
};

/// Who follows from whom in a specification, both ways. Keeps no reference to it.
class LinkIndex {
 public:
  explicit LinkIndex(const Specification& specification);

  [[nodiscard]] const Entry* find(std::string_view id) const;
  [[nodiscard]] const std::vector<Link>& originsOf(std::string_view id) const;    ///< links that end here
  [[nodiscard]] const std::vector<Link>& followersOf(std::string_view id) const;  ///< links that begin here
  /// All ids from which `id` follows, over any number of steps.
  [[nodiscard]] std::vector<std::string> allOriginsOf(std::string_view id) const;
  [[nodiscard]] std::vector<std::string> allFollowersOf(std::string_view id) const;

 private:
  using Links = std::map<std::string, std::vector<Link>, std::less<>>;
  std::map<std::string, Entry, std::less<>> entries_;
  Links origins_;
  Links followers_;
};

/// An indented tree of everything that `id` follows from and everything that follows from it:
///
///     RangeError_Fog_2  requirement, accepted: Range bias in fog
///     follows from
///       RangeError_Fog_1  requirement, accepted: Fog is modelled
///         r0123456789ab  CEPRA row: Range error ← Attenuation
///     leads to
///       RangeError_Fog_3  acceptance test, under review, failed: Range bias at 10 m
///
/// What was shown above already is not unfolded again. Throws InputError that names the nearest id if there is none.
[[nodiscard]] std::string traceText(const Specification& specification, const std::string& id);

}  // namespace specs
