#pragma once
// A context that is lost: everything is made again on a new one, and nothing of the old one is used.
#include <epoxy/gl.h>

#include "app/headless.h"
#include "app/lab.h"
#include "renderer/gl/misuse.h"
#include "renderer/gl/readback.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl::test {

inline std::vector<Image> pictures_of(Lab& lab, const Settings& s) {
  std::vector<Image> out;
  lab.draw(s);
  for (const View v : {View::final, View::lights_per_pixel, View::normal}) {
    lab.draw_measured_view(v);
    out.push_back(lab.image_of(v));
  }
  EXPECT_TRUE(lab.draw_truth_view(View::error, true));
  out.push_back(lab.image_of(View::error));
  return out;
}

// And the light to the last bit.
using Drawn = std::pair<std::vector<Image>, std::vector<glm::vec4>>;

// So many names of each kind are given away: what is made after it has other names than on a context before.
inline void take_names(GLsizei count) {
  std::vector<GLuint> names(static_cast<size_t>(count));
  for (const auto take : {glGenTextures, glGenBuffers, glGenFramebuffers, glGenRenderbuffers, glGenVertexArrays,
                          glGenSamplers, glGenQueries})
    take(count, names.data());
  for (GLsizei k = 0; k < count; ++k) glCreateProgram();
}

inline Drawn drawn_on_a_new_context(const Settings& s, GLsizei taken_names, gl::Api api = gl::Api::core) {
  const HeadlessContext context(api);
  take_names(taken_names);
  Lab lab(FeatureSet{});
  Drawn out{pictures_of(lab, s), {}};
  out.second = lab.numbers_of(View::lit);
  for (const std::string& misuse : gl::take_misuse()) ADD_FAILURE() << misuse;
  return out;
}

inline void expect_the_same_on_each_context(const std::vector<std::string>& presets) {
  std::vector<std::pair<Settings, Drawn>> first;
  for (const std::string& id : presets) {
    Settings s = preset(id).make();
    s.size = {160, 90};
    first.emplace_back(s, drawn_on_a_new_context(s, 0));
  }
  for (size_t k = presets.size(); k-- > 0;) {
    const auto& [settings, drawn] = first[k];
    const Drawn again = drawn_on_a_new_context(settings, 97);
    EXPECT_TRUE(again.first == drawn.first) << presets[k];
    EXPECT_TRUE(again.second == drawn.second) << presets[k];
  }
}

}  // namespace gbl::test
