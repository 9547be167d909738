#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/detection_files/lidar_view.h"
#include "core/error.h"
#include "model/geometry/hits.h"
#include "model/lidar_model.h"
#include "model/signal/signal_chain.h"

namespace model {

/// The seam between the two halves of a lidar model: what the sub-rays of the beams brought back. Left of it lie scene,
/// materials and every effect that changes the power of a sub-ray's return; right of it pulses, receiver, detections.
///
///   signal strength = 10 log10(P_i / P_t) [dB]      P_i  received peak power of sub-ray i, its share of the beam in it
///   time of flight  = 2 r_i / c                     P_t  the emitter's peak power
///
/// so the strengths of the rays of a beam add up as powers. Source: ASAM OSI 3, LidarSensorView.Reflection.
///
/// Rays lie beam by beam, sub-ray by sub-ray. If sub-rays met more than one surface (behind panes, by way of mirrors),
/// all rays follow a second time, with what each of them met second, and so on.
[[nodiscard]] core::LidarSensorView reflectionsOf(const BeamHits& hits, const SignalChain& chain, const Scene& scene);

/// The beams and sub-rays that a sensor fires, as aimed.
struct Fired {
  std::vector<Beam> beams;
  SubRays rays;
};

/// The way back. Rays in the order above keep their sub-rays; if they lie otherwise, each belongs to the beam that
/// lights up its direction, and those outside of all beams count for nothing. Reflections with the same object are met
/// by the beam as one, those without an object each by itself.
/// Throws InputError at `place` (the message): no ray lies in any beam, or no reflection is weaker than what was sent.
[[nodiscard]] BeamHits hitsOf(const core::LidarSensorView& view, Fired fired, const ChainSettings& settings,
                              const core::Place& place);

/// Reflections from a file, one view a message.
struct ReflectionTrace {
  std::filesystem::path file;
  std::vector<core::LidarSensorView> views;

  [[nodiscard]] core::Place placeOf(std::size_t message) const;
};
[[nodiscard]] ReflectionTrace readReflections(const std::filesystem::path& file);

/// The model's effects that are left of the seam: with reflections from elsewhere they do nothing, because their work
/// is in the signal strengths.
[[nodiscard]] std::vector<std::string> effectsInReflections(const LidarModel& model);

}  // namespace model
