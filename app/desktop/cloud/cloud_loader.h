#pragma once

#include <QObject>
#include <QThread>
#include <memory>
#include <optional>

#include "app/desktop/cloud/point_cloud.h"
#include "core/error.h"
#include "model/experiment.h"

namespace desktop {

/// Reads the measurements of a sample in a thread of its own. Of wishes that come while one is under way only the
/// newest is answered.
class CloudLoader final : public QObject {
  Q_OBJECT

 public:
  explicit CloudLoader(QObject* parent = nullptr);
  ~CloudLoader() override;  ///< waits for the thread

  /// The sample must name measurements.
  void load(const model::Experiment& experiment, std::size_t sample);
  /// What is under way is read to its end and thrown away; no signal comes any more.
  void drop();
  [[nodiscard]] bool isLoading() const noexcept { return wanted_; }

 signals:
  void loaded(std::shared_ptr<const desktop::PointCloud> cloud);
  void failed(const core::InputError& error);

 private:
  struct Wish {
    model::Experiment experiment;
    std::size_t sample;
  };
  void begin(Wish wish);

  std::unique_ptr<QThread> thread_;
  std::optional<Wish> next_;
  bool wanted_ = false;
};

}  // namespace desktop
