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
#include "app/desktop/cloud/cloud_loader.h"
#include "app/desktop/cloud/cloud_view.h"
#include "app/desktop/cloud/readout.h"
#include "app/desktop/cloud/simulation_runner.h"
#include "app/desktop/cloud/waveform_view.h"
#include "app/desktop/project_document.h"
#include "model/experiment.h"

namespace desktop {

/// The point cloud tab: what was measured in an experiment's sample, and what a model makes of it, in one picture.
///
/// Experiments and models are those of the project's acceptance tests, and whatever is opened from elsewhere. Simulated
/// samples are kept until another experiment or model is chosen. Whatever takes time happens in threads; what cannot be
/// read is said in the picture's place and beside it: where, what, and what to do.
class CloudPage final : public QWidget {
  Q_OBJECT

 public:
  explicit CloudPage(ProjectDocument& document, QWidget* parent = nullptr);
  ~CloudPage() override;

  /// Shows the error and returns false if the file cannot be read. Measurements are read in the background.
  bool openExperiment(const std::filesystem::path& file);
  void chooseModel(const std::filesystem::path& file);
  /// One that is being stopped is waited for.
  void simulate();
  void cancel();
  [[nodiscard]] bool isLoading() const { return loader_.isLoading(); }

  [[nodiscard]] CloudView& view() { return *view_; }
  [[nodiscard]] SimulationRunner& runner() { return runner_; }
  [[nodiscard]] const PointCloud* cloud(CloudSource source) const;

  /// What the chosen model received from the beam of the picked detection.
  [[nodiscard]] WaveformView& waveform() { return *waveform_; }
  /// What stands beside the picture, as text.
  [[nodiscard]] QString readoutText() const { return toText(readout_); }
  void copyReadout() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeSourceBar();
  QWidget* makeViewBar();
  QWidget* makeSide();
  void connectParts();
  void connectThreads();
  void offerFilesOfProject();
  void fillSamples();
  void showSample();
  void showSimulated();
  void showFrames();
  void showSilent();
  void showPick();
  void showReadout();
  void explainPick();
  [[nodiscard]] BeamQuestion question(int frame) const;
  void setStatus(const QString& text);
  void tellTrouble(Readout trouble);
  void sayWhatIsMissing();
  void showBusy(bool busy);
  void showStatus();
  void forgetSimulation();
  void askForExperiment();
  void askForModel();
  [[nodiscard]] std::size_t sample() const { return std::size_t(std::max(0, samples_->currentIndex())); }
  [[nodiscard]] Readout readoutOfPick(const PickedPoint& point) const;

  ProjectDocument& document_;
  SimulationRunner runner_;
  std::optional<model::Experiment> experiment_;
  std::filesystem::path model_;
  std::shared_ptr<const PointCloud> measured_;
  std::map<std::size_t, std::shared_ptr<const PointCloud>> simulated_;  ///< by sample
  std::shared_ptr<const SilentBeams> silent_;
  std::optional<BeamQuestion> silent_of_;       ///< what silent_ answers, or will
  std::optional<model::BeamExplanation> beam_;  ///< of the pick, once the model has answered
  Readout readout_;                             ///< of the pick, or of the trouble
  Readout trouble_;                             ///< why there is nothing to see; empty if all is well
  int edition_ = 0;                             ///< counts what makes explanations old
  bool again_ = false;                          ///< simulate as soon as the one under way has stopped
  bool stopped_by_hand_ = false;

  QComboBox* experiments_;
  QComboBox* models_;
  QComboBox* samples_;
  QComboBox* frames_;
  QSpinBox* frame_;
  QComboBox* colour_;
  QCheckBox* show_measured_;
  QCheckBox* show_simulated_;
  QCheckBox* show_silent_;
  QSpinBox* point_size_;
  QToolButton* copy_;
  QToolButton* simulate_;
  QToolButton* cancel_;
  QProgressBar* progress_;
  QLabel* status_;
  CloudView* view_;
  QSplitter* side_;
  QTextBrowser* values_ = nullptr;
  WaveformView* waveform_;
  CloudLoader loader_;
  BeamExplainer explainer_;
};

}  // namespace desktop
