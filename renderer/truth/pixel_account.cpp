#include "renderer/truth/pixel_account.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/truth/measure.h"
#include "renderer/truth/reference.h"

namespace gbl {
namespace {

constexpr double kHalfCode = 0.5 / 255;

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }
std::vector<double> list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

class Account {
 public:
  Account(const Settings& s, const Scene& scene, const SeenTexel& texel, const PixelProbe& probe)
      : s_(s), scene_(scene), texel_(texel), probe_(probe), display_{s.exposure, s.colour} {
    out_.pixel = probe.pixel;
  }

  PixelAccount made() {
    const Ray ray = pixel_ray(s_.camera, s_.size, probe_.pixel);
    out_.surface = texel_.instance() >= 0;
    out_.seen = texel_.surface();
    if (!out_.surface) {
      lit_ = background_radiance(s_, ray.direction);
      add_result();
      return std::move(out_);
    }
    at_ = TruthGeometry(s_, scene_, {}).at(ray, texel_);
    add_lights();
    out_.true_position = at_.surface.position + s_.camera.position;
    out_.depth = depth_account(s_, probe_, at_.surface.position);
    out_.routes = position_routes(s_, probe_, at_.surface.position);
    add_stored();
    add_terms();
    return std::move(out_);
  }

 private:
  bool there(ProbeField f) const { return why_missing(probe_fields()[static_cast<size_t>(f)].view, s_).empty(); }
  glm::dvec3 drawn(ProbeField f) const { return probe_.vector(f); }

  void add_lights() {
    const ShadingModelOf model(s_);
    const TruthSurface& surface = at_.surface;
    const std::vector<Light> lights = true_lights(s_, scene_);
    const LightSight sight(s_, scene_, TruthGeometry(s_, scene_).heights());
    for (size_t i = 0; i < lights.size(); ++i) {
      const TruthLight light{lights[i], lights[i].position - s_.camera.position};
      Reflected one = reflected(model, surface, light);
      const bool hidden = !one.nothing() && !sight.sees(light, surface.position, out_.seen);
      if (hidden) one = {};
      diffuse_ += one.diffuse, specular_ += one.specular;
      if (!reaches(light, surface.position)) continue;
      const bool sun = light.light.kind == LightKind::directional;
      const glm::dvec3 to_light = sun ? -light.light.direction : light.position - surface.position;
      LightShare share;
      share.index = s_.lights.only >= 0 ? s_.lights.only : static_cast<int>(i);
      share.distance = sun ? kEndless : glm::length(to_light);
      share.range = light.light.range;
      share.hidden = hidden;
      share.arriving = hidden ? 0 : arriving_share(model, light, surface.position);
      share.n_dot_l = glm::dot(surface.normal, to_light) / std::max(glm::length(to_light), 1e-30);
      share.diffuse = surface.albedo * one.diffuse;
      share.specular = one.specular;
      out_.lights.push_back(share);
    }
    const double all = luminance(surface.albedo * diffuse_ + specular_);
    for (LightShare& l : out_.lights) l.share = all > 0 ? luminance(l.diffuse + l.specular) / all : 0;
    std::stable_sort(out_.lights.begin(), out_.lights.end(),
                     [](const LightShare& a, const LightShare& b) { return a.share > b.share; });
  }

  void store(const char* what, const char* unit, ProbeField f, std::vector<double> truth) {
    AccountLine line{what, unit, {}, std::move(truth)};
    if (there(f)) {
      const glm::dvec3 v = drawn(f);
      for (size_t k = 0; k < line.truth.size(); ++k) line.drawn.push_back(v[static_cast<glm::length_t>(k)]);
      line.error = largest_difference(line.drawn, line.truth);
    }
    out_.stored.push_back(std::move(line));
  }

  void add_stored() {
    const TruthSurface& t = at_.surface;
    store("distance", "units along the view", ProbeField::range, {glm::dot(t.position, s_.camera.forward())});
    store("position", "world units", ProbeField::position, list(t.position + s_.camera.position));
    store("normal", "error: degrees", ProbeField::normal, list(t.normal));
    if (AccountLine& n = out_.stored.back(); !n.drawn.empty()) {
      const glm::dvec3 v = drawn(ProbeField::normal);
      n.error = glm::degrees(std::atan2(glm::length(glm::cross(v, t.normal)), glm::dot(v, t.normal)));
    }
    store("roughness", "0..1", ProbeField::roughness, {t.roughness});
    store("reflectance F0", "share of light", ProbeField::f0, list(t.f0));
  }

  // A term, with what it adds to the sum where it alone is as drawn.
  void term(const char* what, const char* unit, bool known, const glm::dvec3& from_frame, const glm::dvec3& truth,
            const glm::dvec3& off_by) {
    AccountLine line{what, unit, known ? list(from_frame) : std::vector<double>(), list(truth)};
    if (known) {
      line.error = largest_difference(line.drawn, line.truth);
      const glm::dvec3 moved = glm::abs(displayed(display_, lit_ + off_by) - displayed(display_, lit_));
      line.off = !(std::max({moved.x, moved.y, moved.z}) <= kHalfCode);  // also where it is no number
      if (line.off && out_.first_off < 0) out_.first_off = static_cast<int>(out_.terms.size());
    }
    out_.terms.push_back(std::move(line));
  }

  void add_terms() {
    const glm::dvec3 albedo = at_.surface.albedo, own = s_.ambient * at_.ambient + at_.emission;
    const SurfaceLight light(s_, scene_);
    const glm::dvec3 mirrored = light.mirrored(at_, texel_.surface(), out_.pixel).all;
    lit_ = own + albedo * diffuse_ + specular_ + mirrored;
    const glm::dvec3 a = drawn(ProbeField::albedo), d = drawn(ProbeField::diffuse_light),
                     s = drawn(ProbeField::specular_light),
                     o = s_.ambient * drawn(ProbeField::ambient) + drawn(ProbeField::emission);
    const bool split = there(ProbeField::diffuse_light), coloured = there(ProbeField::albedo);
    term("albedo", "share of light", coloured, a, albedo, (a - albedo) * diffuse_);
    term("diffuse light", "on white", split, d, diffuse_, albedo * (d - diffuse_));
    term("albedo x diffuse light", "radiance", split && coloured, a * d, albedo * diffuse_, a * d - albedo * diffuse_);
    term("+ specular light", "radiance", split, s, specular_, s - specular_);
    term("+ ambient, emission", "radiance", coloured, o, own, o - own);
    if (light.mirrors()) {  // no buffer holds it: what is left of the sum
      const glm::dvec3 rest = drawn(ProbeField::lit) - a * d - s - o;
      term("+ mirrored, refracted", "radiance", split && coloured, rest, mirrored, rest - mirrored);
    }
    add_result();
  }

  void add_result() {
    const glm::dvec3 lit = drawn(ProbeField::lit);
    term("= lit", "radiance", true, lit, lit_, lit - lit_);
    term("x exposure", "of white", true, lit * s_.exposure, lit_ * s_.exposure, lit - lit_);
    term("display code", "of 255", true, 255.0 * displayed(display_, lit), 255.0 * displayed(display_, lit_),
         lit - lit_);
  }

  const Settings& s_;
  const Scene& scene_;
  const SeenTexel& texel_;
  const PixelProbe& probe_;
  const Display display_;
  SurfaceAt at_;
  glm::dvec3 diffuse_{0}, specular_{0}, lit_{0};
  PixelAccount out_;
};

}  // namespace

std::string verdict_of(const LightShare& l) {
  if (!l.shaded || *l.shaded == 1) return {};
  if (*l.shaded == 0) return l.diffuse + l.specular == glm::dvec3(0) ? "" : "missed";
  return *l.shaded == 2 ? "counted twice" : fmt::format("counted {} times", *l.shaded);
}

std::string other_surface_note(const PixelAccount& a) {
  if (a.shown == a.seen) return {};
  std::string what = "no surface is known to be what the frame shows";
  if (a.shown.object == 0) what = "the frame shows the background";
  if (a.shown.object > 0)
    what = fmt::format("the frame shows object {}, triangle {}", a.shown.object, a.shown.triangle);
  return fmt::format("{}{}; what follows is the reference's", a.tie ? "an edge, where either may be right: " : "",
                     what);
}

PixelAccount account_of(const Settings& s, const Scene& scene, const SeenTexel& texel, const PixelProbe& probe) {
  return Account(s, scene, texel, probe).made();
}

}  // namespace gbl
