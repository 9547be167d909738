#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/desktop/cloud/point_cloud.h"
#include "model/explanation.h"

namespace desktop {

/// The beams of a frame from which a model reports nothing: where their light was lost, and why.
struct SilentBeams {
  PointCloud cloud;  ///< echo 0; the range of the strongest pulse or first hit, the median of these if there is neither
  std::vector<model::Reason> reasons;
};

/// Which beam, and in whose eyes.
struct BeamQuestion {
  std::filesystem::path experiment;
  std::filesystem::path model;
  int edition = 0;  ///< another one: the files may have changed, read them again
  std::size_t sample = 0;
  int frame = 0;
  std::optional<int> layer;  ///< any, if the detection does not know its own
  double azimuth_rad = 0.0;

  bool operator==(const BeamQuestion&) const = default;
};

/// Asks a model in a thread of its own what happened to a beam. A sample is traced once; then each of its beams is an
/// instant. Of questions that come while one is under way only the newest is answered.
class BeamExplainer final : public QObject {
  Q_OBJECT

 public:
  explicit BeamExplainer(QObject* parent = nullptr);
  ~BeamExplainer() override;  ///< waits for the thread

  void ask(const BeamQuestion& question);
  /// The same for all beams of the question's frame that report nothing.
  void askSilent(const BeamQuestion& question);
  /// No answer is wanted any more.
  void drop();
  void dropSilent();

 signals:
  void explained(const model::BeamExplanation& beam);
  void failed(const QString& why);
  void silentFound(std::shared_ptr<const desktop::SilentBeams> beams);
  void silentFailed(const QString& why);

 private:
  struct Traced;
  struct Outcome;
  void goOn();
  void begin(const BeamQuestion& question, bool silent);
  void hand(const Outcome& outcome, bool silent);

  std::unique_ptr<QThread> thread_;
  std::shared_ptr<Traced> traced_;  ///< of the thread while it runs
  std::shared_ptr<std::atomic<bool>> stop_silent_ = std::make_shared<std::atomic<bool>>(false);
  std::optional<BeamQuestion> next_;
  std::optional<BeamQuestion> next_silent_;
  bool wanted_ = false;
  bool silent_wanted_ = false;
};

}  // namespace desktop
