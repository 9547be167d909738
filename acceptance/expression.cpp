#include "acceptance/expression.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <muParser.h>
#include <optional>
#include <set>

#include "core/text.h"

namespace acceptance {

namespace {

constexpr std::string_view kAllowed = "Write 'left <= right' with <=, <, >= or >, and join several with &&.";

bool isNameCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Position of a whole word in a text.
std::size_t findWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !isNameCharacter(text[at - 1]);
    const std::size_t after = at + word.size();
    if (begins && (after == text.size() || !isNameCharacter(text[after]))) return at;
  }
  return 0;
}

std::vector<std::string> functionNames() {
  std::vector<std::string> names;
  const mu::Parser parser;
  for (const auto& [name, callback] : parser.GetFunDef()) names.push_back(name);
  return names;
}

/// Order at `at`, and how many characters it takes.
std::optional<std::pair<Order, std::size_t>> orderAt(std::string_view text, std::size_t at) {
  if (text[at] != '<' && text[at] != '>') return std::nullopt;
  const bool or_equal = at + 1 < text.size() && text[at + 1] == '=';
  const Order order = text[at] == '<' ? (or_equal ? Order::LessOrEqual : Order::Less)
                                      : (or_equal ? Order::GreaterOrEqual : Order::Greater);
  return std::pair{order, std::size_t{or_equal ? 2u : 1u}};
}

bool compare(double value, Order order, double limit) {
  switch (order) {
    case Order::LessOrEqual:
      return value <= limit;
    case Order::Less:
      return value < limit;
    case Order::GreaterOrEqual:
      return value >= limit;
    case Order::Greater:
      return value > limit;
  }
  return false;
}

/// Margin over the size of the limit, so that relations of different units can be ranked. Undefined ones come first.
double relativeMargin(const Relation& relation) {
  const double size = std::max(std::abs(relation.limit), 1e-300);
  const double margin = relation.margin() / size;
  return std::isnan(margin) ? -HUGE_VAL : margin;
}

/// Blanks and parentheses around the whole stretch fall away: "((a <= b))" is "a <= b".
std::pair<std::size_t, std::size_t> stripped(std::string_view text, std::size_t begin, std::size_t end) {
  while (true) {
    while (begin < end && std::isspace(static_cast<unsigned char>(text[begin]))) ++begin;
    while (begin < end && std::isspace(static_cast<unsigned char>(text[end - 1]))) --end;
    if (end - begin < 2 || text[begin] != '(' || text[end - 1] != ')') return {begin, end};
    int depth = 0;
    for (std::size_t i = begin; i + 1 < end; ++i) {
      depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
      if (depth == 0) return {begin, end};  // the first parenthesis closes before the end
    }
    ++begin;
    --end;
  }
}

}  // namespace

std::string_view symbol(Order order) {
  constexpr std::string_view kSymbols[] = {"<=", "<", ">=", ">"};
  return kSymbols[static_cast<int>(order)];
}

double Relation::margin() const noexcept {
  return order == Order::LessOrEqual || order == Order::Less ? limit - value : value - limit;
}

std::string Relation::text() const {
  return fmt::format("{} = {} {}{} {}", left, core::significant(value, 4), holds ? "" : "is not ", symbol(order),
                     core::significant(limit, 4));
}

const Relation& Decision::decisive() const {
  return *std::min_element(relations.begin(), relations.end(), [](const Relation& a, const Relation& b) {
    // A relation that fails decides before one that holds, also where a strict limit is met exactly (margin 0).
    if (a.holds != b.holds) return b.holds;
    return relativeMargin(a) < relativeMargin(b);
  });
}

Expression::Expression(std::string text, core::Place place) : text_(std::move(text)), place_(std::move(place)) {
  if (core::trimmed(text_).empty()) fail(0, "is empty.", "Write when the test passes: abs(d_bias) <= 0.05.");
  int depth = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    depth += text_[i] == '(' ? 1 : text_[i] == ')' ? -1 : 0;
    if (depth < 0) fail(i, "closes a parenthesis that was never opened.", "Remove it or open one before.");
  }
  if (depth > 0) fail(text_.size(), "ends before a parenthesis is closed.", "Close it.");

  // Split at every && outside of parentheses that do not enclose a whole conjunction.
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, text_.size()}};
  while (!open.empty()) {
    const auto [begin, end] = stripped(text_, open.back().first, open.back().second);
    open.pop_back();
    std::size_t split = end;
    for (std::size_t i = begin; i < end; ++i) {
      depth += text_[i] == '(' ? 1 : text_[i] == ')' ? -1 : 0;
      if (depth == 0 && text_.compare(i, 2, "&&") == 0 && split == end) split = i;
    }
    if (split == end) {
      comparisons_.push_back(comparisonOf(begin, end));
    } else {
      open.emplace_back(split + 2, end);  // later
      open.emplace_back(begin, split);    // now: the order of the relations stays
    }
  }
}

Expression::Comparison Expression::comparisonOf(std::size_t begin, std::size_t end) const {
  std::optional<Order> order;
  std::size_t left_end = end;
  std::size_t right_begin = end;
  for (std::size_t i = begin; i < end; ++i) {
    if (text_[i] == '=' || text_[i] == '!' || text_[i] == '|' || text_[i] == '&' || text_[i] == '?') {
      fail(i, fmt::format("has '{}', which no acceptance expression knows.", text_[i]), std::string(kAllowed));
    }
    const auto found = orderAt(text_, i);
    if (!found) continue;
    if (order) fail(i, "compares twice in one relation.", std::string(kAllowed));
    order = found->first;
    left_end = i;
    right_begin = i + found->second;
    i += found->second - 1;
  }
  if (!order) fail(begin, "compares nothing.", std::string(kAllowed));
  return {sideOf(begin, left_end), *order, sideOf(right_begin, end)};
}

Expression::Side Expression::sideOf(std::size_t begin, std::size_t end) const {
  const std::size_t from = begin;
  while (begin < end && std::isspace(static_cast<unsigned char>(text_[begin]))) ++begin;
  while (begin < end && std::isspace(static_cast<unsigned char>(text_[end - 1]))) --end;
  if (begin == end) fail(from, "lacks one side of a relation.", std::string(kAllowed));
  Side side = {text_.substr(begin, end - begin), begin, {}};
  int depth = 0;
  for (std::size_t i = begin; i < end; ++i) {
    depth += text_[i] == '(' ? 1 : text_[i] == ')' ? -1 : 0;
    if (text_[i] == ',' && depth == 0) {
      fail(i, "has ',' outside of a function.", "Decimals are written with a point: 0.005.");
    }
  }
  try {
    mu::Parser parser;
    parser.SetExpr(side.text);
    for (const auto& [name, address] : parser.GetUsedVar()) side.variables.push_back(name);
  } catch (const mu::Parser::exception_type& error) {
    // Of a function that it does not know muParser names only the parenthesis behind it.
    const std::size_t at = begin + static_cast<std::size_t>(std::max(0, error.GetPos()));
    std::string remedy = "Check the arithmetic there.";
    const std::string token = core::trimmed(error.GetToken());
    if (!token.empty() && std::isalpha(static_cast<unsigned char>(token.front()))) {
      const std::string nearest = core::nearestName(token.substr(0, token.find('(')), functionNames());
      if (!nearest.empty()) remedy = "Did you mean '" + nearest + "'?";
    }
    fail(at, "cannot be read: " + error.GetMsg(), remedy);
  }
  return side;
}

std::vector<std::string> Expression::variables() const {
  std::set<std::string> names;
  for (const Comparison& comparison : comparisons_) {
    names.insert(comparison.left.variables.begin(), comparison.left.variables.end());
    names.insert(comparison.right.variables.begin(), comparison.right.variables.end());
  }
  return {names.begin(), names.end()};
}

void Expression::requireKnown(const Side& side, std::span<const std::string> known) const {
  for (const std::string& name : side.variables) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::vector<std::string> candidates = functionNames();
    candidates.insert(candidates.end(), known.begin(), known.end());
    const std::string nearest = core::nearestName(name, candidates);
    fail(side.at + findWord(side.text, name), "names '" + name + "', which is not known.",
         nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
}

void Expression::requireKnown(std::span<const std::string> known) const {
  for (const Comparison& comparison : comparisons_) {
    requireKnown(comparison.left, known);
    requireKnown(comparison.right, known);
  }
}

double Expression::number(const Side& side, const std::map<std::string, double>& values) const {
  mu::Parser parser;
  std::map<std::string, double> used;  // muParser wants addresses
  for (const std::string& name : side.variables) used[name] = values.at(name);
  for (auto& [name, value] : used) parser.DefineVar(name, &value);
  try {
    parser.SetExpr(side.text);
    return parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    fail(side.at + static_cast<std::size_t>(std::max(0, error.GetPos())), "cannot be evaluated: " + error.GetMsg(),
         "Check the arithmetic there.");
  }
}

Decision Expression::evaluate(const std::map<std::string, double>& values) const {
  std::vector<std::string> known;
  for (const auto& [name, value] : values) known.push_back(name);
  requireKnown(known);
  Decision decision;
  decision.holds = true;
  for (const Comparison& comparison : comparisons_) {
    Relation& relation = decision.relations.emplace_back();
    relation.left = comparison.left.text;
    relation.right = comparison.right.text;
    relation.order = comparison.order;
    relation.value = number(comparison.left, values);
    relation.limit = number(comparison.right, values);
    relation.holds = compare(relation.value, relation.order, relation.limit);
    decision.holds = decision.holds && relation.holds;
  }
  return decision;
}

void Expression::fail(std::size_t at, const std::string& problem, const std::string& remedy) const {
  core::Place place = place_;
  place.item += fmt::format("{}expression '{}', position {}", place.item.empty() ? "" : ", ", text_, at + 1);
  throw core::InputError(place, problem, remedy);
}

}  // namespace acceptance
