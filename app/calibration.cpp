#include "app/calibration.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "app/state_folder.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/frame/estimate.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/options/data_file.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr int kRounds = 3;
constexpr double kMostMs = 150;  // set-ups that would take longer tell nothing that shorter ones do not

std::vector<Settings> set_ups(Settings s, const DeviceLimits& limits) {
  s.accumulation.targets = AccumulationTargets::split;  // so that the lighting is a pass of its own
  s.lights.source = LightSource::generated;
  s.lights.cull = LightCull::front, s.lights.volume.clip = VolumeClip::none;
  std::vector<Settings> out;
  for (const ValueRow& r : rows<LightMethod>())
    for (const int count : {16, 128, 1024})
      for (const double scale : {0.5, 2.0, 1000.0})
        for (const VolumeLevel level : {VolumeLevel::l1, VolumeLevel::l3}) {
          s.lights.method = static_cast<LightMethod>(r.value);
          s.lights.count = count, s.lights.range_scale = scale, s.lights.volume.level = level;
          if (s.lights.method == LightMethod::auto_ || shading_of(s.lights.method) != Shading::deferred) continue;
          if (level == VolumeLevel::l3 && !facts(s.lights.method).draws_meshes) continue;
          if (validate(s, limits).empty()) out.push_back(s);
        }
  return out;
}

double lighting_ms(Renderer& renderer, const Settings& s, const GpuScene& scene, Targets& targets) {
  targets.clusters.clusters.forget();  // as if the camera had moved
  FrameReport report = renderer.render(s, scene, targets);
  renderer.collect(targets, report, true);
  for (const PassTime& p : report.passes)
    if (p.pass == "lighting") return p.ms.value_or(0);
  return 0;
}

std::string name_of(const gl::Device& d) { return fmt::format("{}, {}", d.renderer, d.version); }

Json read_file(const fs::path& file) {
  const std::string where = file.string();
  Json json = parse_json(read_text_file(file), where);
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  check_file_version(json, kVersion, "calibration", where);
  only_members(json, {"version", "devices"}, where);
  if (!json.contains("devices") || !json["devices"].is_object())
    throw Error(ExitCode::bad_input, where, "\"devices\" is not an object");
  return json;
}

double number_in(const Json& node, const char* member, const std::string& where) {
  const bool number = node.is_object() && node.contains(member) && node[member].is_number();
  const double value = number ? node[member].get<double>() : -1;
  if (!(value >= 0 && value < 1e12))
    throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" is not a number of 0 or more", member));
  return value;
}

WorkWeights read_weights(const Json& node, const std::string& where) {
  WorkWeights w;
  w.ns_per_unit = number_in(node, "ns_per_unit", where);
  for (const WorkRow& r : kWork) w.units[r.work] = number_in(node, r.id, where);
  return w;
}

}  // namespace

std::vector<MeasuredWork> measure_work(Renderer& renderer, const GpuScene& scene, const Settings& asked,
                                       const DeviceLimits& limits) {
  std::vector<MeasuredWork> out;
  Targets targets;
  double ns_per_unit = 0;  // as the set-ups so far have it
  for (const Settings& s : set_ups(asked, limits)) {
    const WorkCounts counts = work_of(s.lights.method, lights_in_view(s, renderer.resolve(s, scene)->lights)).counts;
    const double units = units_of(counts, llvmpipe_weights());
    if (!(units > 0)) continue;  // there is no light
    if (units * ns_per_unit > kMostMs * 1e6) continue;
    lighting_ms(renderer, s, scene, targets);             // compiles programs
    double ms = std::numeric_limits<double>::infinity();  // the least: what disturbs a frame makes it longer
    for (int round = 0; round < kRounds; ++round) ms = std::min(ms, lighting_ms(renderer, s, scene, targets));
    if (!(ms > 0)) continue;  // a clock that is too coarse for it
    out.push_back({counts, ms});
    ns_per_unit = std::max(ns_per_unit, ms * 1e6 / units / 2);
  }
  return out;
}

std::optional<fs::path> calibration_file() {
  std::optional<fs::path> folder = state_folder();
  if (folder) *folder /= "calibration.json";
  return folder;
}

void keep_calibration(const fs::path& file, const gl::Device& device, const WorkWeights& weights) {
  Json json{{"version", kVersion}, {"devices", Json::object()}};
  std::error_code ignored;
  if (fs::exists(file, ignored)) try {
      json = read_file(file);
    } catch (const Error&) {  // damaged, or of a newer program: kept beside the new one
      fs::rename(file, file.string() + ".bad", ignored);
    }
  Json& entry = json["devices"][name_of(device)] = {{"ns_per_unit", weights.ns_per_unit}};
  for (const WorkRow& r : kWork) entry[r.id] = weights.units[r.work];
  make_private_folder(file.parent_path());
  write_text_file(file, json.dump(1) + "\n");
}

WorkWeights weights_for(const std::optional<fs::path>& file, const gl::Device& device, std::string& trouble) {
  WorkWeights weights = llvmpipe_weights();
  weights.guessed = device.renderer.find("llvmpipe") == std::string::npos;
  std::error_code ignored;
  if (!file || !fs::exists(*file, ignored)) return weights;
  try {
    const Json json = read_file(*file);
    const auto found = json["devices"].find(name_of(device));
    if (found == json["devices"].end()) return weights;
    return read_weights(*found, fmt::format("{}: {}", file->string(), name_of(device)));
  } catch (const Error& e) {
    trouble = fmt::format("{}; not used: `bench --calibrate` writes it anew", e.what());
    return weights;
  }
}

}  // namespace gbl
