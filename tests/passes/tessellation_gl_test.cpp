// Triangles made from height maps: closed, where they should be, the same for all passes and for the reference.
#include <map>

#include "app/stability_bench.h"
#include "renderer/passes/judging.h"
#include "renderer/truth/height_fields.h"
#include "tests/passes/along_the_wall.h"

namespace gbl::test {
namespace {

class TessellationGl : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!gl::device().features.has(Feature::tessellation)) GTEST_SKIP() << "this driver has no tessellation";
  }
};

Settings tessellated_wall() {
  Settings s = along_the_wall();
  s.tessellation = {TessellationMode::by_distance, 16};
  return s;
}

const Mesh& mesh_named(const Scene& scene, const char* instance) {
  for (const Instance& i : scene.instances)
    if (i.name == instance) return scene.meshes[static_cast<size_t>(i.mesh)];
  throw std::runtime_error(instance);
}

std::shared_ptr<const Scene> drawn(const Settings& s, const GpuScene& gpu, Targets& targets) {
  Renderer renderer;
  renderer.render(s, gpu, targets);
  return targets.tessellation.drawn(gpu);
}

// Edges inside of the wall that have no partner: a corner that lies off its neighbour's edge leaves two of them.
size_t open_edges(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [&](uint32_t i) {
    const glm::vec3 p = mesh.vertices[mesh.indices[i]].position;
    return Place{p.x, p.y, p.z};
  };
  glm::vec2 low(1e9f), high(-1e9f);
  for (const Vertex& v : mesh.vertices) {
    low = glm::min(low, glm::vec2(v.position)), high = glm::max(high, glm::vec2(v.position));
  }
  for (uint32_t t = 0; t < mesh.indices.size(); t += 3)
    for (uint32_t k = 0; k < 3; ++k) {
      const Place a = place(t + k), b = place(t + (k + 1) % 3);
      if (a != b) ++edges[a < b ? std::pair(a, b) : std::pair(b, a)];
    }
  const auto border = [&](const Place& a, const Place& b) {
    for (const int k : {0, 1})
      for (const float side : {low[k], high[k]})
        if (std::abs(a[static_cast<size_t>(k)] - side) < 1e-4f && std::abs(b[static_cast<size_t>(k)] - side) < 1e-4f)
          return true;
    return false;
  };
  size_t open = 0;
  for (const auto& [edge, times] : edges) open += times != 2 && !border(edge.first, edge.second);
  return open;
}

TEST_F(TessellationGl, PatchesMeetWithoutAGap) {
  const GpuScene gpu(room());
  Targets targets;
  Settings s = tessellated_wall();
  for (const TessellationMode mode : {TessellationMode::uniform, TessellationMode::by_distance}) {
    s.tessellation.mode = mode;
    EXPECT_EQ(open_edges(mesh_named(*drawn(s, gpu, targets), "brick wall")), 0u) << row(mode).id;
  }
  s.mistakes = {Mistake::tessellation_unequal_edges};
  EXPECT_GT(open_edges(mesh_named(*drawn(s, gpu, targets), "brick wall")), 20u);
}

// Every corner lies where the height map says; the finer the mesh, the nearer the middles of its triangles.
TEST_F(TessellationGl, CornersLieOnTheHeightField) {
  const GpuScene gpu(room());
  Targets targets;
  Settings s = tessellated_wall();
  s.tessellation.mode = TessellationMode::uniform;
  const HeightFields fields(s, *room());
  int wall = 0;
  while (room()->instances[static_cast<size_t>(wall)].name != "brick wall") ++wall;
  // Straight through the wall at z = -3; any of its triangles spans the same field.
  const auto off = [&](const glm::dvec3& p) {
    const Ray ray{glm::dvec3(p.x, p.y, 0) - s.camera.position, {0, 0, -1}};
    return std::abs((-3 + fields.sunk(ray, {wall + 1, 0}).by.z) - p.z);
  };
  double before = 1e9;
  for (const int level : {16, 64}) {  // pieces of 6 cm and 1.5 cm; a joint is 2 cm wide
    s.tessellation.level = level;
    const std::shared_ptr<const Scene> scene = drawn(s, gpu, targets);
    const Mesh& mesh = mesh_named(*scene, "brick wall");
    EXPECT_EQ(mesh.indices.size(), 3u * 48 * static_cast<size_t>(tessellated_triangles(level))) << "none is left out";
    EXPECT_NEAR(bounds_of(mesh).max.x, 4, 1e-4);
    EXPECT_NEAR(bounds_of(mesh).max.y, 3.2, 1e-4);
    double corners = 0, middles = 0;
    for (size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      glm::dvec3 middle(0);
      for (size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p(mesh.vertices[mesh.indices[t + k]].position);
        corners = std::max(corners, off(p)), middle += p / 3.0;
      }
      middles += off(middle);
    }
    middles /= double(mesh.indices.size() / 3);
    EXPECT_LT(corners, 2e-4) << "the wall is 0.028 deep; float and the sampler round";
    EXPECT_LT(middles, 0.7 * before) << level;
    before = middles;
  }
}

TEST_F(TessellationGl, TheReferenceIsOfTheTrianglesThatAreDrawn) {
  Renderer renderer;
  StabilityBench bench(renderer, gl::probe_device({}));
  SweepSetup setup{tessellated_wall(), room()};
  const Measured m = bench.measure(setup);
  EXPECT_LT(m.errors.over_1_255_display.value_or(1), 1e-3);
  EXPECT_LT(m.errors.position_p99.value_or(1), 1e-3);
  setup.settings.height_map = HeightMap::off;
  const Measured flat = bench.measure(setup);
  double moved = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i)
    if (m.truth->present[i] && flat.truth->present[i])
      moved = std::max(moved, glm::distance(m.truth->position[i], flat.truth->position[i]));
  EXPECT_GT(moved, 0.02) << "it is not the flat wall";
}

TEST_F(TessellationGl, ShadowsMirrorsAndAllMethodsDrawTheSameTriangles) {
  Renderer renderer;
  StabilityBench bench(renderer, gl::probe_device({}));
  SweepSetup setup{tessellated_wall(), room()};
  setup.settings.camera = room()->camera;
  setup.settings.reflections = Reflections::on;
  setup.settings.shadows = Shadows::all;
  setup.settings.shading.model = ShadingModel::ggx;
  setup.settings.lights.method = LightMethod::fullscreen;
  const std::vector<glm::vec3> expected = bench.measure(setup).drawn.lit;
  for (const LightMethod method : {LightMethod::forward_prepass, LightMethod::volumes, LightMethod::clustered}) {
    setup.settings.lights.method = method;
    const std::vector<glm::vec3> lit = bench.measure(setup).drawn.lit;
    size_t off = 0;
    for (size_t i = 0; i < lit.size(); ++i)
      off += glm::distance(lit[i], expected[i]) > 2e-3f * (1 + glm::length(expected[i]));
    EXPECT_LE(off, 2u) << row(method).id;
  }
}

// As long as nothing changes, nothing is made again; and what is made again has the same bits.
TEST_F(TessellationGl, TrianglesAreMadeWhenTheyChange) {
  const GpuScene gpu(room());
  Renderer renderer;
  Targets targets;
  Settings s = tessellated_wall();
  const int first = renderer.render(s, gpu, targets).draw_calls;
  const std::vector<float> lit = gl::read_rgba32f(*targets.frame.texture(Stores::lit));
  EXPECT_EQ(renderer.render(s, gpu, targets).draw_calls, first - 2) << "the wall and the floor";
  s.camera.position.x -= 0.5;
  const int moved = renderer.render(s, gpu, targets).draw_calls;
  EXPECT_EQ(renderer.render(s, gpu, targets).draw_calls, moved - 2);
  s.camera.position.x += 0.5;
  renderer.render(s, gpu, targets);
  EXPECT_EQ(gl::read_rgba32f(*targets.frame.texture(Stores::lit)), lit);
  s.height_map = HeightMap::off;
  renderer.render(s, gpu, targets);
  EXPECT_EQ(targets.tessellation.mib(), 0) << "what nobody draws is not kept";
}

}  // namespace
}  // namespace gbl::test
