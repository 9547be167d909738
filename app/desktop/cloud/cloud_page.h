#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>

#include "app/desktop/cloud/beam_explainer.h"
#include "app/desktop/cloud/cloud_view.h"
#include "app/desktop/cloud/simulation_runner.h"
#include "app/desktop/cloud/waveform_view.h"
#include "app/desktop/project_document.h"
#include "model/experiment.h"

namespace desktop {

/// The point cloud tab: what was measured in an experiment's sample, and what a model makes of it, in one picture.
///
/// Experiments and models are those of the project's acceptance tests, and whatever is opened from elsewhere. Simulated
/// samples are kept until another experiment or model is chosen.
class CloudPage final : public QWidget {
  Q_OBJECT

 public:
  explicit CloudPage(ProjectDocument& document, QWidget* parent = nullptr);
  ~CloudPage() override;

  /// Show an error and return false if the file cannot be read.
  bool openExperiment(const std::filesystem::path& file);
  void chooseModel(const std::filesystem::path& file);
  void simulate();
  void cancel() { runner_.cancel(); }

  [[nodiscard]] CloudView& view() { return *view_; }
  [[nodiscard]] SimulationRunner& runner() { return runner_; }
  [[nodiscard]] const PointCloud* cloud(CloudSource source) const;

  /// What the chosen model received from the beam of the picked detection.
  [[nodiscard]] WaveformView& waveform() { return *waveform_; }

 private:
  QWidget* makeSourceBar();
  QWidget* makeViewBar();
  QWidget* makeSide();
  void connectParts();
  void offerFilesOfProject();
  void fillSamples();
  void showSample();
  void showSimulated();
  void showFrames();
  void showPick();
  void explainPick();
  void showBusy(bool busy);
  void showStatus();
  void forgetSimulation();
  void askForExperiment();
  void askForModel();
  [[nodiscard]] std::size_t sample() const { return std::size_t(std::max(0, samples_->currentIndex())); }
  [[nodiscard]] QString valuesOf(const PickedPoint& point) const;
  [[nodiscard]] QString otherSideOf(const PickedPoint& point) const;

  ProjectDocument& document_;
  SimulationRunner runner_;
  std::optional<model::Experiment> experiment_;
  std::filesystem::path model_;
  std::shared_ptr<const PointCloud> measured_;
  std::map<std::size_t, std::shared_ptr<const PointCloud>> simulated_;  ///< by sample

  QComboBox* experiments_;
  QComboBox* models_;
  QComboBox* samples_;
  QComboBox* frames_;
  QSpinBox* frame_;
  QComboBox* colour_;
  QCheckBox* show_measured_;
  QCheckBox* show_simulated_;
  QToolButton* simulate_;
  QToolButton* cancel_;
  QProgressBar* progress_;
  QLabel* status_;
  CloudView* view_;
  QSplitter* side_;
  QTextBrowser* values_;
  WaveformView* waveform_;
  BeamExplainer explainer_;
};

}  // namespace desktop
