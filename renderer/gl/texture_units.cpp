#include "renderer/gl/texture_units.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <string>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/gl/device.h"
#include "renderer/gl/misuse.h"
#include "renderer/gl/program.h"

namespace gbl::gl {
namespace {

using Units = std::map<std::string, int, std::less<>>;

Units& units() {
  static Units all;  // one GL thread
  return all;
}

bool a_shader_declares(std::string_view sampler) {
  const std::vector<std::string> files = resource_names("shaders/");
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    const UniformNames names = declared_uniforms(resource(file));
    return names.find(sampler) != names.end();
  });
}

}  // namespace

int unit_of(std::string_view sampler) {
  const auto known = units().find(sampler);
  if (known != units().end()) return known->second;
  const int unit = units_in_use();
  if (unit >= device().max_texture_units)
    throw Error(ExitCode::no_gl, fmt::format("sampler '{}'", sampler),
                fmt::format("all {} texture units of this driver have a sampler", device().max_texture_units),
                "give samplers that are never read together the same name");
  glBindSampler(static_cast<GLuint>(unit), 0);  // none that others left here
  units().emplace(sampler, unit);
  return unit;
}

int units_in_use() { return 1 + static_cast<int>(units().size()); }

void activate_unit_of(std::string_view sampler) {
  if (kReportsMisuse && units().find(sampler) == units().end() && !a_shader_declares(sampler))
    report_misuse(fmt::format("a texture is bound for '{}', and no shader declares that sampler", sampler));
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit_of(sampler)));
}

void bind_texture(std::string_view sampler, const Texture& t) {
  activate_unit_of(sampler);
  glBindTexture(GL_TEXTURE_2D, t.id());
}

}  // namespace gbl::gl
