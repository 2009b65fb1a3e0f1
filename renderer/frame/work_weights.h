#pragma once
// What the parts of the lighting methods cost, in units of one turn of the full-screen loop: a light's record read, its
// distance taken, and its shading if it is in range. lights.method=auto weighs the methods by them. They are of the
// device at hand if that was measured (`bench --calibrate`), else of llvmpipe.
#include <array>
#include <cstddef>
#include <iterator>

namespace gbl {

enum class Work {
  turn,
  pixel,
  cleared,
  second_test,
  cluster_pixel,
  listed,
  marked,
  fragment,
  mesh_fragment,
  mark,
  draw,
  triangle,
  quad,
  disc,
  tile_batch,
  listed_light,
  list_entry,
};

struct WorkRow {
  Work work;
  const char* id;
  const char* counts;  // what there is one of
  double at_least;     // units: it holds so many turns
  // Units, as `bench --calibrate` found them on two cores, where a turn took 1.7 ns; of fragments as large lights have them.
  double llvmpipe;
};
// clang-format off
inline constexpr WorkRow kWork[] = {
    {Work::turn, "turn", "light in the full-screen loop, at each pixel", 1, 1},
    {Work::pixel, "pixel", "pixel of a full-screen pass: it reads the G-buffer and writes its sums", 0, 11},
    {Work::cleared, "cleared", "pixel whose sums are cleared, to be blended onto", 0, 1.5},
    {Work::second_test, "second-test", "distance that shade() tests again", 0, 0.05},
    {Work::cluster_pixel, "cluster-pixel", "pixel whose depth is looked at, and which looks up where its list is", 0, 3.1},
    {Work::listed, "listed", "turn of a loop whose lights come from a cluster's list", 1, 1.05},
    {Work::marked, "marked", "turn of a loop whose lights come from a tile's bits", 1, 1.5},
    {Work::fragment, "fragment", "pair with a fragment of its own: it reads the G-buffer, shades and blends", 1, 8},
    {Work::mesh_fragment, "mesh-fragment", "such a pair of a mesh: small triangles leave blocks of pixels half used", 1, 8.5},
    {Work::mark, "mark", "fragment that is only tested against depth", 0, 2.5},
    {Work::draw, "draw", "draw call", 0, 9000},
    {Work::triangle, "triangle", "triangle of a light's mesh", 0, 47},
    {Work::quad, "quad", "light's rectangle", 0, 3700},
    {Work::disc, "disc", "light's disc", 0, 9300},
    {Work::tile_batch, "tile-batch", "256 lights tested by one tile, with its barriers", 0, 9800},
    {Work::listed_light, "listed-light", "light that is put into lists, on the CPU", 0, 200},
    {Work::list_entry, "list-entry", "entry of a list", 0, 16},
};
// clang-format on
inline constexpr size_t kWorkKinds = std::size(kWork);
constexpr bool work_in_order() {
  for (size_t i = 0; i < kWorkKinds; ++i)
    if (kWork[i].work != static_cast<Work>(i)) return false;
  return true;
}
static_assert(work_in_order());

// A number for each kind of work.
class WorkCounts {
 public:
  double& operator[](Work w) { return of_[static_cast<size_t>(w)]; }
  double operator[](Work w) const { return of_[static_cast<size_t>(w)]; }
  bool operator==(const WorkCounts&) const = default;

 private:
  std::array<double, kWorkKinds> of_{};
};

struct WorkWeights {
  WorkCounts units;        // of each; a turn has 1
  double ns_per_unit = 0;  // 0: not known
  bool guessed = false;    // of another device than the one at hand
  bool operator==(const WorkWeights&) const = default;
};
WorkWeights llvmpipe_weights();

double units_of(const WorkCounts&, const WorkWeights&);

// Those that estimates are made with: of the device, as a driver's limits are. llvmpipe's until others are set, which is
// to be before the first frame.
const WorkWeights& work_weights();
void use_work_weights(const WorkWeights&);

}  // namespace gbl
