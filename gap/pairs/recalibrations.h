#pragma once

#include <Eigen/Dense>
#include <map>
#include <optional>
#include <vector>

#include "gap/pairs/looks.h"

namespace gap {

/// What goes best with another value of a parameter: whoever calibrated the model to its means has hidden the cause in
/// it, and no single hypothesis may look better than none. What is left of the cause shows only where the parameter is
/// right within a per cent or two, so signatures are summed at many values of it.
class Recalibrations {
 public:
  /// The looks live longer than this.
  explicit Recalibrations(const Looks& looks);

  struct Hidden {
    std::vector<Guess> by_spreads;  ///< each beside the parameter that goes best with it, if outliers count in full
    std::vector<Guess> by_means;    ///< the same where outliers count little
    std::vector<Guess> by_another;  ///< each beside the second best: few data hardly tell by which it is hidden
  };

  /// The effects that are nearest beside another value of any parameter, by the few data.
  [[nodiscard]] Hidden hidden() const;
  /// The same beside one parameter (a single), by all data that are fitted, of which it leaves so much alone: where few
  /// data cannot tell how much of an effect it makes up for, more of them can. Their distance is the one from these
  /// data.
  [[nodiscard]] std::vector<Guess> hiddenFromFewData(std::size_t parameter, double left_alone) const;

 private:
  /// Two places of an effect of one number (Looks::atoms), with none between them: what it does there is interpolated.
  struct Span {
    std::size_t from = 0, to = 0;
  };
  /// Another value of a parameter, and what it does.
  struct Step {
    double value = 0.0;
    Eigen::VectorXf shifts;
  };
  /// Of every effect, by its place among the singles, what is nearest.
  using Nearest = std::map<std::size_t, Guess>;
  /// How far shifts are from none.
  using Farness = double (*)(const Eigen::VectorXf&);
  /// How places are compared, and whether between them, too: what scatters, of which squares see most, follows no line.
  struct Look {
    Farness farness;
    bool between;
  };

  [[nodiscard]] const Hypothesis& hypothesisOf(const Looks::Atom& atom) const;
  void findSpans();
  [[nodiscard]] std::vector<Step> stepsOf(std::size_t parameter) const;
  [[nodiscard]] Nearest nearestBeside(std::size_t parameter, const Step& step, Farness farness) const;
  void lookBetween(std::size_t parameter, const Step& step, Farness farness, Nearest& nearest) const;
  [[nodiscard]] std::vector<Guess> hiddenBy(std::size_t parameter, const std::vector<Step>& steps,
                                            const Look& look) const;
  [[nodiscard]] std::vector<std::vector<Guess>> placesBeside(std::size_t parameter) const;
  [[nodiscard]] std::optional<Guess> nearestByAll(const std::vector<Guess>& along, double least) const;

  const Looks& looks_;
  std::vector<Span> spans_;
};

}  // namespace gap
