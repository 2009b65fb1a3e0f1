#pragma once
// What one light does to one surface point, in double, from the formulas. Written apart from shaders/pair.glsl: what
// is wrong there must not be wrong here in the same way.
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

// A surface point as the light meets it. Colours linear; directions along the world's axes.
struct TruthSurface {
  glm::dvec3 position{0};  // relative to the camera
  glm::dvec3 normal{0};    // unit
  glm::dvec3 to_eye{0};    // unit
  glm::dvec3 albedo{0};    // base colour x (1 - metal)
  glm::dvec3 f0{0};        // reflectance at normal incidence; in the classic models the highlight's factor
  double roughness = 1, exponent = 1;
  bool unlit = false;
};

// A light placed relative to the camera.
struct TruthLight {
  Light light;
  glm::dvec3 position{0};
};

struct Reflected {
  glm::dvec3 diffuse{0}, specular{0};  // diffuse without albedo
  bool nothing() const { return diffuse == glm::dvec3(0) && specular == glm::dvec3(0); }
};

// The settings' part of the model, once per picture.
struct ShadingModelOf {
  explicit ShadingModelOf(const Settings&);
  ShadingModel model;
  Attenuation attenuation;
  LightSpot spot;
  bool windowed_range;
  double constant_exponent;  // < 0: from roughness
  double dielectric_f0;

  double exponent(double roughness) const;
};

// Schlick 1994: what a surface reflects that is seen at an angle of this cosine.
glm::dvec3 fresnel(const glm::dvec3& f0, double cosine);

// Does the light reach the point at all: nearer than its range, inside its outer cone? Whatever the surface faces.
bool reaches(const TruthLight&, const glm::dvec3& position);

// Of what a light sends towards a point, the share that arrives: falloff, cone and window. 0 beyond its range.
double arriving_share(const ShadingModelOf&, const TruthLight&, const glm::dvec3& position);

// Radiance per channel that this light adds. 0 where it does not reach or the surface is turned away.
Reflected reflected(const ShadingModelOf&, const TruthSurface&, const TruthLight&);

}  // namespace gbl
