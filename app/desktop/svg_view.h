#pragma once

#include <QSvgRenderer>
#include <QWidget>

namespace desktop {

/// A figure of report/ as a sheet of white paper, as large as the widget allows; figures are drawn for paper, so it
/// stays white among dark colours.
class SvgView final : public QWidget {
  Q_OBJECT

 public:
  explicit SvgView(QWidget* parent = nullptr);
  /// Empty text: `instead` is shown.
  void setSvg(const std::string& svg, const QString& instead);
  [[nodiscard]] bool hasFigure() const { return renderer_.isValid(); }
  [[nodiscard]] QSize sizeHint() const override { return {640, 420}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QSvgRenderer renderer_;
  QString instead_;
};

}  // namespace desktop
