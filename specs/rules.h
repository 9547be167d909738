#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "percollect/finding.h"
#include "specs/project_store.h"

namespace specs {

using percollect::Severity;

/// Something in a specification that does not hold together. `rule` is stable: scripts may filter by it.
struct RuleFinding {
  std::string rule;
  Severity severity = Severity::Warning;
  std::string item;  ///< shown id, or "from -> to" of a link
  std::string text;
  std::string remedy;
  bool operator==(const RuleFinding&) const = default;
};

/// "item: warning: text remedy [rule]" on one line.
[[nodiscard]] std::string toString(const RuleFinding& finding);

struct RuleOptions {
  int relevant_from = 12;        ///< a row of this relevance (O + I, 2 ... 20) needs a requirement
  std::filesystem::path folder;  ///< of the project: are the files of the tests there? Empty: not asked
};

struct Rule {
  std::string_view uid;
  Severity severity;
  std::string_view title;  ///< what must hold
};

[[nodiscard]] std::span<const Rule> allRules();

/// Every breach of every rule, in the order of the rules, then of the items.
[[nodiscard]] std::vector<RuleFinding> checkSpecification(const Specification& specification,
                                                          const RuleOptions& options = {});

}  // namespace specs
