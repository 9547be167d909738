#pragma once

#include <QPalette>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "app/desktop/cloud/point_cloud.h"
#include "core/error.h"
#include "model/explanation.h"

namespace desktop {

/// A titled list of values with their units, to be read beside the picture and to be copied as text.
struct ReadoutPart {
  QString title;
  QString note;
  std::vector<std::pair<QString, QString>> rows;
};
using Readout = std::vector<ReadoutPart>;

/// The first part's title heads the pane.
[[nodiscard]] QString toHtml(const Readout& readout, const QPalette& palette);
/// A title a line, a name and its value a line with a tab between: fits a mail and a spreadsheet.
[[nodiscard]] QString toText(const Readout& readout);

/// The values of a detection, or of a beam without one.
[[nodiscard]] ReadoutPart partOf(const PointCloud& cloud, CloudSource source, std::size_t index, const QString& sample);
/// The same beam in the other cloud, `source`, and the difference to the picked one.
[[nodiscard]] ReadoutPart partOfOther(const PointCloud& other, CloudSource source, const PointCloud& own,
                                      std::size_t index);
/// What the model received: the reason, every echo with its fate, what the sub-rays met.
[[nodiscard]] Readout partsOf(const model::BeamExplanation& beam);
/// Where, what and what to do.
[[nodiscard]] Readout readoutOf(const QString& title, const core::InputError& error);

/// "below threshold: …": the word for a reason with a sentence that says what it means.
[[nodiscard]] QString explained(model::Reason reason);

}  // namespace desktop
