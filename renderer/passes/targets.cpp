#include "renderer/passes/targets.h"

#include "renderer/passes/frame_block.h"

namespace gbl {
namespace {

bool same(const std::vector<Attachment>& a, const std::vector<Attachment>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (std::string_view(a[i].name) != b[i].name || a[i].format != b[i].format) return false;
  return true;
}

Canvas& made(std::optional<Canvas>& canvas, const gl::TextureDesc& desc, const gl::Texture* depth = nullptr) {
  if (!canvas) canvas = make_canvas(desc, depth);
  return *canvas;
}

double mib_of(const gl::Texture& t) { return double(t.size.x) * t.size.y * row(t.format).bytes / (1 << 20); }

}  // namespace

Canvas make_canvas(const gl::TextureDesc& desc, const gl::Texture* depth) {
  Canvas c;
  c.texture = gl::make_texture(desc);
  c.framebuffer = gl::make_framebuffer({.colours = {&c.texture}, .depth = depth, .label = desc.label});
  return c;
}

void Targets::prepare(const Settings& s) {
  std::vector<Attachment> wanted = gbl::attachments(s);
  if (size_ == s.size && same(wanted, attachments_)) return;
  std::vector<gl::Texture> textures;
  for (const Attachment& a : wanted)
    textures.push_back(gl::make_texture({.size = s.size, .format = a.format, .label = a.name}));
  std::array<gl::Framebuffer, 3> framebuffers;
  for (const Pass pass : {Pass::geometry, Pass::lighting, Pass::combine}) {
    gl::FramebufferDesc desc{.label = pass == Pass::geometry ? "gbuffer" : pass == Pass::lighting ? "light" : "lit"};
    for (size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i].written_by != pass) continue;
      if (row(wanted[i].format).numeric == Numeric::depth)
        desc.depth = &textures[i];
      else
        desc.colours.push_back(&textures[i]);
    }
    framebuffers[static_cast<int>(pass)] = gl::make_framebuffer(desc);
  }
  // Everything new exists: only now let go of the old.
  composed_.reset();  // these two share depth attachments
  counts_.reset();
  if (size_ != s.size) {
    for (auto& v : views_) v.reset();
    for (auto* c : {&counts_lit_, &count_sums_}) c->reset();
  }
  size_ = s.size;
  attachments_ = std::move(wanted);
  textures_ = std::move(textures);
  framebuffers_ = std::move(framebuffers);
}

const gl::Texture* Targets::texture(Stores what) const {
  for (size_t i = 0; i < attachments_.size(); ++i)
    if (attachments_[i].stores == what) return &textures_[i];
  return nullptr;
}

const gl::Framebuffer& Targets::framebuffer(Pass pass) const { return framebuffers_[static_cast<int>(pass)]; }

double Targets::mib() const {
  double sum = 0;
  for (const gl::Texture& t : textures_) sum += mib_of(t);
  for (const auto& v : views_)
    if (v) sum += mib_of(v->texture);
  for (const auto* c : {&composed_, &counts_, &counts_lit_, &count_sums_})
    if (*c) sum += mib_of((*c)->texture);
  return sum;
}

Canvas& Targets::view(View v) {
  return made(views_[static_cast<int>(v)],
              {.size = size_, .format = Format::rgba8, .linear_filter = true, .label = row(v).id});
}

const Canvas* Targets::drawn_view(View v) const {
  const auto& canvas = views_[static_cast<int>(v)];
  return canvas ? &*canvas : nullptr;
}

Canvas& Targets::composed() {
  return made(composed_, {.size = size_, .format = Format::rgba32f, .label = "composed"}, texture(Stores::depth));
}

Canvas& Targets::counts() {
  return made(counts_, {.size = size_, .format = Format::rgba32f, .label = "counts"}, texture(Stores::light_depth));
}
Canvas& Targets::counts_lit() {
  return made(counts_lit_, {.size = size_, .format = Format::r32f, .label = "counts.lit"});
}
Canvas& Targets::count_sums() {
  return made(count_sums_,
              {.size = (size_ + COUNT_BLOCK - 1) / COUNT_BLOCK, .format = Format::rgba32f, .label = "counts.sums"});
}
Canvas& Targets::probe() {
  return made(probe_, {.size = {PROBE_FIELDS, 1}, .format = Format::rgba32f, .label = "probe"});
}

}  // namespace gbl
