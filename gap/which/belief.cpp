#include "gap/which/belief.h"

#include <algorithm>
#include <cmath>

namespace gap {

namespace {

constexpr double kMostBelief = 0.97;  // in anything
constexpr double kLeads = 2.5;        // times as likely as what cannot be told from it: it says less, or came nearer

double likelihoodOf(const Rival& rival) { return std::exp(-0.5 * rival.separation * rival.separation); }

}  // namespace

double beliefIn(const Yardstick& yardstick, double accounted_for, CauseKind kind) {
  struct Curve {
    double even;   // of the gap: a cause that accounts for so much is as likely right as wrong
    double width;  // of that share: from such a cause to one that is hardly ever wrong
  };
  Curve curve{0.65, 0.1};
  if (yardstick.z() < Yardstick::kClear_z)  // of a small gap chance explains a share, too: most easily with one number
    curve = kind == CauseKind::kParameter ? Curve{0.77, 0.15} : Curve{0.7, 0.12};
  if (kind == CauseKind::kReference) curve = {0.3, 0.1};
  return kMostBelief / (1.0 + std::exp((curve.even - accounted_for) / curve.width));
}

double shareOf(const Decision& decision, const std::string& cause) {
  const auto of = [&](const Rival& rival) { return rival.name == cause; };
  const auto rival = std::find_if(decision.rivals.begin(), decision.rivals.end(), of);
  const bool is_member = rival == decision.rivals.end();
  const std::string& place = is_member ? cause : rival->instead_of;
  double sum = kLeads;
  for (const Rival& other : decision.rivals) sum += other.instead_of == place ? likelihoodOf(other) : 0.0;
  return (is_member ? kLeads : likelihoodOf(*rival)) / sum;
}

std::vector<double> confidencesOf(const Decision& decision, double belief) {
  const std::vector<Candidate>& candidates = decision.singles;
  std::vector<double> confidences(candidates.size(), 0.0);
  if (candidates.empty()) return confidences;
  confidences.front() = kLeads;
  double sum = kLeads;
  for (const Rival& rival : decision.rivals) {
    const auto place = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return c.hypothesis.name == rival.name; });
    if (place == candidates.end()) continue;
    const double share = likelihoodOf(rival);
    confidences[static_cast<std::size_t>(place - candidates.begin())] = share;
    sum += share;
  }
  for (double& confidence : confidences) confidence *= belief / sum;
  return confidences;
}

}  // namespace gap
