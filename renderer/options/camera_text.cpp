#include "renderer/options/camera_text.h"

#include <fmt/format.h>
#include <sstream>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/number.h"
#include "renderer/options/options.h"

namespace gbl {
namespace {

constexpr const char* kForm = "x,y,z:yaw,pitch[:fov]";

// "1,2.5,-3" -> numbers; anything else is an Error.
std::vector<double> numbers(const std::string& text, std::string_view where) {
  std::vector<double> out;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::optional<double> n = decimal(part);
    if (!n)
      throw Error(ExitCode::bad_input, where, fmt::format("'{}' is not a number", part),
                  fmt::format("write {}", kForm));
    out.push_back(*n);
  }
  return out;
}

}  // namespace

void apply_camera(Settings& s, const std::string& text, std::string_view where) {
  std::vector<std::string> parts;
  std::istringstream split(text);
  for (std::string part; std::getline(split, part, ':');) parts.push_back(part);
  const auto bad = [&] {
    return Error(ExitCode::bad_input, where, fmt::format("'{}' is not a camera", text), fmt::format("write {}", kForm));
  };
  if (parts.size() < 2 || parts.size() > 3) throw bad();
  const auto place = numbers(parts[0], where), turn = numbers(parts[1], where);
  if (place.size() != 3 || turn.size() != 2) throw bad();
  apply_patch(s, {{"camera.position", OptionList(place.begin(), place.end())}}, where);
  s.camera.orientation = orientation_from_yaw_pitch(turn[0], turn[1]);
  s.camera.orthographic_height = 0;
  if (parts.size() < 3) return;
  const auto fov = numbers(parts[2], where);
  if (fov.size() != 1) throw bad();
  apply_patch(s, {{"camera.fov", fov[0]}, {"camera.aspect", 0}}, where);
}

}  // namespace gbl
