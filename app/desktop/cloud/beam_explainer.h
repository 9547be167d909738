#pragma once

#include <QObject>
#include <QThread>
#include <filesystem>
#include <memory>
#include <optional>

#include "model/explanation.h"

namespace desktop {

/// Which beam, and in whose eyes.
struct BeamQuestion {
  std::filesystem::path experiment;
  std::filesystem::path model;
  std::size_t sample = 0;
  int frame = 0;
  int layer = 0;
  double azimuth_rad = 0.0;
};

/// Asks a model in a thread of its own what happened to a beam. A sample is traced once; then each of its beams is an
/// instant. Of questions that come while one is under way only the newest is answered.
class BeamExplainer final : public QObject {
  Q_OBJECT

 public:
  explicit BeamExplainer(QObject* parent = nullptr);
  ~BeamExplainer() override;  ///< waits for the thread

  void ask(const BeamQuestion& question);
  /// No answer is wanted any more.
  void drop();

 signals:
  void explained(const model::BeamExplanation& beam);
  void failed(const QString& why);

 private:
  struct Traced;
  void begin(const BeamQuestion& question);

  std::unique_ptr<QThread> thread_;
  std::shared_ptr<Traced> traced_;  ///< of the thread while it runs
  std::optional<BeamQuestion> next_;
  bool wanted_ = false;
};

}  // namespace desktop
