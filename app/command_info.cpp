// `info`: what this machine can do, and why not.
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/calibration.h"
#include "app/commands.h"
#include "app/driver_report.h"
#include "app/headless.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/gl/device.h"
#include "renderer/gltf/scene_gltf.h"
#include "renderer/options/settings_json.h"
#include "renderer/passes/format_check.h"

namespace gbl {
namespace {

bool never_in_es(Feature f) { return f == Feature::compute || f == Feature::tessellation; }

Json to_json(std::span<const Limit> limits) {
  Json out = Json::array();
  for (const Limit& l : limits) out.push_back({{"id", l.id}, {"value", l.value}, {"what", l.what}});
  return out;
}

void print_limits(const char* of, std::span<const Limit> limits) {
  fmt::print("\n{} may ask for at most\n", of);
  for (const Limit& l : limits) fmt::print("  {:>14}  {}\n", l.value, l.what);
}

Json info_json(const gl::Device& d, const gl::RoundingProbe& rounding, FeatureSet switched_off) {
  Json j;
  j["gl"] = d.version;
  j["glsl"] = d.glsl;
  j["vendor"] = d.vendor;
  j["device"] = d.renderer;
  j["software"] = d.software;
  j["max_size"] = d.max_size;
  j["max_draw_buffers"] = d.max_draw_buffers;
  j["max_lights"] = kMaxLights;
  j["time_query_bits"] = d.time_query_bits;
  j["rounding"] = {{"rgba16f_store", gl::label(rounding.half_store)},
                   {"rgba16f_blend", gl::label(rounding.half_blend)},
                   {"r11g11b10f_store", gl::label(rounding.r11_store)}};
  std::string trouble;
  const WorkWeights weights = weights_for(calibration_file(), d, trouble);
  j["method_choice"] = !trouble.empty()           ? trouble
                       : weights.guessed          ? "a guess: measured with llvmpipe (bench --calibrate measures here)"
                       : weights.ns_per_unit == 0 ? "measured with llvmpipe"
                                                  : "measured on this device";
  j["format_checks"] = Json::array();
  for (const StoredAs s : all_stored(d.features)) {
    const FormatCheck c = check_format(s, rounding);
    j["format_checks"].push_back({{"id", name_of(s)},
                                  {"holds", c.holds()},
                                  {"error", std::isfinite(c.error) ? Json(c.error) : Json(nullptr)},
                                  {"bound", c.bound},
                                  {"unit", c.unit},
                                  {"said", c.holds() ? "" : c.said()}});
  }
  j["file_limits"] = to_json(file_limits());
  j["gltf_limits"] = to_json(gltf_limits());
  j["gltf_extensions"] = Json::array();
  for (const std::string_view e : gltf_extensions()) j["gltf_extensions"].push_back(e);
  j["features"] = Json::array();
  for (const FeatureRow& f : kFeatures) {
    const bool there = d.features.has(f.feature);
    const char* reason = there                                             ? ""
                         : switched_off.has(f.feature)                     ? "switched off by --without"
                         : d.api == gl::Api::es3 && never_in_es(f.feature) ? "OpenGL ES 3.0 has none"
                                                                           : "the driver lacks it";
    j["features"].push_back({{"id", f.id}, {"available", there}, {"reason", reason}, {"used_for", f.used_for}});
  }
  return j;
}

}  // namespace

ExitCode run_info(const Arguments& a) {
  if (!a.reports.empty()) {
    fmt::print("{}", driver_table(a.reports));
    return ExitCode::done;
  }
  const HeadlessContext context(api_of(a));
  const FeatureSet off = without_of(a);
  const gl::Device d = gl::probe_device(off);
  const gl::RoundingProbe rounding = gl::probe_rounding();
  const Json j = info_json(d, rounding, off);
  if (a.report) return write_driver_report(*a.report, j, off, a.json);
  if (a.json) {
    fmt::print("{}\n", j.dump(2));
    return ExitCode::done;
  }
  fmt::print("GL            {}\nGLSL          {}\ndevice        {}{}\n", d.version, d.glsl, d.renderer,
             d.software ? "  (a CPU rasteriser: its times say nothing about a GPU)" : "");
  fmt::print("limits        {} pixels a side, {} draw buffers, {} lights, {} bits of time query\n", d.max_size,
             d.max_draw_buffers, kMaxLights, d.time_query_bits);
  fmt::print("rounding      RGBA16F store {}, blend {}; R11G11B10F store {}\n", gl::label(rounding.half_store),
             gl::label(rounding.half_blend), gl::label(rounding.r11_store));
  fmt::print("auto methods  {}\n", j["method_choice"].get<std::string>());
  for (const Json& f : j["features"])
    fmt::print("{:<13} {}  {}\n", f["id"].get<std::string>(),
               f["available"].get<bool>() ? "yes" : "no: " + f["reason"].get<std::string>(),
               f["used_for"].get<std::string>());
  size_t held = 0;
  for (const Json& c : j["format_checks"]) held += c["holds"].get<bool>();
  fmt::print("\n{} of {} formats store and give back known values as their tables say\n", held,
             j["format_checks"].size());
  for (const Json& c : j["format_checks"])
    if (!c["holds"].get<bool>()) fmt::print("  {}\n", c["said"].get<std::string>());
  print_limits("Files", file_limits());
  print_limits("glTF files", gltf_limits());
  fmt::print("and require {}\n", fmt::join(gltf_extensions(), ", "));
  return ExitCode::done;
}

}  // namespace gbl
