// probe
#include <fmt/format.h>
#include "app/truth_keeper.h"
#include "renderer/scene_look.h"
#include "renderer/settings_json.h"
#include "renderer/normal_encoding.h"
#include "renderer/truth/measure.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {
double srgb(double c){ return c<=.0031308?12.92*c:1.055*std::pow(c,1/2.4)-.055; }
double lin(double c){ return c<=.04045?c/12.92:std::pow((c+.055)/1.055,2.4); }
double q(double x,int bits){ if(bits>=32) return x; double n=std::pow(2.0,bits)-1; return std::floor(std::clamp(x,0.0,1.0)*n+.5)/n; }
struct B { int base=32,rough=32,metal=32,occ=32; NormalEncoding enc=NormalEncoding::xyz32f; int em[3]={32,32,32}; };
StoreFn store(B b, double exposure){ return [=](TruthMaterial& m){
  for(int k=0;k<3;++k) if(b.base<32) m.base[k]=lin(q(srgb(std::clamp(m.base[k],0.0,1.0)),b.base));
  for(int k=0;k<3;++k) if(b.em[k]<32) m.emission[k]=lin(q(srgb(std::clamp(m.emission[k]*exposure,0.0,1.0)),b.em[k]))/exposure;
  m.roughness=q(m.roughness,b.rough); m.metal=q(m.metal,b.metal); m.occlusion=q(m.occlusion,b.occ);
  if(b.enc!=NormalEncoding::xyz32f) m.normal=glm::normalize(stored_normal(b.enc,m.normal)); }; }
TEST(Probe, Bits) {
  static const HeadlessContext context; gl::probe_device({});
  Renderer renderer;
  std::vector<std::string> names;
  for (const BuiltinScene& b : builtin_scenes()) names.push_back(fmt::format("builtin:{}", b.id));
  for (const auto& e : std::filesystem::recursive_directory_iterator("/work/shared/models")) { auto x=e.path().extension(); if(x==".gltf"||x==".glb") names.push_back(e.path().string()); }
  struct Row { std::string name; B b; };
  std::vector<Row> rows;
  for(int n:{8,9,10,11,12}) rows.push_back({fmt::format("base {}",n),{.base=n}});
  for(int n:{8,9,10,12}) rows.push_back({fmt::format("rough {}",n),{.rough=n}});
  for(int n:{4,6,8,10}) rows.push_back({fmt::format("metal {}",n),{.metal=n}});
  for(int n:{4,6,8,10}) rows.push_back({fmt::format("occ {}",n),{.occ=n}});
  for(auto e:{NormalEncoding::oct10,NormalEncoding::oct12,NormalEncoding::oct14,NormalEncoding::oct16,NormalEncoding::oct16_precise}) rows.push_back({fmt::format("normal {}",row(e).id),{.enc=e}});
  for(int n:{7,8,9,10}) rows.push_back({fmt::format("emission {}",n),{.em={n,n,n}}});
  rows.push_back({"compact", {.base=8,.rough=12,.enc=NormalEncoding::oct14}});
  rows.push_back({"exact16 10/12/11/11 oct16p em 11 11 10", {.base=10,.rough=12,.metal=11,.occ=11,.enc=NormalEncoding::oct16_precise,.em={11,11,10}}});
  rows.push_back({"tight 10/10/8/8 oct16p em 10", {.base=10,.rough=10,.metal=8,.occ=8,.enc=NormalEncoding::oct16_precise,.em={10,10,10}}});
  rows.push_back({"64 bit: 9/9/- oct14", {.base=9,.rough=9,.enc=NormalEncoding::oct14}});
  struct Sum { double worst=0; std::string at; size_t over1=0, overh=0, n=0; double worst_share1=0; };
  std::vector<Sum> sums(rows.size());
  for (const std::string& name : names) {
    GpuScene scene(open_scene(name));
    Settings s = preset("compact").make();
    apply_scene(s, name, scene.scene());
    s.size = {320, 180};
    s.lights.source = LightSource::generated; s.lights.count = 64, s.lights.seed = 1;
    s.shading.model = ShadingModel::ggx; s.attenuation = Attenuation::windowed; s.range.kind = RangeKind::source; s.colour = Colour::srgb;
    TruthKeeper keeper(1, 2);
    auto set = keeper.get(renderer, scene, s, true);
    for (size_t r=0;r<rows.size();++r) {
      Reference ref(s, scene.shared_scene(), set->texels, store(rows[r].b, s.exposure));
      ref.run(2);
      std::vector<glm::vec3> lit(set->truth.pixels());
      for(size_t i=0;i<lit.size();++i) lit[i]=glm::vec3(ref.truth().lit[i]);
      const BoundCheck h = check_bound(set->truth, lit, {}, {s.exposure,s.colour}, .5/255), o = check_bound(set->truth, lit, {}, {s.exposure,s.colour}, 1/255.);
      Sum& q=sums[r]; q.over1+=o.over; q.overh+=h.over; q.n+=h.compared; q.worst_share1=std::max(q.worst_share1,o.share_over());
      if(h.worst>q.worst) q.worst=h.worst, q.at=name.substr(name.rfind('/')+1);
    }
  }
  for (size_t r=0;r<rows.size();++r) fmt::print("{:<40} worst {:.2f} codes ({})  over half {} of {}  over one {} (worst share {:.5f})\n", rows[r].name, sums[r].worst*255, sums[r].at, sums[r].overh, sums[r].n, sums[r].over1, sums[r].worst_share1);
}
}}
