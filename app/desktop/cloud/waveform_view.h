#pragma once

#include <QWidget>
#include <optional>

#include "model/explanation.h"

namespace desktop {

/// What came back from one beam, as a model sees it: received power over range, the threshold, the pulses that make it
/// up (one stem each), the echoes with what became of them.
class WaveformView final : public QWidget {
  Q_OBJECT

 public:
  explicit WaveformView(QWidget* parent = nullptr);

  /// `reported_m`: the range of the detection that was picked, a line of its own colour; absent if there is none.
  void show(model::BeamExplanation beam, std::optional<double> reported_m, const QColor& colour);
  using QWidget::show;
  void clear(const QString& instead);
  [[nodiscard]] const std::optional<model::BeamExplanation>& beam() const noexcept { return beam_; }

  [[nodiscard]] QSize sizeHint() const override { return {320, 260}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Axes;
  [[nodiscard]] Axes axes() const;
  void drawFrame(QPainter& painter, const Axes& axes) const;
  void drawSignal(QPainter& painter, const Axes& axes) const;
  void drawEchoes(QPainter& painter, const Axes& axes) const;

  std::optional<model::BeamExplanation> beam_;
  std::optional<double> reported_m_;
  QColor colour_;
  QString instead_;
};

}  // namespace desktop
