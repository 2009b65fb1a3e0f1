#include "renderer/study/stability/stability_files.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/stability/stability_chart.h"
#include "renderer/study/stability/stability_page.h"

namespace gbl {
namespace {

constexpr int kStabilityFileVersion = 1;

std::string number_text(const std::optional<double>& v) {
  if (!v) return "";
  if (std::isnan(*v)) return "nan";  // never with a sign, which differs between machines
  return fmt::format("{}", *v);
}

// JSON knows no infinity: what is not finite is a text.
Json number_json(const std::optional<double>& v) {
  if (!v) return nullptr;
  return std::isfinite(*v) ? Json(*v) : Json(number_text(v));
}

const char* id_of(StoreRounding r) { return r == StoreRounding::toward_zero ? "toward-zero" : "to-nearest"; }

Json point_json(const SweepRow& r) {
  Json point = {{"x", r.x}, {"value", number_json(r.value)}, {"lit_pixels", r.lit_pixels}};
  for (const ErrorColumn& c : error_columns()) point[c.id] = number_json(r.errors.*c.value);
  return point;
}

Json curve_json(const SweepResult& result, const CurveResult& c) {
  Json json = {{"id", c.curve}};
  json["not_drawn"] = c.not_drawn.empty() ? Json(nullptr) : Json(c.not_drawn);
  json["statements"] = Json::array(), json["points"] = Json::array();
  for (const Judged& j : c.judged)
    json["statements"].push_back({{"text", j.statement}, {"holds", j.verdict.holds}, {"where", j.verdict.where}});
  for (const SweepRow& r : c.rows) json["points"].push_back(point_json(r));
  if (has_families(*result.sweep))
    for (int family = 0; family < kFamilies; ++family) {
      const FamilyShares s = family_shares(c, family);
      json["families"].push_back({{"family", std::string(1, "ABC"[family])},
                                  {"configurations", s.configurations},
                                  {"wrong", s.wrong},
                                  {"lost", s.lost},
                                  {"worst_linear", number_json(s.worst_linear)}});
    }
  json["settings"] = to_json(c.settings);
  return json;
}

Json sweep_json(const SweepResult& result) {
  const Sweep& s = *result.sweep;
  Json json = {{"id", s.id},           {"label", s.label},       {"help", s.help},     {"parameter", s.parameter},
               {"unit", s.unit},       {"log_axis", s.log_axis}, {"metric", s.metric}, {"holds", result.holds()},
               {"given", result.given}};
  for (const CurveResult& c : result.curves) json["curves"].push_back(curve_json(result, c));
  return json;
}

}  // namespace

std::string stability_csv(const std::vector<SweepResult>& results) {
  std::string text = "sweep,curve,x,metric,value,lit_pixels";
  for (const ErrorColumn& c : error_columns()) text += std::string(",") + c.id;
  text += "\r\n";
  for (const SweepResult& result : results)
    for (const CurveResult& curve : result.curves)
      for (const SweepRow& r : curve.rows) {
        text += fmt::format("{},{},{},{},{},{}", r.sweep, r.curve, r.x, r.metric, number_text(r.value), r.lit_pixels);
        for (const ErrorColumn& c : error_columns()) text += "," + number_text(r.errors.*c.value);
        text += "\r\n";
      }
  return text;
}

Json stability_json(const std::vector<SweepResult>& results, const Machine& machine, const DeviceRounding& rounding) {
  Json json;
  json["version"] = kStabilityFileVersion;
  json["machine"] = {{"driver", machine.driver},
                     {"device", machine.device},
                     {"rounding",
                      {{"rgba16f_store", id_of(rounding.half_store)},
                       {"rgba16f_blend", id_of(rounding.half_blend)},
                       {"r11g11b10f", id_of(rounding.r11)}}}};
  json["sweeps"] = Json::array();
  for (const SweepResult& r : results) json["sweeps"].push_back(sweep_json(r));
  return json;
}

static std::string rounding_words(const DeviceRounding& rounding) {
  return fmt::format("half floats are blended {}",
                     rounding.half_blend == StoreRounding::toward_zero ? "toward zero" : "to nearest");
}

static std::string device_words(const Machine& machine, const DeviceRounding& rounding) {
  return fmt::format("{}; {}", machine.device, rounding_words(rounding));
}

static std::string statements_of(const CurveResult& c) {
  if (!c.not_drawn.empty()) return "not drawn here: " + c.not_drawn;
  std::string text;
  for (const Judged& j : c.judged)
    text += fmt::format("{}{}{}", text.empty() ? "" : "; ", j.statement,
                        j.verdict.holds ? "" : " (DOES NOT HOLD: " + j.verdict.where + ")");
  return text;
}

std::string stability_markdown(const std::vector<SweepResult>& results, const Machine& machine,
                               const DeviceRounding& rounding) {
  std::string page = fmt::format(
      "# Where each method fails\n\nOne parameter is moved through the place where methods break. Of every curve "
      "something is "
      "stated, and each statement is checked against the reference in double precision. This page is generated by "
      "`gbufferlab stability -o FOLDER`, as `stability.md`, on {}.\n",
      device_words(machine, rounding));
  std::string never;
  for (const SweepResult& r : results) {
    const Sweep& s = *r.sweep;
    page += fmt::format("\n## {0}\n\n`{1}`: {2}. Measured: {3}.\n\n![{0}: a curve for each choice]({1}.svg)\n\n",
                        s.label, s.id, s.help, sweep_metric(s.metric).help);
    if (!r.given.empty()) page += fmt::format("Measured with `{}`: nothing is stated of that.\n\n", r.given);
    page += "| curve | what holds |\n|---|---|\n";
    std::string flat;
    for (const CurveResult& c : r.curves) {
      page += fmt::format("| {} | {} |\n", c.curve, statements_of(c));
      const auto zero = [](const SweepRow& row) { return row.value && *row.value == 0; };
      if (r.left == 0 && !c.rows.empty() && std::all_of(c.rows.begin(), c.rows.end(), zero))
        flat += fmt::format("{}{}", flat.empty() ? "" : ", ", c.curve);
    }
    if (!flat.empty()) never += fmt::format("- {}: {}\n", s.label, flat);
  }
  return page + "\n## What never failed\n\nNo error at any point of the curve.\n\n" + never;
}

void write_stability_files(const std::filesystem::path& folder, const std::vector<SweepResult>& results,
                           const Machine& machine, const DeviceRounding& rounding) {
  make_folder(folder);
  write_text_file(folder / "stability.csv", stability_csv(results));
  write_text_file(folder / "stability.json", stability_json(results, machine, rounding).dump(1) + "\n");
  write_text_file(folder / "stability.md", stability_markdown(results, machine, rounding));
  const std::string device = device_words(machine, rounding);
  write_text_file(folder / "stability.html", page_html(stability_page(results, machine, rounding_words(rounding))));
  for (const SweepResult& r : results) {
    const auto has_points = [](const CurveResult& c) { return !c.rows.empty(); };
    if (std::none_of(r.curves.begin(), r.curves.end(), has_points)) continue;  // other machines measure it
    for (const auto& [file, ending] : {std::pair(StabilityFile::svg, ".svg"), std::pair(StabilityFile::png, ".png")})
      write_text_file(folder / (std::string(r.sweep->id) + ending), run_gnuplot(stability_script(r, device, file)));
  }
}

}  // namespace gbl
