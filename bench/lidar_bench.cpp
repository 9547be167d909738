// The lidar model at the speed of the ray tracer: a street of 207 000 triangles, 128 x 2048 beams, 1, 9 and 81 sub-rays
// a beam. Build with the release preset; run build/bin/lidar_bench. `rays/s` counts sub-rays, met or not. The limit is
// a bare Embree loop with packets of sixteen, the coherent flag and ray generation, in this same process.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <embree3/rtcore.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/resource.h>
#include <vector>

#include "bench/street.h"
#include "core/parallel.h"
#include "model/lidar_model.h"
#include "model/signal/signal_chain.h"

namespace {

using nlohmann::json;

constexpr int kLayers = 128, kColumns = 2048;

/// The street as a scene of one mesh, read from a file like any other.
const model::Scene& streetScene() {
  static const model::Scene scene = [] {
    const auto file = std::filesystem::temp_directory_path() / "fidelis-bench-street.ply";
    bench::writeMesh(bench::street(), file);
    model::Scene result;
    result.materials.push_back({.name = "street", .reflectivity = 0.3});
    result.objects.push_back({.id = "street", .shape = model::Mesh{file, 1.0}, .pose = {}, .material = 0});
    return result;
  }();
  return scene;
}

const model::RayTracer& tracer() {
  static const model::RayTracer instance(streetScene());
  return instance;
}

json sensorJson() {
  json layers = json::array();
  for (int l = 0; l < kLayers; ++l) {
    const double step = 360.0 / kColumns;
    layers.push_back({{"elevation_deg", -25.0 + 40.0 * l / (kLayers - 1)},
                      {"azimuth_deg", {{"from", 180.0 - step / 2}, {"to", -180.0 + step / 2}, {"step", step}}}});
  }
  return {{"format", "fidelis-sensor"},
          {"version", 1},
          {"id", "bench"},
          {"emitter",
           {{"wavelength_nm", 905},
            {"peak_power_w", 75.0},
            {"pulse_fwhm_ns", 5.0},
            {"divergence_rad", {{"horizontal", 0.003}, {"vertical", 0.003}}}}},
          {"receiver",
           {{"aperture_diameter_m", 0.03},
            {"efficiency", 0.7},
            {"noise_w", 1e-9},
            {"threshold_w", 6e-9},
            {"saturation_w", 1e-5}}},
          {"scan", {{"frame_rate_hz", 10}, {"layers", layers}}},
          {"detection",
           {{"max_echoes", 3},
            {"echo_separation_m", 1.0},
            {"max_range_m", 200},
            {"range_resolution_m", 0.004},
            {"epw_resolution_m", 0.01},
            {"intensity_resolution", 1},
            {"range_noise_m", 0.01},
            {"epw_noise_m", 0.02},
            {"output", {"range", "epw", "intensity"}}}}};
}

/// What a rotating lidar is modelled with on an ordinary day.
json everydayEffects() {
  return {{"beam-divergence", json::object()},
          {"atmospheric-attenuation", {{"visibility_m", 5000}}},
          {"background-light", {{"irradiance_w_m2_nm", 0.3}}},
          {"saturation", json::object()},
          {"quantisation", {{"range_step_m", 0.004}}}};
}

/// So many sub-rays lie side by side, which compares with scanners that know no grid; other numbers stand for squares.
constexpr int kRaysInARow = 19;

model::LidarModel modelWith(const json& effects, int rays) {
  return model::parseModel({{"format", "fidelis-model"},
                            {"version", 1},
                            {"id", "bench"},
                            {"sensor", sensorJson()},
                            {"rays_per_beam", {rays, rays == kRaysInARow ? 1 : rays}},
                            {"effects", effects}},
                           "bench.json");
}

void countRays(benchmark::State& state, std::size_t rays) {
  state.SetItemsProcessed(static_cast<std::int64_t>(rays) * state.iterations());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Everything that a simulation of the street needs, worked out once.
struct Rig {
  explicit Rig(const json& effects, int rays)
      : lidar(modelWith(effects, rays)),
        chain(lidar.sensor(""), lidar.effects, {}),
        beams(model::beamsOf(lidar.sensor("").scan)) {
    chain.aim(beams);
  }
  model::LidarModel lidar;
  model::SignalChain chain;
  std::vector<model::Beam> beams;
  model::GeometryPass pass{tracer(), beams, chain.subRays(lidar.rays_horizontal, lidar.rays_vertical)};
};

/// Beams of a tile, as the chain takes them.
std::size_t grain(const Rig& rig) { return std::max<std::size_t>(16, 4096 / rig.pass.rays().size()); }

/// Nothing but rays: directions from the beams' axes, first hits, one sum over the ranges.
void bareEmbree(benchmark::State& state, bool robust) {
  core::limitThreads(static_cast<int>(state.range(1)));
  const Rig rig({{"beam-divergence", json::object()}}, static_cast<int>(state.range(0)));
  const model::Triangles mesh = bench::street();
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
  for (const auto& v : mesh.vertices) {
    for (const double c : v) *vertices++ = static_cast<float>(c);
  }
  auto* faces = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.faces.size()));
  for (const auto& f : mesh.faces) faces = std::copy(f.begin(), f.end(), faces);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);

  const model::SubRays& rays = rig.pass.rays();
  const std::size_t per_beam = rays.size(), count = rig.beams.size() * per_beam;
  struct Axes {
    float forward[3], left[3], up[3];
  };
  std::vector<Axes> axes;
  for (const model::Beam& beam : rig.beams) {
    const auto ca = static_cast<float>(std::cos(beam.azimuth_rad)), sa = static_cast<float>(std::sin(beam.azimuth_rad));
    const auto ce = static_cast<float>(std::cos(beam.elevation_rad));
    const auto se = static_cast<float>(std::sin(beam.elevation_rad));
    axes.push_back({{ce * ca, ce * sa, se}, {-sa, ca, 0.0F}, {-se * ca, -se * sa, ce}});
  }
  std::vector<std::array<float, 3>> offsets;
  for (std::size_t r = 0; r < per_beam; ++r) {
    const double l = std::tan(rays.left_rad[r]), u = std::tan(rays.up_rad[r]), n = std::sqrt(1 + l * l + u * u);
    offsets.push_back({static_cast<float>(1 / n), static_cast<float>(l / n), static_cast<float>(u / n)});
  }
  for (auto _ : state) {
    core::parallelFor(rig.beams.size(), grain(rig), [&](std::size_t begin, std::size_t end) {
      static thread_local std::vector<model::RayPacket> packets;
      const std::size_t used = ((end - begin) * per_beam + 15) / 16;
      packets.resize(used);
      for (auto& packet : packets) packet.reset({});
      std::size_t at = 0;
      for (std::size_t b = begin; b < end; ++b) {
        const Axes& a = axes[b];
        for (std::size_t r = 0; r < per_beam; ++r, ++at) {
          model::RayPacket& p = packets[at / 16];
          const auto& o = offsets[r];
          p.direction_x[at % 16] = o[0] * a.forward[0] + o[1] * a.left[0] + o[2] * a.up[0];
          p.direction_y[at % 16] = o[0] * a.forward[1] + o[1] * a.left[1] + o[2] * a.up[1];
          p.direction_z[at % 16] = o[0] * a.forward[2] + o[2] * a.up[2];
        }
      }
      for (; at < 16 * used; ++at) packets[at / 16].nearest[at % 16] = INFINITY;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      rtcIntersectNM(scene, &context, reinterpret_cast<RTCRayHitN*>(packets.data()), 16, static_cast<unsigned>(used),
                     sizeof(model::RayPacket));
      benchmark::DoNotOptimize(packets.data());
    });
  }
  countRays(state, count);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void geometryPass(benchmark::State& state) {
  core::limitThreads(static_cast<int>(state.range(1)));
  const Rig rig({{"beam-divergence", json::object()}}, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    core::parallelFor(rig.beams.size(), grain(rig), [&](std::size_t begin, std::size_t end) {
      static thread_local model::GeometryPass::Tile tile;
      rig.pass.trace(begin, end, tile);
      benchmark::DoNotOptimize(tile.hits.range_m.data());
    });
  }
  countRays(state, rig.beams.size() * rig.pass.rays().size());
}

void wholeChain(benchmark::State& state, const json& effects) {
  core::limitThreads(static_cast<int>(state.range(1)));
  const Rig rig(effects, static_cast<int>(state.range(0)));
  std::uint64_t seed = 1;
  std::size_t detections = 0;
  for (auto _ : state) {
    const model::RunOptions options{.seed = seed++, .sample = 0, .frames = 1};
    const auto shots = rig.chain.couplesBeams() ? rig.chain.run(model::traceBeams(tracer(), rig.beams, rig.pass.rays()),
                                                                streetScene(), options)
                                                : rig.chain.run(rig.pass, streetScene(), options);
    detections = shots.size();
    benchmark::DoNotOptimize(shots.data());
  }
  countRays(state, rig.beams.size() * rig.pass.rays().size());
  state.counters["detections"] = static_cast<double>(detections);
}

void arguments(benchmark::internal::Benchmark* bench) {
  for (const int threads : {1, 2}) {
    for (const int rays : {1, 3, 9, kRaysInARow}) bench->Args({rays, threads});
  }
  bench->ArgNames({"rays", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_CAPTURE(bareEmbree, fast, false)->Apply(arguments);
BENCHMARK_CAPTURE(bareEmbree, robust, true)->Apply(arguments);
BENCHMARK(geometryPass)->Apply(arguments);
BENCHMARK_CAPTURE(wholeChain, everyday, everydayEffects())->Apply(arguments);

/// The everyday chain with one effect more, at the values where a diagnosis would start its fit.
json withFurther(const model::EffectEntry& entry) {
  json effects = everydayEffects();
  json parameters = json::object();
  for (const model::ParameterInfo& parameter : entry.info.parameters) {
    const bool fitted =
        std::find(entry.info.fitted.begin(), entry.info.fitted.end(), parameter.name) != entry.info.fitted.end();
    if (fitted) parameters[parameter.name] = parameter.typical;
  }
  effects[entry.info.name] = parameters;
  return effects;
}

}  // namespace

int main(int argc, char** argv) {
  for (const model::EffectEntry& entry : model::allEffects()) {
    if (everydayEffects().contains(entry.info.name)) continue;
    benchmark::RegisterBenchmark(("further/" + entry.info.name).c_str(), wholeChain, withFurther(entry))
        ->Args({3, 1})
        ->ArgNames({"rays", "threads"})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
