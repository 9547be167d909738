#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/predict/request.h"
#include "metrics/distributions/p_box.h"
#include "metrics/distributions/propagation.h"
#include "metrics/prediction/prediction.h"

namespace app {

/// Predicted errors at one point, by their names: "d_bias".
using NamedErrors = std::map<std::string, metrics::PredictedError>;

struct NamedBox {
  std::string name;
  metrics::PBox box;
};

/// A box that cannot be told, and why.
struct BoxLeftOut {
  std::string name;
  std::string why;
  std::string remedy;
};

/// What values simulated at one point and the errors predicted there say of reality, as far as they were predicted:
///
///   simulated         envelope of the files: the input uncertainty
///   expected, bound   corrected by d_bias and d_cavm (metrics/prediction/predicted_box.h)
///   with_model_form   not corrected but widened, by d- and d+ or by d_avm (metrics/prediction/aggregation.h)
///   total             the same and the numerical part
///
/// [unit of the simulated column, which must be that of the errors]
struct PointBoxes {
  std::vector<std::size_t> n;                 ///< values of each file
  std::vector<NamedBox> boxes;                ///< in the order above
  std::optional<metrics::Margin> model_form;  ///< that was appended
  std::vector<BoxLeftOut> left_out;
};

/// Reads the simulated files and makes every box that `errors` allow. Throws InputError that names the predictions that
/// are missing, if they leave no box to tell or not the one that was asked for (--model-form, --numerical).
[[nodiscard]] PointBoxes boxesAt(const NamedErrors& errors, const BoxRequest& request);

}  // namespace app
